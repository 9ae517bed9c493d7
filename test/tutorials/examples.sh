#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# Part of PclSurfaceRepair: runs the example programs on small shapes.
#
# usage: examples.sh EXAMPLE FOLDER_OF_PROGRAMS SCRATCH_FOLDER

set -euo pipefail
here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
. "$here/shapes.sh"
PATH=$(realpath "$2"):$PATH
rm -rf "$3"
mkdir -p "$3"
cd "$3"

# expect "WHAT" COMMAND...: the command succeeds.
expect() {
  local what=$1
  shift
  "$@" || {
    echo "expected: $what" >&2
    exit 1
  }
}

# exits_with CODE COMMAND...
exits_with() {
  local expected=$1 code=0
  shift
  "$@" || code=$?
  expect "exit code $expected of $*, not $code" [ "$code" -eq "$expected" ]
}

# has FILE.ply WORDS...: the facts of the mesh hold these words of the JSON report.
has() {
  local mesh=$1 words
  shift
  pcl_mesh_quality "$mesh" --quiet --report facts.json
  for words in "$@"; do
    expect "$words in the facts of $mesh" grep -q "$words" facts.json
  done
}

bad_usage() {
  exits_with 1 "$1"
  exits_with 1 "$1" missing.ply out.ply
  expect "no output" [ ! -e out.ply ]
}

test_scan_to_mesh() {
  bad_usage scan_to_mesh
  make_cloud 3000 cloud.obj
  # Colours, and two points far away from all others.
  awk '{ print $2, $3, $4, 255, NR % 256, 7 } END { print "9 9 9 0 0 0\n-9 9 9 0 0 0" }' \
    cloud.obj >cloud.xyz
  pcl_ccaa_reconstruct cloud.xyz cloud.ply --quiet
  exits_with 0 scan_to_mesh cloud.ply mesh.ply
  has mesh.ply '"closed": true' '"consistently_wound": true' '"free_vertices": 2'
  expect "colours" grep -aq 'property uchar green' mesh.ply
}

test_repair_mesh() {
  bad_usage repair_mesh
  make_cloud 3000 cloud.obj
  pcl_ccaa_reconstruct cloud.obj whole.ply --quiet
  pcl_damage_cloud whole.ply pieces.ply --quiet --slab 0,1,0,0.5,0.1 --keep 0.1 --seed 1 \
    --removed truth.ply
  exits_with 0 repair_mesh pieces.ply repaired.ply 0.5 truth.ply
  has repaired.ply '"closed": true' '"components": 1'
  expect "patches" [ -s repaired.ply.patches.ply ]
  exits_with 1 repair_mesh pieces.ply refused.ply 2
  expect "no output for a trust of 2" [ ! -e refused.ply ]
}

test_registered_scans() {
  bad_usage registered_scans
  make_cloud 6000 cloud.obj
  pcl_ccaa_reconstruct cloud.obj cloud.ply --quiet
  exits_with 0 registered_scans cloud.ply mesh.ply
  has mesh.ply '"consistently_wound": true' '"components": 1'
  exits_with 0 registered_scans cloud.ply cap.ply -z 0.3,2 -viewpoint 0,0,9
  has cap.ply '"closed": false' '"consistently_wound": true' '"components": 1'
  exits_with 0 registered_scans cloud.ply inside.ply -z 0.3,2 -viewpoint 0,0,-9
  expect "the viewpoint to turn the mesh" [ "$(cksum <cap.ply)" != "$(cksum <inside.ply)" ]
  exits_with 130 registered_scans cloud.ply cancelled.ply -seconds 0
  expect "no output of a cancelled run" [ ! -e cancelled.ply ]
}

test_other_meshes() {
  bad_usage other_meshes
  make_cloud 3000 cloud.obj
  pcl_ccaa_reconstruct cloud.obj good.obj --quiet
  # A fin on every 300th triangle.
  awk '{ print } /^f / && ++n % 300 == 0 { print "f", $2, $3, 1 + 7 * n % 3000 }' good.obj \
    >faulty.obj
  exits_with 0 other_meshes faulty.obj filtered.ply
  has filtered.ply '"non_manifold_edges": 0' '"consistently_wound": true'
  exits_with 0 other_meshes cloud.obj gp3.ply -gp3 0.3
  has gp3.ply '"non_manifold_edges": 0' '"consistently_wound": true'
}

test_streaming_node() {
  exits_with 1 streaming_node
  exits_with 1 streaming_node missing.pcd -o out.ply
  make_frame 3000 first.pcd
  make_frame 4000 last.pcd
  # Time enough: a mesh for each.
  exits_with 0 streaming_node first.pcd last.pcd -period 5000 -o mesh.ply >slow.txt
  expect "a mesh for each cloud" [ "$(grep -c '^cloud' slow.txt)" = 2 ]
  # No time: the last one always gets its mesh, and it is the same.
  exits_with 0 streaming_node first.pcd first.pcd first.pcd last.pcd -period 0 -o fast.ply >fast.txt
  expect "the last cloud's mesh" grep -q '^cloud 4:' fast.txt
  expect "the same mesh" cmp mesh.ply fast.ply
  has fast.ply '"closed": true' '"vertices": 4000'
}

"test_$1"

#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# Part of PclSurfaceRepair: runs the shell commands of a page on a small cloud.
#
# usage: run_commands.sh PAGE.md FOLDER_OF_PROGRAMS SCRATCH_FOLDER [HEADING]
#
# With a heading only the commands below it are run, in a folder that looks as the
# repository does, with clouds and meshes of the names that the README has. There
# scripts/demo.sh builds and fetches nothing, and the viewer opens no window.

set -euo pipefail
here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
. "$here/shapes.sh"
tutorial=$(realpath "$1")
programs=$(realpath "$2")
PATH=$programs:$PATH

# A page names the programs of others that it needs; without them it is skipped.
for needed in $(sed -n 's/^<!-- needs: \(.*\) -->$/\1/p' "$tutorial"); do
  command -v "$needed" >/dev/null || { echo "no $needed"; exit 77; }
done

rm -rf "$3"
mkdir -p "$3"
cd "$3"
make_cloud 3000 bunny_cloud.obj

like_the_repository() {
  mkdir -p scripts build/demo build/release
  ln -s "$programs" build/release/bin
  printf 'cp bunny_cloud.obj build/demo\n' >scripts/demo.sh
  chmod +x scripts/demo.sh
  make_frame 3000 scan.pcd
  make_frame 3000 a.pcd
  make_frame 2500 b.pcd
  pcl_ccaa_reconstruct a.pcd a.ply --quiet
  cp a.ply b.ply
  cp a.ply c.ply
  pcl_repair_viewer() { [[ -f $1 ]]; }
  export -f pcl_repair_viewer
}

[[ -z ${4:-} ]] || like_the_repository
commands=$(awk -v heading="${4:-}" '
  /^## / { elsewhere = heading != "" && $0 != "## " heading }
  /^```$/ { on = 0 }
  on && !elsewhere { print }
  /^```sh$/ { on = 1 }' "$tutorial")
[[ -n $commands ]]
bash -euxo pipefail -c "$commands"

#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# Part of PclSurfaceRepair: renews the pictures under doc/images from the demo's mesh.

set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."

scripts/demo.sh
render=build/release/bin/pcl_render_mesh
mesh=build/demo/bunny.ply
images=doc/images

mkdir -p "$images"
"$render" build/demo/bunny_cloud.obj "$images/bunny_cloud.png" --size 600x480 --point-size 1.5
"$render" "$mesh" "$images/bunny_mesh.png" --size 600x480
"$render" "$mesh" "$images/bunny_detail.png" --size 600x480 --zoom 6 --edges \
  --focus=-0.45,0.45,0.5

# The Bunny in pieces, and what pcl_repair_holes finds in it.
bin=build/release/bin
"$bin/pcl_damage_cloud" "$mesh" build/demo/pieces.ply --slabs 4 --slab-size 0.06 \
  --spheres 4 --sphere-size 0.05 --keep 0.05 --noise 0.3 --seed 7
"$bin/pcl_repair_holes" build/demo/pieces.ply --inspect build/demo/pieces --view 0,0,1 --size 700x460
for name in islands lines slice; do
  cp "build/demo/pieces/$name.png" "$images/inspect_bunny_$name.png"
done

# A real scan, where there is one: it is no part of the repository.
scan=${PSR_SHARED_DATA:-../shared/data}/range_maps/lato000.ply
if [[ -f $scan ]]; then
  "$bin/pcl_repair_holes" "$scan" --inspect build/demo/scan --size 700x460
  cp build/demo/scan/loops.png "$images/inspect_scan_loops.png"
fi

# Repaired real scans: before, force lines, after.
# repair_pictures NAME SCAN "VIEW AND UP" SIZE SIZE_OF_LINES
repair_pictures() {
  local name=$1 scan=$2 size=$4 size_of_lines=$5
  read -ra view <<<"$3"
  [[ -f $scan ]] || return 0
  "$bin/pcl_repair_holes" "$scan" "build/demo/$name.ply" --quiet || (($? == 2))
  "$bin/pcl_repair_holes" "$scan" --inspect "build/demo/$name" "${view[@]}" \
    --size "$size_of_lines" --quiet
  "$render" "$scan" "$images/repair_${name}_before.png" "${view[@]}" --size "$size"
  "$render" "build/demo/$name.ply" "$images/repair_${name}_after.png" "${view[@]}" --size "$size"
  cp "build/demo/$name/lines.png" "$images/repair_${name}_bridges.png"
}
data=${PSR_SHARED_DATA:-../shared/data}
repair_pictures bunny "$data/bunny/bun_zipper.ply" "--view 0,-1,0.3 --view-up 0,0,1" 640x500 860x500
repair_pictures scan "$data/range_maps/lato180.ply" "--view 0,0,1 --view-up 0,1,0" 600x640 860x640

# What free points and k_i (figure F4.8-5) do to a large hole.
head=$data/igea/igea.ply
if [[ -f $head ]]; then
  hole=(--sphere 0.5,0.62,0.95,0.13)
  view=(--view 0.3,0.1,1 --view-up 0,1,0)
  "$bin/pcl_damage_cloud" "$head" build/demo/head_hole.ply "${hole[@]}" --quiet
  "$bin/pcl_damage_cloud" "$head" build/demo/head_points.ply "${hole[@]}" --keep 0.01 --seed 3 --quiet
  "$bin/pcl_repair_holes" build/demo/head_hole.ply build/demo/head_without.ply --quiet
  "$bin/pcl_repair_holes" build/demo/head_points.ply build/demo/head_with.ply --quiet
  for name in hole without with; do
    "$render" "build/demo/head_$name.ply" "$images/free_points_$name.png" "${view[@]}" --size 480x560
  done
  for k in 0 20; do
    "$bin/pcl_repair_holes" build/demo/head_hole.ply --inspect "build/demo/head_$k" \
      --interpolation "$k" "${view[@]}" --size 860x560 --quiet
    cp "build/demo/head_$k/lines.png" "$images/interpolation_$k.png"
  done
fi

# Stages as the viewer shows them.
viewer=$bin/pcl_repair_viewer
if [[ -x $viewer ]]; then
  for stage in filter base; do
    "$viewer" build/demo/bunny_cloud.obj --stage "$stage" --quiet \
      --screenshot "$images/viewer_bunny_$stage.png" --size 560x380
  done
fi
if [[ -x $viewer && -f $data/range_maps/lato180.ply ]]; then
  "$viewer" "$data/range_maps/lato180.ply" --stage holes --quiet \
    --screenshot "$images/viewer_scan_holes.png" --size 640x420
fi

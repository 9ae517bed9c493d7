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

# What the README begins with: some of the points, and beside them what becomes of all.
bin=build/release/bin
"$bin/pcl_ccaa_reconstruct" build/demo/bunny_cloud.obj build/demo/bunny.obj --repair --quiet
{
  grep '^v ' build/demo/bunny.obj
  awk 'NR % 12 == 0 { print "v", $2 - 2.1, $3, $4 }' build/demo/bunny_cloud.obj
  grep '^f ' build/demo/bunny.obj
} >build/demo/first.obj
"$render" build/demo/first.obj "$images/first.png" --size 560x260 --point-size 1.5 --color-by role

# The Bunny in pieces, and what pcl_repair_holes finds in it.
viewer=$bin/pcl_repair_viewer
"$bin/pcl_damage_cloud" "$mesh" build/demo/pieces.ply --slabs 4 --slab-size 0.06 \
  --spheres 4 --sphere-size 0.05 --keep 0.05 --noise 0.3 --seed 7
"$bin/pcl_repair_holes" build/demo/pieces.ply --inspect build/demo/pieces --view 0,0,1 --size 700x460
for name in islands lines slice; do
  cp "build/demo/pieces/$name.png" "$images/inspect_bunny_$name.png"
done

# A knotted tube in pieces, the force lines between them, and what becomes of it.
scripts/make_shape.sh knot >build/demo/knot.xyz
"$bin/pcl_ccaa_reconstruct" build/demo/knot.xyz build/demo/knot.ply --repair --quiet
"$bin/pcl_damage_cloud" build/demo/knot.ply build/demo/knot_cut.ply --slabs 2 --slab-size 0.08 \
  --patches 5 --patch-size 0.012 --spheres 2 --sphere-size 0.05 --seed 4 --quiet
"$bin/pcl_repair_holes" build/demo/knot_cut.ply build/demo/knot_whole.ply --quiet || (($? == 2))
"$bin/pcl_repair_holes" build/demo/knot_cut.ply --inspect build/demo/knot --size 640x560 --quiet
"$render" build/demo/knot_cut.ply "$images/decision_islands.png" --color-by component --size 480x440
cp build/demo/knot/lines.png "$images/decision_lines.png"
"$render" build/demo/knot_whole.ply "$images/decision_result.png" --new-since build/demo/knot_cut.ply \
  --size 480x440

# Real scans, where there are any: they are no part of the repository.
data=${PSR_SHARED_DATA:-../shared/data}
scan=$data/range_maps/lato000.ply
if [[ -f $scan ]]; then
  "$bin/pcl_repair_holes" "$scan" --inspect build/demo/scan --size 700x460
  cp build/demo/scan/loops.png "$images/inspect_scan_loops.png"
fi

# A repaired real scan: before, force lines, after.
scan=$data/bunny/bun_zipper.ply
if [[ -f $scan ]]; then
  view=(--view 0,-1,0.3 --view-up 0,0,1)
  "$bin/pcl_repair_holes" "$scan" build/demo/bunny_scan.ply --quiet
  "$bin/pcl_repair_holes" "$scan" --inspect build/demo/bunny_scan "${view[@]}" --size 860x500 --quiet
  "$render" "$scan" "$images/repair_bunny_before.png" "${view[@]}" --size 640x500
  "$render" build/demo/bunny_scan.ply "$images/repair_bunny_after.png" "${view[@]}" --size 640x500
  cp build/demo/bunny_scan/lines.png "$images/repair_bunny_bridges.png"
fi

# A scene of several objects (Debian package opencv-doc), from where the sensor stood.
scan=$data/rs1_scene/rs1_normals.ply
if [[ -f $scan ]]; then
  view=(--view 0.1,-0.1,1 --view-up 1,0,0)
  "$bin/pcl_repair_holes" "$scan" build/demo/toys.ply --viewpoint 0,0,0 || (($? == 2))
  "$render" "$scan" "$images/repair_toys_before.png" "${view[@]}" --size 600x500
  "$render" build/demo/toys.ply "$images/repair_toys_after.png" "${view[@]}" --size 600x500 \
    --new-since "$scan"
  [[ ! -x $viewer ]] || "$viewer" "$scan" --viewpoint 0,0,0 --stage holes --quiet "${view[@]}" \
    --screenshot "$images/repair_toys_holes.png" --size 760x500
fi

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

# Sixteen scans of a city block in tiles, each a component of its own.
bench=build/bench/bin/bench_tiles
if [[ -x $bench ]]; then
  mkdir -p build/demo/city
  "$bench" make city 400000 build/demo/city
  "$bin/pcl_ccaa_reconstruct" build/demo/city/scan_*.pcd -o build/demo/city/city.ply \
    --merge --tiles=50000 --tile-folder build/demo/city/tiles --quiet
  /usr/bin/python3 scripts/join_shards.py build/demo/city/tiles build/demo/city/shards.ply
  "$render" build/demo/city/shards.ply "$images/tiles_city.png" --color-by component \
    --no-boundaries --view 0.5,-0.7,0.9 --view-up 0,0,1 --size 900x560
fi

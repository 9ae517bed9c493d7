#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# Part of PclSurfaceRepair: from a bare Debian 12 to a repaired real scan and pictures.

set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
# shellcheck source=scripts/script_tools.sh
source scripts/script_tools.sh

demo=build/demo
bin=build/release/bin

scripts/install_dependencies.sh demo
mkdir -p "$demo"
unpack_package glmark2-data build/packages_of_models # the points of the Stanford Bunny
cmake --preset release -DPSR_BUILD_TESTS=OFF
cmake --build --preset release --target apps

grep '^v ' build/packages_of_models/glmark2-data/usr/share/glmark2/models/bunny.obj \
  >"$demo/bunny_cloud.obj"
echo
echo "Meshing $(wc -l <"$demo/bunny_cloud.obj") points of the Stanford Bunny:"
"$bin/pcl_ccaa_reconstruct" "$demo/bunny_cloud.obj" "$demo/bunny.ply" \
  --report "$demo/bunny.json"
echo
"$bin/pcl_mesh_quality" "$demo/bunny.ply"
"$bin/pcl_render_mesh" "$demo/bunny.ply" "$demo/bunny.png"
echo
echo "The same in pieces, without five slabs of its points and triangles:"
"$bin/pcl_damage_cloud" "$demo/bunny.ply" "$demo/pieces.ply" --slabs 5 --slab-size 0.05 \
  --seed 1
"$bin/pcl_render_mesh" "$demo/pieces.ply" "$demo/pieces.png"
echo
echo "Repaired (exit code 2 tells that something was left open):"
"$bin/pcl_repair_holes" "$demo/pieces.ply" "$demo/repaired.ply" --inspect "$demo/lacks" \
  --bridges "$demo/bridges.vtk" --report "$demo/repair.json" || (($? == 2))
"$bin/pcl_mesh_quality" "$demo/repaired.ply"
"$bin/pcl_render_mesh" "$demo/repaired.ply" "$demo/repaired.png"
echo
echo "Scan:     $PWD/$demo/bunny.ply, bunny.png"
echo "Damaged:  $PWD/$demo/pieces.ply, pieces.png"
echo "Repaired: $PWD/$demo/repaired.ply, repaired.png"
echo "On the way: $PWD/$demo/lacks/loops.png, lines.png"
echo "Reports:  $PWD/$demo/bunny.json, repair.json"
echo "Step by step in a window: $bin/pcl_repair_viewer $demo/bunny_cloud.obj"

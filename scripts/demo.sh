#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# Part of PclSurfaceRepair: from a bare Debian 12 to a repaired real scan and pictures.

set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."

demo=build/demo
bin=build/release/bin
scan=$demo/data/usr/share/glmark2/models/bunny.obj

download_package() {
  # As root apt would warn that it cannot download as a user of less rights.
  (cd "$demo/package" &&
    apt-get -qq -o APT::Sandbox::User=root download glmark2-data </dev/null)
}

# The points of the Stanford Bunny come with a Debian package; its content is only
# unpacked here, nothing is installed.
fetch_scan() {
  [[ -f $scan ]] && return
  rm -rf "$demo/package" "$demo/data"
  mkdir -p "$demo/package"
  if ! download_package 2>/dev/null; then
    scripts/install_dependencies.sh --update # apt did not know the package
    download_package
  fi
  dpkg-deb -x "$demo"/package/glmark2-data_*.deb "$demo/data"
}

scripts/install_dependencies.sh demo
mkdir -p "$demo"
fetch_scan
cmake --preset release -DPSR_BUILD_TESTS=OFF
cmake --build --preset release --target apps

grep '^v ' "$scan" >"$demo/bunny_cloud.obj"
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

#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# Part of PclSurfaceRepair: renews the pictures under doc/images/tutorials.
#
# usage: make_tutorial_images.sh [NUMBER...]     (default: all tutorials)
#
# Runs the commands of each tutorial on the demo's Bunny, then takes the pictures. What
# the commands print goes to build/tutorials/NUMBER/log: the figures in the text.

set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
root=$PWD
images=$root/doc/images/tutorials
scans=${PSR_SHARED_DATA:-$root/../shared/data}
PATH=$root/build/release/bin:$PATH

# run_commands NAME: the shell blocks of doc/tutorials/NAME.md, in a folder of their own.
run_commands() {
  local folder=$root/build/tutorials/${1%%_*}
  rm -rf "$folder"
  mkdir -p "$folder"
  cd "$folder"
  cp "$root/build/demo/bunny_cloud.obj" .
  awk '/^```$/ { on = 0 } on { print } /^```sh$/ { on = 1 }' "$root/doc/tutorials/$1.md" \
    >commands
  bash -euxo pipefail commands >log 2>&1 || {
    cat log >&2
    return 1
  }
}

# size=WxH picture NAME MESH OPTIONS...
picture() {
  pcl_render_mesh "$2" "$images/$1.png" --size "${size:-420x360}" "${@:3}"
}

# size=WxH layer=LAYER lines NAME MESH OPTIONS...: the force lines in it, or another layer
# of its inspection.
lines() {
  pcl_repair_holes "$2" --inspect inspected --quiet --size "${size:-520x330}" "${@:3}"
  cp "inspected/${layer:-lines}.png" "$images/$1.png"
}

tutorial_1() {
  run_commands 1_scan_to_mesh
  pcl_ccaa_reconstruct scan.xyz start.ply --until start
  pcl_ccaa_reconstruct scan.xyz filter.ply --until filter
  size=340x310 picture 1_cloud scan.xyz --color-by rgb
  size=340x310 picture 1_start start.ply --no-boundaries
  size=340x310 picture 1_filter filter.ply
  picture 1_mesh scan.ply --color-by role --point-size 4
  picture 1_colours scan.ply --color-by rgb
  local below=(--view 0.2,-1,0.3 --up 0,0,1)
  size=560x340 picture 1_below bunny.ply "${below[@]}"
  size=560x340 picture 1_closed whole.ply "${below[@]}" --new-since bunny.ply
}

[[ -f build/demo/bunny_cloud.obj && -x build/release/bin/scan_to_mesh ]] || {
  scripts/demo.sh
  cmake --preset release
  cmake --build --preset release --target apps scan_to_mesh repair_mesh registered_scans \
    other_meshes
}
mkdir -p "$images"
for number in "${@:-1}"; do
  (tutorial_"$number")
done
find "$images" -name '*.png' -size +150k -exec echo "larger than 150 KB: {}" \;

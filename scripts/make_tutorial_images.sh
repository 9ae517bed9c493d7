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
# shellcheck source=scripts/script_tools.sh
source scripts/script_tools.sh
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

# size=WxH layer=LAYER lines NAME MESH OPTIONS...: the force lines in it, or another layer
# of its inspection.
lines() {
  pcl_repair_holes "$2" --inspect inspected --quiet --size "${size:-520x330}" "${@:3}"
  cp "inspected/${layer:-lines}.png" "$images/$1.png"
}

# window NAME MESH "KEYS" OPTIONS...: the window of the viewer at the stage "boundaries",
# after keys that an X server sends. Needs xvfb-run and xdotool.
window() {
  local shot
  shot=$(basename "${2%.*}")_boundaries.png
  rm -f "$shot"
  # shellcheck disable=SC2016 # for the inner shell
  xvfb-run -a -s '-screen 0 1280x1024x24' bash -euc '
    pcl_repair_viewer "$1" --stage boundaries --quiet "${@:3}" &
    xdotool search --sync --onlyvisible --name "^pcl_repair_viewer" \
      mousemove --window %1 600 300
    xdotool key --delay 200 $2 j
    for _ in {1..300}; do [[ ! -f $0 ]] || break; sleep 0.1; done
    xdotool key q
    wait' "$shot" "$2" "$3" "${@:4}"
  mv "$shot" "$images/$1.png"
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
  local below=(--view 0.2,-1,0.3 --view-up 0,0,1)
  size=560x340 picture 1_below bunny.ply "${below[@]}"
  size=560x340 picture 1_closed whole.ply "${below[@]}" --new-since bunny.ply
}

tutorial_2() {
  run_commands 2_islands
  local name view=(--view 0.2,0,1)
  for name in loops islands lines; do
    size=520x360 layer=$name lines "2_$name" pieces.ply "${view[@]}"
  done
  picture 2_before pieces.ply "${view[@]}"
  picture 2_after repaired.ply "${view[@]}" --new-since pieces.ply
  local toy=$scans/parasaurolophus/parasaurolophus_low_normals2.ply
  [[ -f $toy ]] || return 0
  pcl_repair_holes "$toy" toy.ply --quiet || (($? == 2))
  other_meshes "$toy" filtered.ply
  pcl_repair_holes filtered.ply filtered_toy.ply --quiet || (($? == 2))
  view=(--view=-1,0,0.3 --view-up 0,1,0 --focus=40,10,-655 --zoom 2.2)
  picture 2_scan_before "$toy" "${view[@]}"
  picture 2_scan_after toy.ply "${view[@]}" --new-since "$toy"
  picture 2_scan_filtered filtered_toy.ply "${view[@]}" --new-since filtered.ply
}

tutorial_3() {
  run_commands 3_free_points
  local name trust size=340x300
  local view=(--view 0.8,0.1,1 --focus 0.75,-0.55,0 --zoom 2.6)
  picture 3_hole without.ply "${view[@]}"
  for name in few some more; do
    picture "3_${name}_hole" "$name.ply" "${view[@]}" --color-by role --point-size 4
  done
  for name in without few some more; do
    picture "3_$name" "$name.repaired.ply" "${view[@]}" --new-since "$name.ply"
  done
  for trust in 0 0.1 0.5 0.99; do
    picture "3_trust_$trust" "noisy.$trust.ply" "${view[@]}" --new-since noisy.ply
  done
}

tutorial_4() {
  run_commands 4_pcl_pipeline
  local near=(--zoom 6 --focus=-0.45,0.45,0.5 --edges)
  size=340x300 picture 4_raw raw.ply
  size=300x260 picture 4_raw_near raw.ply "${near[@]}"
  picture 4_mesh mesh.ply
  size=300x260 picture 4_mesh_near mesh.ply "${near[@]}"
  picture 4_patch_2.5 patch_2.5.ply
  picture 4_patch_6 patch_6.ply
  picture 4_front front.ply
  picture 4_back back.ply
}

tutorial_5() {
  run_commands 5_other_meshes
  picture 5_faulty faulty.obj
  picture 5_filtered filtered.ply
  size=340x300 picture 5_raw raw.ply
  picture 5_gp3 gp3.ply
  picture 5_gp3_whole gp3_whole.ply --new-since gp3.ply
  local mask=$scans/holes/holes.ply
  [[ -f $mask ]] || return 0
  other_meshes "$mask" mask.ply >>log
  layer=loops lines 5_loops mask.ply
}

# strip NAME MESH OPTION "VALUES" OPTIONS...: force lines, a picture for each value.
strip() {
  local value
  for value in $4; do
    lines "6_$1_$value" "$2" "$3" "$value" "${@:5}"
  done
}

tutorial_6() {
  run_commands 6_tuning
  local spacing size=460x300
  local above=(--view 0,0,1) aside=(--view 0.2,-1,0.2 --view-up 0,0,1)
  lines 6_default disc.ply "${above[@]}"
  strip room disc.ply --room "1.2 5" "${above[@]}"
  strip chi disc.ply --falloff-exponent "1 6" "${above[@]}"
  strip near disc.ply --near "0.02 0.3" "${above[@]}"
  strip spacing disc.ply --line-spacing "0.08 1" "${above[@]}"
  strip k_i bar.ply --interpolation "0 20" "${above[@]}"
  strip T hole.ply --hole-threshold "0.05 0.15 0.25 0.45" "${above[@]}"
  for spacing in 0.1 0.5; do
    size=360x250 picture "6_bridges_$spacing" "bridges_$spacing.ply" "${above[@]}" \
      --edges --new-since disc.ply --zoom 1.45
  done
  size=460x190
  local samples=(--free-points dome.xyz)
  strip R2 hole.ply --free-point-far "0.05 0.2 0.6" "${samples[@]}" "${aside[@]}"
  samples+=(--free-point-far 0.6)
  strip k_t hole.ply --trust "0 0.5 0.95" "${samples[@]}" "${aside[@]}"
  strip gamma hole.ply --free-point-exponent "0.5 4" "${samples[@]}" "${aside[@]}"
}

tutorial_7() {
  run_commands 7_decisions
  local size=460x320 view=(--view 0,0,1)
  picture 7_scene scene.ply "${view[@]}"
  picture 7_aside scene.ply --view 1,0.3,1
  picture 7_repaired repaired.ply "${view[@]}" --new-since scene.ply
  picture 7_decided decided.ply "${view[@]}" --new-since scene.ply
  pcl_repair_viewer scene.ply --stage holes --quiet --screenshot "$images/7_holes.png" \
    --size 560x380 "${view[@]}"
  local next=period
  view+=(--size 640x470)
  window 7_window scene.ply "h" "${view[@]}"
  # The hole on the flank is closed, then the strip joined.
  window 7_result scene.ply "h $(printf "$next %.0s" {1..8}) a $(printf "$next %.0s" {1..6}) v" \
    "${view[@]}"
}

tutorial_9() {
  run_commands 9_bad_data
  local name size=280x240 near=(--zoom 2 --focus=-0.4,0.5,0.4)
  size=300x260 picture 9_strays strays.ply --color-by role --point-size 2
  picture 9_strays_whole strays_whole.ply --color-by none --zoom 1.5
  for name in noisy clean finer; do
    picture "9_$name" "$name.ply"
  done
  for name in double single wound.obj rewound fins.obj without_fins; do
    [[ $name == *.obj ]] || name=$name.ply
    picture "9_${name%.*}" "$name" "${near[@]}"
  done
  picture 9_uneven_points uneven.xyz
  picture 9_uneven uneven.ply
}

[[ -f build/demo/bunny_cloud.obj && -x build/release/bin/scan_to_mesh ]] || {
  scripts/demo.sh
  cmake --build --preset release --target examples
}
mkdir -p "$images"
(($# > 0)) || set -- 1 2 3 4 5 6 7 9
for number; do
  (tutorial_"$number")
done
find "$images" -name '*.png' -size +150k -exec echo "larger than 150 KB: {}" \;

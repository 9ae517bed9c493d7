#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# Part of PclSurfaceRepair: makes doc/gallery.md and its pictures, from shapes that
# scripts/make_shape.sh generates and models of Debian packages.
#
# usage: make_gallery.sh [--check] [FOLDER_OF_PROGRAMS]    (default: build/release/bin)
#
# --check runs the commands on the generated shapes only, without pictures, and fails where
# one ends otherwise than the page says: complete or incomplete. Takes two minutes, the
# check ten seconds.

set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
# shellcheck source=scripts/script_tools.sh
source scripts/script_tools.sh

check=''
if [[ ${1:-} == --check ]]; then
  check=yes
  shift
fi
PATH=$(realpath "${1:-build/release/bin}"):$PWD/scripts:$PATH
page=$PWD/doc/gallery.md
images=$PWD/doc/images/gallery
work=$PWD/build/gallery$check
size=270x220
failed=0

# models PACKAGE FOLDER FILE...: files of a Debian package go to the folder of the work.
models() {
  unpack_package "$1" build/packages_of_models
  local folder=build/packages_of_models/$1/$2
  if [[ $folder == *.tar.gz ]]; then
    tar -xzf "$folder" -C "$work" --strip-components 2 "${@:3}"
  else
    (cd "$folder" && cp "${@:3}" "$work")
  fi
}

# run COMMANDS: each with the last line of what it prints.
run() {
  local line
  while IFS= read -r line; do
    printf '$ %s\n' "$line"
    (cd "$work" && { eval "$line" || (($? == 2)); }) 2>/dev/null </dev/null | tail -n 1
  done <<<"$1"
}

# Whether "$1", the result of run, ends as the page says below the heading "$2".
agrees() {
  local said
  said=$(awk -v title="## $2" '$0 == title { on = 1; next } /^## / { on = 0 } on' "$page")
  diff <(grep -oE '^(\$ .*|complete|incomplete)' <<<"$said") \
    <(grep -oE '^(\$ .*|complete|incomplete)' <<<"$1") || {
    echo "$page: '$2' is out of date: run scripts/make_gallery.sh" >&2
    failed=1
  }
}

# view=(...) since=MESH entry NAME "TITLE" BEFORE AFTER "COMMANDS" "WHAT IS HARD IN IT"
# With `since` what is new in AFTER is green.
entry() {
  local name=$1 title=$2 before=$3 after=$4 commands=$5 hard=$6 result
  [[ -z $check || $commands == make_shape.sh* ]] || return 0
  result=$(run "$commands")
  if [[ -n $check ]]; then
    agrees "$result" "$title"
    return
  fi
  picture "${name}_before" "$work/$before" "${view[@]}" --point-size 1.5 --quiet
  picture "${name}_after" "$work/$after" "${view[@]}" --quiet ${since:+--new-since "$work/$since"}
  cat <<END >&3

## $title

$hard

| before | after |
|---|---|
| ![before](images/gallery/${name}_before.png) | ![after](images/gallery/${name}_after.png) |

\`\`\`text
$result
\`\`\`
END
}

generated() {
  view=(--view 0.3,0.3,1)
  since=body.ply entry body "A body in three pieces" body.ply whole.ply \
    "make_shape.sh body >body.xyz
pcl_ccaa_reconstruct body.xyz body.ply
pcl_repair_holes body.ply whole.ply" \
    "Two cuts go all round the body, so no piece has a hole of its own: the rims have to find each
other. Bridges along force lines join them, and what is left between the bridges is closed."

  view=(--view 0.3,0.6,1)
  size=230x190 entry layers "Two scans, badly registered" as_it_is.ply one_layer.ply \
    "make_shape.sh layers >layers.xyz
pcl_ccaa_reconstruct layers.xyz as_it_is.ply
pcl_ccaa_reconstruct layers.xyz one_layer.ply --clean --repair" \
    "The second scan is off by a little more than the points are apart, and both are noisy. Triangles
are woven between the layers, with handles that are not there; \`--clean\` makes one layer first, of
new points."

  view=(--view 0,0,1)
  size=230x190 entry knot "A knot" knot.xyz knot.ply \
    "make_shape.sh knot >knot.xyz
pcl_ccaa_reconstruct knot.xyz knot.ply" \
    "The strands pass close to each other and must not be joined; and only the inside of the tube
tells which side is out."

  view=(--view 0.5,1,0.6 --view-up 0,1,0)
  entry roll "A rolled sheet" roll.xyz roll.ply \
    "make_shape.sh roll >roll.xyz
pcl_ccaa_reconstruct roll.xyz roll.ply" \
    "Each layer has another one five spacings behind it. The border of the sheet is no hole, and stays
open."

  view=(--view 0.3,0.3,1)
  since=cube.ply entry cube "Limit: a corner that nobody has seen" cube.ply whole_cube.ply \
    "make_shape.sh cube >cube.xyz
pcl_ccaa_reconstruct cube.xyz cube.ply
pcl_repair_holes cube.ply whole_cube.ply" \
    "The edges of the cube lead to a corner, and a person would put it there. The repair closes the hole
smoothly, with a rounded corner: nothing was measured there, and the verdict knows of no lack."

  view=(--view 0.3,-0.8,1.2 --view-up 0,0,1 --zoom 4)
  size=190x160 entry wall "Limit: a wall thinner than its points are far apart" wall.xyz wall.ply \
    "make_shape.sh wall >wall.xyz
pcl_ccaa_reconstruct wall.xyz wall.ply" \
    "Both sides of a wall, half a spacing apart. Nothing in the points says which of them belong to
which side: the two are woven together, with tunnels that are not there, and in part it looks inside
out. The verdict doubts it. Measure such walls more densely, or mesh one side at a time; from one
spacing on it goes well."

  view=(--view 0.3,0.3,1)
  entry moebius "Limit: a surface with one side" moebius.xyz moebius.ply \
    "make_shape.sh moebius >moebius.xyz
pcl_ccaa_reconstruct moebius.xyz moebius.ply" \
    "All triangles are right, but no winding of them can be: somewhere front meets back, which the
verdict calls a fault. Back faces are orange."
}

from_packages() {
  models glmark2-data usr/share/glmark2/models bunny.obj
  models opencv-doc usr/share/doc/opencv-doc/examples/surface_matching/data \
    rs1_normals.ply parasaurolophus_low_normals2.ply
  models libcgal-demo usr/share/doc/libcgal-dev/data.tar.gz data/points_3/{kitten.xyz,radar.xyz} \
    data/points_3/{hippo1.ply,b9_training.ply} data/meshes/{elephant-with-holes,lion}.off

  view=(--view 0.2,-1,0.3 --view-up 0,0,1)
  since=bunny.ply entry bunny "The Bunny from below" bunny.ply \
    whole_bunny.ply "pcl_ccaa_reconstruct bunny.obj bunny.ply
pcl_repair_holes bunny.ply whole_bunny.ply" \
    "Scans have not seen all of the base (package \`glmark2-data\`). The surface there is a guess,
and stays flat as its surroundings are."

  view=(--view 0,0,1)
  entry kitten "A kitten of few points" kitten.xyz kitten.ply \
    "pcl_ccaa_reconstruct kitten.xyz kitten.ply" \
    "5210 points for all of it, ears and tail included (package \`libcgal-demo\`). The tail touches the
body without being one with it, which makes the one handle that the summary tells."

  view=(--view 0,0,1)
  entry hippo "One view of a hippopotamus" hippo1.ply hippo.ply \
    "pcl_ccaa_reconstruct hippo1.ply hippo.ply --repair" \
    "Everything was seen from the front only, and the legs behind are islands of their own (package
\`libcgal-demo\`). That two of them belong together may be likely, but nothing says so: all pieces
stay apart, which is right for one view."

  view=(--view 0.1,-0.1,1 --view-up 1,0,0)
  since=rs1_normals.ply entry toys "Four toys, one view" rs1_normals.ply \
    toys.ply "pcl_repair_holes rs1_normals.ply toys.ply --viewpoint 0,0,0" \
    "Behind each silhouette another toy begins (package \`opencv-doc\`). The place of the sensor tells
what may be a hole, so that no toys are glued together; what is in doubt is left open, and the
verdict counts it."

  view=(--view=-1,0,0.3 --view-up 0,1,0)
  since=parasaurolophus_low_normals2.ply entry dinosaur \
    "A dinosaur of many scans" parasaurolophus_low_normals2.ply dinosaur.ply \
    "pcl_repair_holes parasaurolophus_low_normals2.ply dinosaur.ply" \
    "33 pieces with 114 openings where the scans did not meet (package \`opencv-doc\`). Most are closed or
joined; a few crumbs, and places where the surface runs through its own boundary, are left to you."

  view=(--view 0,0,1)
  since=lion.off entry lion "The head of a lion" lion.off lion.ply \
    "pcl_repair_holes lion.off lion.ply" \
    "Eyes and mouth are holes, the neck is where the model ends (package \`libcgal-demo\`). The rim of the
neck might be either; the verdict says that it is for you to tell, with \`--close all\` or a decision."

  view=(--view 0,0,1)
  since=elephant-with-holes.off entry elephant "Limit: more holes than elephant" \
    elephant-with-holes.off elephant.ply "pcl_repair_holes elephant-with-holes.off elephant.ply" \
    "106 holes among 2500 points, up to the tip of the trunk (package \`libcgal-demo\`). Six of them would
be closed only by a patch that runs through the surface, and stay open; and so much is new that the
verdict doubts the whole."

  view=(--view 0,0,1)
  entry ball "Limit: a scan of a few parts" radar.xyz radar.ply \
    "pcl_ccaa_reconstruct radar.xyz radar.ply --repair" \
    "A radar dome, scanned from the ground in uneven swaths (package \`libcgal-demo\`). The gaps are closed
by the shape around them, well for most of a ball; a hem at the left shows where it was too little."

  view=(--view 0,0,1)
  size=230x190 entry aerial "Limit: a town from the air" b9_training.ply b9.ply \
    "pcl_ccaa_reconstruct b9_training.ply b9.ply --repair --up 0,0,1" \
    "An aeroplane sees roofs and streets, but hardly a wall, and trees as noise (package
\`libcgal-demo\`). Walls are closed where they are short; handles and openings stay among the trees."
}

mkdir -p "$work" "$images"
view=()
since=''
if [[ -n $check ]]; then
  generated
  exit "$failed"
fi
exec 3>"$work/page.md"
cat <<'END' >&3
# Gallery

Made by `scripts/make_gallery.sh`: seven shapes that `scripts/make_shape.sh` generates, and models
of Debian packages, which the script unpacks and does not install. Each entry has the commands and
the verdict that they end with. Red lines are boundaries, back faces are orange, what a repair has
added is green. Where we fall short the heading says *limit*; what other methods do with such clouds
is in [the comparison](comparison.md), what to do about bad data in
[tutorial 9](tutorials/9_bad_data.md).
END
generated
from_packages
exec 3>&-
mv "$work/page.md" "$page"
find "$images" -name '*.png' -size +60k -exec echo "larger than 60 KB: {}" \;
du -bc "$images"/*.png | tail -n 1

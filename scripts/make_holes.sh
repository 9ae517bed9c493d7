#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# Part of PclSurfaceRepair: makes doc/comparison_holes.md and its pictures.
#
# usage: make_holes.sh     (a minute; CGAL and MeshLab only where they are installed)

set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."

page=doc/comparison_holes.md
images=doc/images/comparison
work=build/holes
bin=build/release/bin

cmake --preset release -DPSR_BUILD_BENCHMARKS=ON
cmake --build --preset release --target bench_holes pcl_render_mesh
rm -rf "$work"
mkdir -p "$work" "$images"
"$bin/bench_holes" write "$work"

cat >"$work/close.mlx" <<'END'
<!DOCTYPE FilterScript>
<FilterScript>
 <filter name="Close Holes">
  <Param type="RichInt" name="MaxHoleSize" value="100000"/>
  <Param type="RichBool" name="Selected" value="false"/>
  <Param type="RichBool" name="NewFaceSelected" value="false"/>
  <Param type="RichBool" name="SelfIntersection" value="false"/>
 </filter>
</FilterScript>
END
if command -v meshlabserver >/dev/null; then
  for mesh in "$work"/*.ply; do
    xvfb-run -a meshlabserver -i "$mesh" -o "${mesh%.ply}.MeshLab.ply" -s "$work/close.mlx" \
      >"$work/meshlab.log" 2>&1
  done
fi
"$bin/bench_holes" compare "$work" MeshLab >"$work/tables.md"
for row in "$work"/*.row.ply; do
  name=$(basename "$row" .row.ply)
  "$bin/pcl_render_mesh" "$row" "$images/filling_$name.png" --size 800x160 --quiet
done

{
  cat <<'END'
# Which filling when

Made by `scripts/make_holes.sh`: seven meshes that are generated and damaged, so that the true
surface is known, and what each method makes of them in the same run.

| your holes | take | because |
|---|---|---|
| small, in a smooth surface | ours, CGAL | both are as dense and smooth as what is around |
| large, in a curved body | ours or CGAL | the surface goes on as it came; MeshLab and VTK lay a lid on it |
| a corner or an edge is missing | CGAL | it comes nearest to the corner; ours lays a flat cut over a plane rim that is met steeply, as the others do, and rounds it with `--cap smooth`; none makes an edge |
| with an island in the hole, or in pieces | ours | the others close each loop by itself: the island gets a lid of its own, inside the surface |
| in an open surface, whose border must stay | ours; MeshLab with a size that fits | the others know no border, and close it, too |
| in a mesh that must not get more points | MeshLab, VTK, CGAL's plain triangulation, ours with `--no-refine` | no new vertices |
| one hole after the other, by hand | MeshLab, or `pcl_repair_viewer` | a window |

The methods: ours with its defaults; CGAL 5.5 `triangulate_refine_and_fair_hole()` of each loop; VTK
9.1 `vtkFillHolesFilter` for holes of any size, which does not care for the winding of its triangles
(*faulty edges*); MeshLab 2020.09 *Close Holes* for holes of any size, without its test for
intersections, which leaves more of them open. MeshFix is in no package of Debian 12,
and not in this run.

How to read the tables: *loops* are openings, *handles* those of all pieces (-: no manifold); *faulty
edges* have more than two triangles, or two that are wound differently; *crossings* are pairs of
triangles; *too much* is the mean distance of the mesh from the true surface, *missing* of this from
the mesh, in mean edges. Pictures, from left to right: the damaged mesh, and the methods in the order
of the table. Boundaries are red, back faces orange, edges of three or more triangles magenta.
END
  while IFS= read -r line; do
    printf '%s\n' "$line"
    if [[ $line == '## '* ]]; then
      name=${line#'## '}
      name=${name%%:*}
      printf '\n![%s](images/comparison/filling_%s.png)\n' "$name" "${name// /_}"
    fi
  done <"$work/tables.md"
} >"$page"

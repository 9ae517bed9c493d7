#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# Part of PclSurfaceRepair: renews tables and pictures of doc/comparison.md.
#
# usage: make_comparison.sh            (five minutes; CGAL and Open3D only where they are installed)

set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."

page=doc/comparison.md
images=doc/images/comparison
work=build/comparison
bin=build/release/bin

cmake --preset release -DPSR_BUILD_BENCHMARKS=ON
cmake --build --preset release --target bench_methods pcl_render_mesh
mkdir -p "$work" "$images"
# PCL's Poisson tells of its troubles on both streams, whatever it is told.
taskset -c 0 "$bin/bench_methods" "$work" 2>/dev/null | grep -v '^Vertex pair not in list' \
  >"$work/tables.md"
for row in "$work"/*.ply; do
  "$bin/pcl_render_mesh" "$row" "$images/$(basename "$row" .ply).png" --size 1000x128 \
    --color-by role --point-size 1 --quiet
done

# All above the mark is written by hand. Each table gets its picture.
mark='<!-- from here on made by scripts/make_comparison.sh -->'
{
  sed "\|^$mark\$|q" "$page"
  while IFS= read -r line; do
    printf '%s\n' "$line"
    if [[ $line == '## '* ]]; then
      name=${line#'## '}
      name=${name%%:*}
      printf '\n![%s](images/comparison/%s.png)\n' "$name" "${name// /_}"
    fi
  done <"$work/tables.md"
} >"$work/page.md"
mv "$work/page.md" "$page"

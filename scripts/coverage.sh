#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# Part of PclSurfaceRepair: builds the coverage preset, runs the tests, and tells which
# lines of the two modules they ran. Fails below the share that is asked for.
#
# usage: coverage.sh [PERCENT]     (default: 90)

set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
wanted=${1:-90}
build=build/coverage
report=$build/profiles

scripts/install_dependencies.sh test
rm -rf "$report"
cmake --preset coverage
cmake --build --preset coverage
ctest --preset coverage -j "$(nproc)"

profiles=("$report"/*.profraw)
llvm-profdata merge -sparse "${profiles[@]}" -o "$report/all.profdata"

# Templates are compiled into the tests as well as into the libraries.
objects=()
for object in "$build"/lib/*.so "$build"/test/test_*; do
  [[ -f $object && -x $object ]] && objects+=(-object "$object")
done
look=("${objects[@]:1}" -instr-profile "$report/all.profdata")

llvm-cov show -format=html -output-dir="$build/html" "${look[@]}" \
  surface_ccaa surface_repair >/dev/null
good=true
for module in surface_ccaa surface_repair; do
  # The last row has the sums; its eighth column are lines, its ninth those not run.
  llvm-cov report "${look[@]}" "$module" | awk -v module="$module" -v wanted="$wanted" '
    $1 == "TOTAL" { lines = $8; run = $8 - $9 }
    END {
      share = lines > 0 ? 100 * run / lines : 0
      printf "%s: %.1f %% of %d lines\n", module, share, lines
      exit share < wanted
    }' || good=false
done
echo "Line by line: $PWD/$build/html/index.html"
if ! $good; then
  echo "coverage.sh: less than $wanted % of the lines" >&2
  exit 1
fi

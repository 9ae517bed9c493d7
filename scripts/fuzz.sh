#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# Part of PclSurfaceRepair: runs the fuzz targets for long, built by the
# asan-ubsan preset. Starts from the seeds and from what earlier runs have found.
#
# usage: fuzz.sh RUNS [TARGET...]     (default: all targets, one after the other)

set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
runs=${1:?usage: fuzz.sh RUNS [TARGET...]}
shift
targets=("$@")
if ((${#targets[@]} == 0)); then
  targets=(mesh_file cloud_file filter reconstruction repair)
fi

cmake --preset asan-ubsan >/dev/null
cmake --build --preset asan-ubsan --target "${targets[@]/#/fuzz_}"
work=build/asan-ubsan/test/fuzz
export LSAN_OPTIONS=suppressions=$PWD/test/fuzz/leaks.txt
for target in "${targets[@]}"; do
  mkdir -p "$work/$target"
  words=()
  [[ -f test/fuzz/$target.dict ]] && words=("-dict=test/fuzz/$target.dict")
  echo "$target: $runs inputs"
  if build/asan-ubsan/test/"fuzz_$target" "$work/$target" "test/fuzz/corpus/$target" \
    -runs="$runs" -max_len=4096 -timeout=300 -rss_limit_mb=3000 -print_final_stats=1 \
    "-artifact_prefix=$work/" "${words[@]}" >"$work/$target.log" 2>&1; then
    grep -E '^(Done|stat::(number|average|peak))' "$work/$target.log"
  else
    tail -n 40 "$work/$target.log" >&2
    echo "fuzz.sh: $target has a finding; the input is in $work" >&2
    exit 1
  fi
done

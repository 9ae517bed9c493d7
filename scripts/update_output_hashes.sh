#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# Part of PclSurfaceRepair: renews test/regression/output_hashes.csv with the programs of
# the release preset. Rows whose input is missing keep their hash.

set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."

table=test/regression/output_hashes.csv
renewed=$(mktemp)
trap 'rm -f "$renewed"' EXIT

while IFS= read -r row; do
  if [[ $row == \#* ]]; then
    echo "$row"
    continue
  fi
  IFS=, read -r name input damage program options hash <<<"$row"
  path=${input/#test\//$PWD/test/data/}
  path=${path/#shared\//$PWD/../shared/data/}
  answer=$(cmake -D "NAME=$name" -D "INPUT=$path" -D "DAMAGE=$damage" -D "PROGRAM=$program" \
    -D "OPTIONS=$options" -D "APPS_DIR=$PWD/build/release/bin" \
    -D "SCRATCH=$PWD/build/release/test/regression" \
    -P test/regression/check_output_hash.cmake 2>&1 </dev/null)
  if [[ $answer =~ ^[0-9a-f]{64}$ ]]; then
    [[ $answer == "$hash" ]] || echo "changed: $name" >&2
    hash=$answer
  else
    echo "$answer" >&2
  fi
  echo "$name,$input,$damage,$program,$options,$hash"
done <"$table" >"$renewed"
cp "$renewed" "$table"

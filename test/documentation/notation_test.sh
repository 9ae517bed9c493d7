#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# Part of PclSurfaceRepair: the page of the notation knows the code, and the code knows
# the page.
#
# usage: notation_test.sh names|tags FOLDER

set -euo pipefail
check=$1
cd "$2"
page=doc/notation.md
failed=0

code() {
  find surface_ccaa surface_repair apps -name '*.h' -o -name '*.hpp' -o -name '*.cpp'
}

# The words of all code, once.
words() {
  code | xargs grep -ohE '[A-Za-z_][A-Za-z0-9_]*' | sort -u
}

case $check in
  names)
    # Whatever the page shows as code is a word of the code; of A::b both are.
    missing=$(comm -23 <(grep -v '^|---' "$page" | grep -oE '`[^`]+`' |
      grep -oE '[A-Za-z_][A-Za-z0-9_]+' | sort -u) <(words))
    ;;
  tags)
    # Numbers of equations, definitions, conditions, tables and lemmas of the method.
    tag='\b(E|EC|ED|D|C|T|L)[34]\.[0-9]+-[0-9]+\b'
    missing=$(comm -23 <(code | xargs grep -ohE "$tag" | sort -u) \
      <(grep -oE "$tag" "$page" | sort -u))
    missing+=$(comm -23 <(grep -ohE "$tag" "$page" doc/concepts/*.md | sort -u) \
      <(code | xargs grep -ohE "$tag" | sort -u))
    ;;
esac
if [[ -n $missing ]]; then
  echo "$page and the code do not agree on:" "${missing//$'\n'/ }" >&2
  failed=1
fi
exit "$failed"

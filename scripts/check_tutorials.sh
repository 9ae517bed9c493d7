#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# Part of PclSurfaceRepair: shows that the code in tutorials is that of the examples.
#
# usage: check_tutorials.sh [--fix]     (default: report and fail)
#
# Each C++ block of a tutorial follows a line <!-- SOURCE.cpp: REGION --> and holds the
# lines of doc/examples/SOURCE.cpp between two lines //! [REGION]. --fix puts them in.
# Links to files of this repository must lead somewhere.

set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."

# The tutorial $1 as it should be.
expected() {
  awk '
    # The lines of a region without the indent of the first one.
    function region(file, name,    line, inside, indent, lines) {
      while ((getline line < file) > 0) {
        if (line ~ /^ *\/\/! \[.*\]$/) {
          if (index(line, "[" name "]"))
            inside = !inside
          continue
        }
        if (!inside)
          continue
        if (lines++ == 0) {
          match(line, /^ */)
          indent = RLENGTH
        }
        print substr(line, 1, indent) ~ /^ *$/ ? substr(line, indent + 1) : line
      }
      close(file)
      if (lines == 0 || inside)
        print "no region [" name "] in " file
    }
    /^<!-- .*\.cpp: .* -->$/ {
      source = $0
      sub(/^<!-- /, "", source)
      sub(/ -->$/, "", source)
    }
    skipping && /^```$/ { skipping = 0 }
    !skipping { print }
    /^```cpp$/ {
      split(source, part, ": ")
      source == "" ? missing() : region("doc/examples/" part[1], part[2])
      source = ""
      skipping = 1
    }
    function missing() { print "no line <!-- SOURCE.cpp: REGION --> before this block" }
  ' "$1"
}

# Links of the file $1, but for code, that lead nowhere.
broken_links() {
  awk '/^```/ { code = !code } !code' "$1" | grep -oE '\]\([^)]+\)' | sed -E 's/^\]\(//; s/\)$//; s/#.*//' | sort -u |
    while read -r link; do
      [[ -z $link || $link == *://* || -e $(dirname "$1")/$link ]] || echo "$1: no $link"
    done
}

failed=0
for tutorial in doc/tutorials/*.md; do
  if [[ ${1:-} == --fix ]]; then
    fixed=$(expected "$tutorial")
    printf '%s\n' "$fixed" >"$tutorial"
  fi
  diff --label "$tutorial" --label "doc/examples" -u "$tutorial" <(expected "$tutorial") ||
    failed=1
  broken=$(broken_links "$tutorial")
  [[ -z $broken ]] || { echo "$broken"; failed=1; }
done
exit $failed

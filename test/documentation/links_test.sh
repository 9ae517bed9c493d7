#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# Part of PclSurfaceRepair: every relative link in the pages leads to a file that exists,
# and to a heading of it where it names one.
#
# usage: links_test.sh FOLDER

set -euo pipefail
cd "$1"

# Text of a page without what is shown as code.
prose() {
  sed -e '/^ *```/,/^ *```/d' -e 's/`[^`]*`//g' "$1"
}

# Names of its headings, as repositories on the web give them.
headings() {
  sed '/^ *```/,/^ *```/d' "$1" | sed -n 's/^#\+ \+//p' |
    tr '[:upper:]' '[:lower:]' | sed -e 's/[^a-z0-9 _-]//g' -e 's/ /-/g'
}

failed=0
complain() {
  echo "$1" >&2
  failed=1
}

pages=0
links=0
while IFS= read -r page; do
  pages=$((pages + 1))
  while IFS= read -r target; do
    links=$((links + 1))
    file=${target%%#*}
    place=$(dirname "$page")/$file
    [[ -n $file ]] || place=$page
    if [[ ! -e $place ]]; then
      complain "$page: no $target"
    elif [[ $target == *#* ]] && ! headings "$place" | grep -x -- "${target#*#}" >/dev/null; then
      complain "$page: no heading $target"
    fi
  done < <(prose "$page" | grep -oE '\]\([^) ]+\)' | sed -E 's/^\]\((.*)\)$/\1/' |
    grep -vE '^[a-z]+:' || true)
done < <(find . -name '*.md' -not -path './build*' -not -path './.*/*')
echo "$links links on $pages pages"
((pages > 0 && links > 0)) || complain "nothing was looked at"
exit "$failed"

#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# Part of PclSurfaceRepair: rooms of the programs include only what the table of the
# layout lets them use.
#
# usage: rooms_test.sh FOLDER

set -euo pipefail
cd "$1"
page=doc/decisions/0001-layout.md
failed=0

rooms=$(find apps -mindepth 2 -name '*.h' -printf '%h\n' | sed 's/^apps.//' | sort -u)
above=""
while IFS='|' read -r _ room _ uses _; do
  room=$(tr -d ' `' <<<"$room")
  for used in $(tr -d '`' <<<"$uses"); do
    if [[ " $above " != *" $used "* ]]; then
      echo "$page: '$room' uses '$used', which does not stand above it" >&2
      failed=1
    fi
  done
  included=$(cat "apps/$room"/* | sed -nE "s/^#include \"(${rooms//$'\n'/|})\/.*/\1/p" |
    sort -u)
  for used in $included; do
    if [[ $used != "$room" && " $(tr -d '`' <<<"$uses") " != *" $used "* ]]; then
      echo "apps/$room includes $used/, which $page does not let it use" >&2
      failed=1
    fi
  done
  above+=" $room"
done < <(grep -E '^\| `[a-z]+` \|' "$page")
if [[ $(tr ' ' '\n' <<<"$above" | sed '/^$/d' | sort) != "$rooms" ]]; then
  echo "$page does not tell of these rooms and no others:" "${rooms//$'\n'/ }" >&2
  failed=1
fi
exit "$failed"

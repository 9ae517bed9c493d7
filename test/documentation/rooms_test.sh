#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# Part of PclSurfaceRepair: rooms include only what the architecture page lets them use.
#
# usage: rooms_test.sh FOLDER

set -euo pipefail
cd "$1"
page=doc/architecture.md
failed=0

folders=$(find surface_ccaa/src surface_repair/src apps -mindepth 1 -maxdepth 1 -type d)
rooms=$(sed 's/.*\///' <<<"$folders" | sort)
above=""
while IFS='|' read -r _ room _ _ uses _; do
  room=$(tr -d ' `' <<<"$room")
  uses=$(tr -d '`' <<<"$uses")
  for used in $uses; do
    if [[ " $above " != *" $used "* ]]; then
      echo "$page: '$room' uses '$used', which does not stand above it" >&2
      failed=1
    fi
  done
  above+=" $room"
  folder=$(grep -E "/$room\$" <<<"$folders" || true)
  if [[ -z $folder ]]; then
    continue
  fi
  included=$(find "$folder" -type f -exec cat {} + |
    sed -nE "s/^#include \"(${rooms//$'\n'/|})\/.*/\1/p" | sort -u)
  for used in $included; do
    if [[ $used != "$room" && " $uses " != *" $used "* ]]; then
      echo "$folder includes $used/, which $page does not let it use" >&2
      failed=1
    fi
  done
done < <(grep -E '^\| `[a-z_]+` \|' "$page")
if [[ $(tr ' ' '\n' <<<"$above" | sed '/^$/d' | sort) != "$rooms" ]]; then
  echo "$page does not tell of these rooms and no others:" "${rooms//$'\n'/ }" >&2
  failed=1
fi
exit "$failed"

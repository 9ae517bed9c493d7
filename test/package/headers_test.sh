#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# Part of PclSurfaceRepair: what is installed is what users call, and stands by itself.
#
# usage: headers_test.sh list|closed|alone INCLUDE_FOLDER
#   list    the installed headers are those of installed_headers.txt, beside this file
#   closed  none of them includes a header that is not installed
#   alone   each that a user includes compiles by itself, with the flags of pkg-config;
#           CXX is the compiler

set -euo pipefail
check=$1
list="$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)/installed_headers.txt"
cd "$2"

installed() {
  find pcl/surface_ccaa pcl/surface_repair -type f | LC_ALL=C sort
}

case $check in
  list)
    diff --label "$list" --label installed -u "$list" <(installed)
    ;;
  closed)
    failed=0
    # Headers next to sources are included with quotes.
    if installed | xargs grep -n '#include "'; then
      failed=1
    fi
    while read -r header; do
      if [[ ! -e $header ]]; then
        echo "$header is included, but not installed" >&2
        failed=1
      fi
    done < <(installed | xargs sed -nE 's%^#include <(pcl/surface_(ccaa|repair)/.*)>%\1%p' |
      sort -u)
    exit "$failed"
    ;;
  alone)
    read -ra flags <<<"$(pkg-config --cflags pcl_surface_repair)"
    # In the shell that xargs starts.
    # shellcheck disable=SC2016
    installed | grep -v /impl/ | xargs -P "$(nproc)" -I '{}' bash -c \
      'echo "#include <$0>" | "$@" -x c++ -fsyntax-only - || { echo "$0" >&2; exit 255; }' \
      '{}' "${CXX:-c++}" -std=c++17 "${flags[@]}"
    ;;
esac

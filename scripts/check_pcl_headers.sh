#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# Part of PclSurfaceRepair: checks our sources against the headers of another version of
# PCL: compiles without making code, with the use of anything deprecated as an error.
#
# usage: check_pcl_headers.sh INCLUDE_FOLDER [PATTERN]
#   INCLUDE_FOLDER  that which holds pcl/pcl_config.h of the other version, as of a
#                   package libpcl-dev that was unpacked, or an installation of PCL
#   PATTERN         only sources whose path matches this expression; without it those that
#                   name a header of PCL's own, and users' programs of test/consumer
#
# Needs build/release configured (cmake --preset release), for what else the sources
# include. COMPILER=clang++ takes another compiler; JOBS the number of processes.

set -euo pipefail
headers=$(cd "$1" && pwd)
pattern=${2:-}
cd "$(dirname "${BASH_SOURCE[0]}")/.."
commands=build/release/compile_commands.json
export COMPILER=${COMPILER:-c++}

version=$(sed -nE 's/^#define PCL_VERSION_PRETTY "(.*)"/\1/p' "$headers/pcl/pcl_config.h")
echo "PCL $version in $headers"

# "source<tab>flags" of what is compiled: its include folders and definitions, PCL's
# replaced; no precompiled headers, which hold the system's PCL.
jobs_to_do() {
  sed -nE 's/^ *"(command|file)": "(.*)",?$/\1\t\2/p' "$commands" | sed 's/\\*"/"/g' |
    awk -F'\t' -v new="$headers" '
      $1 == "command" { command = $2; next }
      {
        n = split(command, words, " ")
        flags = ""
        for (i = 2; i <= n; ++i) {
          word = words[i]
          if (word ~ /^-[ID]/) flags = flags " " word
          if (word == "-isystem") {
            folder = words[++i]
            if (folder ~ /\/pcl-[0-9.]+$/) folder = new
            flags = flags " -isystem " folder
          }
        }
        print $2 "\t" flags
      }'
}

# check SOURCE FLAGS
check() {
  local flags log
  read -ra flags <<<"$2"
  log=$(mktemp -p "$work")
  "$COMPILER" -std=c++17 -fsyntax-only -fopenmp -Wall -Wextra \
    -Werror=deprecated-declarations "${flags[@]}" "$1" >"$log" 2>&1 || {
    echo "FAILED: $1"
    cat "$log"
    return 1
  }
}
export -f check
work=$(mktemp -d)
export work
trap 'rm -rf "$work"' EXIT

# Whether a source includes PCL beside our own part of its folders.
names_pcl() {
  awk '/#include <pcl\// && !/<pcl\/surface_(ccaa|repair)\// { found = 1 }
       END { exit !found }' "$1"
}

chosen() {
  local source flags
  while IFS=$'\t' read -r source flags; do
    if [[ -n $pattern ]]; then
      [[ $source =~ $pattern ]] || continue
    else
      names_pcl "$source" || continue
    fi
    printf '%s\t%s\n' "$source" "$flags"
  done
}

# Users' programs are compiled like the sources of the library they use.
consumers() {
  local flags
  flags=$(jobs_to_do | sed -n '/^[^\t]*\/surface_repair\/src\//{s/.*\t//p}' | sort -u)
  printf "%s\t$flags\n" test/consumer/*.cpp
}

{
  jobs_to_do | grep -vE 'cmake_pch|/build/[^\t]*\.cpp'
  consumers
} | sort -u | chosen >"$work/jobs"
[[ -s $work/jobs ]] || {
  echo "no source matches '$pattern' in $commands" >&2
  exit 1
}
tr '\t' '\n' <"$work/jobs" |
  xargs -d '\n' -n 2 -P "${JOBS:-$(nproc)}" bash -c 'check "$1" "$2"' check
echo "$(wc -l <"$work/jobs") sources pass"

#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# Part of PclSurfaceRepair: bash completion of a program, from what it says of itself.
#
# usage: make_completion.sh PROGRAM FUNCTIONS OUTPUT
#   FUNCTIONS  psr_completion.bash, which goes into each completion

set -euo pipefail
# shellcheck source=cmake/program_help.sh
source "$(dirname "${BASH_SOURCE[0]}")/program_help.sh"
program=$1
functions=$2
output=$3
name=${program##*/}
help=$("$program" --help)

# Names of the required and optional arguments, in their order; one that other ways of
# calling repeat comes once more at the end, as NAME...
arguments() {
  local synopsis
  synopsis=$(help_synopsis <<<"$help" | tr -d '[]')
  head -n 1 <<<"$synopsis" | tr ' ' '\n' | grep -E '^[A-Z]'
  tail -n +2 <<<"$synopsis" | tr ' ' '\n' | grep -E '^[A-Z_]+\.\.\.$' | sort -u || true
}

endings_in() {
  grep -oE '\.[a-z]{2,4}\b' | sort -u | tr -d . | paste -sd' ' || true
}

# Endings of an argument: its own line says them, or its name, or the summary.
endings_of() {
  local text
  text=$(help_argument "${1%...}" <<<"$help")
  if [[ -z $text && $1 =~ \.[a-z]+$ ]]; then
    text=$1
  elif [[ -z $text ]]; then
    text=$(help_summary <<<"$help")
  fi
  endings_in <<<"$text"
}

# The first word of a program that takes a step to do.
first_step() {
  help_synopsis <<<"$help" | head -n 1 | grep -oE '^[a-z]+\b' || true
}

# The words an option takes: the program names them when it refuses another one, or its
# description ends in a list of them.
choices_of() {
  local placeholders refusal words
  mapfile -t placeholders < <(first_step; arguments | sed -E -e '/\.\.\.$/d' -e 's/^([A-Z_]+)\.([a-z]+)$/no-file.\2/; t
    s/^.*IN.*/no-file.pcd/; t; s/^OUT.*/no-result.ply/; t; s/.*/no-file.ply/')
  refusal=$("$program" "$1" '?' "${placeholders[@]}" 2>&1 || true)
  words=$(sed -nE \
    "s/^[^:]*: $1 (must be|takes) (one of )?([a-z]+[a-z, -]*), not '\?'.*/\3/p" <<<"$refusal")
  if [[ -z $words ]]; then
    words=$(sed -nE 's/^[^:]*: ([a-z-]+(, [a-z-]+){2,}( or [a-z-]+)?)(;.*)?$/\1/p' <<<"$2")
  fi
  sed -E 's/,? or /, /; s/, */ /g' <<<"$words"
}

# What may follow an option that takes an argument: "words ...", "files ...", "folder". One
# whose default is a number takes no words, and the program need not be asked.
kind_of() {
  local choices=''
  [[ $3 =~ \(=-?[0-9] ]] || choices=$(choices_of "$1" "$2")
  if [[ -n $choices ]]; then
    echo "words $choices"
  elif [[ $2 == *folder* ]]; then
    echo folder
  elif [[ $2 =~ this\ ([A-Z]+)\ file ]]; then
    echo "files ${BASH_REMATCH[1],,}"
  elif [[ $2 =~ \.[a-z]+\ file || $2 =~ (this|to\ a)\ (file|cloud) || $2 == a\ cloud* ]]; then
    echo "files $(endings_in <<<"$2")"
  else
    echo nothing
  fi
}

{
  echo "# bash completion of $name; made from its --help"
  echo
  # Each completion is loaded by itself, and must not change another's functions.
  sed "/^#/d; s/_psr_/_${name}_/g" "$functions"
  echo
  echo "_$name() {"
  echo "  local options='$(help_options <<<"$help" | cut -f1 | paste -sd' ')'"
  echo '  local -A values=('
  help_options <<<"$help" | while IFS=$'\t' read -r option takes text; do
    if [[ $takes == arg* ]]; then
      echo "    [$option]='$(kind_of "$option" "$text" "$takes")'"
    fi
  done
  echo '  )'
  echo '  local arguments=('
  arguments | while read -r argument; do
    repeat=''
    [[ $argument == *... ]] && repeat='repeat '
    echo "    '${repeat}files $(endings_of "$argument")'"
  done
  echo '  )'
  echo "  _${name}_complete"
  echo '}'
  echo "complete -o filenames -F _$name $name"
} >"$output.part"
mv "$output.part" "$output"

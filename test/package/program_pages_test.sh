#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# Part of PclSurfaceRepair: checks one thing about the pages of a program.
#
# usage: program_pages_test.sh CASE PROGRAM PAGES

set -euo pipefail
check=$1
program=$2
name=${program##*/}
man_page=$3/man/$name.1.gz
completion=$3/completion/$name

# Long options as the help has them, found in another way than the pages' scripts do.
options_in_help() {
  "$program" --help | sed -n '/^Options:/,/^Examples:/p' |
    grep -oE '^  (-[a-z] \[ )?--[a-z0-9-]+' | grep -oE '\-\-.*'
}

# candidates WORD...: what completion offers for the last word
candidates() {
  bash -c 'source "$1"; shift; COMP_WORDS=("$@"); COMP_CWORD=$(($# - 1)); "_$1"
    printf "%s\n" "${COMPREPLY[@]}"' bash "$completion" "$name" "$@"
}

# every_option_in TEXT
every_option_in() {
  local missing=0 option
  [[ -n $(options_in_help) ]] || missing=1
  for option in $(options_in_help); do
    grep -qE -- "(^|[^a-z-])$option([^a-z-]|$)" <<<"$1" || {
      echo "$option is missing" >&2
      missing=1
    }
  done
  return "$missing"
}

case $check in
  man_options)
    every_option_in "$(MANWIDTH=200 man -l "$man_page" | col -b)"
    ;;
  man_warnings)
    warnings=$(LC_ALL=C.UTF-8 MANWIDTH=80 man --warnings -l "$man_page" 2>&1 >/dev/null)
    echo "$warnings"
    [[ -z $warnings ]]
    ;;
  completion_options)
    every_option_in "$(candidates -)"
    ;;
  choices)
    # Where the default is a word, the words offered have it among them.
    defaults=$("$program" --help |
      sed -nE 's/^  (--[a-z0-9-]+) arg \(=([a-z][a-z-]*)\).*/\1 \2/p')
    while read -r option default; do
      [[ -n $option ]] || continue
      offered=$(candidates "$option" '')
      [[ $'\n'$offered$'\n' == *$'\n'$default$'\n'* ]] || {
        echo "$option offers '$offered', not its default, $default" >&2
        exit 1
      }
    done <<<"$defaults"
    ;;
  *) exit 1 ;;
esac

#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# Part of PclSurfaceRepair: the manual page of a program, from what it says of itself.
#
# usage: make_man_page.sh PROGRAM OUTPUT.1.gz [OTHER_PROGRAM...]

set -euo pipefail
# shellcheck source=cmake/program_help.sh
source "$(dirname "${BASH_SOURCE[0]}")/program_help.sh"
program=$1
output=$2
others=("${@:3}")
name=${program##*/}
help=$("$program" --help)

# Text as troff prints it: plain dashes and backslashes, no line taken for a request.
escaped() {
  sed -e 's/\\/\\e/g' -e 's/-/\\-/g' -e "s/^[.']/\\\\\&&/"
}

# The first sentence of the summary, up to its first pause.
purpose() {
  local text
  text=$(help_summary <<<"$help" | sed '/^$/q' | tr '\n' ' ' | sed -E 's/[.:,] .*//')
  echo "${text,}"
}

# A list entry where a line starts with the name of an argument, else text as it is.
summary() {
  help_summary <<<"$help" | escaped | awk '
    /^[A-Z][A-Z_]+  / {
      print ".TP\n.I " $1
      sub(/^[^ ]+ +/, "")
      print "\\&" $0
      listed = 1
      next
    }
    /^$/ || (listed && /^[^ ]/) { print ".PP"; listed = 0 }
    /./ { sub(/^   +/, ""); print }'
}

options() {
  local group
  help_groups <<<"$help" | while IFS= read -r group; do
    [[ $group == Options ]] || printf '.SS "%s"\n' "$group"
    options_of "$group"
  done
}

options_of() {
  local option takes text
  help_options "$1" <<<"$help" | escaped | while IFS=$'\t' read -r option takes text; do
    case $takes in
      '\-') takes='' ;;
      'arg (='*) takes=" \\fIvalue\\fR (default: ${takes:6}" ;;
      *) takes=' \fIvalue\fR' ;;
    esac
    printf '.TP\n\\fB%s\\fR%s\n%s\n' "$(with_short_name "$option")" "$takes" "$text"
  done
}

# "-h, --help" of "--help" if the program knows a letter for it.
with_short_name() {
  local letter
  letter=$(escaped <<<"$help" | sed -nE "s/^  \\\\-([a-z]) \[ ${1//\\/\\\\} \].*/\1/p")
  echo "${letter:+\\-$letter\\fR, \\fB}$1"
}

page() {
  local codes
  echo ".TH ${name^^} 1 \"\" \"PclSurfaceRepair ${version}\" \"User Commands\""
  printf '.SH NAME\n%s \\- %s\n' "$name" "$(purpose | escaped)"
  printf '.SH SYNOPSIS\n'
  help_synopsis <<<"$help" | escaped | while IFS= read -r arguments; do
    printf '.B %s\n[\\fIoptions\\fR] %s\n.br\n' "$name" "$arguments"
  done
  printf '.SH DESCRIPTION\n'
  summary | sed '$ { /^\.PP$/d }'
  printf '.SH OPTIONS\n'
  options
  printf '.SH EXAMPLES\n.nf\n'
  help_examples <<<"$help" | escaped
  printf '.fi\n.SH "EXIT STATUS"\n'
  codes=$(help_exit_codes <<<"$help" | escaped)
  sed -E -e 's/(^|; |\. )([0-9]+) /\n.TP\n.B \2\n/g' -e 's/\.?$//' <<<"$codes" | sed 1d
  printf '.SH "SEE ALSO"\n'
  for other in "${others[@]}"; do
    [[ $other == "$name" ]] || printf '.BR %s (1),\n' "$other"
  done
  printf '.BR pcl_viewer (1)\n'
}

version=$("$program" --version | sed 's/.* //')
page | gzip -9n >"$output.part"
mv "$output.part" "$output"

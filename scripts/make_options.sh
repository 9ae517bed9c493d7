#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# Part of PclSurfaceRepair: the page doc/options.md, from what the programs say of themselves.
#
# usage: make_options.sh [--check] [FOLDER_OF_PROGRAMS]    (default: build/release/bin)
#
# --check changes nothing, and fails where the page is not up to date, or where an option
# does not tell when one needs it.

set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
# shellcheck source=cmake/program_help.sh
source cmake/program_help.sh

check=''
if [[ ${1:-} == --check ]]; then
  check=yes
  shift
fi
bin=${1:-build/release/bin}
page=doc/options.md
programs=(pcl_ccaa_reconstruct pcl_repair_holes pcl_repair_viewer pcl_mesh_quality pcl_render_mesh
  pcl_damage_cloud pcl_ccaa_tiles)

# rows GROUP: a row of the table for each option of a program's help on standard input.
rows() {
  help_options "$1" | sed -E 's/\|/\\|/g; s/([<>])/\\\1/g' | awk -F'\t' '
    {
      takes = ""
      if (match($2, /\(=.*\)/)) takes = " (" substr($2, RSTART + 2, RLENGTH - 3) ")"
      place = index($3, "; use it ")
      what = place ? substr($3, 1, place - 1) : $3
      use = place ? substr($3, place + 9) : ""
      print "| `" $1 "`" takes " | " what " | " use " |"
    }'
}

content() {
  cat <<'END'
# Every option, and when one needs it

Made by `scripts/make_options.sh` from what each program says for `--help`. In brackets the default.
No option has to be set; each row tells when one is worth a thought. How the programs work, and what
options mean for each other, is told in [the programs](apps.md); what the options of the method do to
a force line, with pictures, in [tutorial 6](tutorials/6_tuning.md). In C++ and in [Python](python.md)
each option has a sentence "Set it ..." that tells the same: see `pcl::repair::RepairParameters`, or
type `help(psr.repair)`.
END
  local program help group
  for program in "${programs[@]}"; do
    help=$("$bin/$program" --help)
    printf '\n## %s\n' "$program"
    help_groups <<<"$help" | while IFS= read -r group; do
      [[ $group == Options ]] || printf '\n%s:\n' "$group"
      printf '\n| option | what it does | use it |\n|---|---|---|\n'
      rows "$group" <<<"$help"
    done
  done
}

made=$(content)
silent=$(grep -E '^\| `--.*\|  \|$' <<<"$made" | grep -vE '^\| `--(help|version)`' || true)
if [[ -n $silent ]]; then
  printf 'these options do not tell when one needs them:\n%s\n' "$silent" >&2
  exit 1
fi
if [[ -z $check ]]; then
  printf '%s\n' "$made" >"$page"
else
  diff -u "$page" - <<<"$made" || {
    echo "$page is out of date: run scripts/make_options.sh" >&2
    exit 1
  }
fi

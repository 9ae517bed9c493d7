#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# Part of PclSurfaceRepair: completes command lines as bash does and looks at what is
# offered.
#
# usage: completion_test.sh FOLDER_OF_COMPLETIONS

set -euo pipefail
folder=$1
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
cd "$scratch"
touch scan.ply scan.pcd "two words.PLY" notes.md report.json lines.vtk
mkdir results
failed=0

# offers "EXPECTED,EXPECTED" WORD...: what is offered for the last word of the line, in
# order of the alphabet
offers() {
  local expected=$1 found
  shift
  found=$(
    # shellcheck disable=SC1090
    source "$folder/$1"
    COMP_WORDS=("$@")
    COMP_CWORD=$(($# - 1))
    "_$1"
    printf '%s\n' "${COMPREPLY[@]}" | LC_ALL=C sort | paste -sd,
  )
  if [[ $found != "$expected" ]]; then
    echo "$*: offers '$found', not '$expected'" >&2
    failed=1
  fi
}

# Files by ending and folders, of either case.
offers 'lines.vtk,results,scan.ply,two words.PLY' pcl_mesh_quality ''
offers 'scan.pcd,scan.ply' pcl_ccaa_reconstruct s
offers 'scan.ply' pcl_ccaa_reconstruct scan.pcd s
# Not more arguments than the program takes.
offers '' pcl_mesh_quality scan.ply ''
# Options, the values of choices, files and folders as values.
offers '--labels' pcl_repair_holes scan.ply --la
offers 'full,light' pcl_repair_holes --mode ''
offers 'minimum-weight' pcl_repair_holes a.ply b.ply --filling m
offers 'report.json,results' pcl_repair_holes --report ''
offers 'results' pcl_repair_holes --inspect ''
offers 'lines.vtk' pcl_repair_holes --bridges l
offers 'lines.vtk,results,scan.ply,two words.PLY' pcl_ccaa_reconstruct --output ''
offers '' pcl_repair_holes --trust ''
# --option=value comes as three words; a value is no argument.
offers 'full,light' pcl_repair_holes --mode =
offers 'light' pcl_repair_holes --mode = l
offers 'lines.vtk,results,scan.ply,two words.PLY' pcl_mesh_quality --threads 2 ''
offers 'lines.vtk,results,scan.ply,two words.PLY' pcl_mesh_quality --threads = 2 ''
exit "$failed"

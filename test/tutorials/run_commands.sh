#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# Part of PclSurfaceRepair: runs the shell commands of a tutorial on a small cloud.
#
# usage: run_commands.sh TUTORIAL.md FOLDER_OF_PROGRAMS SCRATCH_FOLDER

set -euo pipefail
here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
. "$here/shapes.sh"
tutorial=$(realpath "$1")
PATH=$(realpath "$2"):$PATH

# A page names the programs of others that it needs; without them it is skipped.
for needed in $(sed -n 's/^<!-- needs: \(.*\) -->$/\1/p' "$tutorial"); do
  command -v "$needed" >/dev/null || { echo "no $needed"; exit 77; }
done

rm -rf "$3"
mkdir -p "$3"
cd "$3"
make_cloud 3000 bunny_cloud.obj
commands=$(awk '/^```$/ { on = 0 } on { print } /^```sh$/ { on = 1 }' "$tutorial")
[[ -n $commands ]]
bash -euxo pipefail -c "$commands"

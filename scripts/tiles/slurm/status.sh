#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# Part of PclSurfaceRepair: tells Snakemake how a job of Slurm is doing.
#
# usage: status.sh JOB      prints running, success or failed

set -uo pipefail
state=$(scontrol --oneliner show job "$1" 2>/dev/null | sed -n 's/.* JobState=\([A-Z_]*\).*/\1/p')
# The controller forgets jobs after a while (MinJobAge), the accounting does not.
[[ -n $state ]] || state=$(sacct --noheader --parsable2 -X -j "$1" -o state 2>/dev/null | head -1)
# Nobody knows it: lost, or nobody can be asked just now.
[[ -n $state ]] || scontrol ping >/dev/null 2>&1 || state=PENDING
case ${state%% *} in
  COMPLETED) echo success ;;
  PENDING | CONFIGURING | RUNNING | SUSPENDED | COMPLETING | REQUEUED | RESIZING) echo running ;;
  *) echo failed ;;
esac

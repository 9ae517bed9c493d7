#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# Part of PclSurfaceRepair: starts a Slurm cluster of one node here, meshes a cloud on it
# tile by tile, kills the process of one job, and compares the shards with those of
# pcl_ccaa_reconstruct --tiles. Needs root; installs Snakemake, Slurm and MUNGE.
#
# usage: check_slurm.sh [FOLDER_OF_PROGRAMS]     (default: build/release/bin)

set -euo pipefail
here=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
programs=$(cd "${1:-$here/build/release/bin}" && pwd)
"$here/scripts/install_dependencies.sh" workflow

work=$(mktemp -d)
pids=()
finish() {
  local code=$?
  ((code == 0)) || tail -n 20 "$work"/*.log >&2
  scancel --state=RUNNING,PENDING --quiet --user="$(id -un)" 2>/dev/null || true
  ((${#pids[@]} == 0)) || kill "${pids[@]}" 2>/dev/null || true
  wait
  rm -rf "$work"
}
trap finish EXIT

# MUNGE says who sends a message; a key and a socket of this cluster's own.
mkdir -m 755 "$work/munge" "$work/state" "$work/spool"
chmod 755 "$work"
dd if=/dev/urandom of="$work/munge/key" bs=1024 count=1 status=none
chmod 400 "$work/munge/key"
munged --foreground --force --key-file="$work/munge/key" --socket="$work/munge/socket" \
  --pid-file="$work/munge/pid" --seed-file="$work/munge/seed" --num-threads=2 \
  2>"$work/munged.log" &
pids+=($!)

export SLURM_CONF=$work/slurm.conf
cat >"$SLURM_CONF" <<CONF
ClusterName=check
SlurmctldHost=$(hostname -s)(127.0.0.1)
SlurmUser=root
AuthType=auth/munge
AuthInfo=socket=$work/munge/socket
CryptoType=crypto/munge
SlurmctldPort=26817
SlurmdPort=26818
StateSaveLocation=$work/state
SlurmdSpoolDir=$work/spool
SlurmctldPidFile=$work/slurmctld.pid
SlurmdPidFile=$work/slurmd.pid
ProctrackType=proctrack/linuxproc
TaskPlugin=task/none
JobAcctGatherType=jobacct_gather/none
MpiDefault=none
SelectType=select/cons_tres
SelectTypeParameters=CR_CPU_Memory
SchedulerParameters=sched_interval=1,batch_sched_delay=0
MinJobAge=3600
ReturnToService=2
NodeName=$(hostname -s) NodeAddr=127.0.0.1 CPUs=$(nproc) RealMemory=4096
PartitionName=all Nodes=ALL Default=YES
CONF
slurmctld -D >"$work/slurmctld.log" 2>&1 &
pids+=($!)
slurmd -D >"$work/slurmd.log" 2>&1 &
pids+=($!)
for _ in $(seq 60); do
  sinfo --noheader --states=idle -o %n 2>/dev/null | grep -q . && break
  sleep 1
done
sinfo

"$here/test/apps/tile_workflow.sh" job "$here" "$programs" "$work/run" \
  --profile "$here/scripts/tiles/slurm" --latency-wait 10
count() {
  scontrol --oneliner show jobs | grep -c "JobState=$1" || true
}
echo "same bytes after $(count COMPLETED) jobs of Slurm and $(count FAILED) that was killed"
(($(count FAILED) == 1))

# SPDX-License-Identifier: MIT
# Sourced: a Slurm of one node, this one, in a folder of its own. It needs no root, systemd, cgroups or accounts.
#
#   start_slurm FOLDER    sets SLURM_CONF; fails with what the daemons said
#   stop_slurm

slurm_pids=()

start_slurm() {
  local at=$1 host port i
  host=$(hostname -s)
  port=$((20000 + $$ % 20000))
  mkdir -p "$at/state" "$at/spool"
  chmod 755 "$at"
  head -c 1024 /dev/urandom > "$at/munge.key"
  chmod 400 "$at/munge.key"
  # --force: folders above belong to whomever
  munged --force --foreground --key-file="$at/munge.key" --socket="$at/munge.socket" --pid-file="$at/munged.pid" \
    --log-file="$at/munged.log" --seed-file="$at/munge.seed" > "$at/munged.out" 2>&1 &
  slurm_pids+=($!)
  cat > "$at/slurm.conf" <<CONF
ClusterName=one
SlurmctldHost=$host(127.0.0.1)
SlurmctldPort=$port
SlurmdPort=$((port + 1))
SlurmUser=$(id -un)
SlurmdUser=$(id -un)
AuthType=auth/munge
AuthInfo=socket=$at/munge.socket
CredType=cred/munge
StateSaveLocation=$at/state
SlurmdSpoolDir=$at/spool
SlurmctldPidFile=$at/slurmctld.pid
SlurmdPidFile=$at/slurmd.pid
SlurmctldLogFile=$at/slurmctld.log
SlurmdLogFile=$at/slurmd.log
ProctrackType=proctrack/linuxproc
TaskPlugin=task/none
JobAcctGatherType=jobacct_gather/none
AccountingStorageType=accounting_storage/none
SchedulerType=sched/backfill
SelectType=select/cons_tres
SelectTypeParameters=CR_CPU
MpiDefault=none
ReturnToService=2
MailProg=/bin/true
SchedulerParameters=sched_min_interval=0,batch_sched_delay=0
NodeName=$host NodeAddr=127.0.0.1 CPUs=$(nproc) State=UNKNOWN
PartitionName=all Nodes=$host Default=YES MaxTime=INFINITE State=UP
CONF
  printf 'CgroupPlugin=cgroup/v1\nCgroupAutomount=no\n' > "$at/cgroup.conf"
  export SLURM_CONF=$at/slurm.conf
  for i in $(seq 100); do [ -S "$at/munge.socket" ] && break; sleep 0.1; done
  slurmctld -D -f "$SLURM_CONF" > "$at/slurmctld.out" 2>&1 &
  slurm_pids+=($!)
  slurmd -D -N "$host" -f "$SLURM_CONF" > "$at/slurmd.out" 2>&1 &
  slurm_pids+=($!)
  for i in $(seq 300); do
    sinfo -h -o %T 2>/dev/null | grep -q idle && return 0
    sleep 0.1
  done
  echo "slurm did not come up:"
  tail -n 20 "$at"/munged.out "$at"/munged.log "$at"/slurmctld.out "$at"/slurmctld.log "$at"/slurmd.out "$at"/slurmd.log 2>/dev/null
  return 1
}

stop_slurm() {
  local i
  for ((i = ${#slurm_pids[@]} - 1; i >= 0; --i)); do kill "${slurm_pids[i]}" 2>/dev/null; done
  for ((i = ${#slurm_pids[@]} - 1; i >= 0; --i)); do wait "${slurm_pids[i]}" 2>/dev/null; done
  slurm_pids=()
}

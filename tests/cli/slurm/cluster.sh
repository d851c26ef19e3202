#!/bin/bash
# A Slurm controller and one node on this machine, in a folder of their own and without any trace
# elsewhere.
#
#   cluster.sh start FOLDER     starts them; `source FOLDER/environment` to use them
#   cluster.sh stop FOLDER      ends them, by the process numbers they wrote down
#
# Exit status 77 where Slurm or munge is not installed.
set -euo pipefail
export PATH="$PATH:/usr/sbin:/sbin"

action=$1
folder=$(realpath "$2")

stop() {
  local name pid
  for name in slurmd slurmctld munged; do
    pid=$(cat "$folder/$name.pid" 2>/dev/null || true)
    [ -n "$pid" ] || continue
    kill "$pid" 2>/dev/null || true
    for _ in $(seq 100); do
      kill -0 "$pid" 2>/dev/null || break
      sleep 0.1
    done
  done
}

free_port() {
  local port
  while :; do
    port=$((20000 + RANDOM % 20000))
    (exec 3<>"/dev/tcp/127.0.0.1/$port") 2>/dev/null || break
  done
  echo "$port"
}

start() {
  local command user
  for command in munged slurmctld slurmd sbatch; do
    command -v "$command" >/dev/null || { echo "no $command here" >&2; exit 77; }
  done
  user=$(id -un)
  chmod 755 "$folder"
  mkdir -p "$folder/state" "$folder/spool"
  (umask 077; head -c 1024 /dev/urandom >"$folder/munge.key")
  cat >"$folder/slurm.conf" <<EOF
ClusterName=quoin
SlurmctldHost=localhost(127.0.0.1)
SlurmctldPort=$(free_port)
SlurmdPort=$(free_port)
SlurmUser=$user
SlurmdUser=$user
AuthType=auth/munge
AuthInfo=socket=$folder/munge.socket
CredType=cred/munge
ProctrackType=proctrack/linuxproc
TaskPlugin=task/none
SelectType=select/cons_tres
SelectTypeParameters=CR_Core
MpiDefault=none
ReturnToService=2
SlurmdParameters=config_overrides
StateSaveLocation=$folder/state
SlurmdSpoolDir=$folder/spool
SlurmctldPidFile=$folder/slurmctld.pid
SlurmdPidFile=$folder/slurmd.pid
SlurmctldLogFile=$folder/slurmctld.log
SlurmdLogFile=$folder/slurmd.log
SchedulerParameters=sched_min_interval=100000
NodeName=localhost NodeAddr=127.0.0.1 CPUs=2 State=UNKNOWN
PartitionName=test Nodes=ALL Default=YES MaxTime=INFINITE State=UP
EOF
  echo "export SLURM_CONF='$folder/slurm.conf' PATH='$PATH'" >"$folder/environment"
  export SLURM_CONF=$folder/slurm.conf
  trap stop ERR
  munged --force --key-file="$folder/munge.key" --socket="$folder/munge.socket" \
    --pid-file="$folder/munged.pid" --log-file="$folder/munged.log" \
    --seed-file="$folder/munge.seed"
  slurmctld -c
  slurmd -c
  for _ in $(seq 300); do
    sinfo --noheader --format=%T 2>/dev/null | grep -q idle && return
    sleep 0.1
  done
  echo "the node did not come up" >&2
  tail -5 "$folder"/*.log >&2
  stop
  exit 1
}

"$action"

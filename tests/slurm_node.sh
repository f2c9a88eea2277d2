#!/bin/sh
# Slurm on one node, for one command: slurm_node.sh FOLDER COMMAND ... starts munged, slurmctld and slurmd as this user, with all
# their files in FOLDER, which must be absolute and new; waits until the node is idle; does the command; and stops them.
set -u
folder=$1
shift
PATH=$PATH:/usr/sbin:/sbin
SLURM_CONF=$folder/slurm.conf
export SLURM_CONF
node=$(hostname -s) user=$(id -un) port=$((20000 + $$ % 5000 * 2)) daemons=
mkdir -p "$folder/state" "$folder/spool"
stop() { [ -z "$daemons" ] || kill $daemons 2>/dev/null; wait; }
trap stop EXIT
within() { # seconds, a condition
  turns=$(($1 * 10))
  until eval "$2"; do
    turns=$((turns - 1))
    [ $turns -gt 0 ] || return 1
    sleep 0.1
  done
}

(umask 077 && head -c 128 /dev/urandom >"$folder/key")
cat >"$SLURM_CONF" <<OF_SLURM
ClusterName=one
SlurmctldHost=$node(127.0.0.1)
SlurmctldPort=$port
SlurmdPort=$((port + 1))
SlurmUser=$user
SlurmdUser=$user
AuthType=auth/munge
CredType=cred/munge
AuthInfo=socket=$folder/socket
StateSaveLocation=$folder/state
SlurmdSpoolDir=$folder/spool
SlurmctldPidFile=$folder/slurmctld.pid
SlurmdPidFile=$folder/slurmd.pid
ProctrackType=proctrack/pgid
TaskPlugin=task/none
SwitchType=switch/none
MpiDefault=none
JobAcctGatherType=jobacct_gather/none
AccountingStorageType=accounting_storage/none
SelectType=select/cons_tres
SelectTypeParameters=CR_CPU
ReturnToService=2
NodeName=$node NodeAddr=127.0.0.1 CPUs=$(nproc) State=UNKNOWN
PartitionName=all Nodes=ALL Default=YES MaxTime=INFINITE State=UP
OF_SLURM
# (--force: the folder of its socket need not be open to all)
munged --foreground --force --key-file "$folder/key" --socket "$folder/socket" --pid-file "$folder/munged.pid" \
  --log-file "$folder/munged.log" --seed-file "$folder/seed" >"$folder/munged.told" 2>&1 &
daemons=$!
within 60 '[ -S "$folder/socket" ]'
slurmctld -D >"$folder/slurmctld.log" 2>&1 &
daemons="$daemons $!"
slurmd -D -N "$node" >"$folder/slurmd.log" 2>&1 &
daemons="$daemons $!"
within 120 'sinfo -h -o %T 2>/dev/null | grep -q idle' || {
  for told in munged.told slurmctld.log slurmd.log; do tail -n 5 "$folder/$told" >&2; done
  exit 1
}
"$@"

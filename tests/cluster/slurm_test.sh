#!/usr/bin/env bash
# slurm_test.sh SIDESTEP: whether a sweep that a real Slurm runs in an array ends in the tables of
# the sweep on one machine, bit for bit.
#
# Installs Debian's Slurm if it is missing, starts a cluster of this one node in a folder of its own,
# submits an array of four shards, kills one half-way, has Slurm tell another that its time is up, and
# drains and resumes the node meanwhile; submits what is missing, and compares. Stops all it started.
# Exits with 77 where there is no Slurm and none can be installed. Needs root, no systemd, no munge.
set -euo pipefail
sidestep="$(realpath "$1")"
skip() { printf 'SKIPPED: %s\n' "$*"; exit 77; }
step() { printf '== %2d s: %s\n' "$SECONDS" "$*"; }

has_slurm() { local one; for one in slurmctld slurmd sbatch srun; do command -v $one >/dev/null || return 1; done; }

install_slurm() {
  ! has_slurm || return 0
  command -v apt-get >/dev/null || skip "there is no Slurm here, and no apt-get to install it"
  step "installing Slurm"
  local apt=(apt-get -qq -o DPkg::Lock::Timeout=120) policy=/usr/sbin/policy-rc.d status=0
  # A policy, unless there is one, so that the packages start no service.
  local is_mine=false
  [[ -e $policy ]] || { printf '#!/bin/sh\nexit 101\n' >$policy; chmod +x $policy; is_mine=true; }
  { "${apt[@]}" update && DEBIAN_FRONTEND=noninteractive "${apt[@]}" install -y \
    --no-install-recommends slurmctld slurmd slurm-client; } >"$work/apt.log" 2>&1 || status=$?
  ! $is_mine || rm -f $policy
  [[ $status -eq 0 ]] || { tail -n 3 "$work/apt.log"; skip "Slurm can't be installed here"; }
}

[[ "$(id -u)" -eq 0 ]] || skip "a Slurm of one's own needs root"
work="$(mktemp -d)"
daemons=()
clean_up() {
  local status=$?
  [[ $status -eq 0 || $status -eq 77 ]] || tail -n 20 "$work"/*.log "$work"/array/*.log >&2 || true
  if [[ ${#daemons[@]} -gt 0 ]]; then
    scancel --user=root --full --signal=KILL 2>/dev/null || true
    scancel --user=root 2>/dev/null || true
    for _ in {1..50}; do [[ -n "$(squeue -h 2>/dev/null)" ]] || break; sleep 0.1; done
    kill "${daemons[@]}" 2>/dev/null || true
    wait "${daemons[@]}" 2>/dev/null || true
  fi
  rm -rf --one-file-system "$work"
}
trap clean_up EXIT
fail() { printf 'FAILED: %s\n' "$*" >&2; squeue >&2 || true; exit 1; }
install_slurm

# wait_for WORDS COMMAND...: until it succeeds.
wait_for() {
  local words="$1" end=$((SECONDS + 120))
  until "${@:2}" >/dev/null 2>&1; do
    [[ $SECONDS -lt $end ]] || fail "waited too long for $words"
    kill -0 "${daemons[@]}" || fail "a daemon of Slurm ended"
    sleep 0.05
  done
}

step "starting a cluster of one node"
node="$(hostname -s)"
port=$((20000 + 2 * ($$ % 10000)))
export SLURM_CONF="$work/slurm.conf"
mkdir "$work/state" "$work/spool"
cat >"$SLURM_CONF" <<END
ClusterName=sidestep
SlurmctldHost=$node(127.0.0.1)
SlurmctldPort=$port
SlurmdPort=$((port + 1))
SlurmUser=root
SlurmdUser=root
AuthType=auth/none
CredType=cred/none
StateSaveLocation=$work/state
SlurmdSpoolDir=$work/spool
SlurmctldPidFile=$work/slurmctld.pid
SlurmdPidFile=$work/slurmd.pid
MailProg=/bin/true
ProctrackType=proctrack/linuxproc
TaskPlugin=task/none
MpiDefault=none
JobAcctGatherType=jobacct_gather/none
AccountingStorageType=accounting_storage/none
SelectType=select/cons_tres
SelectTypeParameters=CR_CPU
SchedulerParameters=batch_sched_delay=0,sched_interval=1,bf_interval=1
ReturnToService=2
NodeName=$node NodeAddr=127.0.0.1 CPUs=2 State=UNKNOWN
PartitionName=main Nodes=ALL Default=YES MaxTime=INFINITE State=UP OverSubscribe=NO
END
slurmctld -D -c >"$work/slurmctld.log" 2>&1 &
daemons+=($!)
slurmd -D >"$work/slurmd.log" 2>&1 &
daemons+=($!)
node_is() { [[ "$(sinfo -h -o %T)" == "$1" ]]; }
wait_for "the node" node_is idle

step "the map on this machine alone"
cat >"$work/hop.yaml" <<'END'
sidestep: 1
name: hop
robot: hopper
duration_s: 6.5
gait:
  - {type: stand, start_s: 0.0}
  - {type: hop, start_s: 0.5, stance_s: 0.15, flight_s: 0.15, swing_height_m: 0.05}
pushes:
  - {body: trunk, force_N: [5, 0, 0], start_s: 2.0, duration_s: 0.3}
sensors: {gyro_noise_radps: 0.005, touch_noise_N: 0.05}
END
cat >"$work/map.yaml" <<'END'
sidestep_sweep: 1
name: hop_map
scenario: hop.yaml
set: {pushes.0.after_s: 1.5}
vary:
  pushes.0.direction_rad: [0, 2]
  pushes.0.at_phase: [0.25, mid_stance]
limit: {key: pushes.0.impulse_Nspkg, ladder: [1, 2, 4, 6], resolution: 0.5}
seeds: 3
controllers:
  ours: {}
  fixed: {control.mpc.box_lower_m: [0, 0, 0], control.mpc.box_upper_m: [0, 0, 0]}
END
"$sidestep" sweep "$work/map.yaml" -o "$work/one" -q -j2

step "an array, with a shard killed, another out of time, and the node drained"
array="$work/array"
"$sidestep" sweep plan "$work/map.yaml" -o "$array" -q
"$sidestep" sweep slurm "$array" --shards 4 --throttle 2 --sbatch=--time=10 >"$work/jobs.sh"
said="$(bash "$work/jobs.sh")"
[[ "$said" =~ ^array\ ([0-9]+),\ merge\ ([0-9]+)$ ]] || fail "jobs.sh said '$said'"
job="${BASH_REMATCH[1]}" merge="${BASH_REMATCH[2]}"
# has_rows SHARD N: that many lines, the header included.
has_rows() { [[ "$(wc -l <"$array/rows-$1-of-4.csv")" -ge "$2" ]]; }
is_over() { [[ -z "$(squeue -h -r -j "$1" 2>/dev/null)" ]]; }
wait_for "rows of shard 0" has_rows 0 2
wait_for "rows of shard 1" has_rows 1 3
scontrol update nodename="$node" state=drain reason=test
kill -KILL "$(pgrep -o -f -- "^$sidestep sweep run $array --shard 1/4")"
scancel --batch --signal=USR1 "${job}_0" || true  # it tries again, and finds the job gone
wait_for "both to end" is_over "${job}_0,${job}_1"
grep -q 'goes on with the rest' "$array/slurm-${job}_0.log" || fail "shard 0 did not end by itself"
sleep 1
[[ ! -e "$array/rows-2-of-4.csv" ]] || fail "a shard was started on a drained node"
scontrol update nodename="$node" state=resume
wait_for "the merge" is_over "$job,$merge"
said="$(cat "$array/slurm-$merge-merge.log")"
printf '%s\n' "$said"
[[ "$said" =~ (--array=0,1)$ ]] || fail "the merge said '$said'"
[[ ! -e "$array/cells.csv" ]] || fail "tables of half a sweep"

step "what is missing, as the merge says: ${BASH_REMATCH[1]}"
before="$(wc -l <"$array/rows-1-of-4.csv")"
said="$(bash "$work/jobs.sh" "${BASH_REMATCH[1]}")"
[[ "$said" =~ ^array\ ([0-9]+),\ merge\ ([0-9]+)$ ]] || fail "jobs.sh said '$said'"
wait_for "the merge" is_over "${BASH_REMATCH[1]},${BASH_REMATCH[2]}"
cat "$array/slurm-${BASH_REMATCH[2]}-merge.log"
[[ "$(wc -l <"$array/rows-1-of-4.csv")" -gt "$before" ]] || fail "shard 1 did not go on"

# same FOLDER: its tables are those of one machine, but for the columns cpu_s, wall_s and host.
same() {
  local table
  for table in rays.csv strengths.csv; do cmp "$1/$table" "$work/one/$table"; done
  cmp <(sed -E 's/(,[^,]*){3}$//' "$1/cells.csv") <(sed -E 's/(,[^,]*){3}$//' "$work/one/cells.csv")
}
same "$array" || fail "the array's tables are not those of one machine"

step "one allocation: the rank is the shard"
"$sidestep" sweep plan "$work/map.yaml" -o "$work/ranks" -q
srun -n 2 "$sidestep" sweep run "$work/ranks" --shard auto --jobs 1 -q
"$sidestep" sweep merge "$work/ranks"
same "$work/ranks" || fail "the ranks' tables are not those of one machine"
step "$(wc -l <"$work/one/cells.csv") lines are the same, bit for bit"

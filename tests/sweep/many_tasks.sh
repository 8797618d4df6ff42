#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# Many small tasks of two_boxes: by one process, by two, and with processes that are killed at random, each to the same
# table byte for byte. Prints what a task costs; compares no times.
#
#   many_tasks.sh PABD [TASKS]       200 unless told otherwise, a multiple of 50
set -u
pabd=$1
tasks=${2:-200}
work=$(mktemp -d "${TMPDIR:-/tmp}/pabd-many-XXXXXX")
trap 'rm -rf "$work"' EXIT
failed=0
RANDOM=7

fail() {
  echo "FAILED: $*"
  failed=1
}

# The environment of whoever started this must say nothing of tasks.
unset SLURM_ARRAY_TASK_ID PBS_ARRAY_INDEX PARALLEL_SEQ OMPI_COMM_WORLD_RANK OMPI_COMM_WORLD_SIZE PMI_RANK PMI_SIZE

cat > "$work/plan.json" <<PLAN
{ "format": "pabd-sweep", "version": 1, "scene": "two_boxes", "picture": false,
  "parameters": [ { "key": "contact.N", "values": [1, 2, 3, 4, 5] },
                  { "key": "contact.kappa", "from": 1, "to": 1000, "count": 10, "scale": "log" },
                  { "key": "contact.d_hat", "from": 0.005, "to": 0.024, "count": $((tasks / 50)) } ],
  "stop": { "steps": 60 } }
PLAN

# Runs a command; says how long it took and how much of the CPUs, a task.
measured() {
  local what=$1
  shift
  TIMEFORMAT='%R %U %S'
  { time "$@" > "$work/out" 2>&1; } 2> "$work/time"
  local code=$?
  awk -v what="$what" -v n="$tasks" \
    '{ printf "%-14s %7.2f s, a task %6.2f ms, of a CPU %5.2f ms\n", what, $1, 1000 * $1 / n, 1000 * ($2 + $3) / n }' "$work/time"
  return "$code"
}

sweep() { "$pabd" sweep "$work/plan.json" -o "$work/$1" --quiet --jobs "$2"; }

# Its table, when all tasks are there.
table() {
  "$pabd" sweep collect "$work/$1" -o "$work/$1-table" --quiet || fail "collect $1"
  [ "$(wc -l < "$work/$1-table/table.csv")" = $((tasks + 1)) ] || fail "$1 has not $tasks tasks"
}

same() {
  table "$1"
  cmp "$work/one-table/table.csv" "$work/$1-table/table.csv" || fail "$1: another table"
}

bare=$("$pabd" run two_boxes --steps 6000 --quiet --json | sed -n 's/.*"wall_time": *\([0-9.e-]*\).*/\1/p')
awk -v t="$bare" 'BEGIN { printf "%-14s %25.2f ms in one run, without tasks\n", "60 steps", 10 * t }'

measured "one process" sweep one 1 || fail "one process"
table one
measured "two processes" sweep two 2 || fail "two processes"
same two

# Whenever a twentieth of the tasks is done, a process of the pool is killed, or the pool itself with all of them, and the
# same command goes on. By what is done, not by the clock: machines differ by ten times.
done_tasks() { find "$work/killed/tasks" -name result.json 2> /dev/null | wc -l; }
rounds=0
workers=0
for ((i = 1; i < 20; ++i)); do
  setsid "$pabd" sweep "$work/plan.json" -o "$work/killed" --quiet --jobs 2 > "$work/out" 2>&1 &
  pool=$!
  while kill -0 "$pool" 2> /dev/null && (($(done_tasks) < i * tasks / 20)); do sleep 0.002; done
  if ((i % 2)); then
    child=$(ps -o pid= --ppid "$pool" | head -1)
    [ -n "$child" ] && kill -9 "$child" 2> /dev/null && workers=$((workers + 1))
    sleep 0.01
  fi
  kill -9 -- "-$pool" 2> /dev/null
  wait "$pool" 2> /dev/null
  [ $? = 137 ] || break
  rounds=$((rounds + 1))
done
sweep killed 2 || fail "after $rounds kills"
same killed
echo "killed $rounds times on the way, and $workers processes of it alone"
[ "$rounds" -gt 0 ] || fail "nothing was killed"
[ "$workers" -gt 0 ] || fail "no process was killed alone"
exit "$failed"

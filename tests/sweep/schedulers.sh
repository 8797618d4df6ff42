#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# A sweep by the engines that people have, with the files that --emit writes: GNU parallel, mpirun with two ranks, and a
# Slurm of one node that this script starts. Each must leave the bytes that the serial sweep leaves.
#
#   schedulers.sh PABD [ENGINE…]       parallel mpi slurm unless told otherwise
#
# Snakemake is tried when it is named: its packages are more than half a gigabyte, so that the suite leaves it out.
set -u
pabd=$1
shift
engines=${*:-parallel mpi slurm}
here=$(cd "$(dirname "$0")" && pwd)
work=$(mktemp -d "${TMPDIR:-/tmp}/pabd sweep XXXXXX")
slurm=$(mktemp -d "${TMPDIR:-/tmp}/pabd-slurm-XXXXXX")
# shellcheck source=one_node_slurm.sh
. "$here/one_node_slurm.sh"
trap 'stop_slurm; rm -rf "$work" "$slurm"' EXIT
failed=0

fail() {
  echo "FAILED: $*"
  failed=1
}

# The environment of whoever started this must say nothing of tasks.
unset SLURM_ARRAY_TASK_ID PBS_ARRAY_INDEX PARALLEL_SEQ OMPI_COMM_WORLD_RANK OMPI_COMM_WORLD_SIZE PMI_RANK PMI_SIZE

cat > "$work/plan.json" <<'PLAN'
{ "format": "pabd-sweep", "version": 1, "scene": "two_boxes", "picture": false,
  "parameters": [ { "key": "contact.N", "values": [2, 3] },
                  { "key": "contact.d_hat", "values": [0.01, 0.02, 0.03, -1] } ],
  "stop": { "steps": 60 } }
PLAN

# All that is the same in every run: no times, no files of the engines.
results() { (cd "$1/tasks" && find . -type f ! -name timing.json | LC_ALL=C sort | xargs sha256sum); }

same() {
  if [ "$(results "$work/serial")" = "$(results "$work/$1")" ]; then
    echo "$1: 8 tasks, the same bytes as the serial sweep"
  else
    fail "$1: other results than the serial sweep"
    diff <(results "$work/serial") <(results "$work/$1") | head
  fi
}

emit() {
  "$pabd" sweep "$work/plan.json" -o "$work/$1" --emit "$@" --quiet || fail "--emit $1"
}

need() {
  command -v "$1" > /dev/null && return 0
  fail "$1 is not there: apt-get install $2 (scripts/setup --test does)"
  return 1
}

"$pabd" sweep "$work/plan.json" -o "$work/serial" --jobs 1 --quiet || fail "the serial sweep"
[ "$(results "$work/serial" | wc -l)" = 22 ] || fail "the serial sweep has not its 22 files"

for engine in $engines; do
  case $engine in
    parallel)
      need parallel parallel || continue
      emit parallel
      sh "$work/parallel/sweep.parallel.sh" > "$work/out" 2>&1 || { fail "parallel"; cat "$work/out"; }
      # One line of its log for each task, and who has no --task finds it in PARALLEL_SEQ.
      [ "$(wc -l < "$work/parallel/parallel.log")" = 9 ] || fail "parallel: not 8 jobs"
      same parallel
      mkdir -p "$work/sequence"
      seq 8 | parallel -j 2 -N0 "'$pabd' sweep '$work/plan.json' -o '$work/sequence' --quiet" || fail "PARALLEL_SEQ"
      same sequence
      ;;
    mpi)
      need mpirun openmpi-bin || continue
      emit mpi
      sh "$work/mpi/sweep.mpi.sh" --allow-run-as-root --oversubscribe -n 2 > "$work/out" 2>&1 \
        || { fail "mpirun"; cat "$work/out"; }
      same mpi
      ;;
    snakemake)
      need snakemake snakemake || continue
      # Braces mean something there.
      "$pabd" sweep "$work/plan.json" -o "$work/sna{ke}" --emit snakemake --quiet || fail "--emit snakemake"
      snakemake -s "$work/sna{ke}/Snakefile" --cores 2 > "$work/out" 2>&1 || { fail "snakemake"; cat "$work/out"; }
      same "sna{ke}"
      ;;
    slurm)
      need slurmctld slurm-wlm || continue
      need munged munge || continue
      start_slurm "$slurm" || { fail "slurm"; continue; }
      emit slurm --chunk 3
      sbatch --wait "$work/slurm/sweep.sbatch" > "$work/out" 2>&1 \
        || { fail "sbatch"; cat "$work/out" "$work"/slurm/slurm-*.out "$slurm"/slurmctld.log; }
      [ "$(find "$work/slurm" -name 'slurm-*.out' | wc -l)" = 3 ] || fail "slurm: not 3 jobs of 3 tasks"
      same slurm
      ;;
  esac
done
exit "$failed"

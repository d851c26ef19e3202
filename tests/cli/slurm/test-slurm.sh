#!/bin/bash
# A study on a real Slurm controller and node: 200 cases in an array, of which one task never runs
# and one is killed; submitted again, gathered, and compared with a run without Slurm.
#
#   test-slurm.sh QUOIN_CLI EXAMPLES
#
# Exit status 77 (skipped) where Slurm is not installed.
set -euo pipefail
cli=$1
examples=$2
here=$(dirname "$(realpath "$0")")
work=$(mktemp -d)
mkdir "$work/slurm"

cleanup() {
  "$here/cluster.sh" stop "$work/slurm"
  rm -rf "$work"
}
trap cleanup EXIT

fail() {
  echo "FAILED: $1" >&2
  exit 1
}

wait_for_queue() {
  while squeue --noheader | grep -q .; do sleep 0.2; done
}

"$here/cluster.sh" start "$work/slurm"
source "$work/slurm/environment"

cat >"$work/wall.quoin-study" <<EOF
{ "format": "quoin-study", "version": 1, "model": "$examples/ferris-tin-loi/wall3.quoin",
  "run": "solve",
  "parameters": [ { "name": "friction", "path": "laws[0].friction",
    "distribution": { "kind": "lognormal", "mean": 0.65, "cov": 0.1 } } ],
  "plan": { "kind": "latin-hypercube", "count": 200, "seed": 2 },
  "outputs": ["collapse_multiplier", "mechanism_kind"] }
EOF
folder="$work/on a cluster"
"$cli" study run "$work/wall.quoin-study" -o "$work/local" --quiet
"$cli" study run "$work/wall.quoin-study" -o "$folder" --prepare --quiet

"$cli" study submit "$folder" --slurm --array-size 8 --dry-run >"$work/script"
grep -q -- '--array=1-8' "$work/script" || fail "the dry run shows no array"
squeue --noheader | grep -q . && fail "the dry run submitted something"

# As long as the partition is down, every task waits.
scontrol update PartitionName=test State=DOWN
"$cli" study submit "$folder" --slurm --array-size 8
job=$(squeue --noheader --array --format=%F | head -1)
[ "$(squeue --noheader --array | wc -l)" = 8 ] || fail "there are not 8 tasks"
"$cli" study submit "$folder" --slurm | grep -q 'nothing to submit' \
  || fail "waiting tasks were submitted again"
"$cli" study submit "$folder" --slurm --array-size 5 2>/dev/null \
  && fail "another array size was taken while tasks wait"
scancel "${job}_8"
scontrol update PartitionName=test State=UP
until [ -n "$(squeue --noheader --array --states=RUNNING --format=%i)" ]; do sleep 0.05; done
scancel --signal=KILL "$(squeue --noheader --array --states=RUNNING --format=%i | head -1)" || true
"$cli" study gather "$folder"
wait_for_queue

"$cli" study gather "$folder" | tee "$work/gathered"
grep -q '200 of 200' "$work/gathered" && fail "the task that was cancelled has cases"
"$cli" study submit "$folder" --slurm
squeue --noheader --array --format=%K | grep -qx 8 || fail "the lost task was not submitted"
[ "$(squeue --noheader --array | wc -l)" -le 2 ] || fail "tasks that had ended well run again"
wait_for_queue
"$cli" study gather "$folder" | grep -q '200 of 200 cases, 0 failed' || fail "cases are missing"
"$cli" study submit "$folder" --slurm | grep -q 'nothing to submit' || fail "work is left"

"$cli" study table "$work/local" >"$work/local.csv"
"$cli" study table "$folder" >"$work/cluster.csv"
diff "$work/local.csv" "$work/cluster.csv" || fail "the tables differ"
echo "200 cases on Slurm equal 200 cases without it, row by row"

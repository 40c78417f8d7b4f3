#!/usr/bin/env bash
# A table of profiles by 1, 2 and 3 ranks has the same bytes as without mpirun; a bad profile, wrong
# input and a rank that is killed end as they should.
#
#   mpi_table.sh HOST_SIM MODEL
set -euo pipefail

host_sim="$1"
model="$2"
source "$(dirname "$0")/../support/ranks.sh"
scratch="$(mktemp -d)"
trap 'rm -rf "$scratch"' EXIT

# profile FILE HIGH ROWS: between 10 N and HIGH.
profile() {
  mkdir -p "$(dirname "$1")"
  awk -v high="$2" -v rows="$3" 'BEGIN {
    print "time_s,input_tension_N"
    for (i = 0; i < rows; i++) printf "%.3f,%d\n", i * 0.005, i % 2 ? high : 10
  }' > "$1"
}

for number in $(seq 20); do
  profile "$scratch/logs/robot$((number % 3))/$number.csv" "$((20 + number))" "$((100 * number))"
done
cp "$model" "$scratch/logs/model.toml"
sed 's/^ipl_scale = .*/ipl_scale = 2e4/' "$model" > "$scratch/logs/robot2/model.toml"

"$host_sim" replay "$scratch/logs" --threads 1 --table "$scratch/alone.csv" \
  --json "$scratch/alone.json"
[ "$(wc -l < "$scratch/alone.csv")" -eq 21 ] || fail "not one row for each profile"
for count in 1 2 3; do
  ranks "$count" replay "$scratch/logs" --table "$scratch/$count.csv" --json "$scratch/$count.json"
  cmp "$scratch/alone.csv" "$scratch/$count.csv"
  cmp "$scratch/alone.json" "$scratch/$count.json"
done

echo "time_s" > "$scratch/logs/robot1/7.csv"
status=0
ranks 3 replay "$scratch/logs" --table "$scratch/bad.csv" 2> "$scratch/bad.err" || status=$?
[ "$status" -eq 1 ] || fail "status $status for a bad profile"
grep -q 'robot1/7.csv:1' "$scratch/bad.err" || fail "it is not named"
diff <(grep -v 'robot1/7.csv' "$scratch/alone.csv") <(grep -v 'robot1/7.csv' "$scratch/bad.csv") \
  || fail "the others have other rows"

status=0
ranks 2 replay "$scratch/logs" --model "$scratch/none.toml" --table "$scratch/none.csv" \
  2> "$scratch/none.err" || status=$?
[ "$status" -eq 1 ] || fail "status $status without a model"
[ "$(grep -c 'none.toml: cannot be opened' "$scratch/none.err")" -eq 1 ] || fail "not told once"
[ ! -e "$scratch/none.csv" ] || fail "a table of nothing"

# One rank is killed at work: the other is ended, and there is no table.
profile "$scratch/long/1.csv" 50 1000000
for number in $(seq 2 200); do
  ln "$scratch/long/1.csv" "$scratch/long/$number.csv"
done
end_at_work one_rank "$scratch/killed.csv" replay "$scratch/long" --threads 1 --model "$model"

# The user stops mpirun: nothing at all is left behind.
end_at_work all "$scratch/stopped.csv" replay "$scratch/long" --threads 1 --model "$model"
! compgen -G "$scratch/stopped.csv*" || fail "something is left behind"

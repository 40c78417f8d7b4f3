#!/usr/bin/env bash
# A batch by 1, 2 and 3 ranks gives the same bytes as without mpirun; a refused campaign and a rank
# that is killed end all ranks.
#
#   mpi_batch.sh HOST_SIM MAKE_CAMPAIGNS
set -euo pipefail

host_sim="$1"
source "$(dirname "$0")/../support/ranks.sh"
scratch="$(mktemp -d)"
trap 'rm -rf "$scratch"' EXIT
"$2" "$scratch/all" 24

"$host_sim" calibrate "$scratch/all" --batch --bootstraps 20 --threads 1 \
  --table "$scratch/alone.csv" --json "$scratch/alone.json"
[ "$(wc -l < "$scratch/alone.csv")" -eq 25 ] || fail "not one row for each campaign"
for count in 1 2 3; do
  ranks "$count" calibrate "$scratch/all" --batch --bootstraps 20 \
    --table "$scratch/$count.csv" --json "$scratch/$count.json"
  cmp "$scratch/alone.csv" "$scratch/$count.csv"
  cmp "$scratch/alone.json" "$scratch/$count.json"
done

echo "specimen" > "$scratch/all/campaign_0007/specimens.csv"
status=0
ranks 3 calibrate "$scratch/all" --batch --bootstraps 20 --table "$scratch/refused.csv" \
  2> "$scratch/refused.err" || status=$?
[ "$status" -eq 1 ] || fail "status $status for a refused campaign"
grep -q 'campaign_0007/specimens.csv:1' "$scratch/refused.err" || fail "it is not named"
[ "$(wc -l < "$scratch/refused.csv")" -eq 25 ] || fail "the others have no rows"

status=0
ranks 2 calibrate "$scratch/nowhere" --batch --table "$scratch/none.csv" \
  2> "$scratch/none.err" || status=$?
[ "$status" -eq 1 ] || fail "status $status without a folder"
[ ! -e "$scratch/none.csv" ] || fail "a table of nothing"

# One rank is killed at work: the other is ended, and nothing is left behind.
end_at_work one_rank "$scratch/killed.csv" calibrate "$scratch/all" --batch --bootstraps 1000000

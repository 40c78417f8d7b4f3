# For scripts that run host_sim by several ranks; to be sourced with $host_sim set.

# ranks COUNT ARGUMENTS...: host_sim by so many ranks.
ranks() {
  local count="$1"
  shift
  # In the foreground it tells mpirun of a signal once; told twice, mpirun kills its ranks.
  timeout --foreground 120 mpirun --allow-run-as-root --oversubscribe --mca btl_vader_single_copy_mechanism none \
    -n "$count" "$host_sim" "$@"
}

fail() {
  echo "$1" >&2
  exit 1
}

# end_at_work HOW TABLE ARGUMENTS...: two ranks of host_sim with these arguments and --table TABLE, which
# are ended while they work: one_rank is killed, or mpirun is told to stop (all). The run has to fail.
end_at_work() {
  local how="$1" table="$2" status=0 job
  shift 2
  ranks 2 "$@" --table "$table" 2> "$table.err" &
  job=$!
  wait_for_two_ranks "$*" "$table"
  case "$how" in
    one_rank) kill -KILL "$(tail -n 1 <<< "$ranks_at_work")" ;;
    all) kill -TERM "$(pgrep -P "$job")" ;;
  esac
  wait "$job" || status=$?
  [ "$status" -ne 0 ] && [ "$status" -ne 124 ] || fail "status $status after $how was ended"
  rm "$table.err"
  [ ! -e "$table" ] || fail "a table of half the work"
}

# wait_for_two_ranks TEXT PARTIAL: until two processes whose command line begins with "$host_sim TEXT"
# are at work on the output PARTIAL; sets $ranks_at_work.
wait_for_two_ranks() {
  for _ in $(seq 100); do
    ranks_at_work="$(pgrep -f "^$host_sim $1" || true)"
    [ "$(wc -w <<< "$ranks_at_work")" -eq 2 ] && compgen -G "$2.partial*" > /dev/null && break
    sleep 0.1
  done
  [ "$(wc -w <<< "$ranks_at_work")" -eq 2 ] || fail "no two ranks came up"
  sleep 0.5
}

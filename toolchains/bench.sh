#!/usr/bin/env bash
# Builds and runs all benchmarks of this machine, and prints the table of lifemodel/README.md.
#
#   bench.sh [--peer FOLDER] [--write]
#
#   --peer FOLDER  times another counter beside ours, in turn and on the same samples: FOLDER has it built
#                  as libpeer.so with the C function
#                  void peer_count(const double* tension_N, size_t samples, double hysteresis_N);
#   --write        puts the table into lifemodel/README.md, without the peer
#
# BENCH_TIME is the least seconds of each run (0.5), BENCH_RUNS how many runs the median is of (5).
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."

usage() {
  sed -n '2,11p' "${BASH_SOURCE[0]}" | sed 's/^# \{0,1\}//' >&2
  exit 2
}

table=()
while [ $# -gt 0 ]; do
  case "$1" in
    --peer)
      [ $# -ge 2 ] && [ -f "$2/libpeer.so" ] || { echo "--peer: no libpeer.so in '${2:-}'" >&2; exit 2; }
      TENDONLIFE_PEER="$(cd "$2" && pwd)"
      export TENDONLIFE_PEER
      shift
      ;;
    --write) table=(--write lifemodel/README.md) ;;
    *) usage ;;
  esac
  shift
done

build=build/host-release
results=build/bench
benches=(lifemodel_bench replay_bench calibrate_bench plan_bench)
mkdir -p "$results"
cmake --preset host-release > "$results/configure.log"
cmake --build "$build" --target "${benches[@]}" > "$results/build.log"
for bench in "${benches[@]}"; do
  "$build/tests/bench/$bench" --benchmark_repetitions="${BENCH_RUNS:-5}" \
    --benchmark_min_time="${BENCH_TIME:-0.5}" --benchmark_enable_random_interleaving=true \
    --benchmark_out="$results/$bench.json" --benchmark_out_format=json \
    --benchmark_display_aggregates_only=true
done
python3 toolchains/bench_table.py "$results/lifemodel_bench.json" "${table[@]}"

#!/usr/bin/env bash
# Plays the same profiles on two builds of the controller with a virtual clock; succeeds where every
# frame, every bit of damage and the store agree.
#
# usage: compare_runs.sh CONTROLLER_A CONTROLLER_B [EMULATOR...]     the emulator is for B
#
# Without CONTROLLER_A: a skip (77), and under CI a failure.
set -euo pipefail
if [ ! -x "$1" ]; then
  echo "$1 is not there: build the preset host-release first" >&2
  exit "$([ -n "${CI:-}" ] && echo 1 || echo 77)"
fi
here="$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)"
bench="$here/bench"
files="$(mktemp -d)"
trap 'rm -rf "$files"' EXIT
. "$bench/write_config.sh"

a=("$1")
b=("${@:3}" "$2")
python3 "$bench/make_profile.py" motor_current_A 1 20000 > "$files/current0.csv"
python3 "$bench/make_profile.py" motor_current_A 2 20000 > "$files/current1.csv"
python3 "$bench/make_profile.py" input_tension_N 3 20000 > "$files/tension.csv"
python3 "$bench/make_profile.py" drive 4 20000 > "$files/drive.csv"
python3 "$bench/make_profile.py" pair 5 20000 > "$files/pair.csv"
upper_arm="$here/../../host_sim/examples/upper_arm.csv"

# run NAME RATE_HZ TENDON...
run() {
  local name="$1" rate="$2" side frames
  shift 2
  for side in a b; do
    local -n program="$side"
    local folder="$files/$side.$name"
    mkdir "$folder"
    write_config "$folder/controller.toml" "$rate" "$folder" "$@"
    # Twice, so that the second run takes up what the first one kept.
    for again in 1 2; do
      "${program[@]}" --config "$folder/controller.toml" --virtual-clock \
        --report "$folder/report$again.json" > "$folder/text$again" 2> /dev/null
      mv "$folder/frames.log" "$folder/frames$again.log"
    done
    rm "$folder/controller.toml" "$folder/store/lock"
  done
  frames="$(wc -l < "$files/a.$name/frames1.log")"
  if [ "$frames" -lt 100 ]; then
    echo "$name: only $frames frames" >&2
    exit 1
  fi
  diff -r "$files/a.$name" "$files/b.$name"
  echo "$name: $frames frames, the lives and the store are identical, damage $(
    sed -n 's/.*"damage": "\(.*\)".*/\1/p' "$files/a.$name/report2.json" | paste -sd ' ')"
}

run current 1000 "$bench/current.block:$files/current0.csv"
run two_currents 1000 "$bench/current.block:$files/current0.csv" \
  "$bench/current.block:$files/current1.csv"
run extended_drive 1000 "$bench/drive.block:$files/drive.csv"
run extended_pair 1000 "$bench/pair.block:$files/pair.csv"
run tension 1000 "$bench/tension.block:$files/tension.csv"
run output_tension 200 "$bench/upper_arm.block:$upper_arm"

#!/usr/bin/env bash
# The controller from outside: its help, its errors, runs that are the same twice, and SIGTERM.
#
# usage: program.sh CONTROLLER [EMULATOR...]
set -euo pipefail
here="$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)"
bench="$here/bench"
files="$(mktemp -d)"
trap 'rm -rf "$files"' EXIT
. "$bench/write_config.sh"
controller=("${@:2}" "$1")
upper_arm="$here/../../host_sim/examples/upper_arm.csv"
config="$files/controller.toml"
block="$bench/upper_arm.block"

fail() {
  echo "program.sh: $*" >&2
  exit 1
}

# expect STATUS TEXT ARGUMENT...    beside the warning of missing lines one line on stderr, which holds
# TEXT; the empty TEXT: whatever
expect() {
  local wanted="$1" text="$2" status=0
  shift 2
  "${controller[@]}" "$@" > "$files/out" 2> "$files/err" || status=$?
  [ "$status" -eq "$wanted" ] || fail "$*: exit status $status, expected $wanted: $(cat "$files/err")"
  if [ -n "$text" ]; then
    sed -i '/: no lines are configured: /d' "$files/err"
    grep -qF -- "$text" "$files/err" || fail "$*: expected '$text' in: $(cat "$files/err")"
    [ "$(wc -l < "$files/err")" -eq 1 ] || fail "$*: more than one line: $(cat "$files/err")"
  fi
}

# expect_config STATUS TEXT SED_SCRIPT ARGUMENT...
expect_config() {
  local status="$1" text="$2" script="$3"
  shift 3
  write_config "$config" 200 "$files" "$block:$upper_arm"
  sed -i "$script" "$config"
  expect "$status" "$text" --config "$config" "$@"
}

expect 0 "" --help
grep -q -- --virtual-clock "$files/out" || fail "--help does not name --virtual-clock"
expect 0 "" --version
status=0
"${controller[@]}" --no-such-option > "$files/out" 2> "$files/err" || status=$?
[ "$status" -eq 2 ] || fail "wrong usage: exit status $status"

expect 1 "/no/such.toml: " --config /no/such.toml
expect_config 1 "controller.toml:3:1: id is 0; accepted: id 1..127" 's/id = 7/id = 0/' --check
expect_config 1 "made for a sample every 5000 us, and the loop has 1000 us" 's/= 200/= 1000/' --check
printf 'time_s,motor_current_A\n0,1\n0.001,2\n' > "$files/current.csv"
write_config "$config" 1000 "$files" "$bench/tension.block:$files/current.csv"
expect 1 "made of a model without [drive]" --config "$config" --check
# An extension needs what it is written in terms of.
# without MODEL COLUMN    its profile with all columns but that
without() {
  python3 "$bench/make_profile.py" "$1" 1 100 | awk -F, -v OFS=, -v column="$2" '
    NR == 1 { for (i = 1; i <= NF; ++i) if ($i == column) left = i; if (!left) exit 1 }
    { line = $1; for (i = 2; i <= NF; ++i) if (i != left) line = line OFS $i; print line }' \
    > "$files/less.csv"
}
while read -r model column complaint; do
  without "$model" "$column"
  write_config "$config" 1000 "$files" "$bench/$model.block:$files/less.csv"
  for check in --check --virtual-clock; do
    expect 1 "$bench/$model.block: $complaint, which is not measured; accepted: a profile with its column" \
      --config "$config" "$check"
  done
done << 'END'
drive tendon_velocity_m_s gear_asymmetry needs the velocity of the tendon
drive motor_angle_rad torque_ripple needs the angle of the rotor
drive winding_temperature_C torque_gain needs the temperature of the winding
pair sheath_temperature_C friction_temperature needs the temperature of the sheath
pair motor_angle_rad empirical needs the angle of the rotor
END
python3 "$bench/make_profile.py" drive 1 100 > "$files/drive.csv"
write_config "$config" 1000 "$files" "$bench/drive.block:$files/drive.csv"
expect 0 "" --config "$config" --check

# A block that was loaded over the bus, put into the file of the store (file_generations.hpp).
load() {
  python3 - "$files/store/life" "$1" << 'END'
import struct
import sys
import zlib

path, block = sys.argv[1], open(sys.argv[2], "rb").read()
life = bytearray(open(path, "rb").read())
assert struct.unpack_from("<II", life) == (0x46534C54, 3)
life[16] |= 2
struct.pack_into(f"<I{len(block)}s", life, 16 + 4 + 88, len(block), block)
struct.pack_into("<I", life, len(life) - 4, zlib.crc32(life[:-4]))
open(path, "wb").write(life)
END
}
# rest_and_play CONFIGURED PROFILE WARNING [LOADED]
rest_and_play() {
  rm -rf "$files/store"
  write_config "$config" 1000 "$files" "$1:$files/rest.csv"
  expect 0 "" --config "$config" --virtual-clock
  [ $# -lt 4 ] || load "$4"
  write_config "$config" 1000 "$files" "$1:$2"
  expect 0 "$3" --config "$config" --virtual-clock --report "$files/played.json"
  sed -n 's/.*"damage": "\(.*\)".*/\1/p' "$files/played.json" | grep '[1-9a-f]'
}
printf '%s\n' \
  time_s,motor_current_A,tendon_velocity_m_s,motor_angle_rad,sheath_temperature_C,winding_temperature_C \
  0,1,0,0,20,20 0.001,1,0,0,20,20 > "$files/rest.csv"
python3 "$bench/make_profile.py" drive 1 5000 > "$files/drive.csv"
python3 "$bench/make_profile.py" motor_current_A 1 5000 > "$files/alone.csv"
# It counts with its extension, as if it were configured; where that cannot be, the configured one does.
loaded="$(rest_and_play "$bench/current.block" "$files/drive.csv" "" "$bench/drive.block")"
configured="$(rest_and_play "$bench/drive.block" "$files/drive.csv" "")"
[ "$loaded" = "$configured" ] || fail "the loaded model counts $loaded, configured $configured"
refused="the parameters that were loaded for tendon 0 are refused: an effect needs what is not measured"
kept="$(rest_and_play "$bench/current.block" "$files/alone.csv" "$refused" "$bench/drive.block")"
configured="$(rest_and_play "$bench/current.block" "$files/alone.csv" "")"
[ "$kept" = "$configured" ] || fail "beside a refused model $kept is counted, alone $configured"
head -c 100 "$bench/drive.block" > "$files/short.block"
rest_and_play "$bench/current.block" "$files/drive.csv" "the extension does not hold" \
  "$files/short.block" > /dev/null
rm -rf "$files/store"

expect_config 1 "no such network interface; accepted: a CAN interface; there are: " \
  '/^log/d; s/"none"/"tl-none"/; s/"tl-none"$/"tl-none"/; /chip/s/tl-none/none/'
expect_config 1 "no such gpiochip" \
  's|chip = "none"|chip = "tl-none"\ndrive_enable = "0"\nbrake = "1"\nemergency_stop = "2"|'
expect_config 1 "there is no such folder" 's|^folder = .*|folder = "/no/such"|'
expect_config 1 "--virtual-clock: the configuration has devices that run in real time" \
  's/"stop"/"repeat"/' --virtual-clock
expect_config 0 "" "" --check

# Twice the same, and nothing is left behind but the store and what was asked for.
for run in 1 2; do
  rm -rf "$files/store"
  expect_config 0 "" "" --virtual-clock --report "$files/report$run.json"
  mv "$files/frames.log" "$files/frames$run.log"
done
cmp "$files/frames1.log" "$files/frames2.log"
cmp "$files/report1.json" "$files/report2.json"
# 20 turns at 200 Hz; a row each period.
grep -q '"periods": 12001,' "$files/report1.json" || fail "other than 12001 periods"
# A heartbeat of node 7 in each second, and the one of the start.
heartbeats="$(grep -c ' 707#05$' "$files/frames1.log")"
[ "$heartbeats" -ge 59 ] && [ "$heartbeats" -le 62 ] || fail "$heartbeats heartbeats in 60 s"
grep -q ' 707#00$' "$files/frames1.log" || fail "no boot-up message"

# A second run continues where the first one ended.
life() { sed -n 's/.*"damage_ppb": \([0-9]*\).*/\1/p' "$1"; }
expect_config 0 "" "" --virtual-clock --report "$files/report3.json"
[ "$(life "$files/report3.json")" -gt "$(life "$files/report1.json")" ] || fail "the life did not continue"

# SIGTERM in real time: drive off, lives saved, status 0.
write_config "$config" 200 "$files" "$block:$upper_arm"
sed -i 's/"stop"/"repeat"/' "$config"
"${controller[@]}" --config "$config" --report "$files/report4.json" \
  > "$files/out4" 2> "$files/err4" &
process=$!
for _ in $(seq 100); do
  grep -q "no lines are configured" "$files/err4" && break
  sleep 0.1
done
sleep 1
# In use, as long as it runs.
expect 1 "in use by another controller" --config "$config"
kill -TERM "$process"
status=0
wait "$process" || status=$?
[ "$status" -eq 0 ] || fail "SIGTERM: exit status $status: $(cat "$files/err4")"
grep -q '"saved": true' "$files/report4.json" || fail "SIGTERM: not saved"
[ "$(life "$files/report4.json")" -ge "$(life "$files/report3.json")" ] || fail "SIGTERM: life lost"
echo "all as expected"

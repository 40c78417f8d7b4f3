#!/usr/bin/env bash
# The controller counts the damage of an extended model, to the last bit, that `host_sim replay` counts.
#
# usage: same_as_replay.sh HOST_SIM CONTROLLER
set -euo pipefail
here="$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)"
bench="$here/bench"
files="$(mktemp -d)"
trap 'rm -rf "$files"' EXIT
. "$bench/write_config.sh"

for model in drive pair; do
  python3 "$bench/make_profile.py" "$model" 6 20000 > "$files/$model.csv"
  "$1" replay "$files/$model.csv" --model "$bench/$model.toml" --json "$files/$model.json" > /dev/null
  rm -rf "$files/store"
  write_config "$files/$model.config" 1000 "$files" "$bench/$model.block:$files/$model.csv"
  "$2" --config "$files/$model.config" --virtual-clock --report "$files/$model.report" \
    > /dev/null 2>&1
  python3 - "$files/$model.json" "$files/$model.report" << 'END'
import json
import sys

replayed, controlled = (json.load(open(path)) for path in sys.argv[1:])
[tendon] = controlled["tendons"]
# Q24.104, of which a number of JSON has the first 53 bits: the words of 32 bits added up from the last.
words = int(tendon["damage"], 16)
damage = sum((words >> shift & 0xFFFFFFFF) * 2.0 ** (shift - 104) for shift in range(0, 128, 32))
wanted = replayed["damage"]["total"]
if not wanted > 0 or damage != wanted:
    sys.exit(f"the controller has counted {damage!r}, replay {wanted!r}")
if tendon["cycles"] != replayed["cycles"]["closed"]:
    sys.exit(f"the controller has closed {tendon['cycles']} cycles, replay {replayed['cycles']}")
print(f"damage {damage!r} in {tendon['cycles']} cycles, by {', '.join(replayed['extensions'])}")
END
done

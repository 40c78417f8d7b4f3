#!/usr/bin/env bash
# Makes the pictures of the pages anew, after a build with the preset host-release.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."

build="${1:-build/host-release}"
scratch="$(mktemp -d)"
trap 'rm -rf "$scratch"' EXIT
program="$build/host_sim/host_sim"
"$program" replay host_sim/examples/upper_arm.csv --model host_sim/examples/upper_arm.toml \
  --report "$scratch/replay.html"
"$program" synth --plan host_sim/examples/synth/crossed.toml --out "$scratch/crossed"
"$program" diagnose "$scratch/crossed" --report "$scratch/diagnosis.html" > /dev/null
node tests/pictures/make.mjs host_sim/examples/pictures "$scratch/replay.html" \
  "$scratch/diagnosis.html" "$build/tests/monitor/monitor_live_feed"

#!/usr/bin/env bash
# Installs what is missing, builds host_sim with all that is installed beside it, and replays the shipped
# example.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."

toolchains/setup.sh run
# The tests need more than host_sim does, and stay out.
build=build/host-release
cmake --preset host-release -DTENDONLIFE_TESTS=OFF > /dev/null
cmake --build "$build"
echo
"$build/host_sim/host_sim" replay host_sim/examples/upper_arm.csv \
  --model host_sim/examples/upper_arm.toml --report "$build/upper_arm.html"
echo
echo "Report: $PWD/$build/upper_arm.html"
echo "To find host_sim in this shell: export PATH=\"$PWD/$build/host_sim:\$PATH\""

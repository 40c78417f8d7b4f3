#!/usr/bin/env bash
# The parameter blocks in this folder are what `host_sim pack` makes of their models.
#
# usage: same_blocks.sh HOST_SIM
set -euo pipefail
here="$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)"
files="$(mktemp -d)"
trap 'rm -rf "$files"' EXIT

for model in current drive pair tension; do
  "$1" pack "$here/$model.toml" --out "$files/$model.block" 2> /dev/null
done
"$1" pack "$here/../../../host_sim/examples/upper_arm.toml" --out "$files/upper_arm.block"
for block in current drive pair tension upper_arm; do
  cmp "$files/$block.block" "$here/$block.block"
done

#!/usr/bin/env bash
# Runs two builds of the trail on the same recording; succeeds where every byte agrees.
#
# usage: compare.sh PROGRAM_A PROGRAM_B       each is called as PROGRAM OUT RECORDING
set -euo pipefail
here="$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)"
files="$(mktemp -d)"
trap 'rm -rf "$files"' EXIT

python3 "$here/make_recording.py" "$files/recording"
"$1" "$files/a" "$files/recording"
"$2" "$files/b" "$files/recording"
lines="$(wc -l < "$files/a")"
if [ "$lines" -lt 100 ]; then
  echo "the trail is too short: $lines lines" >&2
  exit 1
fi
if ! cmp "$files/a" "$files/b"; then
  diff "$files/a" "$files/b" | head -n 6
  exit 1
fi
echo "$lines lines are identical, CRC $(cksum < "$files/a" | cut -d' ' -f1)"

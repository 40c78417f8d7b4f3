#!/usr/bin/env bash
# The firmware with the last digit of what it says changed.
set -euo pipefail
"$FIRMWARE" "$@"
size="$(stat -c %s "$1")"
truncate -s $((size - 2)) "$1"
printf 'G\r' >> "$1"

#!/usr/bin/env bash
# The trail with every digit of its last line changed.
set -euo pipefail
"$TRAIL" "$1" "$2"
sed -i '$ y/0123456789abcdef/123456789abcdef0/' "$1"

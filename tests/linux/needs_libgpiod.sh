#!/usr/bin/env bash
# Without libgpiod of version 2 the Linux controller is refused at configure time, in words that help.
#
# usage: needs_libgpiod.sh CMAKE SOURCE_FOLDER
set -euo pipefail
cmake="$1"
source="$2"
files="$(mktemp -d)"
trap 'rm -rf "$files"' EXIT
mkdir "$files/none" "$files/old"
# What Debian 12 has without its backports.
printf 'Name: libgpiodcxx\nDescription: C++ bindings\nVersion: 1.6.3\nLibs: -lgpiodcxx\n' \
  > "$files/old/libgpiodcxx.pc"

# refused FOLDER TEXT
refused() {
  if PKG_CONFIG_LIBDIR="$files/$1" "$cmake" -G Ninja -S "$source" -B "$files/build-$1" \
    -DTENDONLIFE_BOARD=linux -DTENDONLIFE_TESTS=OFF > "$files/log" 2>&1; then
    echo "$1: was configured" >&2
    exit 1
  fi
  # CMake breaks lines where it likes.
  tr -s ' \n' ' ' < "$files/log" > "$files/line"
  for text in "$2" "needs libgpiodcxx 2.0 or later" "bookworm-backports"; do
    grep -qF -- "$text" "$files/line" || { echo "$1: no '$text' in:"; cat "$files/log"; exit 1; } >&2
  done
}

refused none "found: no libgpiodcxx at all"
refused old "found: libgpiodcxx 1.6.3, which has another interface"

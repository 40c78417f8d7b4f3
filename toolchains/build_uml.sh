#!/usr/bin/env bash
# Builds a User-Mode Linux kernel with CAN, simulated lines and netem from Debian's linux-source,
# for tests/kernel. Takes some minutes once; then it lies in a cache folder outside the source tree.
#
#   build_uml.sh             builds the kernel if it is not there, and prints its path
#   build_uml.sh --path      prints the path alone, whether or not it is there
#
# The path changes with uml.config, with the room for registers and with the version of the package.
set -euo pipefail
here="$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)"
package=linux-source-6.1
archive=/usr/src/$package.tar.xz
fragment=$here/uml.config
# Bytes that a process of the kernel has for its vector registers. Linux 6.1 has 2,696, and a host gives
# and takes all or nothing: with AMX 11,008.
register_room=16384

fail() {
  echo "build_uml.sh: $*" >&2
  exit 1
}

cache_folder() {
  local cache=${XDG_CACHE_HOME:-}
  if [[ -z $cache ]]; then
    [[ -n ${HOME:-} ]] || fail "neither XDG_CACHE_HOME nor HOME is set"
    cache=$HOME/.cache
  fi
  echo "$cache/tendonlife"
}

[[ $# -eq 0 || ($# -eq 1 && $1 == --path) ]] || {
  sed -n '5,6s/^# \{0,1\}//p' "${BASH_SOURCE[0]}" >&2
  exit 2
}

version=$(dpkg-query -W -f '${Version}' "$package" 2> /dev/null) ||
  fail "$package is not installed (apt-get install --no-install-recommends $package flex bison bc kmod)"
key=$({ cat "$fragment"; echo "$package $version $(uname -m) $register_room"; } | sha256sum | cut -c 1-16)
cache=$(cache_folder)
kernel=$cache/uml-$key/linux

if [[ ${1:-} == --path || -x $kernel ]]; then
  echo "$kernel"
  exit 0
fi

[[ $(uname -m) == x86_64 ]] || fail "User-Mode Linux runs on x86_64 only; this is $(uname -m)"
[[ -r $archive ]] || fail "$archive is missing: reinstall $package"
for tool in make gcc flex bison bc xz; do
  command -v "$tool" > /dev/null || fail "$tool is missing (apt-get install make gcc flex bison bc xz-utils)"
done

mkdir -p "$cache"
work=$(mktemp -d "$cache/uml-build-XXXXXX")
trap 'rm -rf "$work"' EXIT
log=$cache/uml-build.log

# The configuration that was asked for, of which make drops silently what it does not know.
check_config() {
  local wanted missing=()
  while read -r wanted; do
    grep -qxF "$wanted" "$work/out/.config" || missing+=("$wanted")
  done < <(grep '^CONFIG_' "$fragment")
  [[ ${#missing[@]} -eq 0 ]] || fail "$package $version does not take ${missing[*]}"
}

run() {
  nice "$@" >> "$log" 2>&1 < /dev/null || {
    tail -n 30 "$log" >&2
    fail "'$*' failed; the whole output is in $log"
  }
}

echo "Building User-Mode Linux from $package $version: about 5 minutes on 2 cores, once" >&2
: > "$log"
mkdir "$work/out"
# The header files of one graphics card are a third of the archive.
run tar -xJf "$archive" -C "$work" --exclude='*/drivers/gpu/drm/amd/include/*' \
  --exclude='*/tools/testing/*'
registers=$work/$package/arch/x86/um/user-offsets.c
run grep -F 'DEFINE_LONGS(HOST_FP_SIZE, 2696);' "$registers"
run sed -i "s/HOST_FP_SIZE, 2696/HOST_FP_SIZE, $register_room/" "$registers"
make_kernel=(make -C "$work/$package" ARCH=um O="$work/out")
run env KCONFIG_ALLCONFIG="$fragment" "${make_kernel[@]}" allnoconfig
check_config
run "${make_kernel[@]}" -j "$(nproc)" linux
strip --strip-debug -o "$work/linux" "$work/out/linux"
mkdir -p "$(dirname "$kernel")"
mv "$work/linux" "$kernel"
echo "$kernel"

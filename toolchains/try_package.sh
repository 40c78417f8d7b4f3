#!/usr/bin/env bash
# Builds the Debian packages, installs them in a clean Debian 12, uses them there, and purges them.
# The clean system is kept in build/clean, and made anew where that is gone.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."

suite=bookworm
clean="$PWD/build/clean"
image="$clean/$suite-$(dpkg --print-architecture).tar"

# What lacks here may not lack where everything has to hold.
skip() {
  echo "skipped: $*"
  [ "${CI:-}" != true ] || exit 1
  exit 77
}

[ "$(id -u)" -eq 0 ] || skip "a clean system needs root"
command -v debootstrap > /dev/null || skip "debootstrap is not installed"

began="$SECONDS"
cmake --preset debian > /dev/null
cmake --build --preset debian -j "$(nproc)"
rm -f build/debian/*.deb
cpack --preset debian
packages=(build/debian/*.deb)
echo "built in $((SECONDS - began)) s: ${packages[*]}"

# The same bytes when they are packed again.
sums="$(sha256sum "${packages[@]}")"
rm -f "${packages[@]}"
cpack --preset debian > /dev/null
sha256sum --check --quiet <<< "$sums"

if command -v lintian > /dev/null; then
  lintian --allow-root --fail-on error,warning "${packages[@]}"
else
  echo "lintian is not installed"
  [ "${CI:-}" != true ]
fi

root="$(mktemp -d "${TMPDIR:-/tmp}/tendonlife-clean.XXXXXX")"
trap 'rm -rf "$root"' EXIT
began="$SECONDS"
if [ ! -s "$image" ]; then
  mkdir -p "$clean"
  mirror="$(toolchains/mirror.sh)"
  debootstrap --variant=minbase "$suite" "$root" "$mirror" > "$clean/debootstrap.log" 2>&1 ||
    { tail -n 5 "$clean/debootstrap.log"; skip "no $suite from $mirror"; }
  tar -C "$root" -cf "$image.part" .
  mv "$image.part" "$image"
  echo "debootstrap in $((SECONDS - began)) s"
else
  tar -C "$root" -xpf "$image"
fi

# Packages that have come once need not come again.
mkdir -p "$clean/archives"
cp -n "$clean"/archives/*.deb "$root/var/cache/apt/archives/" 2> /dev/null || true
cp /etc/resolv.conf "$root/etc/resolv.conf"
cp "${packages[@]}" tests/package/use.sh "$root/root/"
began="$SECONDS"
env -i PATH=/usr/sbin:/usr/bin:/sbin:/bin HOME=/root LANG=C.UTF-8 DEBIAN_FRONTEND=noninteractive \
  http_proxy="${http_proxy:-}" https_proxy="${https_proxy:-}" \
  chroot "$root" /bin/bash /root/use.sh
cp -n "$root"/var/cache/apt/archives/*.deb "$clean/archives/" 2> /dev/null || true
echo "installed, used and purged in $((SECONDS - began)) s"

#!/usr/bin/env bash
# Builds the Debian packages, installs them in a clean Debian 12, uses them there, and purges them.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
. toolchains/clean_debian.sh

require_root
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

make_clean_system
cp "${packages[@]}" tests/package/use.sh "$root/root/"
began="$SECONDS"
run_in_clean_system /bin/bash /root/use.sh
echo "installed, used and purged in $((SECONDS - began)) s"

#!/usr/bin/env bash
# Follows README.md in a clean Debian 12, from a clone on: runs its commands as they are printed, up to
# the first that fails, and compares what they print with what the page says. toolchains/readme.py says
# how the page marks what does not run there. The clone is that of the last commit.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
. toolchains/clean_debian.sh

require_root
toolchains/readme.py commands README.md > /dev/null
make_clean_system
git clone -q --depth 1 "file://$PWD" "$root/root/tendonlife"

# Nothing that a reader would have: the cache of the compiler, so that this takes minutes and not a
# quarter of an hour, and what is pinned by its checksum and comes over the network else.
mount -t proc proc "$root/proc"
if command -v ccache > /dev/null; then
  mkdir -p "$root/mnt/ccache"
  mount --bind "$(ccache --get-config cache_dir)" "$root/mnt/ccache"
fi
fetched="$(toolchains/fetch_uplot.sh --folder)"
if [ -d "$fetched" ]; then
  mkdir -p "$root/root/.cache/tendonlife"
  cp -r "$fetched" "$root/root/.cache/tendonlife/"
fi
cat > "$root/root/prepare.sh" << 'END'
set -euo pipefail
apt=(apt-get -q -y -o APT::Sandbox::User=root)
echo 'APT::Sandbox::User "root"; APT::Keep-Downloaded-Packages "true";' > /etc/apt/apt.conf.d/90kept
"${apt[@]}" update
"${apt[@]}" install --no-install-recommends ca-certificates ccache curl
END
run_in_clean_system /bin/bash /root/prepare.sh > "$clean/prepare.log" 2>&1 ||
  { tail -n 20 "$clean/prepare.log"; exit 1; }

began="$SECONDS"
toolchains/readme.py commands README.md > "$root/root/commands.sh"
result=0
run_in_clean_system /usr/bin/env CCACHE_DIR=/mnt/ccache CCACHE_BASEDIR=/root/tendonlife CCACHE_NOHASHDIR=1 \
  CMAKE_C_COMPILER_LAUNCHER=ccache CMAKE_CXX_COMPILER_LAUNCHER=ccache TENDONLIFE_WARNINGS_ARE_ERRORS=ON \
  /bin/bash -c 'cd /root/tendonlife && exec /bin/bash /root/commands.sh' > "$clean/readme.log" 2>&1 || result=$?
if [ "$result" -ne 0 ]; then
  tail -n 40 "$clean/readme.log"
  exit 1
fi
toolchains/readme.py compare README.md "$clean/readme.log"
echo "followed in $((SECONDS - began)) s"

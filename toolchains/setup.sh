#!/usr/bin/env bash
# Installs what the project needs on Debian 12. Quick, and without network, where all is there.
#
#   setup.sh run     to build and run host_sim
#   setup.sh test    the same, and to run every test
set -euo pipefail
here="$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)"

run_packages=(
  g++ cmake ninja-build
  libcli11-dev libtomlplusplus-dev nlohmann-json3-dev libfmt-dev zlib1g-dev
  ca-certificates openssl
)
test_packages=(
  git python3
  libgtest-dev libgmock-dev libbenchmark-dev librapidcheck-dev libboost-math-dev
  gcc-arm-none-eabi binutils-arm-none-eabi libnewlib-arm-none-eabi
  libstdc++-arm-none-eabi-newlib qemu-system-arm
  clang clang-tidy clang-format libclang-rt-14-dev
  chromium
)

case "${1:-}" in
  run) wanted=("${run_packages[@]}") ;;
  test) wanted=("${run_packages[@]}" "${test_packages[@]}") ;;
  *)
    sed -n '2,5s/^# \{0,1\}//p' "${BASH_SOURCE[0]}" >&2
    exit 2
    ;;
esac
# Debian's npm conflicts with the Node.js of other sources, which brings its own.
command -v npm > /dev/null || wanted+=(nodejs npm)

missing=()
for package in "${wanted[@]}"; do
  state="$(dpkg-query -W -f '${db:Status-Abbrev}' "$package" 2> /dev/null || true)"
  [[ $state == ii* ]] || missing+=("$package")
done

if [ "${#missing[@]}" -gt 0 ]; then
  if ! command -v apt-get > /dev/null; then
    echo "setup.sh: this is not a Debian system; install the equivalents of: ${missing[*]}" >&2
    exit 1
  fi
  as_root=()
  if [ "$(id -u)" -ne 0 ]; then
    if ! command -v sudo > /dev/null; then
      echo "setup.sh: run as root, or install: ${missing[*]}" >&2
      exit 1
    fi
    as_root=(sudo)
  fi
  echo "Installing ${missing[*]}"
  apt=("${as_root[@]}" env DEBIAN_FRONTEND=noninteractive apt-get -q -y
    -o DPkg::Lock::Timeout=300 -o Acquire::Retries=3)
  "${apt[@]}" update
  "${apt[@]}" install --no-install-recommends "${missing[@]}"
fi

"$here/fetch_uplot.sh"

#!/usr/bin/env bash
# Installs what the project needs on Debian 12. Quick, and without network, where all is there.
#
#   setup.sh run     to build and run host_sim
#   setup.sh test    the same, and to build and run the tests on this machine
#   setup.sh all     the same, and what the tests of the boards, the kernel, the pages and the packages need
set -euo pipefail
here="$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)"

run_packages=(
  g++ cmake ninja-build
  libcli11-dev libtomlplusplus-dev nlohmann-json3-dev libfmt-dev zlib1g-dev libzstd-dev
  libboost-math-dev libeigen3-dev libnlopt-cxx-dev librandom123-dev libssl-dev libpcap-dev libcpp-httplib-dev
  pkg-config ca-certificates openssl
)
test_packages=(
  git python3 python3-icalendar python3-jsonschema ccache clang-format
  libgtest-dev libgmock-dev libbenchmark-dev librapidcheck-dev
)
all_packages=(
  libopenmpi-dev openmpi-bin r-base-core r-cran-survival
  gcc-arm-none-eabi binutils-arm-none-eabi libnewlib-arm-none-eabi
  libstdc++-arm-none-eabi-newlib qemu-system-arm libunicorn-dev
  clang clang-tidy libclang-rt-14-dev
  chromium meson
  g++-aarch64-linux-gnu g++-arm-linux-gnueabihf qemu-user-static
  tmux libmosquitto-dev mosquitto mosquitto-clients
  zsh fish man-db mandoc debootstrap lintian
  can-utils iproute2 linux-source-6.1 make xz-utils flex bison bc kmod
)
# libgpiod of version 2, which Debian 12 has in its backports alone.
gpio_packages=(libgpiod-dev gpiod)
gpio_version=2.0
backports_source=/etc/apt/sources.list.d/tendonlife-backports.sources

case "${1:-}" in
  run) wanted=("${run_packages[@]}") ;;
  test) wanted=("${run_packages[@]}" "${test_packages[@]}") ;;
  all) wanted=("${run_packages[@]}" "${test_packages[@]}" "${all_packages[@]}") ;;
  *)
    sed -n '2,6s/^# \{0,1\}//p' "${BASH_SOURCE[0]}" >&2
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

missing_gpio=()
if [ "$1" = all ]; then
  for package in "${gpio_packages[@]}"; do
    version="$(dpkg-query -W -f '${Version}' "$package" 2> /dev/null || true)"
    if [ -z "$version" ] || dpkg --compare-versions "$version" lt "$gpio_version"; then
      missing_gpio+=("$package")
    fi
  done
fi

if [ "${#missing[@]}" -gt 0 ] || [ "${#missing_gpio[@]}" -gt 0 ]; then
  if ! command -v apt-get > /dev/null; then
    echo "setup.sh: this is not a Debian system; install the equivalents of: ${missing[*]} ${missing_gpio[*]}" >&2
    exit 1
  fi
  as_root=()
  if [ "$(id -u)" -ne 0 ]; then
    if ! command -v sudo > /dev/null; then
      echo "setup.sh: run as root, or install: ${missing[*]} ${missing_gpio[*]}" >&2
      exit 1
    fi
    as_root=(sudo)
  fi
  echo "Installing ${missing[*]} ${missing_gpio[*]}"
  apt=("${as_root[@]}" env DEBIAN_FRONTEND=noninteractive apt-get -q -y
    -o DPkg::Lock::Timeout=300 -o Acquire::Retries=3)
  "${apt[@]}" update
  # Packages come from the backports only where they are asked for by name.
  from=()
  if [ "${#missing_gpio[@]}" -gt 0 ] && [ "$(. /etc/os-release && echo "${VERSION_CODENAME:-}")" = bookworm ]; then
    from=(-t bookworm-backports)
    if [ ! -e "$backports_source" ]; then
      mirror="$("$here/mirror.sh")"
      printf '%s\n' 'Types: deb' "URIs: $mirror" 'Suites: bookworm-backports' \
        'Components: main' 'Signed-By: /usr/share/keyrings/debian-archive-keyring.gpg' |
        "${as_root[@]}" tee "$backports_source" > /dev/null
      "${apt[@]}" update
    fi
  fi
  if [ "${#missing[@]}" -gt 0 ]; then
    "${apt[@]}" install --no-install-recommends "${missing[@]}"
  fi
  if [ "${#missing_gpio[@]}" -gt 0 ]; then
    "${apt[@]}" install --no-install-recommends "${from[@]}" "${missing_gpio[@]}"
  fi
fi

"$here/fetch_uplot.sh"
if [ "$1" = all ]; then
  "$here/fetch_dbc_decoder.sh"
  "$here/sysroot.sh" arm64
  "$here/sysroot.sh" armhf
fi

#!/usr/bin/env bash
# Puts the libraries of the Linux controller, built for another processor, into a cache folder outside
# the source tree. Nothing is installed, and no foreign architecture is added to this machine.
#
#   sysroot.sh arm64|armhf            fetches (default folder: the one that --folder prints)
#   sysroot.sh --folder arm64|armhf   prints the folder
#
# The packages are Debian's, checked by apt against the keys of the archive. The name of the folder
# holds a hash of the list below, so that a change of the list makes a new one. The C and C++ runtime
# comes with the cross compiler.
set -euo pipefail

packages=(
  libgpiod-dev/bookworm-backports libgpiod3/bookworm-backports
  libtomlplusplus-dev libtomlplusplus3 libfmt-dev libfmt9 zlib1g-dev zlib1g
  libcli11-dev nlohmann-json3-dev
)
keys=/usr/share/keyrings/debian-archive-keyring.gpg

fail() {
  echo "sysroot.sh: $*" >&2
  exit 1
}

folder_of() {
  local cache=${XDG_CACHE_HOME:-} hash
  if [[ -z $cache ]]; then
    [[ -n ${HOME:-} ]] || fail "neither XDG_CACHE_HOME nor HOME is set"
    cache=$HOME/.cache
  fi
  hash=$(printf '%s\n' "${packages[@]}" | sha256sum | cut -c1-12)
  echo "$cache/tendonlife/sysroot-$1-$hash"
}

known() {
  [[ $1 == arm64 || $1 == armhf ]] || fail "unknown architecture '$1'; there are: arm64, armhf"
}

# apt with a configuration, lists and caches of its own.
private_apt() {
  local root=$1 architecture=$2
  mkdir -p "$root"/{lists/partial,archives/partial,etc/apt.conf.d,etc/preferences.d,etc/trusted.gpg.d}
  : > "$root/status"
  cat > "$root/sources.list" << EOF
deb [signed-by=$keys] $mirror bookworm main
deb [signed-by=$keys] $mirror bookworm-backports main
EOF
  cat > "$root/apt.conf" << EOF
Dir::Etc "$root/etc";
Dir::Etc::SourceList "$root/sources.list";
Dir::Etc::SourceParts "-";
Dir::State "$root";
Dir::State::Lists "$root/lists";
Dir::State::status "$root/status";
Dir::Cache "$root";
Dir::Cache::Archives "$root/archives";
Dir::Cache::pkgcache "";
Dir::Cache::srcpkgcache "";
Dir::Log "$root";
APT::Architecture "$architecture";
APT::Architectures { "$architecture"; };
Acquire::Languages "none";
Acquire::Retries "3";
APT::Sandbox::User "root";
EOF
}

fetch() {
  local architecture=$1 folder=$2 work mirror
  command -v apt-get > /dev/null || fail "needs apt-get; put the files of ${packages[*]} for $architecture into $folder"
  [[ -r $keys ]] || fail "$keys is missing (Debian: apt-get install debian-archive-keyring)"
  mkdir -p "$(dirname "$folder")"
  work=$(mktemp -d "$(dirname "$folder")/sysroot.XXXXXX")
  # shellcheck disable=SC2064  # the folder of now
  trap "rm -rf '$work'" EXIT
  mirror=$("$(dirname "${BASH_SOURCE[0]}")/mirror.sh") || fail "Debian's packages for $architecture cannot be fetched"
  private_apt "$work/apt" "$architecture"
  export APT_CONFIG="$work/apt/apt.conf"
  apt-get -q update > "$work/log" 2>&1 || { cat "$work/log" >&2; fail "no package lists for $architecture"; }
  (cd "$work/apt/archives" && apt-get -q download "${packages[@]}") > "$work/log" 2>&1 ||
    { cat "$work/log" >&2; fail "not all packages could be fetched for $architecture"; }
  mkdir "$work/root"
  for package in "$work"/apt/archives/*.deb; do
    dpkg-deb -x "$package" "$work/root"
  done
  # What an archive links to by its absolute path lies in the folder too.
  find "$work/root" -type l -lname '/*' -print0 | while IFS= read -r -d '' link; do
    ln -snfr "$work/root$(readlink "$link")" "$link"
  done
  (cd "$work/apt/archives" && sha256sum ./*.deb) > "$work/root/packages.sha256"
  rm -rf "$folder"
  mv "$work/root" "$folder"
}

if [[ ${1:-} == --folder ]]; then
  known "${2:-}"
  folder_of "$2"
  exit 0
fi
known "${1:-}"
folder=$(folder_of "$1")
[[ -s $folder/packages.sha256 ]] || fetch "$1" "$folder"

# A clean Debian 12 to try things in, as root; a script sources it from the folder of the project. It is
# kept in build/clean with the packages that have come once, and made anew where that is gone.

suite=bookworm
clean="$PWD/build/clean"
image="$clean/$suite-$(dpkg --print-architecture).tar"

# What lacks here may not lack where everything has to hold.
skip() {
  echo "skipped: $*"
  [ "${CI:-}" != true ] || exit 1
  exit 77
}

require_root() {
  [ "$(id -u)" -eq 0 ] || skip "a clean system needs root"
  command -v debootstrap > /dev/null || skip "debootstrap is not installed"
}

# Makes the folder $root, which is gone at the end of the script.
make_clean_system() {
  local began="$SECONDS" mirror
  root="$(mktemp -d "${TMPDIR:-/tmp}/tendonlife-clean.XXXXXX")"
  trap remove_clean_system EXIT
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
  mkdir -p "$clean/archives"
  cp -n "$clean"/archives/*.deb "$root/var/cache/apt/archives/" 2> /dev/null || true
  cp /etc/resolv.conf "$root/etc/resolv.conf"
}

remove_clean_system() {
  local place
  # What is mounted there is not its own.
  for place in "$root"/proc "$root"/mnt/*; do
    ! mountpoint -q "$place" || umount "$place" || exit 1
  done
  rm -rf "$root"
}

# run_in_clean_system COMMAND... with an environment of its own, and packages kept.
run_in_clean_system() {
  local result=0
  env -i PATH=/usr/local/sbin:/usr/local/bin:/usr/sbin:/usr/bin:/sbin:/bin HOME=/root LANG=C.UTF-8 \
    DEBIAN_FRONTEND=noninteractive http_proxy="${http_proxy:-}" https_proxy="${https_proxy:-}" \
    chroot "$root" "$@" || result=$?
  cp -n "$root"/var/cache/apt/archives/*.deb "$clean/archives/" 2> /dev/null || true
  return "$result"
}

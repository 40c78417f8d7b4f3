#!/usr/bin/env bash
# Runs as root in a clean Debian, with the packages beside it: installs, uses and purges them.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")"

# Every file that is neither apt's nor dpkg's own, nor a log.
files() {
  find / -xdev \( -path /proc -o -path /sys -o -path /dev -o -path /tmp -o -path /root \
    -o -path /var/lib/apt -o -path /var/cache -o -path /var/lib/dpkg -o -path /var/log \) -prune \
    -o -print | sort
}

# expect WHAT COMMAND...: COMMAND does, or the run ends.
expect() {
  local what="$1"
  shift
  if ! "$@"; then
    echo "FAILED: $what: $*"
    exit 1
  fi
  echo "$what"
}

holds() { grep -q -- "$2" "$1"; }

apt=(apt-get -q -y -o APT::Sandbox::User=root -o APT::Keep-Downloaded-Packages=true
  --no-install-recommends)
"${apt[@]}" update > apt.log 2>&1 || { tail -n 5 apt.log; exit 1; }
files > before
"${apt[@]}" install ./tendonlife_*.deb > apt.log 2>&1 || { tail -n 20 apt.log; exit 1; }

documents=/usr/share/doc/tendonlife
examples=$documents/examples
host_sim --version > version
expect "version $(cat version)" test "$(cat version)" = "$(dpkg-query -W -f '${Version}' tendonlife)"
host_sim replay $examples/upper_arm.csv --model $examples/upper_arm.toml --report page.html \
  --json result.json --can run.log > summary
expect "a report was written" holds page.html '</html>'
expect "the example uses what it has to" holds summary 'life used     0.0209475 '
host_sim monitor --log run.log --once > table
expect "the monitor reads the log" holds table 'normal'
host_sim calibrate $examples/tendon_alt --bootstraps 50 --out model.toml > /dev/null
host_sim pack model.toml --out block.bin
expect "a fitted model was packed" test -s block.bin
expect "MPI is not needed" test -z "$(dpkg-query -W -f '${Package} ' '*mpi*' 2> /dev/null)"
expect "the program is stripped" test -z "$(grep -a -o '\.symtab' /usr/bin/host_sim)"

for file in /usr/share/bash-completion/completions/host_sim \
  /usr/share/zsh/vendor-completions/_host_sim /usr/share/fish/vendor_completions.d/host_sim.fish \
  $documents/copyright $documents/changelog.gz $documents/README.md \
  $documents/host_sim/README.md; do
  expect "$file" test -s $file
done
expect "bash reads the completion" bash -n /usr/share/bash-completion/completions/host_sim
gzip -dc /usr/share/man/man1/host_sim.1.gz > page.1
expect "the manual page names the examples" holds page.1 "$examples/upper_arm.csv"

"${apt[@]}" purge tendonlife > apt.log 2>&1
"${apt[@]}" autoremove --purge >> apt.log 2>&1
files > after
expect "nothing is left" diff before after

"${apt[@]}" install ./liblifemodel-dev_*.deb > apt.log 2>&1 || { tail -n 20 apt.log; exit 1; }
expect "headers" test -s /usr/include/lifemodel/c/lifemodel.h
expect "package for CMake" test -s /usr/lib/*/cmake/lifemodel/lifemodelConfig.cmake
"${apt[@]}" purge liblifemodel-dev > apt.log 2>&1
files > after
expect "nothing is left" diff before after

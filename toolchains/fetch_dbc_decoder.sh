#!/usr/bin/env bash
# Puts the third-party reader of DBC files that the tests compare with (candied, from npm) into a cache
# folder outside the source tree.
#
#   fetch_dbc_decoder.sh [FOLDER]   fetches into FOLDER (default: the folder that --folder prints)
#   fetch_dbc_decoder.sh --folder   prints the default folder
#
# Does nothing when the files are there already. The archive must match the checksum below.
set -euo pipefail

version=2.2.0
sha512=r2C6Ekh7nF8TbgLFL94r1SMWijiYKS8MBw6yb99FKVXvpa8OeH15WgRwV6PfPKENVAsMFQP0YU6SqemkUrWmXQ==
files=(dist/index.cjs.js LICENSE)

fail() {
  echo "fetch_dbc_decoder.sh: $*" >&2
  exit 1
}

default_folder() {
  local cache=${XDG_CACHE_HOME:-}
  if [[ -z $cache ]]; then
    [[ -n ${HOME:-} ]] || fail "neither XDG_CACHE_HOME nor HOME is set: name a folder"
    cache=$HOME/.cache
  fi
  echo "$cache/tendonlife/candied-$version"
}

complete() {
  local file
  for file in "${files[@]}"; do
    [[ -s $1/$(basename "$file") ]] || return 1
  done
}

if [[ ${1:-} == --folder ]]; then
  default_folder
  exit 0
fi
folder=${1:-$(default_folder)}
complete "$folder" && exit 0

command -v npm >/dev/null || fail "npm is needed to fetch candied $version (Debian: apt-get install npm)"
command -v openssl >/dev/null || fail "openssl is needed to check the download"

work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
npm pack --silent --pack-destination "$work" "candied@$version" >/dev/null ||
  fail "npm could not fetch candied $version; without network, put $(basename -a "${files[@]}" | paste -sd ' ') into $folder"
archive=$work/candied-$version.tgz
found=$(openssl dgst -sha512 -binary "$archive" | openssl base64 -A)
[[ $found == "$sha512" ]] || fail "checksum of $archive is sha512-$found, expected sha512-$sha512"

tar -xzf "$archive" -C "$work" "${files[@]/#/package/}"
mkdir -p "$folder"
for file in "${files[@]}"; do
  mv "$work/package/$file" "$folder/$(basename "$file")"
done

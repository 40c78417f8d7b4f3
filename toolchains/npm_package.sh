# Fetches a pinned package of npm into a cache folder outside the source tree. A thin script sets
# package, version, sha512 and files (paths in the package), and then sources this with its own
# arguments:
#
#   SCRIPT [FOLDER]   fetches into FOLDER (default: the folder that --folder prints)
#   SCRIPT --folder   prints the default folder
#
# Does nothing when the files are there already. The archive must match the checksum.
set -euo pipefail

fail() {
  echo "$(basename "$0"): $*" >&2
  exit 1
}

default_folder() {
  local cache=${XDG_CACHE_HOME:-}
  if [[ -z $cache ]]; then
    [[ -n ${HOME:-} ]] || fail "neither XDG_CACHE_HOME nor HOME is set: name a folder"
    cache=$HOME/.cache
  fi
  echo "$cache/tendonlife/$package-$version"
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

command -v npm >/dev/null || fail "npm is needed to fetch $package $version (Debian: apt-get install npm)"
command -v openssl >/dev/null || fail "openssl is needed to check the download"

work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
npm pack --silent --pack-destination "$work" "$package@$version" >/dev/null ||
  fail "npm could not fetch $package $version; without network, put $(basename -a "${files[@]}" | paste -sd ' ') into $folder"
archive=$work/$package-$version.tgz
found=$(openssl dgst -sha512 -binary "$archive" | openssl base64 -A)
[[ $found == "$sha512" ]] || fail "checksum of $archive is sha512-$found, expected sha512-$sha512"

tar -xzf "$archive" -C "$work" "${files[@]/#/package/}"
mkdir -p "$folder"
for file in "${files[@]}"; do
  mv "$work/package/$file" "$folder/$(basename "$file")"
done

#!/usr/bin/env bash
# pages_in_browser.sh MAKE_PAGES FOLDER INTERACT
# Loads every sample page in headless Chromium. Passes when each page says that it has drawn as many
# plots as it should and met no error, the drawn elements are in the document, and a page answers to
# the keyboard as INTERACT expects, wide and narrow.
set -euo pipefail
here="$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)"

make_pages=$1
folder=$2
interact=$3
skipped=77

browser=$(command -v chromium || command -v chromium-browser || command -v google-chrome || true)
if [[ -z $browser ]]; then
  echo "SKIPPED: no Chromium found, the page was NOT tried in a browser" >&2
  exit "$skipped"
fi

rm -rf "$folder"
"$make_pages" "$folder"
profile=$(mktemp -d)
trap 'rm -rf "$profile"' EXIT

failures=0
complain() {
  echo "FAILED $1: $2" >&2
  failures=$((failures + 1))
}

# Writes the document of page NAME, as it is after loading in a window of WIDTH, to DOM.
load() {
  local name=$1 width=$2 dom=$3
  timeout 60 "$browser" --headless --no-sandbox --disable-gpu --disable-quic --no-first-run \
    --disable-background-networking --disable-component-update --disable-sync \
    --user-data-dir="$profile" --window-size="$width,2400" --virtual-time-budget=5000 \
    --dump-dom "file://$(realpath "$folder")/$name.html" >"$dom" 2>"$dom.log" ||
    complain "$name" "the browser did not load the page: $(tail -n 3 "$dom.log")"
}

root_of() {
  grep -o -m 1 '<html[^>]*>' "$1" || true
}

while read -r name charts; do
  dom=$folder/$name.dom.html
  load "$name" 1280 "$dom"
  root=$(root_of "$dom")
  [[ $root == *'data-ready="true"'* ]] || complain "$name" "the page is not ready: $root"
  [[ $root == *"data-charts=\"$charts\""* ]] || complain "$name" "expected $charts plots: $root"
  [[ $root != *data-error* ]] || complain "$name" "an error in the page: $root"
  lines=$({ grep -o '<canvas' "$dom" || true; } | wc -l)
  maps=$({ grep -o 'class="frame"' "$dom" || true; } | wc -l)
  ((lines + maps == charts)) || complain "$name" "$lines line charts and $maps heat maps"
  echo "$name: $lines line charts, $maps heat maps"
done <"$folder/charts.txt"

sed -e '/^<\/body>/{s/.*/<script>/;r '"$here/interaction.js"'
r '"$interact"'
a </script></body>
}' "$folder/typical.html" >"$folder/used.html"
for width in 1280 500; do
  load used "$width" "$folder/used.dom.html"
  root=$(root_of "$folder/used.dom.html")
  [[ $root == *'data-interaction="ok"'* ]] || complain "used at $width px" "$root"
  [[ $root != *data-error* ]] || complain "used at $width px" "an error in the page: $root"
done
exit "$((failures > 0))"

#!/usr/bin/env bash
# Prints where this machine gets Debian's packages from, as its own apt sources say.
set -euo pipefail

suite="$(. /etc/os-release && echo "${VERSION_CODENAME:-}")"
address="$(apt-get indextargets --format '$(RELEASE) $(REPO_URI)' |
  awk -v suite="$suite" '$1 == suite && $2 ~ /^https?:/ && !found { print $2; found = 1 }')"
if [ -z "$address" ]; then
  echo "mirror.sh: no source of apt on this machine has the suite '$suite' over http or https" >&2
  exit 1
fi
echo "${address%/}"

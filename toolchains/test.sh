#!/usr/bin/env bash
# Installs what the tests on this machine need, builds them and runs them. Stops at the first failure;
# the last line counts stages and tests: N passed, N failed.
#
# What takes longer or needs more packages, blind campaigns, proofs, boards, a kernel, sanitizers,
# fuzzing, pages in a browser, packages, is in test_all.sh.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
. toolchains/stages.sh

check_format() {
  git ls-files -z '*.c' '*.h' '*.cpp' '*.hpp' | xargs -0 clang-format --dry-run --Werror
}

try_example() {
  toolchains/try.sh
  test -s build/host-release/upper_arm.html
}

stage "set-up" toolchains/setup.sh test
use_compiler_cache
stage "first command of the README" try_example
stage "format" check_format
stage "host-release: build" build host-release -DTENDONLIFE_TESTS=ON \
  -DTENDONLIFE_LONG_TESTS=OFF -DTENDONLIFE_BENCH=OFF
stage "host-release: tests" run_tests host-release
finish

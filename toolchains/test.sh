#!/usr/bin/env bash
# Installs what is missing, then runs everything that has to hold. Stops at the first failure; the
# last line counts stages and tests: N passed, N failed.
#
# Logs of the stages lie in build/logs.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."

# What the set-up has installed may not be missing.
export CI=true TENDONLIFE_REQUIRE_KERNEL=1
# host_sim is built by the first command and again with its tests.
export CMAKE_C_COMPILER_LAUNCHER=ccache CMAKE_CXX_COMPILER_LAUNCHER=ccache
# Builds of one kind find each other's objects.
export CCACHE_BASEDIR="$PWD" CCACHE_NOHASHDIR=1

jobs="$(nproc)"
logs=build/logs
passed=0
failed=0

# What ctest says in its summary, added to the counts.
count_tests() {
  local not_passed total
  while read -r not_passed total; do
    failed=$((failed + not_passed))
    passed=$((passed + total - not_passed))
  done < <(sed -n 's/^[0-9]*% tests passed, \([0-9]*\) tests* failed out of \([0-9]*\)$/\1 \2/p' "$1")
}

stage() {
  local name="$1" log="$logs/${1//[^A-Za-z0-9]/_}.log" began="$SECONDS" result
  shift
  printf '%-46s' "$name"
  # In a subshell and not in a condition, where set -e would mean nothing.
  set +e
  (set -e; "$@") > "$log" 2>&1 < /dev/null
  result=$?
  set -e
  count_tests "$log"
  if [ "$result" -ne 0 ]; then
    echo "FAILED after $((SECONDS - began)) s"
    tail -n 100 "$log"
    echo "The whole output is in $log"
    echo "$passed passed, $((failed + 1)) failed"
    exit 1
  fi
  passed=$((passed + 1))
  echo "passed in $((SECONDS - began)) s"
  # What was left out is part of the result.
  sed -n 's/^ *[0-9]*\/[0-9]* Test .*: \(.*\) \.*\*\*\*Skipped.*/  skipped: \1/p' "$log"
}

check_format() {
  git ls-files -z '*.c' '*.h' '*.cpp' '*.hpp' | xargs -0 clang-format --dry-run --Werror
}

build() {
  cmake --preset "$@"
  cmake --build --preset "$1" -j "$jobs"
}

# Tests that need a kernel have a stage of their own.
run_tests() {
  ctest --preset "$1" -LE 'kernel|blind' -j "$jobs" --timeout 900
}

# Each analyses many campaigns, on all cores.
run_blind_tests() {
  ctest --preset host-release -L blind --timeout 1800
}

# Their kernels wait for their clocks most of the time.
run_kernel_tests() {
  ctest --preset host-release -L kernel -j "$((2 * jobs))" --timeout 600
}

show_budgets() {
  local checks=tests/target/checks/check_budget.py stm32=build/stm32g431/tests/target/b_g431b_esc1 section
  for section in instructions size stack firmware_instructions firmware_size firmware_stack \
    extended_instructions extended_stack; do
    echo "$section on qemu_mps2"
    python3 $checks $section build/qemu-m4/tests/target/$section.json
  done
  for section in size stack; do
    echo "$section on b_g431b_esc1"
    python3 $checks $section $stm32/$section.json tests/target/b_g431b_esc1/budget.json
  done
}

build_fuzzers() {
  cmake --preset host-fuzz
  local -a fuzzers
  mapfile -t fuzzers < <(ninja -C build/host-fuzz -t targets all |
    sed -n 's/^\(fuzz_[a-z0-9_]*\): phony$/\1/p')
  if [ "${#fuzzers[@]}" -eq 0 ]; then
    echo "there are no fuzz targets"
    return 1
  fi
  cmake --build --preset host-fuzz -j "$jobs" --target "${fuzzers[@]}"
}

compare_host_and_target() {
  local host
  for host in host-release host-asan-ubsan; do
    tests/target/trail/compare.sh "build/$host/tests/target/host/trail" \
      build/qemu-m4/tests/target/trail/run_trail
    python3 tests/target/firmware/compare.py "build/$host/tests/target/host/record" \
      "build/$host/tests/target/host/firmware_host" \
      build/qemu-m4/tests/target/firmware/run_firmware
    python3 tests/target/firmware/compare_extended.py \
      "build/$host/tests/target/host/extended_host" "build/$host/tests/target/host/extended_host" \
      build/qemu-m4/tests/target/firmware/run_extended
  done
}

# lifemodel from its installed package alone, as others use it.
use_package() {
  local stage="$PWD/build/package" example
  rm -rf "$stage"
  cmake --install build/host-release --prefix "$stage/prefix" --component lifemodel
  for example in control_loop control_loop_c; do
    cmake -G Ninja -S "lifemodel/examples/$example" -B "$stage/$example" \
      -DCMAKE_PREFIX_PATH="$stage/prefix" -DCMAKE_BUILD_TYPE=Release
    cmake --build "$stage/$example" -j "$jobs"
  done
  "$stage/control_loop/control_loop" | grep '^life used: 0\.[0-9]*[1-9]'
  build/host-release/host_sim/host_sim pack host_sim/examples/upper_arm.toml --out "$stage/block"
  "$stage/control_loop_c/control_loop_c" "$stage/block" | grep '^life used: [1-9][0-9]* ppb$'
}

# The analyzer follows every path of what runs on a board. What runs on hosts alone is held by the
# sanitizers, and would take it longer than all else together. Its sources are read many at a time,
# from the files of the unity build that include them.
check_with_clang_tidy() {
  # Clang does not know all warnings that GCC is told of.
  local -a tidy=(run-clang-tidy -quiet -j "$jobs" -p build/host-release
    -extra-arg=-Wno-unknown-warning-option)
  "${tidy[@]}" "^$PWD/(lifemodel|firmware|hal)/"
  "${tidy[@]}" -checks='-clang-analyzer-*,-bugprone-suspicious-include' \
    "^$PWD/(build/host-release/)?host_sim/"
}

try_example() {
  toolchains/try.sh
  test -s build/try/upper_arm.html
}

mkdir -p "$logs"
stage "set-up" toolchains/setup.sh test
stage "format" check_format
stage "first command of the README" try_example
stage "host-asan-ubsan: build" build host-asan-ubsan
stage "host-asan-ubsan: tests" run_tests host-asan-ubsan
stage "host-release: build" build host-release -DTENDONLIFE_MPI=ON
stage "host-release: tests" run_tests host-release
stage "host-release: blind suite, a sample" run_blind_tests
stage "host-fuzz: build" build_fuzzers
stage "host-fuzz: short runs" ctest --preset host-fuzz -L fuzz -j "$jobs" --timeout 900
stage "qemu-m4: build" build qemu-m4
stage "qemu-m4: tests" run_tests qemu-m4
stage "stm32g431: build" build stm32g431
stage "stm32g431: tests" run_tests stm32g431
show_budgets
for architecture in aarch64 armhf; do
  stage "linux-$architecture: build" build linux-$architecture
  stage "linux-$architecture: tests" run_tests linux-$architecture
done
stage "kernel: build" toolchains/build_uml.sh
stage "kernel: tests" run_kernel_tests
stage "bit-identical on host and target" compare_host_and_target
stage "lifemodel installed and used" use_package
stage "package in a clean Debian 12" toolchains/try_package.sh
stage "clang-tidy" check_with_clang_tidy
echo "$passed passed, $failed failed"

#!/usr/bin/env bash
# Installs the rest and runs what test.sh leaves out. Stops at the first failure; the last line counts
# stages and tests: N passed, N failed.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
. toolchains/stages.sh

# What the set-up has installed may not be missing.
export CI=true TENDONLIFE_REQUIRE_KERNEL=1

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
  for section in size stack instructions; do
    echo "$section on b_g431b_esc1"
    python3 $checks $section $stm32/$section.json tests/target/b_g431b_esc1/budget.json
  done
}

compare_host_and_target() {
  local host=build/host-release/tests/target/host target=build/qemu-m4/tests/target
  tests/target/trail/compare.sh "$host/trail" $target/trail/run_trail
  python3 tests/target/firmware/compare.py "$host/record" "$host/firmware_host" \
    $target/firmware/run_firmware
  python3 tests/target/firmware/compare_extended.py "$host/extended_host" "$host/extended_host" \
    $target/firmware/run_extended
}

# The analyzer follows the paths of what runs on a board, and only of what stands in the main file of a
# unit: those sources are read one by one, and paths of a function end at 50,000 states (225,000 by
# default, of which one file made five minutes). What runs on hosts alone is held by the sanitizers, and
# would take the analyzer longer than all else together. Its sources are read many at a time, from the
# files of the unity build that include them, and by the checks that see what no warning of the
# compilers does: each check goes through all that is included.
check_with_clang_tidy() {
  # Clang does not know all warnings that GCC is told of, and warns of reserved names sooner than the
  # check of its own.
  local -a tidy=(run-clang-tidy -quiet -j "$jobs" -extra-arg=-Wno-unknown-warning-option
    -extra-arg=-Wreserved-identifier)
  local -a fewer_states=(-extra-arg=-Xclang -extra-arg=-analyzer-config
    -extra-arg=-Xclang -extra-arg=max-nodes=50000)
  local hosts_checks='-*,readability-identifier-naming,misc-unused-*,modernize-use-override'
  hosts_checks+=',bugprone-use-after-move,bugprone-dangling-handle,bugprone-unused-*'
  hosts_checks+=',bugprone-infinite-loop,bugprone-integer-division,bugprone-branch-clone'
  hosts_checks+=',bugprone-implicit-widening-of-multiplication-result,cppcoreguidelines-slicing'
  hosts_checks+=',performance-unnecessary-*,performance-for-range-copy,performance-move-const-arg'
  cmake --preset host-release -B build/one-by-one -DCMAKE_UNITY_BUILD=OFF
  "${tidy[@]}" "${fewer_states[@]}" -p build/one-by-one "^$PWD/(lifemodel|firmware/boards|hal/linux)/"
  "${tidy[@]}" -p build/host-release -checks="$hosts_checks" \
    "^$PWD/build/host-release/(host_sim|firmware/CMakeFiles|hal/CMakeFiles/hal_files)"
}

stage "set-up of everything" toolchains/setup.sh all
use_compiler_cache
stage "structure of the sources" toolchains/structure.py
cat "$logs/structure_of_the_sources.log"
stage "host-release: what needs more to build" build host-release -DTENDONLIFE_TESTS=ON \
  -DTENDONLIFE_MPI=ON -DTENDONLIFE_MQTT=ON
stage "host-release: what needs more to run" run_tests host-release tools
stage "host-release: proofs" run_tests host-release proof
stage "host-release: blind suite, a sample" run_tests host-release blind
stage "host-asan-ubsan: build" build host-asan-ubsan
stage "host-asan-ubsan: tests" run_tests host-asan-ubsan
stage "host-asan-ubsan: short runs of the fuzzers" run_tests host-asan-ubsan fuzz
stage "qemu-m4: build" build qemu-m4
stage "qemu-m4: tests" run_tests qemu-m4
stage "stm32g431: build" build stm32g431
stage "stm32g431: tests" run_tests stm32g431
stage "virtual STM32G431: the image runs" run_tests host-release virtual
show_budgets
for architecture in aarch64 armhf; do
  stage "linux-$architecture: build" build linux-$architecture
  stage "linux-$architecture: tests" run_tests linux-$architecture
done
stage "kernel: build" toolchains/build_uml.sh
stage "kernel: tests" run_kernel_tests
stage "bit-identical on host and target" compare_host_and_target
stage "lifemodel in builds of others" toolchains/try_lifemodel.sh
stage "package in a clean Debian 12" toolchains/try_package.sh
stage "README in a clean Debian 12" toolchains/try_readme.sh
stage "clang-tidy" check_with_clang_tidy
finish

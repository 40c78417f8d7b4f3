# What test.sh and test_all.sh run their stages with; a script sources it from the folder of the project.
# The last line that a script prints counts stages and tests: N passed, N failed. Logs lie in build/logs.

jobs="$(nproc)"
logs=build/logs
passed=0
failed=0
mkdir -p "$logs"
export TENDONLIFE_WARNINGS_ARE_ERRORS=ON

# After the set-up, which installs ccache. Builds of one kind find each other's objects, as that of the
# packages does those of the tests.
use_compiler_cache() {
  export CMAKE_C_COMPILER_LAUNCHER=ccache CMAKE_CXX_COMPILER_LAUNCHER=ccache
  export CCACHE_BASEDIR="$PWD" CCACHE_NOHASHDIR=1
}

# What ctest says in its summary, added to the counts.
count_tests() {
  local not_passed total
  while read -r not_passed total; do
    failed=$((failed + not_passed))
    passed=$((passed + total - not_passed))
  done < <(sed -n 's/^[0-9]*% tests passed, \([0-9]*\) tests* failed out of \([0-9]*\)$/\1 \2/p' "$1")
}

# stage NAME COMMAND [ARGUMENT]... runs a command whose output goes into a log, and ends the script
# where it fails.
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

finish() {
  echo "$((SECONDS / 60)) min $((SECONDS % 60)) s"
  echo "$passed passed, $failed failed"
}

build() {
  cmake --preset "$@"
  cmake --build --preset "$1" -j "$jobs"
}

# run_tests PRESET [LABEL] runs the tests of this machine, or those that have a label.
run_tests() {
  if [ $# -eq 1 ]; then
    ctest --preset "$1" -LE 'blind|fuzz|kernel|proof|tools|virtual' -j "$jobs" --timeout 900
  else
    ctest --preset "$1" -L "$2" -j "$jobs" --timeout 1800
  fi
}

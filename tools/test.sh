#!/bin/bash
# Builds Quoin with warnings as errors and runs every test, then runs the quick ones again
# under the address and undefined-behaviour sanitizers, those with threads under the thread
# sanitizer and some of the core under valgrind. Sets the machine up first where something is
# missing. The last line says how many tests passed and failed.
set -euo pipefail
cd "$(dirname "$0")/.."
exec </dev/null

tools/setup.sh

passed=0
failed=0

# count FOLDER STATUS: adds the test cases of a finished run to the totals. A program that fails
# without a failing case (a crash, a leak found at its end) counts as one.
count () {
  local log good=0 bad=0 programs=0
  log=$(echo "$1"/meson-logs/testlog*.junit.xml) # of a setup: testlog-valgrind
  if [ -f "$log" ]; then
    read -r good bad < <(awk '
      function value (name) {
        return match ($0, " " name "=\"[0-9]+\"") \
          ? substr ($0, RSTART + length (name) + 3, RLENGTH - length (name) - 4) + 0 : 0
      }
      BEGIN { RS = ">" }
      /<testsuite / {
        wrong = value ("failures") + value ("errors")
        bad += wrong
        good += value ("tests") - wrong - value ("skipped")
      }
      END { print good + 0, bad + 0 }' "$log")
    programs=$(grep -cvE '"result": "(OK|SKIP|EXPECTEDFAIL)"' "${log%.junit.xml}.json" || true)
  fi
  if [ "$bad" -lt "$programs" ]; then
    bad=$programs
  fi
  if [ "$2" -ne 0 ] && [ "$bad" -eq 0 ]; then
    bad=1
  fi
  passed=$((passed + good))
  failed=$((failed + bad))
}

# check FOLDER SETUP-OPTION... -- TEST-OPTION...: configures, builds and tests one build; of the
# targets only those in $targets where that is set.
targets=
check () {
  local folder=$1 status=0
  shift
  local options=()
  while [ "$1" != -- ]; do
    options+=("$1")
    shift
  done
  shift
  if [ ! -f "$folder/build.ninja" ]; then
    meson setup "$folder" -Dwerror=true "${options[@]}" || status=$?
  fi
  if [ "$status" -eq 0 ]; then
    # shellcheck disable=SC2086 # several targets
    ninja -C "$folder" $targets || status=$?
  fi
  rm -f "$folder"/meson-logs/testlog*
  if [ "$status" -eq 0 ]; then
    meson test -C "$folder" --no-rebuild --print-errorlogs "$@" || status=$?
  fi
  count "$folder" "$status"
}

echo "== tests"
check build-test -- --timeout-multiplier 3

echo "== tests under sanitizers"
export ASAN_OPTIONS=detect_leaks=1:abort_on_error=1
export LSAN_OPTIONS="suppressions=$PWD/tests/sanitize/leaks.supp:print_suppressions=0"
export UBSAN_OPTIONS=print_stacktrace=1:halt_on_error=1
check build-sanitize -Db_sanitize=address,undefined -Db_lundef=false -- \
  --timeout-multiplier 6 --no-suite slow --no-suite app

echo "== threads under the thread sanitizer"
export TSAN_OPTIONS="suppressions=$PWD/tests/sanitize/thread.supp:halt_on_error=1"
targets="tests/faults/test-faults-parallel tests/doc/test-doc-job"
check build-thread -Db_sanitize=thread -Db_lundef=false -Dapp=disabled -- \
  --timeout-multiplier 10 parallel doc-job
targets=

echo "== the core under valgrind"
check build-test -- --setup valgrind newton lanczos stability interior-point path-stages \
  central-path weld polygon-ops json-parse whole-file

echo "$passed passed, $failed failed"
[ "$failed" -eq 0 ]

#!/bin/bash
# Builds Quoin with warnings as errors and runs every test, then runs the quick ones and those of
# the window again under the address and undefined-behaviour sanitizers, those with threads under
# the thread sanitizer and some of the core under valgrind; then builds Quoin in other ways
# (tools/build-matrix.sh). Sets the machine up first where something is missing. The last lines name
# the programs that failed, in which build and at which cases, and the very last one says how many
# tests passed and failed.
set -euo pipefail
cd "$(dirname "$0")/.."
exec </dev/null

# clang and its C++ compiler, for the other builds.
tools/setup.sh clang

# Several hundred programs are linked: gold takes a quarter of the time.
if command -v ld.gold >/dev/null; then
  export CC_LD=gold CXX_LD=gold
fi

passed=0
failed=0
failures=()

# name_failures FOLDER: notes the programs of a finished run that failed, with their cases. A program
# that was cut off names the case that it had last finished, and what it said at its end.
name_failures () {
  local log build line
  log=$(echo "$1"/meson-logs/testlog*.json) # of a setup: testlog-valgrind
  build=${log##*/testlog}
  build=$1${build%.json}
  if [ ! -f "$log" ]; then
    return
  fi
  while IFS= read -r line; do
    failures+=("$build: $line")
  done < <(python3 - "$log" <<'END'
import json, re, sys

for line in open(sys.argv[1], encoding="utf-8", errors="replace"):
    test = json.loads(line)
    if test["result"] in ("OK", "SKIP", "EXPECTEDFAIL"):
        continue
    said = (test.get("stdout") or "").splitlines()
    cases = [m[1] for m in (re.match(r"not ok \d+ (.*)", text) for text in said) if m]
    if not cases:
        good = [m[1] for m in (re.match(r"ok \d+ (\S+)", text) for text in said) if m]
        cases = ["after " + good[-1]] if good else []
        errors = (test.get("stderr") or "").splitlines()
        telling = [e for e in errors + said if re.search(r"ERROR|Bail out|SUMMARY", e)]
        cases += (telling or [e for e in errors if e.strip()])[-1:]
    detail = "; ".join(case.strip() for case in cases)
    print(f"{test['name']}: {test['result']}" + (f": {detail[:300]}" if detail else ""))
END
  )
}

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
    failures+=("$1: ended with status $2")
  fi
  passed=$((passed + good))
  failed=$((failed + bad))
}

# build FOLDER SETUP-OPTION...: configures where that is still to be done, and builds; of the targets
# only those in $targets where that is set.
targets=
build () {
  local folder=$1
  shift
  if [ ! -f "$folder/build.ninja" ]; then
    meson setup "$folder" -Dwerror=true "$@" || return
  fi
  # shellcheck disable=SC2086 # several targets
  ninja -C "$folder" $targets
}

# check FOLDER SETUP-OPTION... -- TEST-OPTION...: builds and tests.
said=$(mktemp)
trap 'rm -f "$said"' EXIT
check () {
  local folder=$1 status=0
  shift
  local options=()
  while [ "$1" != -- ]; do
    options+=("$1")
    shift
  done
  shift
  build "$folder" "${options[@]}" 2>&1 | tee "$said" || status=$?
  if [ "$status" -ne 0 ]; then
    failures+=("$folder: not built: $(grep -m 1 -iE 'error: |undefined reference' "$said" \
      || tail -n 1 "$said")")
    failed=$((failed + 1))
    return
  fi
  rm -f "$folder"/meson-logs/testlog*
  meson test -C "$folder" --no-rebuild --print-errorlogs "$@" || status=$?
  count "$folder" "$status"
  name_failures "$folder"
}

# What a test leaves in the temporary folder is found at the end.
TMPDIR=$(mktemp -d)
export TMPDIR

echo "== tests"
check build-test -- --timeout-multiplier 3 --no-suite app --no-suite monkey

# These wait for the display half of their time.
waiting=$((2 * $(nproc)))
echo "== the window"
check build-test -- --timeout-multiplier 3 --num-processes $waiting --suite app

echo "== tests under sanitizers"
export ASAN_OPTIONS=detect_leaks=1:abort_on_error=1
export LSAN_OPTIONS="suppressions=$PWD/tests/sanitize/leaks.supp:print_suppressions=0"
export UBSAN_OPTIONS=print_stacktrace=1:halt_on_error=1
check build-sanitize -Db_sanitize=address,undefined -Db_lundef=false -- \
  --timeout-multiplier 6 --no-suite slow

echo "== the window under sanitizers"
check build-sanitize -- --timeout-multiplier 6 --num-processes $waiting --suite app

echo "== threads under the thread sanitizer"
export TSAN_OPTIONS="suppressions=$PWD/tests/sanitize/thread.supp:halt_on_error=1"
targets="tests/faults/test-faults-parallel tests/doc/test-doc-job tests/doc/test-doc-threads"
check build-thread -Db_sanitize=thread -Db_lundef=false -Dapp=disabled -- \
  --timeout-multiplier 10 parallel doc-job doc-threads
targets=

echo "== the core under valgrind"
check build-test -- --setup valgrind newton lanczos stability interior-point path-stages \
  central-path weld polygon-ops io-json-parse whole-file

echo "== other builds"
tools/build-matrix.sh | tee "$said" || true
while read -r cell word _; do
  case $word in
    good) passed=$((passed + 1)) ;;
    FAILED)
      failures+=("tools/build-matrix.sh $cell")
      failed=$((failed + 1))
      ;;
  esac
done < <(sed -n '/^-- matrix$/,$p' "$said" | tail -n +2)
if ! grep -q '^-- matrix$' "$said"; then
  failures+=("tools/build-matrix.sh: ended without a table")
  failed=$((failed + 1))
fi

for left in "$TMPDIR"/quoin*; do
  [ -e "$left" ] || continue
  failures+=("a test left a folder behind: $left")
  failed=$((failed + 1))
done
rm -rf "$TMPDIR"

if [ ${#failures[@]} -gt 0 ]; then
  echo "== failed"
  printf '%s\n' "${failures[@]}"
fi
echo "$passed passed, $failed failed"
[ "$failed" -eq 0 ]

#!/bin/bash
# Builds Quoin with warnings as errors and tests it. The last lines name the programs that failed, in
# which build and at which cases, and the very last one says how many tests passed and failed.
#
#   tools/test.sh --quick   the quick tests, for a change in progress
#   tools/test.sh           what every change must pass: quick tests and the window under the address
#                           and undefined-behaviour sanitizers; with clang, optimised and without the
#                           window, the tests of core, files and stress, those that count work
#                           and the long ones; the programs with gcc, optimised, and without
#                           anything optional
#   tools/test.sh --all     before a release: also storms of faults, benchmarks, random actions in the
#                           window, the thread sanitizer, valgrind, and all other ways to build
#
# tests/README.md says what is in each, and how long it takes.
set -euo pipefail
cd "$(dirname "$0")/.."
exec </dev/null
case ${1-} in
  "" | --quick | --all) mode=${1-} ;;
  *) sed -n '2,/^set/s/^# \{0,1\}//p' "$0" && exit 2 ;;
esac

# clang and its C++ compiler, for the second build.
tools/setup.sh clang

# gold takes a quarter of the time. What is compiled is kept, whatever the folder is called.
if command -v ld.gold >/dev/null; then
  export CC_LD=gold CXX_LD=gold
fi
export CCACHE_BASEDIR=$PWD CCACHE_NOHASHDIR=1 CCACHE_SLOPPINESS=pch_defines,time_macros
ccache=$(command -v ccache || true)

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
    said = (test.get("stdout") or "").splitlines()
    empty = test["result"] == "SKIP" and said[-1:] == ["1..0"]
    if test["result"] in ("OK", "SKIP", "EXPECTEDFAIL") and not empty:
        continue
    cases = [m[1] for m in (re.match(r"not ok \d+ (.*)", text) for text in said) if m]
    if not cases:
        good = [m[1] for m in (re.match(r"ok \d+ (\S+)", text) for text in said) if m]
        cases = ["after " + good[-1]] if good else []
        errors = (test.get("stderr") or "").splitlines()
        telling = [e for e in errors + said if re.search(r"ERROR|Bail out|SUMMARY", e)]
        own = [e for e in errors if e.strip() and not e.startswith("(test program exited with")]
        cases += (telling or own or errors)[-2:]
    if empty:
        cases = ["no case has the path it was called with"]
    detail = "; ".join(case.strip() for case in cases)
    print(f"{test['name']}: {test['result']}" + (f": {detail[:300]}" if detail else ""))
END
  )
}

# count FOLDER STATUS: adds the test cases of a finished run to the totals. A program that fails
# without a failing case (a crash, a leak found at its end), or runs no case at all, counts as one.
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
    programs=$(sed 's/1\.\.0\\n", "result": "SKIP"/"result": "EMPTY"/' "${log%.junit.xml}.json" |
      grep -cvE '"result": "(OK|SKIP|EXPECTEDFAIL)"' || true)
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

# needs FOLDER SUITE...: the targets of the tests of these suites, but for those of the suite "all"; and
# translations.
needs () {
  python3 - "$@" <<'END'
import json, os, sys

folder, suites = os.path.realpath(sys.argv[1]), set(sys.argv[2:])
files = {t["id"]: t["filename"] for t in json.load(open(folder + "/meson-info/intro-targets.json"))}
needed = {os.path.relpath(f, folder) for names in files.values() for f in names if f.endswith(".mo")}
for test in json.load(open(folder + "/meson-info/intro-tests.json")):
    own = {suite.split(":")[-1] for suite in test["suite"]}
    if own & suites and "all" not in own:
        needed.update(os.path.relpath(f, folder) for d in test["depends"] for f in files[d])
print(*sorted(needed))
END
}

# build FOLDER SETUP-OPTION...: configures where that is still to be done, and builds; of the targets
# only those in $targets, or those that the tests of $suites need, where one of them is set.
targets=
suites=
build () {
  local folder=$1
  shift
  if [ ! -f "$folder/build.ninja" ]; then
    meson setup "$folder" -Dwerror=true "$@" || return
  fi
  # shellcheck disable=SC2046,SC2086 # several targets
  ninja -C "$folder" $targets ${suites:+$(needs "$folder" $suites)}
}

# check FOLDER SETUP-OPTION... -- TEST-OPTION...: builds and tests.
said=$(mktemp)
cell=$(mktemp)
behind=
trap 'rm -f "$said" "$cell"; [ -z "$behind" ] || kill "$behind" 2>/dev/null || true' EXIT
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

# tell NAME COMMAND...: runs what has one result of its own for each line after "-- matrix".
tell () {
  local name=$1 cell word
  shift
  "$@" | tee "$said" || true
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
    failures+=("$name: ended without a table")
    failed=$((failed + 1))
  fi
}

# What a test leaves in the temporary folder is found at the end.
TMPDIR=$(mktemp -d)
export TMPDIR

# These wait for the display half of their time.
waiting=$((2 * $(nproc)))
export ASAN_OPTIONS=detect_leaks=1:abort_on_error=1
export LSAN_OPTIONS="suppressions=$PWD/tests/sanitize/leaks.supp:print_suppressions=0"
export UBSAN_OPTIONS=print_stacktrace=1:halt_on_error=1
export TSAN_OPTIONS="suppressions=$PWD/tests/sanitize/thread.supp:halt_on_error=1"

if [ "$mode" = --quick ]; then
  echo "== quick tests"
  check build-test -- --timeout-multiplier 3 --no-suite slow --no-suite all
else
  # Sources of a target together, where names of one may hide those of another, and GTK's headers once:
  # most of the time is the compiler's.
  sanitized=(-Doptimization=1 -Ddebug=false "-Dc_args=-g1 -Wno-shadow" "-Db_sanitize=address,undefined"
    -Db_lundef=false -Dunity=on -Dunity_size=8 -Db_pch=true)
  # with_clang COMMAND TEST-OPTION...: builds, or checks.
  with_clang () {
    CC="$ccache clang" CXX="$ccache clang++" suites="core io stress slow" \
      "$1" build-clang --buildtype=release -Dapp=disabled "${@:2}"
  }

  echo "== quick tests under sanitizers"
  build build-sanitize "${sanitized[@]}" || true # what is wrong is told below
  # The other builds take what the tests leave of the processors.
  (
    renice -n 19 "$BASHPID" >/dev/null
    with_clang build >"$cell" 2>&1 || true
    tools/build-matrix.sh gcc-release >"$cell" 2>&1
  ) &
  behind=$!
  check build-sanitize "${sanitized[@]}" -- \
    --timeout-multiplier 6 --no-suite slow --no-suite all --no-suite stress

  echo "== the window under sanitizers"
  check build-sanitize -- --timeout-multiplier 6 --num-processes $waiting --suite app --no-suite all

  echo "== clang, optimised"
  wait "$behind" || true
  behind=
  with_clang check -- --timeout-multiplier 3 --no-suite all --suite core --suite io --suite stress \
    --suite slow

  echo "== gcc, optimised, and without anything optional"
  tell gcc-release cat "$cell"
fi

if [ "$mode" = --all ]; then
  echo "== before a release"
  check build-test -- --timeout-multiplier 3 --suite all --no-suite app
  check build-test -- --timeout-multiplier 3 --num-processes $waiting --suite app

  echo "== faults under sanitizers"
  check build-sanitize -- --timeout-multiplier 6 --suite faults

  echo "== threads under the thread sanitizer"
  targets="tests/faults/test-faults tests/doc/test-doc-document"
  check build-thread -Db_sanitize=thread -Db_lundef=false -Dapp=disabled -- \
    --timeout-multiplier 10 faults doc-document
  targets=

  echo "== the core under valgrind"
  check build-test -- --setup valgrind core-equilibrium core-linalg core-limit stereotomy io-json disk

  echo "== other builds"
  tell matrix tools/build-matrix.sh all
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

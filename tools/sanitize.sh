#!/bin/bash
# Runs tests under a sanitizer, each in a build of its own.
#
#   tools/sanitize.sh address             quick tests under ASan, UBSan and LeakSanitizer
#   tools/sanitize.sh faults              fault injection, the same way: minutes
#   tools/sanitize.sh window              the window on a display of its own, the same way: minutes
#   tools/sanitize.sh thread              tests with threads under TSan
#   tools/sanitize.sh valgrind            tests of the core under valgrind, uninstrumented
#
# What tools/test.sh runs of it: address, window, thread, valgrind. docs/faults.md tells more; tools/fuzz.sh looks for new inputs.
set -euo pipefail
cd "$(dirname "$0")/.."
exec </dev/null

export ASAN_OPTIONS=detect_leaks=1:abort_on_error=1
export LSAN_OPTIONS="suppressions=$PWD/tests/sanitize/leaks.supp:print_suppressions=0"
export UBSAN_OPTIONS=print_stacktrace=1:halt_on_error=1
export TSAN_OPTIONS="suppressions=$PWD/tests/sanitize/thread.supp:halt_on_error=1"

# configure FOLDER OPTION...
configure () {
  local folder=$1
  shift
  [ -f "$folder/build.ninja" ] || meson setup "$folder" "$@"
}

# with_asan SUITES...: builds all and runs tests of these suites.
with_asan () {
  configure build-sanitize -Dwerror=true -Db_sanitize=address,undefined -Db_lundef=false
  ninja -C build-sanitize
  meson test -C build-sanitize --no-rebuild --print-errorlogs --timeout-multiplier 6 "$@"
}

with_tsan () {
  configure build-thread -Db_sanitize=thread -Db_lundef=false -Dapp=disabled
  ninja -C build-thread tests/faults/test-faults-parallel tests/doc/test-doc-job \
    tests/faults/test-faults-cancel
  meson test -C build-thread --no-rebuild --print-errorlogs --timeout-multiplier 10 \
    parallel doc-job cancel
}

with_valgrind () {
  configure build-test -Dwerror=true
  ninja -C build-test
  meson test -C build-test --no-rebuild --print-errorlogs --setup valgrind \
    newton lanczos stability interior-point path-stages contacts limit-run central-path \
    weld polygon-ops io-json-parse whole-file
}

case ${1:-} in
  address) with_asan --no-suite slow ;;
  faults) with_asan --suite faults --suite fuzz ;;
  window) with_asan --suite app ;;
  thread) with_tsan ;;
  valgrind) with_valgrind ;;
  *)
    sed -n '2,/^set/s/^# \{0,1\}//p' "$0"
    exit 2
    ;;
esac

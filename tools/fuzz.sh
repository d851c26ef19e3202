#!/bin/bash
# Looks for inputs that break the readers, with clang's libFuzzer under the address and
# undefined-behaviour sanitizers, then measures which lines of the readers were executed.
#
#   tools/fuzz.sh MINUTES [TARGET...]     so long in all, shared by all targets or these
#   tools/fuzz.sh coverage [TARGET...]    no search: coverage by what was found before
#
# Inputs found stay in build-fuzz/found/TARGET, reduced to the fewest that cover the same; the next run
# begins with them. Reproducers of errors are build-fuzz/errors/TARGET-*: an input that shows an error
# belongs into tests/fuzz/corpus/TARGET once the error is corrected. Exits non-zero where one was found.
# Needs clang, llvm and libclang-rt-dev. docs/faults.md tells what campaigns have found.
set -euo pipefail
cd "$(dirname "$0")/.."
exec </dev/null

if [ $# -eq 0 ]; then
  sed -n '2,/^set/s/^# \{0,1\}//p' "$0"
  exit 2
fi
minutes=$1
shift
targets=("$@")
[ $# -gt 0 ] || targets=(compas dxf hybridfem project record result study svg text)

export ASAN_OPTIONS=detect_leaks=1:allocator_may_return_null=1
export LSAN_OPTIONS="suppressions=$PWD/tests/sanitize/leaks.supp:print_suppressions=0"
export UBSAN_OPTIONS=print_stacktrace=1:halt_on_error=1

# build FOLDER FLAGS OPTION...: the targets, by clang with these flags.
build () {
  local folder=$1 flags=$2
  shift 2
  [ -f "$folder/build.ninja" ] || CC=clang meson setup "$folder" -Dfuzzers=true \
    -Dapp=disabled -Dgstreamer=disabled -Dosmesa=disabled -Degl=disabled -Dpython=disabled \
    -Db_lundef=false "-Dc_args=$flags" "-Dc_link_args=$flags" \
    "$@"
  ninja -C "$folder" "${targets[@]/#/tests/fuzz/libfuzzer-}"
}

# Folders of inputs that a target begins with.
seeds () {
  echo "tests/fuzz/corpus/$1"
  case $1 in
    dxf) echo examples/dxf ;;
    study) echo examples/studies ;;
  esac
}

# search TARGET SECONDS: one target for so long, then its inputs reduced.
search () {
  local target=$1 folder=build-fuzz/found/$1 log=build-fuzz/logs/$1.log options
  mkdir -p "$folder" build-fuzz/errors build-fuzz/logs build-fuzz/reduced
  options=(-max_total_time="$2" -timeout=20 -rss_limit_mb=2500 -print_final_stats=1
    -artifact_prefix="build-fuzz/errors/$target-")
  [ ! -f "tests/fuzz/$target.dict" ] || options+=("-dict=tests/fuzz/$target.dict")
  # shellcheck disable=SC2046 # several folders
  build-fuzz/tests/fuzz/libfuzzer-"$target" "${options[@]}" "$folder" $(seeds "$target") \
    >"$log" 2>&1 || failed=1
  rm -rf "build-fuzz/reduced/$target"
  mkdir "build-fuzz/reduced/$target"
  build-fuzz/tests/fuzz/libfuzzer-"$target" -merge=1 "build-fuzz/reduced/$target" "$folder" \
    >>"$log" 2>&1
  rm -rf "$folder"
  mv "build-fuzz/reduced/$target" "$folder"
  printf '%-10s %12s executions %6s inputs %s\n' "$target" \
    "$(sed -n 's/.*number_of_executed_units: *//p' "$log" | head -n 1)" \
    "$(find "$folder" -type f | wc -l)" "$(grep -m 1 -oE '(SUMMARY|ERROR): .*' "$log" || true)"
}

# Lines of every reader that the inputs execute, all targets together.
coverage () {
  build build-coverage "-fprofile-instr-generate -fcoverage-mapping"
  rm -f build-coverage/*.profraw
  local target objects=()
  for target in "${targets[@]}"; do
    mkdir -p "build-fuzz/found/$target"
    # shellcheck disable=SC2046 # several folders
    LLVM_PROFILE_FILE=build-coverage/$target.profraw \
      build-coverage/tests/fuzz/libfuzzer-"$target" -runs=0 "build-fuzz/found/$target" \
      $(seeds "$target") >/dev/null 2>&1
    objects+=(-object "build-coverage/tests/fuzz/libfuzzer-$target")
  done
  llvm-profdata merge -sparse build-coverage/*.profraw -o build-coverage/all.profdata
  llvm-cov report -instr-profile=build-coverage/all.profdata "${objects[@]:1}" \
    -show-branch-summary=false -show-region-summary=false -show-functions=false \
    -ignore-filename-regex='^/usr/|/tests/|/src/(core|stereotomy|disk|render|doc|io/text)/' \
    | tee build-coverage/report.txt
  echo "Line by line: llvm-cov show -instr-profile=build-coverage/all.profdata" \
    "build-coverage/tests/fuzz/libfuzzer-TARGET FILE"
}

failed=0
if [ "$minutes" != coverage ]; then
  build build-fuzz "-fsanitize=fuzzer-no-link,float-cast-overflow,unsigned-shift-base" \
    -Db_sanitize=address,undefined
  for target in "${targets[@]}"; do
    search "$target" $((minutes * 60 / ${#targets[@]}))
  done
fi
coverage
exit "$failed"

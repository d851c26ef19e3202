#!/bin/bash
# Builds Quoin in the ways that packagers and users do, shows that it works, and says how long each
# took.
#
#   tools/build-matrix.sh            the cell that continuous integration runs
#   tools/build-matrix.sh all        all cells, with the quick tests where a cell has tests
#   tools/build-matrix.sh CELL...    these
#
#   without names  gcc-release       gcc, optimised, warnings are errors: the programs alone; then without
#                                    anything optional
#   on request     gcc-debug         without optimisation; then without each optional dependency in turn,
#                                    without any, and without the window: only what an option changes is
#                                    compiled again
#                  dist              the release archive, built without the window, tested, installed
#                                    into a folder and run from there
#                  gcc-unity         sources of a target compiled together: programs and tests
#                  clang-sanitize    clang's address and undefined-behaviour sanitizers, with conversions
#                                    and shifts: readers over the fuzzing corpus, mechanics, examples
#                  gcc-debugoptimized, clang-release, clang-debug, clang-debugoptimized
#
# Other cells build the programs and run the tests named below.
set -euo pipefail
cd "$(dirname "$0")/.."
exec </dev/null
root=$PWD
export ASAN_OPTIONS=detect_leaks=1:abort_on_error=1
export LSAN_OPTIONS="suppressions=$PWD/tests/sanitize/leaks.supp:print_suppressions=0"
export UBSAN_OPTIONS=print_stacktrace=1:halt_on_error=1

in_ci=(gcc-release)
others=(gcc-debug dist gcc-unity clang-sanitize gcc-debugoptimized clang-release clang-debug clang-debugoptimized)
programs=(src/cli/quoin-cli src/library/libquoin.so.0.1.0)
tests=(core-equilibrium core-limit core-linalg core-contact io-project io-result cli-project)
whole=no # all quick tests

# configure FOLDER COMPILER OPTION...
configure () {
  local folder=$1
  [ -f "$folder/build.ninja" ] || CC=$2 meson setup "$folder" -Dwerror=true "${@:3}" \
    >"$folder.log" || { tail -n 5 "$folder.log"; return 1; }
}

# run_tests FOLDER TEST...: builds and runs these, or all quick ones.
run_tests () {
  local folder=$1
  shift
  if [ "$whole" = yes ]; then
    ninja -C "$folder" --quiet
    meson test -C "$folder" --no-rebuild --no-suite slow --no-suite app --timeout-multiplier 6 \
      --quiet --print-errorlogs
    return
  fi
  # The programs of tests by their names: meson knows which is which.
  local needed
  mapfile -t needed < <(meson introspect "$folder" --tests | python3 -c '
import json, os, sys
folder = os.path.realpath(sys.argv[1])
found = [t for t in json.load(sys.stdin) if t["name"] in sys.argv[2:]]
missing = set(sys.argv[2:]) - {t["name"] for t in found}
if missing: sys.exit("no such tests: " + " ".join(sorted(missing)))
print("\n".join(os.path.relpath(t["cmd"][0], folder) for t in found))' "$folder" "$@")
  [ ${#needed[@]} -gt 0 ]
  ninja -C "$folder" --quiet "${needed[@]}"
  meson test -C "$folder" --no-rebuild --timeout-multiplier 6 --quiet --print-errorlogs "$@"
}

# smoke CLI: what every build must be able to do.
smoke () {
  tests/smoke.sh "$1" examples >/dev/null
}

# compile COMPILER BUILDTYPE: the programs with the window, and tests.
compile () {
  local folder=build-matrix/$1-$2
  configure "$folder" "$1" "--buildtype=$2"
  ninja -C "$folder" --quiet "${programs[@]}" src/app/quoin
  smoke "$folder/src/cli/quoin-cli"
  case $1-$2 in
    gcc-release) bare "$folder" ;;
    gcc-debug) run_tests "$folder" "${tests[@]}" && options "$folder" ;;
    *) run_tests "$folder" "${tests[@]}" ;;
  esac
}

optional=(gstreamer osmesa egl python manual)

# Without anything optional, and without the window.
bare () {
  local folder=$1 all=("${optional[@]/%/=disabled}")
  echo "without anything optional"
  meson configure "$folder" "${all[@]/#/-D}" -Dapp=disabled
  ninja -C "$folder" --quiet "${programs[@]}"
  smoke "$folder/src/cli/quoin-cli"
  all=("${optional[@]/%/=auto}")
  meson configure "$folder" "${all[@]/#/-D}" -Dapp=enabled
}

# The folder of a cell, configured anew for each.
options () {
  local folder=$1 option
  for option in "${optional[@]}"; do
    echo "without $option"
    meson configure "$folder" "-D$option=disabled"
    ninja -C "$folder" --quiet "${programs[@]}" src/app/quoin
    smoke "$folder/src/cli/quoin-cli"
    meson configure "$folder" "-D$option=auto"
  done
  bare "$folder"
}

sanitize () {
  local folder=build-matrix/clang-sanitize example
  configure "$folder" clang -Dapp=disabled -Dpython=disabled -Db_sanitize=address,undefined \
    -Db_lundef=false "-Dc_args=-fsanitize=float-cast-overflow,unsigned-shift-base"
  ninja -C "$folder" --quiet src/cli/quoin-cli
  smoke "$folder/src/cli/quoin-cli"
  for example in 05-stack 06-arch 10-soft-on-stiff 34-frame-hybrid 41-column-impulse; do
    "$folder/src/cli/quoin-cli" solve "examples/$example.quoin" --quiet \
      -o "$folder/$example.json" >/dev/null
    "$folder/src/cli/quoin-cli" render "examples/$example.quoin" --result "$folder/$example.json" \
      --view forces --field stress -o "$folder/$example.png"
  done
  run_tests "$folder" core-{base,contact,equilibrium,linalg} fuzz-{compas,dxf,hybridfem} \
    fuzz-{project,record,result,study,svg,text}
}

unity () {
  local folder=build-matrix/gcc-unity
  configure "$folder" gcc -Dunity=on
  ninja -C "$folder" --quiet
  smoke "$folder/src/cli/quoin-cli"
}

# From the last commit, in a folder that knows nothing of this tree.
dist () {
  local folder=build-matrix/dist unpacked=build-matrix/unpacked
  rm -rf "$folder" "$unpacked" build-matrix/root
  configure "$folder" gcc -Dapp=disabled -Dtests=false
  meson dist -C "$folder" --no-tests --allow-dirty >"$folder.log" 2>&1 \
    || { tail -n 5 "$folder.log"; return 1; }
  mkdir -p "$unpacked"
  tar -xf "$folder"/meson-dist/*.tar.xz -C "$unpacked" --strip-components=1
  # As on a machine without GTK.
  printf '#!/bin/sh\ncase " $* " in *" gtk4 "*) exit 1 ;; esac\nexec pkg-config "$@"\n' \
    >build-matrix/pkg-config
  chmod +x build-matrix/pkg-config
  (cd "$unpacked"
    PKG_CONFIG=$root/build-matrix/pkg-config \
      configure build gcc --prefix=/usr -Dapp=disabled -Dtests=false)
  ninja -C "$unpacked/build" --quiet
  meson test -C "$unpacked/build" --no-rebuild --quiet --print-errorlogs
  DESTDIR=$root/build-matrix/root meson install -C "$unpacked/build" --no-rebuild --quiet
  smoke "$root/build-matrix/root/usr/bin/quoin-cli"
  if find build-matrix/root -name '*quoin.Quoin*' | grep .; then
    echo "files of the window are installed without it"
    return 1
  fi
}

cell () {
  case $1 in
    clang-sanitize) sanitize ;;
    dist) dist ;;
    gcc-unity) unity ;;
    *) compile "${1%-*}" "${1#*-}" ;;
  esac
}

# A cell by itself, in a shell of its own: the first error ends it and no more.
if [ "${1:-}" = --cell ]; then
  [ "${3:-}" != whole ] || whole=yes
  cell "$2"
  exit
fi

cells=("$@")
[ $# -gt 0 ] || cells=("${in_ci[@]}")
if [ "${1:-}" = all ]; then
  cells=("${in_ci[@]}" "${others[@]}")
  whole=whole
fi
for one in "${cells[@]}"; do
  case " ${in_ci[*]} ${others[*]} " in
    *" $one "*) ;;
    *) sed -n '2,/^set/s/^# \{0,1\}//p' "$0" && exit 2 ;;
  esac
done

mkdir -p build-matrix
failed=0
table=()
for one in "${cells[@]}"; do
  echo "-- $one"
  SECONDS=0
  word=good
  "$0" --cell "$one" "$whole" || { word=FAILED; failed=1; }
  table+=("$(printf '%-22s %-6s %4d s' "$one" "$word" "$SECONDS")")
done
echo "-- matrix"
printf '%s\n' "${table[@]}"
exit "$failed"

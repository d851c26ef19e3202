#!/bin/bash
# Measures which lines and branches of the sources the tests reach, by room, and fails where the rooms
# of a layer that must be covered reach less than asked for.
#
#   tools/coverage.sh [TESTS…]   default: the quick tests of all layers but the window, and those that
#                                let memory fail
#
# TESTS are arguments of `meson test`: `--suite core`, `core-law`. The build is build-coverage; the
# table goes to standard output. Needs gcovr. Loops that are always inlined are compiled once here, so
# that their branches do not count again for every caller.
set -euo pipefail
cd "$(dirname "$0")/.."
command -v gcovr >/dev/null || { echo "gcovr is missing: apt install gcovr" >&2; exit 2; }

build=build-coverage
if command -v ld.gold >/dev/null; then
  export CC_LD=gold CXX_LD=gold
fi
[ -d $build ] || meson setup $build -Db_coverage=true -Dbuildtype=debug \
  "-Dc_args=-fprofile-update=atomic -Dalways_inline=noinline" -Dapp=disabled >/dev/null
ninja -C $build >/dev/null
find $build -name '*.gcda' -delete
some=$*
[ $# -gt 0 ] || set -- --no-suite slow --no-suite all
status=0
meson test -C $build --no-rebuild -t 10 "$@" >/dev/null || status=$?
[ -n "$some" ] || meson test -C $build --no-rebuild memory-faults -t 10 >/dev/null || status=$?
gcovr --root . --filter src/ --exclude-throw-branches --json-summary $build/coverage.json $build

python3 - $build/coverage.json ${some:+some} <<'END'
import collections, json, sys

rooms = collections.defaultdict(collections.Counter)
for file in json.load(open(sys.argv[1]))["files"]:
    parts = file["filename"].split("/")[1:-1]
    for room in {"/".join(parts), parts[0], "all"}:
        for key in ("line_covered", "line_total", "branch_covered", "branch_total"):
            rooms[room][key] += file[key]
print("| room | lines | reached % | branches | taken % |\n| --- | --- | --- | --- | --- |")
for room, sums in sorted(rooms.items()):
    print(f"| {room} | {sums['line_total']} | {100 * sums['line_covered'] / max(sums['line_total'], 1):.1f} "
          f"| {sums['branch_total']} | {100 * sums['branch_covered'] / max(sums['branch_total'], 1):.1f} |")
# Branches of these layers that must be taken, %.
for layer, least in {"core": 90, "io": 90}.items():
    taken = 100 * rooms[layer]["branch_covered"] / max(rooms[layer]["branch_total"], 1)
    if len(sys.argv) == 2 and taken < least:
        sys.exit(f"{layer}: {taken:.1f} % of the branches are taken, {least} % are asked for")
END
exit $status

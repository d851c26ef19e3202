#!/bin/bash
# Runs the benchmarks, an hour or so in all, and says what got worse since a baseline. Sets the
# machine up first where something is missing, Clp and, where it is packaged, HiGHS among it, the
# peers of limit analysis.
#
#   tools/bench.sh [NAME...]     all, or some of: contacts dynamics earthquakes factor joints
#                                members outcomes paths render scaling stress study
#                                variations walls
#
# Tables, charts and a description of the machine go to build/bench-results; the baseline is
# $BASELINE, tests/bench/baselines/epyc by default. Exits non-zero where a benchmark fails, or
# a count, a multiplier or (beyond the noise) a time in calibration kernels got worse.
set -euo pipefail
cd "$(dirname "$0")/.."
exec </dev/null
baseline=${BASELINE:-tests/bench/baselines/epyc}
failed=0
partial=()
[ $# -eq 0 ] || partial=(--partial)

peers=(coinor-libclp-dev)
if apt-cache show libhighs-dev >/dev/null 2>&1; then
  peers+=(libhighs-dev)
fi
tools/setup.sh "${peers[@]}"
if [ -f build/build.ninja ]; then
  meson setup --reconfigure build >/dev/null # a peer may be new
else
  meson setup build
fi
ninja -C build
rm -rf build/bench-results
meson test -C build --no-rebuild --benchmark --verbose "$@" || failed=$?

echo
tests/bench/tables.py compare "${partial[@]}" "$baseline" build/bench-results || failed=$?
exit "$failed"

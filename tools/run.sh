#!/bin/bash
# Builds Quoin, solves the six masonry walls of Ferris & Tin-Loi (examples/ferris-tin-loi/),
# prints how the collapse multipliers compare with the published ones and draws the collapse
# mechanisms and the load-displacement curves. Sets the machine up first where something is
# missing.
#
#   tools/run.sh [FOLDER]     results and pictures go to FOLDER, "out" by default
set -euo pipefail
cd "$(dirname "$0")/.."
exec </dev/null
folder=${1:-out}

tools/setup.sh
[ -f build/build.ninja ] || meson setup build
ninja -C build src/cli/quoin-cli src/app/quoin

cli=build/src/cli/quoin-cli
missed=0
echo
"$cli" verify walls --keep "$folder" || missed=$?
[ "$missed" -le 1 ] || exit "$missed"

walls=()
for wall in 1 2 3 4 5 6; do
  walls+=("examples/ferris-tin-loi/wall$wall.quoin=$folder/walls/wall$wall.json")
done
"$cli" compare --columns 3 --size 2400x1800 -o "$folder/mechanisms.png" "${walls[@]}"
"$cli" curve --until 0.3 --size 1600x1200 -o "$folder/curves.png" "${walls[@]}"

echo
echo "Results:              $folder/walls/wall1.json ... wall6.json"
echo "Collapse mechanisms:  $folder/mechanisms.png"
echo "Load paths:           $folder/curves.png"
echo "The window:           build/src/app/quoin examples/ferris-tin-loi/wall3.quoin"
exit "$missed"

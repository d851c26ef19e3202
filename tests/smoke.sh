#!/bin/sh
# What every build of quoin-cli can do, whatever was left out of it: read, solve, check, draw, move,
# import. Run by `meson test` even without the other tests, and on installed programs.
#
#   smoke.sh QUOIN-CLI EXAMPLES
set -eu
cli=$1
examples=$2
folder=$(mktemp -d)
trap 'rm -r "$folder"' EXIT

"$cli" --version
"$cli" solve "$examples/02-overturning-block.quoin" --quiet -o "$folder/result.json"
"$cli" check "$examples/02-overturning-block.quoin" --result "$folder/result.json"
"$cli" limit "$examples/ferris-tin-loi/wall3.quoin" --quiet --no-timings -o "$folder/limit.json"
# Half its width over half its height.
grep -qE '"collapse_multiplier": (0\.5|0\.50000[0-9]*|0\.49999[0-9]*),' "$folder/result.json"
for ending in png svg pdf; do
  "$cli" render "$examples/02-overturning-block.quoin" --result "$folder/result.json" \
    --view mechanism -o "$folder/picture.$ending"
  [ "$(wc -c <"$folder/picture.$ending")" -gt 1000 ]
done
"$cli" animate "$examples/02-overturning-block.quoin" --result "$folder/result.json" --frames 4 \
  --size 160x120 --quiet -o "$folder/motion.gif"
"$cli" import "$examples/dxf/wall-clean.dxf" -o "$folder/wall.quoin"
"$cli" check "$folder/wall.quoin" >/dev/null

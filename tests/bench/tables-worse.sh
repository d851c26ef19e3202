#!/bin/sh
# tables.py must complain where a figure got worse, a row is missing, or a document shows another one.
# usage: tables-worse.sh TABLES.PY BASELINE
set -eu
folder=$(mktemp -d)
trap 'rm -r "$folder"' EXIT
cp "$2"/*.csv "$folder"
"$1" compare "$2" "$folder" >"$folder/said"

refuses () {
  if "$@" >"$folder/said" 2>&1; then
    echo "passed: $*"
    exit 1
  fi
}
sed -i '2s/^\(1,0,load,3,.*\),[0-9]*$/\1,999999/' "$folder/walls.csv"
refuses "$1" compare "$2" "$folder"
grep -q 'WORSE  walls 1 0 load 3.* factorisations .* -> 999999' "$folder/said"
sed -i 2d "$folder/walls.csv"
refuses "$1" compare "$2" "$folder"
grep -q 'missing walls 1 0 load 3' "$folder/said"
printf '<!-- table joints: wall | multiplier -->\nold\n<!-- end -->\n' >"$folder/text.md"
refuses "$1" show --check "$2" "$folder/text.md"
"$1" show "$2" "$folder/text.md"
"$1" show --check "$2" "$folder/text.md"
grep -q '^| wall | multiplier |$' "$folder/text.md"
refuses "$1" compare "$folder/none" "$folder/nowhere"

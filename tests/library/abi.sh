#!/bin/sh
# The binary interface is that of the last release, or adds to it.
#
#   abi.sh ABIDW ABIDIFF LIBRARY HEADER RELEASED.abi          compares
#   abi.sh ABIDW ABIDIFF LIBRARY HEADER RELEASED.abi --write  at a release
set -eu
abidw=$1 abidiff=$2 library=$(realpath "$3") header=$4 released=$5
describe() {
  "$abidw" --header-file "$header" --drop-private-types --exported-interfaces-only --no-show-locs \
    --no-elf-needed --no-comp-dir-path --no-corpus-path "$library"
}
if [ "${6-}" = --write ]; then
  describe >"$released"
  exit 0
fi
work=$(mktemp -d)
trap 'rm -r "$work"' EXIT
describe >"$work/now.abi"
grep -q quoin_solve "$work/now.abi"
"$abidiff" --no-added-syms "$released" "$work/now.abi"

# A parameter less shows that the comparison can fail.
awk '/name=.quoin_solve. / { inside = 1 }
  inside && /<parameter / && !cut { cut = 1; next } { print }' "$released" >"$work/other.abi"
! "$abidiff" "$work/other.abi" "$work/now.abi" >/dev/null

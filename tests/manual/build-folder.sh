#!/bin/bash
# The command of docs/library.md for a build folder, in the state that tools/run.sh leaves: the
# command line is built, the library is not.
#
#   build-folder.sh SOURCE-ROOT
set -euo pipefail
source=$(realpath "$1")
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
unset PYTHONPATH QUOIN_LIBRARY QUOIN_HEADER
export PATH=/usr/bin:$PATH

command=$(sed -n '/^From a build folder/,/^```$/p' "$source/docs/library.md" | sed '1,/^```console$/d; /^```$/d')
[[ $command == *examples/python/six_walls.py* ]]
for entry in "$source"/*; do
  [ -f "$entry/build.ninja" ] || cp -r "$entry" "$work"
done
cd "$work"
meson setup build -Dapp=disabled -Dmanual=disabled -Dtests=false >log
ninja -C build src/cli/quoin-cli >>log || { tail "$work/log"; exit 1; }
[ ! -e build/src/library/libquoin.so.0 ]
bash -euo pipefail -c "$command" | tee table
[ "$(wc -l <table)" -ge 6 ]

#!/bin/bash
# The wheel: built, installed into an environment of its own without a network, and used from a
# folder where nothing of the source tree is.
#
#   wheel.sh SOURCE-ROOT
set -euo pipefail
source=$(realpath "$1")
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
unset PYTHONPATH QUOIN_LIBRARY QUOIN_HEADER
export PATH=/usr/bin:$PATH

/usr/bin/python3 -m build --wheel --no-isolation --outdir "$work/dist" \
  -Csetup-args=-Dwheel=true -Csetup-args=-Dapp=disabled -Cbuilddir="$work/build" "$source" \
  >"$work/log" 2>&1 || { cat "$work/log"; exit 1; }
/usr/bin/python3 -m venv --system-site-packages "$work/environment"
"$work/environment/bin/pip" install --quiet --no-index --no-deps "$work"/dist/quoin-*.whl
cd "$work"
"$work/environment/bin/python" -c 'import quoin; print(quoin.__file__)' | grep -q "^$work/"
"$work/environment/bin/python" "$source/examples/python/six_walls.py" \
  "$source/examples/ferris-tin-loi" | tee table
[ "$(grep -c 'Wall [1-6]' table)" = 6 ]

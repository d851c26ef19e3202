#!/bin/bash
# The wheel: built from a copy of what it needs, installed into an environment of its own without a
# network, and used from a folder where nothing of the source tree is.
#
#   wheel.sh SOURCE-ROOT
set -euo pipefail
source=$(realpath "$1")
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
unset PYTHONPATH QUOIN_LIBRARY QUOIN_HEADER
export PATH=/usr/bin:$PATH

mkdir -p "$work/quoin/docs"
cp -r "$source"/{meson.build,meson_options.txt,pyproject.toml,src,python} "$work/quoin"
cp "$source/docs/library.md" "$work/quoin/docs"
cd "$work"
python3 -m build --wheel --no-isolation --skip-dependency-check \
  -Csetup-args=-Dwheel=true -Csetup-args=-Dapp=disabled --outdir dist quoin >log 2>&1 || { cat log; exit 1; }
python3 -m venv --system-site-packages environment
environment/bin/pip install --quiet --no-index --no-deps dist/quoin-*.whl
rm -r quoin
environment/bin/python -c 'import quoin; print(quoin.__file__)' | grep "^$work/environment/"
environment/bin/python "$source/examples/python/six_walls.py" "$source/examples/ferris-tin-loi" \
  | tee table
[ "$(wc -l <table)" -ge 6 ]

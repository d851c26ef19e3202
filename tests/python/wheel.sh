#!/bin/bash
# The wheel: `pip install` of a copy of what it needs into an environment of its own without a network,
# and used from a folder where nothing of the source tree is.
#
#   wheel.sh SOURCE-ROOT
set -euo pipefail
source=$(realpath "$1")
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
unset PYTHONPATH QUOIN_LIBRARY QUOIN_HEADER
export PATH=/usr/bin:$PATH

mkdir -p "$work/quoin/docs" "$work/quoin/tools"
cp -r "$source"/{meson.build,meson_options.txt,pyproject.toml,src,python,examples} "$work/quoin"
cp "$source/docs/library.md" "$work/quoin/docs"
cp "$source/tools/wheel_backend.py" "$work/quoin/tools"
cd "$work"
python3 -m venv --system-site-packages environment

# What is lacking is said in one line.
(cd quoin && PATH=$work/none PYTHONPATH=tools "$work/environment/bin/python" -c \
  'import wheel_backend; wheel_backend.build_wheel(".")' 2>"$work/lacks") && exit 1
grep -qx 'quoin: the build lacks gcc, .*' "$work/lacks"

environment/bin/pip install --quiet --no-index --no-deps ./quoin >log 2>&1 \
  || { cat log; exit 1; }
rm -r quoin
environment/bin/python -c 'import quoin; print(quoin.__file__)' | grep "^$work/environment/"
environment/bin/python "$source/examples/python/six_walls.py" "$source/examples/ferris-tin-loi" \
  | tee table
[ "$(wc -l <table)" -ge 6 ]
# The program is inside too, and mypy finds the hints.
environment/bin/python -c 'import quoin; print(quoin.command("--version"))' | grep '^quoin '
[ -f environment/lib/python3*/site-packages/quoin/py.typed ]

#!/bin/sh
# The hints of the Python package, and of a program that uses it.
#
#   types.sh PYTHON SOURCE-ROOT
set -eu
if ! "$1" -c 'import mypy' 2>/dev/null; then
  echo "skipped: mypy is not installed (Debian: package mypy)"
  exit 77
fi
cd "$2"
cache=$(mktemp -d)
trap 'rm -r "$cache"' EXIT
test -f python/quoin/py.typed
MYPYPATH=python "$1" -m mypy --config-file pyproject.toml --cache-dir "$cache" python/quoin \
  tests/python/typed_use.py

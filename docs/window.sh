#!/bin/bash
# Makes the pictures of the window again, that of the README and those of the manual in each
# language:  docs/window.sh BUILD-FOLDER
set -euo pipefail
build=$(realpath "$1")
cd "$(dirname "$0")/.."
meson test -C "$build" app-look-plain app-look-fr
cp "$build/screenshots/window.png" docs/window.png
for picture in "$build"/screenshots/manual-*.png; do
  name=${picture##*/manual-}
  case $name in
  plain-*) cp "$picture" "docs/manual/figures/${name#plain-}" ;;
  fr-*) cp "$picture" "docs/manual/fr/figures/${name#fr-}" ;;
  esac
done

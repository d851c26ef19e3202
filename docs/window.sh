#!/bin/bash
# Makes docs/window.png again, the picture of the window in the README:  docs/window.sh BUILD-FOLDER
set -euo pipefail
cd "$(dirname "$0")/.."
meson test -C "$1" app-look-plain
cp "$1/screenshots/window.png" docs/window.png

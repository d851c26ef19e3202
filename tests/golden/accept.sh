#!/bin/sh
# Makes what the image tests draw now their references. Look at every picture that changed
# before committing it:  tests/golden/accept.sh BUILD-FOLDER && git diff --stat tests/golden
set -eu
[ $# -eq 1 ] || { echo "usage: $0 BUILD-FOLDER" >&2; exit 2; }
ninja -C "$1" tests/render/test-render-image tests/render/test-render-scene-beams
G_TEST_SRCDIR=$(cd "$(dirname "$0")/.." && pwd) QUOIN_ACCEPT_IMAGES=1 \
  "$1"/tests/render/test-render-image -p /render/image/golden -p /render/image/golden-zoomed
G_TEST_SRCDIR=$(cd "$(dirname "$0")/.." && pwd) QUOIN_ACCEPT_IMAGES=1 \
  "$1"/tests/render/test-render-scene-beams -p /scene-beams/golden

#!/bin/sh
# The library as a package has it: installed into a folder, found by pkg-config, the example compiled
# against it and run. Nothing of the source tree is used but the example and a wall.
#
#   installed.sh MESON BUILD-FOLDER EXAMPLE WALL COMPILER...
set -eu
meson=$1 build=$2 example=$3 wall=$4
shift 4
work=$(mktemp -d)
trap 'rm -r "$work"' EXIT
"$meson" install -C "$build" --no-rebuild --destdir "$work" --tags devel,runtime >/dev/null
pc=$(find "$work" -name quoin.pc)
[ -n "$pc" ]

# The place of installation comes before the prefix that the file names.
PKG_CONFIG_PATH=$(dirname "$pc")
export PKG_CONFIG_PATH PKG_CONFIG_SYSROOT_DIR="$work"
[ "$(pkg-config --modversion quoin)" = "$(sed -n 's/^Version: //p' "$pc")" ]
pkg-config --exists 'quoin >= 0.1'
! pkg-config --exists 'quoin >= 100'
"$@" -Wall -Wextra -Werror "$example" -o "$work/example" $(pkg-config --cflags --libs quoin)
library=$(dirname "$(find "$work" -name 'libquoin.so.0')")
LD_LIBRARY_PATH="$library" "$work/example" "$wall" | tee "$work/out"
grep -q 0.64 "$work/out"

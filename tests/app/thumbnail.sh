#!/bin/sh
# A picture of a project for file managers, whatever the name of the file; nothing of what is no
# project.
#
#   thumbnail.sh THUMBNAILER QUOIN-CLI PROJECT
set -eu
work=$(mktemp -d)
trap 'rm -r "$work"' EXIT
# The thumbnailer of the build tree with the program of the build tree.
sed "s|\"[^\"]*/quoin-cli\"|$(realpath "$2")|" "$1" >"$work/thumbnailer"

sh "$work/thumbnailer" "$3" "$work/without-ending" 128
[ "$(head -c 4 "$work/without-ending" | tail -c 3)" = PNG ]
width=$(od -An -t u1 -j 19 -N 1 "$work/without-ending" | tr -d ' ')
[ "$width" = 128 ]
# More than an empty picture.
[ "$(wc -c <"$work/without-ending")" -gt 1000 ]

echo '{}' >"$work/wrong.quoin"
! sh "$work/thumbnailer" "$work/wrong.quoin" "$work/wrong" 128 2>/dev/null

#!/bin/sh
# A picture of a project or a result for file managers, whatever the name of the file; nothing of what
# is neither. Results are told from other JSON by what they begin with.
#
#   thumbnail.sh THUMBNAILER QUOIN-CLI PROJECT MIME.xml
set -eu
work=$(mktemp -d)
trap 'rm -r "$work"' EXIT
# The thumbnailer of the build tree with the program of the build tree.
sed "s|\"[^\"]*/quoin-cli\"|$(realpath "$2")|" "$1" >"$work/thumbnailer"

# check PICTURE: 128 pixels wide, and more than an empty picture.
check () {
  [ "$(head -c 4 "$1" | tail -c 3)" = PNG ]
  [ "$(od -An -t u1 -j 19 -N 1 "$1" | tr -d ' ')" = 128 ]
  [ "$(wc -c <"$1")" -gt 1000 ]
}

# refused FILE: no picture of it.
refused () {
  if sh "$work/thumbnailer" "$1" "$work/wrong" 128 2>/dev/null; then
    echo "$1 has a picture"
    exit 1
  fi
}

sh "$work/thumbnailer" "$3" "$work/without-ending" 128
check "$work/without-ending"

cp "$3" "$work"
"$2" solve "$work/$(basename "$3")" --quiet -o "$work/result.json"
sh "$work/thumbnailer" "$work/result.json" "$work/mechanism" 128
check "$work/mechanism"
if cmp -s "$work/without-ending" "$work/mechanism"; then
  echo "a result looks like its project"
  exit 1
fi

echo '{}' >"$work/wrong.quoin"
refused "$work/wrong.quoin"
# A result alone, and one whose project would be elsewhere.
mkdir "$work/alone"
cp "$work/result.json" "$work/alone"
refused "$work/alone/result.json"
sed "s|\"model\": \"|&../|" "$work/result.json" >"$work/alone/outside.json"
refused "$work/alone/outside.json"

if command -v update-mime-database >/dev/null && command -v gio >/dev/null; then
  mkdir -p "$work/share/mime/packages"
  cp "$4" "$work/share/mime/packages"
  cp /usr/share/mime/packages/freedesktop.org.xml "$work/share/mime/packages"
  update-mime-database "$work/share/mime" 2>/dev/null
  echo '{ "format": "other" }' >"$work/other.json"
  for pair in result.json=quoin-result other.json=json "$(basename "$3")=x-quoin"; do
    XDG_DATA_HOME=$work/share XDG_DATA_DIRS=$work/share \
      gio info -a standard::content-type "$work/${pair%=*}" | grep "${pair#*=}\$"
  done
fi

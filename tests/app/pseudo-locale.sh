#!/bin/bash
# Makes a catalogue in which every string is longer by two fifths, as German or French ones are,
# so that a window can be looked at before anybody has translated it.
#
#   pseudo-locale.sh SOURCE-ROOT CATALOGUE.mo COPY
set -eu
root=$1
mkdir -p "$(dirname "$2")"
out=$(realpath "$2")
copy=$(realpath "$3")
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cd "$root"
xgettext --from-code=UTF-8 --keyword=_ --keyword=N_ --keyword=ngettext:1,2 --keyword=X:2 \
  -f po/POTFILES.in -o "$work/all.pot" 2>/dev/null
msgen "$work/all.pot" -o "$work/same.po"
msgfilter -i "$work/same.po" -o "$work/long.po" --keep-header awk '
  BEGIN { RS = "\001" }
  { text = $0; tail = ""
    if (sub(/\n$/, "", text)) tail = "\n"
    filler = ""
    while (length(filler) < 0.4 * length(text)) filler = filler "äng"
    printf "%s%s%s", text, filler, tail }'
msgfmt "$work/long.po" -o "$out"
cp "$out" "$copy"

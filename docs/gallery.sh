#!/bin/sh
# Makes the pictures of docs/gallery.md again:  docs/gallery.sh BUILD-FOLDER
set -eu
[ $# -eq 1 ] || { echo "usage: $0 BUILD-FOLDER" >&2; exit 2; }
quoin=$(cd "$1" && pwd)/src/cli/quoin-cli
cd "$(dirname "$0")/.."
walls=examples/ferris-tin-loi
out=docs/gallery
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
mkdir -p "$out"

"$quoin" solve $walls/wall3.quoin -q -o "$work/wall3.json"
"$quoin" solve $walls/wall6.quoin -q -o "$work/wall6.json"
"$quoin" solve $walls/wall6.quoin -q --set laws[0].dilatancy=0.65 -o "$work/associative.json"
"$quoin" solve examples/06-arch.quoin -q -o "$work/arch.json"

wall3() { "$quoin" render $walls/wall3.quoin --size 900x675 "$@"; }
wall3 --view model -o $out/model.png
wall3 --view contacts -o $out/contacts.png
wall3 --view deformed -r "$work/wall3.json" -o $out/deformed.png
wall3 --view mechanism -r "$work/wall3.json" -o $out/mechanism.png
wall3 --view mechanism -r "$work/wall3.json" --monochrome -o $out/monochrome.png
wall3 --view deformed -r "$work/wall3.json" --field displacement --hide symbols -o $out/field.png
wall3 --view forces -r "$work/wall3.json" --field stress -o $out/stress.png
"$quoin" render examples/06-arch.quoin --view forces -r "$work/arch.json" --size 900x675 -o $out/thrust.png
"$quoin" render examples/06-arch.quoin --view forces --step 0 -r "$work/arch.json" --size 900x675 -o $out/thrust-dead.png
"$quoin" render $walls/wall6.quoin --view mechanism -r "$work/wall6.json" \
  --onion "$work/associative.json" --hide symbols --size 900x675 -o $out/onion.png
"$quoin" solve $walls/wall3.quoin -q --set laws[0].dilatancy=0.65 -o "$work/wall3-associative.json"
"$quoin" curve $walls/wall3.quoin="$work/wall3.json" $walls/wall3.quoin="$work/wall3-associative.json" \
  --reference 0.4037="limit analysis" --until 0.12 --size 900x675 -o $out/curve.png
"$quoin" verify walls -q --keep "$work" >"$work/walls.txt"
set --
for wall in 1 2 3 4 5 6; do
  set -- "$@" "$walls/wall$wall.quoin=$work/walls/wall$wall.json"
done
"$quoin" compare --columns 6 --size 1800x510 -o docs/six-walls.png "$@"
"$quoin" animate $walls/wall6.quoin -r "$work/wall6.json" -q --frames 36 --size 480x480 -o $out/collapse.gif
"$quoin" animate $walls/wall3.quoin -r "$work/wall3.json" -q --view deformed --frames 36 --rate 12 \
  --size 720x405 -o $out/path.gif

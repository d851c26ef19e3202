#!/bin/sh
# Pages of the manual: well formed, every link leads somewhere, every page is in the index, every
# picture is there.
#
#   pages.sh YELP-CHECK FOLDER...
set -eu
check=$1
shift
work=$(mktemp -d)
trap 'rm -r "$work"' EXIT

complaints() {
  (cd "$1" && for what in links orphans media ids; do "$check" "$what" .; done)
}

for folder; do
  ls "$folder"/*.page | wc -l | grep -q '^[3-9][0-9]$'
  [ -z "$(complaints "$folder")" ] || { complaints "$folder"; exit 1; }
  if grep -r 'blob/main//' "$folder"; then
    exit 1 # a path of the machine that made the page
  fi
done

# A link to nothing shows that the check can fail.
cp -r "$1" "$work/wrong"
sed -i 's|</page>|<p><link xref="no-such-page">a</link></p></page>|' "$work/wrong/limits.page"
[ -n "$(complaints "$work/wrong")" ]

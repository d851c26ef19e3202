#!/bin/sh
# What the header of libquoin declares, what its map lists and what the library exports are the
# same names, those of Debian's list of symbols too; and none of an earlier release is missing.
#
#   symbols.sh HEADER MAP LIBRARY RELEASED DEBIAN-SYMBOLS
set -eu
folder=$(mktemp -d)
trap 'rm -r "$folder"' EXIT
export LC_ALL=C

sed -e 's|/\*.*\*/||' "$1" | sed '/\/\*/,/\*\//d' | grep -o '\<quoin_[a-z_]* (' | tr -d ' (' \
  | sort -u >"$folder/header"
grep -o '\<quoin_[a-z_]*;' "$2" | tr -d ';' | sort >"$folder/map"
nm --dynamic --defined-only "$3" | awk '$2 == "T" { sub("@@.*", "", $3); print $3 }' \
  | sort >"$folder/library"
[ -s "$folder/library" ]
diff "$folder/header" "$folder/map"
diff "$folder/map" "$folder/library"
grep -o '^ quoin_[a-z_]*' "$5" | tr -d ' ' | sort >"$folder/debian"
diff "$folder/library" "$folder/debian"

# A made-up name shows that the comparison can fail.
echo quoin_made_up >>"$folder/header"
! diff "$folder/header" "$folder/map" >/dev/null

missing=$(sort "$4" | comm -23 - "$folder/library")
if [ -n "$missing" ]; then
  echo "gone since the release: $missing" >&2
  exit 1
fi

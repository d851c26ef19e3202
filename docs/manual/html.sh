#!/bin/sh
# Mallard pages as HTML:  html.sh YELP-BUILD PAGES-FOLDER OUT-FOLDER
set -eu
rm -rf "$3"
mkdir -p "$3"
"$1" html -o "$3" "$2"/*.page

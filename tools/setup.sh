#!/bin/bash
# Installs the packages that building, testing and running Quoin needs, and any others that are named,
# where one is missing, on Debian 12, Ubuntu 24.04 and later ones. On Fedora and Arch it names the
# packages. Run by tools/run.sh, tools/test.sh and tools/bench.sh.
set -euo pipefail

# What to install where there is no apt: building, the window, the manual; tests need more.
fedora=(
  gcc pkgconf-pkg-config meson ninja-build gettext glib2-devel cjson-devel suitesparse-devel
  lapack-devel geos-devel libxml2-devel cairo-devel pango-devel zlib-devel giflib-devel
  gdk-pixbuf2-devel dejavu-sans-fonts mesa-libEGL-devel mesa-dri-drivers gstreamer1-devel
  gstreamer1-plugins-base-devel gstreamer1-plugins-good gsl-devel sqlite-devel gtk4-devel
  python3-cffi python3-numpy python3-markdown-it-py yelp-tools yelp-xsl desktop-file-utils appstream
)
arch=(
  base-devel meson gettext glib2-devel cjson suitesparse lapack geos libxml2 cairo pango zlib giflib
  gdk-pixbuf2 ttf-dejavu mesa gst-plugins-base gst-plugins-good gsl sqlite gtk4 python-cffi
  python-numpy python-markdown-it-py yelp-tools yelp-xsl desktop-file-utils appstream
)
if ! command -v apt-get >/dev/null; then
  id=$(. /etc/os-release 2>/dev/null && echo "${ID-} ${ID_LIKE-}")
  case " $id " in
  *" fedora "*) echo "setup: install by hand: sudo dnf install ${fedora[*]} $*" >&2 ;;
  *" arch "*) echo "setup: install by hand: sudo pacman -S --needed ${arch[*]} $*" >&2 ;;
  *) echo "setup: this is neither Debian nor Ubuntu; README.md of src/ lists what is needed" >&2 ;;
  esac
  exit 1
fi

# The format is that of version 14; without it the test of the format is left out. From Debian 13 on,
# gold, which links in a quarter of the time, is a package of its own.
format=clang-format-14
gold=binutils-gold
[ -n "$(apt-cache show "$format" 2>/dev/null)" ] || format=binutils
[ -n "$(apt-cache show "$gold" 2>/dev/null)" ] || gold=binutils

packages=(
  # building
  gcc libc6-dev pkg-config meson ninja-build gettext libglib2.0-dev-bin
  # files, mechanics, geometry
  libglib2.0-dev libcjson-dev libsuitesparse-dev liblapack-dev libgeos-dev libxml2-dev
  # pictures and animations, with OpenGL where there is no display
  libcairo2-dev libpango1.0-dev zlib1g-dev libgif-dev libgdk-pixbuf-2.0-dev fonts-dejavu-core
  libosmesa6-dev libegl-dev libgl1-mesa-dri
  libgstreamer1.0-dev libgstreamer-plugins-base1.0-dev gstreamer1.0-plugins-good
  # the Python package and its tests
  python3-cffi python3-numpy python3-pandas python3-matplotlib python3-shapely python3-pytest
  mypy
  # studies: distributions and statistics, the table of cases
  libgsl-dev libsqlite3-dev
  # the window
  libgtk-4-dev
  # the manual
  yelp-tools yelp-xsl python3-markdown-it
  # checks and tests
  "$format" "$gold" ccache valgrind locales-all desktop-file-utils appstream xvfb xauth xdotool
  poppler-utils
  adwaita-icon-theme librsvg2-common slurm-wlm munge fish zsh abigail-tools
  "$@"
)

missing=()
for package in "${packages[@]}"; do
  state=$(dpkg-query --show --showformat='${db:Status-Status}' "$package" 2>/dev/null || true)
  [ "$state" = installed ] || missing+=("$package")
done
if [ ${#missing[@]} -eq 0 ]; then
  exit 0
fi

echo "setup: installing ${missing[*]}"
as_root=()
if [ "$(id -u)" -ne 0 ]; then
  if ! command -v sudo >/dev/null; then
    echo "setup: these packages need root: apt-get install ${missing[*]}" >&2
    exit 1
  fi
  as_root=(sudo)
fi
apt=("${as_root[@]}" env DEBIAN_FRONTEND=noninteractive
  apt-get --quiet=2 -o DPkg::Lock::Timeout=300)
"${apt[@]}" update </dev/null
"${apt[@]}" install --yes --no-install-recommends "${missing[@]}" </dev/null >/dev/null

#!/bin/bash
# Runs a command on an X display of its own, with settings, state and caches of its own, and
# turns every warning of GTK into a crash.
#
#   with-display.sh WIDTHxHEIGHT COMMAND [ARGUMENT...]
#
# GTK 4.8 may crash in its theme of icons: the thread that has loaded an icon lets go of it while a
# window looks it up. Where a sanitizer's trace begins there, the command is run once more.
set -eu
size=$1
shift

folder=$(mktemp -d)
Xvfb -displayfd 3 -screen 0 "${size}x24" -nolisten tcp 3>"$folder/display" 2>"$folder/log" &
server=$!
show () {
  cat "$folder/out" 2>/dev/null || true
  cat "$folder/err" >&2 2>/dev/null || true
}
clean_up () {
  kill $server 2>/dev/null
  wait $server 2>/dev/null || true
  rm -rf "$folder"
}
trap 'show; clean_up' EXIT
for _ in $(seq 200); do
  [ -s "$folder/display" ] && break
  sleep 0.05
done
[ -s "$folder/display" ] || { cat "$folder/log" >&2; exit 1; }

for name in CONFIG DATA STATE CACHE; do
  export "XDG_${name}_HOME=$folder/$name"
done
export XDG_RUNTIME_DIR="$folder"
chmod 700 "$folder"
export DISPLAY=":$(cat "$folder/display")" GDK_BACKEND=x11 GSK_RENDERER=${GSK_RENDERER:-cairo}
export GTK_A11Y=none GSETTINGS_BACKEND=memory DBUS_SESSION_BUS_ADDRESS=disabled:
export GTK_THEME= G_DEBUG=fatal-warnings LC_ALL="${QUOIN_TEST_LOCALE:-C.UTF-8}"
unset GTK_THEME WAYLAND_DISPLAY

status=0
"$@" >"$folder/out" 2>"$folder/err" || status=$?
if [ $status -ge 128 ] && [ -z "${QUOIN_ONCE_MORE-}" ] \
  && grep -A 5 'AddressSanitizer: SEGV' "$folder/err" | grep -q ' in gtk_icon_theme_lookup_icon '; then
  echo "with-display: GTK crashed in its theme of icons; once more" >&2
  clean_up
  trap - EXIT
  QUOIN_ONCE_MORE=1 exec "$0" "$size" "$@"
fi
exit $status

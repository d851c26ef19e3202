#!/bin/bash
# Runs a command on an X display of its own, with settings, state and caches of its own, and
# turns every warning of GTK into a crash.
#
#   with-display.sh WIDTHxHEIGHT COMMAND [ARGUMENT...]
set -eu
size=$1
shift

folder=$(mktemp -d)
Xvfb -displayfd 3 -screen 0 "${size}x24" -nolisten tcp 3>"$folder/display" 2>"$folder/log" &
server=$!
trap 'kill $server 2>/dev/null; wait $server 2>/dev/null || true; rm -rf "$folder"' EXIT
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
"$@"

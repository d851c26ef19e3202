#!/bin/bash
# Runs a command of the project in another release of Debian, as root: in a folder that is made once with
# debootstrap, with a copy of the sources that keeps what was built there. A second one waits for the first.
#
#   tools/chroot.sh SUITE FOLDER COMMAND...
#   tools/chroot.sh trixie ~/trixie tools/run.sh
set -euo pipefail
[ $# -ge 3 ] || { sed -n '2,/^set/s/^# \{0,1\}//p' "$0"; exit 2; }
suite=$1
mkdir -p "$2"
folder=$(realpath "$2")
shift 2
cd "$(dirname "$0")/.."

[ -e "$folder/etc/os-release" ] || debootstrap --variant=buildd "$suite" "$folder"
cp /etc/resolv.conf "$folder/etc/"
copy=$folder/root/quoin
mkdir -p "$copy"
exec {lock}>"$folder/root/lock"
flock "$lock"
# What has left the tree leaves the copy, but for the folders build*.
find "$copy" -path "$copy/build*" -prune -o ! -type d -printf '%P\0' | LC_ALL=C sort -z \
  | LC_ALL=C comm -z -23 - <(git ls-files -z | LC_ALL=C sort -z) | (cd "$copy" && xargs -0r rm -f --)
# Files keep their times: only what has changed is built again.
git ls-files -z | tar --create --null --files-from=- | tar --extract --directory="$copy"

# The mounts go with the last process.
export folder
unshare --mount --pid --fork --kill-child bash -c '
  mount -t proc proc "$folder/proc"
  mount --rbind /dev "$folder/dev"
  exec chroot "$folder" env -i HOME=/root LANG=C.UTF-8 TERM="${TERM-dumb}" \
    PATH=/usr/local/sbin:/usr/local/bin:/usr/sbin:/usr/bin:/sbin:/bin \
    bash -c '\''cd /root/quoin && exec "$@"'\'' bash "$@"' bash "$@"

#!/bin/sh
# Runs a command in a bare Debian, in a clone of the last commit of this tree: what a new user's machine sees.
#   sudo sh Testing/debian.sh SUITE COMMAND...
# For example: sudo sh Testing/debian.sh trixie sh Testing/run.sh
# SUITE is bookworm (Debian 12), trixie (13) or forky (testing). Needs root, debootstrap and some 8 GB disk.
# The system is made in build-debian-SUITE/ (or the folder that SOLIDMOMENTS_DEBIAN names), with git and
# nothing else, and is used again where it is there, so that the next run builds only what changed; delete the
# folder to start anew. The clone is /home/user/project in it. The exit status is the command's.
set -eu
if [ $# -lt 2 ]; then
  sed -n 2,8p "$0" >&2
  exit 1
fi
suite=$1
shift
project=$(cd "$(dirname "$0")/.." && pwd)
system=${SOLIDMOMENTS_DEBIAN:-$project/build-debian-$suite}
clone=$system/home/user/project

if [ "$(id -u)" -ne 0 ] || ! command -v debootstrap >/dev/null 2>&1; then
  echo "debian.sh: this needs root and the package debootstrap" >&2
  exit 1
fi
if [ ! -e "$system/.made" ]; then
  rm -rf "$system"
  mkdir -p "$system"
  # A debootstrap that is older than the suite makes it as it makes Debian's unstable.
  script=$suite
  [ -e "/usr/share/debootstrap/scripts/$suite" ] || script=sid
  debootstrap --variant=minbase --include=git,ca-certificates "$suite" "$system" http://deb.debian.org/debian "$script" \
    >"$system.log" 2>&1 || {
    tail -n 5 "$system.log" >&2
    exit 1
  }
  touch "$system/.made"
fi
cp /etc/resolv.conf "$system/etc/resolv.conf"
[ -s "$system/etc/hosts" ] || echo "127.0.0.1 localhost" >"$system/etc/hosts"

# shellcheck disable=SC2317
leave() {
  umount "$system/dev/pts" 2>/dev/null || true
  umount "$system/dev" "$system/proc" 2>/dev/null || true
}
trap leave EXIT
trap 'exit 130' INT TERM
mount --bind /dev "$system/dev"
mount --bind /dev/pts "$system/dev/pts"
mount -t proc proc "$system/proc"
if [ -e "$clone" ]; then
  git -C "$clone" fetch -q "$project" HEAD
  git -C "$clone" checkout -q --force FETCH_HEAD
else
  git clone -q --no-hardlinks "$project" "$clone"
fi
status=0
chroot "$system" env -i HOME=/root PATH=/usr/sbin:/usr/bin:/sbin:/bin LANG=C.UTF-8 TERM=dumb DEBIAN_FRONTEND=noninteractive \
  sh -c 'cd /home/user/project && exec "$@"' sh "$@" || status=$?
exit "$status"

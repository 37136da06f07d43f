#!/usr/bin/env bash
# SPDX-FileCopyrightText: 2026 The Jalon authors
# SPDX-License-Identifier: Apache-2.0
# README's two commands on a fresh Debian 12 root, from a clone, twice. Needs root, debootstrap and Debian's packages.
# Usage: fresh_root.sh [FOLDER]   (default: a temporary one, removed at the end)
set -uo pipefail
root=$(cd "$(dirname "$0")/../.." && pwd)
. "$root/examples/packages.sh"
[ "$(id -u)" -eq 0 ] || { echo "skipped: needs root"; exit 77; }
need_packages debootstrap git || exit 1

chroot_folder=${1:-$(mktemp -d)}
passed=0 failed=0
check() { # check NAME COMMAND ...
  local name=$1
  shift
  if "$@"; then echo "ok - $name" && passed=$((passed + 1)); else echo "not ok - $name" && failed=$((failed + 1)); fi
}
inside() { chroot "$chroot_folder" /usr/bin/env -i HOME=/root PATH=/usr/sbin:/usr/bin:/sbin:/bin LC_ALL=C.UTF-8 CI="${CI:-}" "$@"; }
leave() {
  umount "$chroot_folder/proc" "$chroot_folder/dev/shm" 2>/dev/null
  [ -n "${1:-}" ] || rm -rf --one-file-system "$chroot_folder"
}
trap 'leave "${1:-}"' EXIT

mirror=$(cat /etc/apt/sources.list /etc/apt/sources.list.d/* 2>/dev/null |
  awk '/^deb /{for (i = 2; i <= NF; i++) if ($i ~ /^https?:/) {print $i; exit}} /^URIs:/{print $2; exit}')
if [ ! -d "$chroot_folder/usr" ]; then
  check "a Debian 12 root is made" debootstrap --variant=minbase bookworm "$chroot_folder" ${mirror:+"$mirror"} >/dev/null || exit 1
fi
cp /etc/resolv.conf "$chroot_folder/etc/" 2>/dev/null
cp -r /etc/apt/apt.conf.d "$chroot_folder/etc/apt/" 2>/dev/null
cp -r /etc/apt/sources.list /etc/apt/sources.list.d /etc/apt/auth.conf.d /etc/apt/keyrings "$chroot_folder/etc/apt/" 2>/dev/null
cp -r /usr/local/share/ca-certificates "$chroot_folder/usr/local/share/" 2>/dev/null
mkdir -p "$chroot_folder/proc" && mount -t proc proc "$chroot_folder/proc"
mkdir -p "$chroot_folder/dev/shm" && mount -t tmpfs tmpfs "$chroot_folder/dev/shm"
git clone -q "$root" "$chroot_folder/project" || exit 1
if [ -d "$root/../shared" ]; then
  mkdir -p "$chroot_folder/shared" && cp -r "$root/../shared/data" "$chroot_folder/shared/"
fi

check "the main job works, first time" inside bash /project/examples/run.sh
check "the main job works, second time" inside bash /project/examples/run.sh
for file in report.html elevation.svg model.obj segments.las segments.ply; do
  check "it made $file" test -s "$chroot_folder/project/out/facade/$file"
done
check "the tests pass, first time" inside bash /project/tests/run.sh
check "the tests pass, second time" inside bash /project/tests/run.sh
echo "$passed passed, $failed failed, 0 skipped"
[ $failed -eq 0 ]

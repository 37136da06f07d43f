#!/usr/bin/env bash
# SPDX-FileCopyrightText: 2026 The Jalon authors
# SPDX-License-Identifier: Apache-2.0
# README's two commands on a fresh Debian 12 root, from a clone; then again in the same clone, where nothing is left to install or to
# compile: of the tests those suites whose tools the first run installed or made. Needs root, debootstrap and Debian's packages; no
# compiler cache.
# Usage: fresh_root.sh [FOLDER]   (default: a temporary one, removed at the end)
set -uo pipefail
root=$(cd "$(dirname "$0")/../.." && pwd)
. "$root/examples/packages.sh"
[ "$(id -u)" -eq 0 ] || { echo "skipped: needs root"; exit 77; }
need_packages debootstrap git || exit 1

chroot_folder=${1:-$(mktemp -d)}
log=$root/build/logs/fresh_root_step.log
mkdir -p "$(dirname "$log")"
passed=0 failed=0

# check NAME COMMAND ...: the command succeeds; prints how long it took and its last line.
check() {
  local name=$1 begin=$SECONDS
  shift
  if "$@" >"$log" 2>&1; then
    passed=$((passed + 1)); echo "ok - fresh root: $name ($((SECONDS - begin)) s): $(tail -n 1 "$log")"
  else
    failed=$((failed + 1)); echo "not ok - fresh root: $name ($((SECONDS - begin)) s)"; tail -n 40 "$log" | sed 's/^/    /'
  fi
}
finish() {
  echo "$passed passed, $failed failed, 0 skipped"
  [ $failed -eq 0 ]
  exit
}
inside() { chroot "$chroot_folder" /usr/bin/env -i HOME=/root PATH=/usr/sbin:/usr/bin:/sbin:/bin LC_ALL=C.UTF-8 "$@"; }
leave() {
  umount "$chroot_folder/dev/pts" "$chroot_folder/dev/shm" "$chroot_folder/proc" 2>/dev/null
  [ -n "${1:-}" ] || rm -rf --one-file-system "$chroot_folder"
}
trap 'leave "${1:-}"' EXIT

# Only Debian itself, from the mirror this machine uses: other sources, and packages already here, would hide what is missing.
make_root() {
  local mirror extra=()
  mirror=$(cat /etc/apt/sources.list /etc/apt/sources.list.d/* 2>/dev/null |
    awk '/^(deb|URIs:) /{for (i = 2; i <= NF; i++) if ($i ~ /^https?:.*\/debian\/?$/) {print $i; exit}}')
  mirror=${mirror:-http://deb.debian.org/debian}
  [[ $mirror != https:* ]] || extra=(--include=ca-certificates) # an https mirror cannot be read without
  [ -d "$chroot_folder/usr" ] || debootstrap --variant=minbase "${extra[@]}" bookworm "$chroot_folder" "$mirror" || return 1
  echo "deb $mirror bookworm main" >"$chroot_folder/etc/apt/sources.list"
  cp /etc/resolv.conf "$chroot_folder/etc/"
  grep -l Acquire /etc/apt/apt.conf.d/* | xargs -r cp -t "$chroot_folder/etc/apt/apt.conf.d/" # proxies and such
  [ ! -d /etc/apt/auth.conf.d ] || cp -r /etc/apt/auth.conf.d "$chroot_folder/etc/apt/"
  cp -r /usr/local/share/ca-certificates "$chroot_folder/usr/local/share/"
  mkdir -p "$chroot_folder/proc" "$chroot_folder/dev/shm" "$chroot_folder/dev/pts"
  mount -t proc proc "$chroot_folder/proc" && mount -t tmpfs tmpfs "$chroot_folder/dev/shm" &&
    mount -t devpts -o ptmxmode=0666 devpts "$chroot_folder/dev/pts"
}
make_clone() {
  git clone -q "$root" "$chroot_folder/project" || return 1
  [ ! -d "$root/../shared/data" ] || { mkdir -p "$chroot_folder/shared" && cp -r "$root/../shared/data" "$chroot_folder/shared/"; }
}

installed='style|abi|install|comma_locale|laspy|validators|bindings.*|tsan/unit_base'

check "a Debian 12 root is made" make_root
[ $failed -eq 0 ] || finish
check "a clone is made" make_clone
check "the main job works, first time" inside bash /project/examples/run.sh
check "the main job works, second time" inside bash /project/examples/run.sh
for file in report.html elevation.svg model.obj segments.las segments.ply; do
  check "it made $file" test -s "$chroot_folder/project/out/facade/$file"
done
check "the tests pass, first time" inside bash /project/tests/run.sh
check "the tests pass, second time" inside bash /project/tests/run.sh --only "^($installed)\$"
finish

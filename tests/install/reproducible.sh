#!/usr/bin/env bash
# SPDX-FileCopyrightText: 2026 The Jalon authors
# SPDX-License-Identifier: Apache-2.0
# The same sources give the same bytes: library and tool are built once more from a copy in another folder and at another time,
# and what is installed of them is compared byte by byte. Usage: reproducible.sh BUILD_FOLDER
set -uo pipefail
build=$(realpath "${1:?usage: reproducible.sh BUILD_FOLDER}")
. "$(dirname "$0")/builds.sh"
subject=reproducible

copy="$work/a longer place of the same sources"
mkdir -p "$copy"
(cd "$root" && git ls-files -z | tar -c --null -T - -f -) | tar -x -C "$copy" --touch -f -
check "the copy is configured" cmake -S "$copy" -B "$copy/out" -DCMAKE_BUILD_TYPE=Release
check "the copy is built" cmake --build "$copy/out" --target jalon jalon_cli
check "the first is installed" cmake --install "$build" --prefix "$work/first/usr"
check "the second is installed" cmake --install "$copy/out" --prefix "$work/second/usr"
for file in lib/libjalon.so bin/jalon; do
  first=$(find "$work/first/usr" -path "*/$(basename "$file")" -type f -o -path "*/$(basename "$file").[0-9]*" -type f | head -n 1)
  second=${first/$work\/first/$work\/second}
  check "$(basename "$file") has the same bytes" cmp "$first" "$second"
done
check "neither names the folder that it was built in" bash -c '! strings -n 4 "$1"/usr/*/*jalon* "$1"/usr/*/*/*jalon.so* 2>/dev/null | grep -F -e "$2" -e "$3"' \
  _ "$work/second" "$copy" "$root"
finish

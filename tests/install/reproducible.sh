#!/usr/bin/env bash
# SPDX-FileCopyrightText: 2026 The Jalon authors
# SPDX-License-Identifier: Apache-2.0
# The same sources give the same bytes: library and tool are built once more from a copy in another folder, at another time and
# under another user's name of a home, and what is installed of them is compared byte by byte. Usage: reproducible.sh BUILD_FOLDER
set -uo pipefail
build=$(realpath "${1:?usage: reproducible.sh BUILD_FOLDER}")
root=$(cd "$(dirname "$0")/../.." && pwd)
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
passed=0 failed=0
judge() {
  local name=$1
  shift
  if "$@" >"$work/log" 2>&1; then echo "ok - $name" && passed=$((passed + 1)); else
    echo "not ok - $name: $(tail -n 5 "$work/log")" && failed=$((failed + 1))
  fi
}

copy="$work/a longer place of the same sources"
mkdir -p "$copy"
(cd "$root" && git ls-files -z | tar -c --null -T - -f -) | tar -x -C "$copy" --touch -f -
judge "the copy is configured" cmake -S "$copy" -B "$copy/out" -G Ninja -DCMAKE_BUILD_TYPE=Release
judge "the copy is built" cmake --build "$copy/out" --target jalon jalon_cli
judge "the first is installed" cmake --install "$build" --prefix "$work/first/usr"
judge "the second is installed" cmake --install "$copy/out" --prefix "$work/second/usr"
for file in lib/libjalon.so bin/jalon; do
  first=$(find "$work/first/usr" -path "*/$(basename "$file")" -type f -o -path "*/$(basename "$file").[0-9]*" -type f | head -n 1)
  second=${first/$work\/first/$work\/second}
  judge "$(basename "$file") has the same bytes" cmp "$first" "$second"
done
judge "neither names the folder that it was built in" bash -c '! strings -n 4 "$1"/usr/*/*jalon* "$1"/usr/*/*/*jalon.so* 2>/dev/null | grep -F -e "$2" -e "$3"' \
  _ "$work/second" "$copy" "$root"
echo "$passed passed, $failed failed"
[ "$failed" -eq 0 ]

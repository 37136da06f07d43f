#!/usr/bin/env bash
# SPDX-FileCopyrightText: 2026 The Jalon authors
# SPDX-License-Identifier: Apache-2.0
# The same sources give the same bytes: library and tool are built once more from a copy in another folder and at another time,
# and what is installed of them is compared byte by byte; so are two wheels, each made over one of them with the same
# SOURCE_DATE_EPOCH. The tool that packs wheels comes from PyPI; without it they are skipped, visibly, and where CI is set that fails.
# Usage: reproducible.sh BUILD_FOLDER
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

packer() { python3 -m venv "$work/venv" && "$work/venv/bin/pip" install --disable-pip-version-check scikit-build-core pathspec; }
wheel() { # wheel SOURCES PREFIX FOLDER
  SOURCE_DATE_EPOCH=1700000000 "$work/venv/bin/pip" wheel --disable-pip-version-check --no-deps --no-build-isolation --wheel-dir "$3" \
    -C build-dir="$3/build" -C cmake.define.JALON_INSTALLED=ON -C cmake.define.CMAKE_PREFIX_PATH="$2" "$1"
}
if [ -n "${CI:-}" ] || packer >"$work/log" 2>&1; then
  [ -x "$work/venv/bin/pip" ] || check "what packs wheels is there" packer
  check "a wheel over the first" wheel "$root" "$work/first/usr" "$work/wheel"
  check "a wheel over the second" wheel "$copy" "$work/second/usr" "$work/another wheel"
  check "both wheels have the same bytes" cmp "$work"/wheel/jalon-*.whl "$work"/another\ wheel/jalon-*.whl
else
  skipped=$((skipped + 1)); echo "skipped: scikit-build-core cannot be installed"
fi
finish

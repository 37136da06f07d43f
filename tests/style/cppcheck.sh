#!/usr/bin/env bash
# SPDX-FileCopyrightText: 2026 The Jalon authors
# SPDX-License-Identifier: Apache-2.0
# cppcheck over the library and the tool says nothing beyond cppcheck_exceptions.txt, and something of a wrong program: cppcheck.sh
set -uo pipefail
here=$(cd "$(dirname "$0")" && pwd)
command -v cppcheck >/dev/null || { echo "skipped: cppcheck is missing"; exit 77; }
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
passed=0 failed=0
# said SOURCE ...: "file: id" of each of its words. That functions which refuse do not return it does not know (2.10), nor that an array
# may be left as it is until it is written: the first three of these.
said() {
  cppcheck -q -j "$(nproc)" --enable=warning,portability --std=c++20 --language=c++ -Isrc -Iinclude --suppress=nullPointerRedundantCheck \
    --suppress=containerOutOfBounds --suppress=uninitMemberVar --suppress=missingIncludeSystem --template='{file}: {id}' "$@" 2>&1 |
    grep -v '^nofile' | sort -u
}
cd "$here/../.." || exit 1
printf 'int f() {\n  int a[2] = {0, 0};\n  return a[2];\n}\n' >"$work/wrong.cpp"
if [ -n "$(said "$work/wrong.cpp")" ]; then passed=$((passed + 1)); echo "ok - cppcheck: sees an index beyond an array"; else
  failed=$((failed + 1)); echo "not ok - cppcheck: sees an index beyond an array"
fi
said src >"$work/said"
if grep -v '^#' "$here/cppcheck_exceptions.txt" | sed 's/  .*//' | sort | diff - "$work/said" >"$work/difference"; then
  passed=$((passed + 1)); echo "ok - cppcheck: nothing new in $(find src -name '*.cpp' | wc -l) files"
else
  failed=$((failed + 1)); echo "not ok - cppcheck: nothing new (>), and nothing that went (<)"; cat "$work/difference"
fi
echo "$passed passed, $failed failed, 0 skipped"
[ $failed -eq 0 ]

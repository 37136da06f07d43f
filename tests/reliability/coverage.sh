#!/usr/bin/env bash
# SPDX-FileCopyrightText: 2026 The Jalon authors
# SPDX-License-Identifier: Apache-2.0
# How much of src the tests of C and C++ run: built with counters in WORK_FOLDER/build (again only what changed), each program run
# once, what was counted printed by room. Usage: coverage.sh WORK_FOLDER
# Branches that only an exception takes are left out: GCC makes one at every call.
set -uo pipefail
work=$(realpath -m "${1:?usage: coverage.sh WORK_FOLDER}")
root=$(cd "$(dirname "$0")/../.." && pwd)
command -v gcovr >/dev/null || { echo "skipped: there is no gcovr"; exit 77; }
build=$work/build
cmake -S "$root" -B "$build" -G Ninja -DCMAKE_BUILD_TYPE=Debug -DJALON_BUILD_TESTS=ON "-DCMAKE_C_FLAGS_DEBUG=-O1 -g0 --coverage -fprofile-update=atomic" \
  "-DCMAKE_CXX_FLAGS_DEBUG=-O1 -g0 --coverage -fprofile-update=atomic" >"$work/configure.log" || { tail "$work/configure.log"; exit 1; }
mapfile -t programs < <(PYTHONPATH=$root/tests/runner python3 -c 'from suites import *; print("\n".join(unit_programs() + [n for n in c_programs()]))')
ninja -C "$build" "${programs[@]}" >"$work/build.log" 2>&1 || { tail -n 30 "$work/build.log"; exit 1; }
find "$build" -name '*.gcda' -delete
passed=0 failed=0
export build work
# JALON_SANITIZED: the small forms, as under the sanitizers; counters cost as much.
one() { cd "$work" && JALON_SANITIZED=1 timeout 3000 "$build/tests/$1" >"$work/$1.log" 2>&1; echo "$? $1"; }
export -f one
printf '%s\n' "${programs[@]}" | xargs -P 2 -I{} bash -c 'one {}' >"$work/ended"
while read -r code name; do
  # 77: skipped; what fails with counters is told and leaves its counts all the same.
  if [ "$code" = 0 ] || [ "$code" = 77 ]; then passed=$((passed + 1)); else failed=$((failed + 1)) && echo "not ok - $name ends with $code"; fi
done <"$work/ended"
gcovr --root "$root" --filter "$root/src/" --exclude "$root/src/cli/" --exclude-throw-branches --exclude-unreachable-branches --json-summary-pretty \
  --json-summary "$work/coverage.json" -j 2 "$build" >"$work/gcovr.log" 2>&1 || { tail "$work/gcovr.log"; exit 1; }
python3 "$(dirname "$0")/coverage_rooms.py" "$work/coverage.json"
echo "$passed passed, $failed failed"
[ "$failed" -eq 0 ]

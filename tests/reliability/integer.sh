#!/usr/bin/env bash
# SPDX-FileCopyrightText: 2026 The Jalon authors
# SPDX-License-Identifier: Apache-2.0
# Clang's integer sanitizer: numbers without a sign that wrap, bits that are lost in conversions and shifts, signs that change. Readers with
# malformed files and with what fuzzing kept, counts that are large or lie, the C tests and the unit tests of the rooms that read and
# write. All is told, nothing stops; integer_exceptions.txt has what wraps as it means to. Usage: integer.sh [NAME ...], of programs.
set -uo pipefail
. "$(dirname "$0")/../install/builds.sh"
subject=integer here=$root/tests/reliability build=$root/build/integer
for tool in clang-14 clang++-14; do
  command -v $tool >/dev/null || { echo "skipped: $tool is missing"; exit 77; }
done
units=(unit_base unit_bytes unit_formats)
# Left out: allocators and libraries that are replaced or unloaded, and what takes its time to say the same again.
left_out='allocation|load_test|soak|cycles|cancel|threads_operations'
export JALON_SANITIZED=1
unset JALON_FULL

configured() {
  cmake -S "$root" -B "$build" -DCMAKE_BUILD_TYPE=Debug "-DCMAKE_CXX_FLAGS_DEBUG=-O1 -g1" "-DCMAKE_C_FLAGS_DEBUG=-O1 -g1" -DJALON_SANITIZE=integer \
    -DJALON_BUILD_TESTS=ON -DJALON_BUILD_CLI=OFF -DCMAKE_C_COMPILER=clang-14 -DCMAKE_CXX_COMPILER=clang++-14
}
built() { cmake --build "$build" --target jalon malformed_files fuzz_replay c_tests "${units[@]}"; }
sees_a_wrong_program() {
  printf '%s\n' '#include <cstdint>' 'uint16_t cut(uint32_t n) { return n; }' 'int main(int n, char**) { return cut(n * 65536u) + (n - 2u > 7u); }' >"$work/wrong.cpp"
  clang++-14 -fsanitize=integer "$work/wrong.cpp" -o "$work/wrong" && { "$work/wrong"; true; } 2>&1 |
    grep -c -e 'implicit conversion' -e 'unsigned integer overflow' | grep -x 2
}
# one PROGRAM: its log stays, whatever it ends with.
one() {
  local arguments=() name
  name=$(basename "$1")
  [ "$name" = fuzz_replay ] && arguments=("$here/../fuzz/corpus")
  timeout 1800 "$1" "${arguments[@]}" >"$work/$name.words" 2>&1 </dev/null
  case $? in 0 | 77) echo "ok - integer: $name" ;; *) echo "not ok - integer: $name ended with $?"; grep -v 'runtime error\|SUMMARY' "$work/$name.words" | tail -n 5 ;; esac
}
programs() {
  local name
  if [ $# -gt 0 ]; then for name in "$@"; do find "$build/tests" -name "$name" -type f -executable; done; return; fi
  ls "$build"/tests/fuzz/malformed_files "$build"/tests/fuzz/fuzz_replay "${units[@]/#/$build/tests/}"
  find "$build/tests" -maxdepth 1 -type f -executable -name '*_*' | grep -E '/(capi|reliability)_' | grep -Ev "$left_out" | sort
}
nothing_else() { python3 "$here/integer_findings.py" "$root" "$work"/*.words; }

check "is configured" configured
check "sees what wraps and what is cut" sees_a_wrong_program
check "builds" built
export -f one
export work here
programs "$@" | xargs -r -n 1 -P "$(nproc)" bash -c 'one "$1"' _ >"$work/all"
cat "$work/all"
passed=$((passed + $(grep -c '^ok' "$work/all"))) failed=$((failed + $(grep -c '^not ok' "$work/all")))
check "nothing wraps but what means to" nothing_else
grep FIGURE "$work/log"
finish

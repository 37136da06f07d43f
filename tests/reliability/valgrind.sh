#!/usr/bin/env bash
# SPDX-FileCopyrightText: 2026 The Jalon authors
# SPDX-License-Identifier: Apache-2.0
# The C tests, and what fuzzing kept, under Valgrind's memcheck: no error and nothing lost, each within its time. Usage: valgrind.sh BUILD_FOLDER [NAME ...]
set -uo pipefail
tests=$(realpath "${1:?usage: valgrind.sh BUILD_FOLDER [NAME ...]}")/tests
shift
here=$(cd "$(dirname "$0")" && pwd)
command -v valgrind >/dev/null || { echo "skipped: there is no valgrind"; exit 77; }
# What cannot run so: an allocator that fails on purpose and the system's calls led elsewhere are what Valgrind replaces itself; a stack
# of 256 KiB holds no memcheck; libraries unloaded a thousand times lose their symbols; modes of rounding are not emulated; eight threads take turns for hours, and the soak is one of its own.
left_out='allocation|io_faults|stack|soak|threads_operations|load_test|arithmetic|memory_limit|counted_memory|lying_counts'
# Under Valgrind all are 30 times as slow and one thread at a time: the short forms, as under the sanitizers.
export JALON_SANITIZED=1
unset JALON_FULL
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

one() {
  local program=$1 name arguments=()
  name=$(basename "$program")
  [ "$name" = fuzz_replay ] && arguments=("$here/../fuzz/corpus")
  timeout 1800 valgrind --quiet --error-exitcode=99 --leak-check=full --errors-for-leak-kinds=definite,indirect --show-leak-kinds=definite,indirect \
    --fair-sched=yes "$program" "${arguments[@]}" >"$work/$name.log" 2>&1
  local code=$?
  if [ $code -eq 0 ] || [ $code -eq 77 ]; then echo "ok - valgrind: $name"; else
    echo "not ok - valgrind: $name (exit $code): $(grep -E '^==|ERROR' "$work/$name.log" | head -n 6 | tr '\n' ' ')"
  fi
}
export -f one
export work here
if [ $# -gt 0 ]; then programs=$(printf "$tests/%s\n" "$@"); else
  programs=$(ls "$tests"/capi_*_test "$tests"/reliability_*_test "$tests"/fuzz/fuzz_replay | grep -Ev "$left_out")
fi
xargs -n 1 -P 2 bash -c 'one "$1"' _ <<<"$programs" | tee "$work/all"
passed=$(grep -c '^ok' "$work/all") failed=$(grep -c '^not ok' "$work/all")
echo "FIGURE valgrind: $passed programs of C without an error or a lost byte"
echo "$passed passed, $failed failed"
[ "$failed" -eq 0 ]

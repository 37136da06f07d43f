#!/usr/bin/env bash
# SPDX-FileCopyrightText: 2026 The Jalon authors
# SPDX-License-Identifier: Apache-2.0
# Fuzzes what reads hostile bytes, with libFuzzer, the address and the undefined-behaviour sanitizer (Debian: clang-14):
#   fuzz.sh SECONDS [TARGET ...]    so long each target, two at a time; the targets stand in fuzz_targets.cpp
# Builds build/fuzz. It begins with seeds and with tests/fuzz/corpus; inputs of new coverage stay in build/fuzz/inputs, what breaks
# something in build/fuzz/found: a small one of each kind belongs into tests/fuzz/corpus, which every build reads (replay.cpp).
set -uo pipefail
root=$(cd "$(dirname "$0")/../.." && pwd)
seconds=${1:?usage: fuzz.sh SECONDS [TARGET ...]}
shift
build=$root/build/fuzz inputs=$root/build/fuzz/inputs found=$root/build/fuzz/found
command -v clang++-14 >/dev/null || { echo "skipped: clang++-14 is missing"; echo "0 passed, 0 failed, 1 skipped"; exit 77; }
cmake -S "$root" -B "$build" -G Ninja -DCMAKE_BUILD_TYPE=Debug "-DCMAKE_CXX_FLAGS_DEBUG=-O1 -g1" "-DCMAKE_C_FLAGS_DEBUG=-O1 -g1" \
  -DCMAKE_C_COMPILER=clang-14 -DCMAKE_CXX_COMPILER=clang++-14 -DJALON_BUILD_TESTS=ON -DJALON_BUILD_CLI=OFF -DJALON_FUZZ=ON \
  -DJALON_SANITIZE=address,undefined >"$build.log" 2>&1 && ninja -C "$build" jalon_fuzz fuzz_seeds >>"$build.log" 2>&1 ||
  { tail -n 30 "$build.log"; echo "0 passed, 1 failed, 0 skipped"; exit 1; }
export ASAN_OPTIONS=detect_leaks=1:allocator_may_return_null=1
mkdir -p "$found"
"$build/tests/fuzz/fuzz_seeds" "$inputs" || exit 1
for folder in "$root"/tests/fuzz/corpus/*/; do
  [ -d "$folder" ] && mkdir -p "$inputs/$(basename "$folder")" && cp -n "$folder"* "$inputs/$(basename "$folder")/"
done
for format in las laz e57; do # small files of others, where they are at hand
  find "$root/../shared/data/$format" "$root/../shared/data/las" -name "*.$format" -size -64k -exec cp -n {} "$inputs/$format/" \; 2>/dev/null
done
[ $# -gt 0 ] || set -- $(JALON_FUZZ_TARGET= "$build/tests/fuzz/jalon_fuzz" 2>&1 | sed -n 's/.*names none of //p')

one() { # one TARGET
  mkdir -p "$inputs/$1" "$found/$1"
  JALON_FUZZ_TARGET=$1 "$build/tests/fuzz/jalon_fuzz" -max_total_time="$seconds" -max_len=65536 -rss_limit_mb=2048 -timeout=10 \
    -print_final_stats=1 -artifact_prefix="$found/$1/" "$inputs/$1" >"$found/$1.log" 2>&1
  local status=$? runs reached
  runs=$(sed -n 's/^stat::number_of_executed_units: *//p' "$found/$1.log")
  reached=$(sed -n 's/.* cov: \([0-9]*\) .*/\1/p' "$found/$1.log" | tail -n 1)
  echo "FIGURE fuzzing $1: ${runs:-0} inputs in $seconds s reach ${reached:-0} branches, $(find "$found/$1" -type f | wc -l) findings"
  if [ $status -eq 0 ]; then echo "ok - fuzzing $1"; else
    echo "not ok - fuzzing $1"
    grep -E "ERROR|SUMMARY|runtime error|status [0-9]" "$found/$1.log" | head -n 4
  fi
}
export -f one
export build inputs found seconds
printf '%s\n' "$@" | xargs -P 2 -I{} bash -c 'one "$1"' _ {} | tee "$found/all.log"
echo "$(grep -c '^ok' "$found/all.log") passed, $(grep -c '^not ok' "$found/all.log") failed, 0 skipped"
! grep -q '^not ok' "$found/all.log"

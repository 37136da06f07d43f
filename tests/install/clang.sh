#!/usr/bin/env bash
# SPDX-FileCopyrightText: 2026 The Jalon authors
# SPDX-License-Identifier: Apache-2.0
# Debian's Clang, the oldest and the newest that Jalon promises: clang.sh BUILD_FOLDER [VERSION ...]
# Library, tool and tests without a warning; the tests pass (of the first version all, of the others those that see the library through
# its C surface); the results have the bits of those in BUILD_FOLDER, by GCC.
set -uo pipefail
. "$(dirname "$0")/builds.sh"
reference=$(realpath "${1:?usage: clang.sh BUILD_FOLDER [VERSION ...]}")
shift
versions=("$@")
[ ${#versions[@]} -gt 0 ] || versions=(14 19)

configured() {
  cmake -S "$root" -B "$build" -DCMAKE_BUILD_TYPE=Release -DJALON_WERROR=ON -DJALON_BUILD_TESTS=ON \
    -DCMAKE_C_COMPILER="clang-$version" -DCMAKE_CXX_COMPILER="clang++-$version"
}
built() { cmake --build "$build" --target "$@" && ! grep -n 'warning:' "$work/log"; }
same_bits() { "$reference/tests/bits" 1 >"$work/gcc" && "$build/tests/bits" 1 >"$work/clang" && diff "$work/gcc" "$work/clang"; }

for version in "${versions[@]}"; do
  build=$root/build/clang-$version subject=clang-$version
  if ! command -v "clang++-$version" >/dev/null; then
    echo "skipped: clang++-$version is missing"
    skipped=$((skipped + 1))
    continue
  fi
  check "is configured" configured
  check "library and tool compile without a warning" built jalon jalon_cli
  check "the program of the bits does" built bits
  check "its results have the bits of GCC's" same_bits
  check "the same with 1, 2 and 7 threads, with AVX2 and without" bash "$root/tests/scenarios/bits.sh" "$build"
  tests=all names='^(unit|capi|reliability)_[a-z0-9_]*$'
  [ "$version" = "${versions[0]}" ] || { tests=c_tests names='^(capi|reliability)_[a-z0-9_]*$'; }
  check "its tests compile without a warning: $tests" built $tests
  while read -r name; do
    [ -x "$build/tests/$name" ] || continue
    "$build/tests/$name" >"$work/test" 2>&1 </dev/null
    status=$?
    [ $status -ne 77 ] || { skipped=$((skipped + 1)); echo "skipped: $name"; continue; }
    check "$name" sh -c "tail -n 40 '$work/test'; exit $status"
  done < <(cd "$build/tests" && ls | grep -E "$names")
  check "the tool" bash "$root/tests/scenarios/cli.sh" "$build/src/jalon"
done
finish

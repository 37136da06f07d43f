#!/usr/bin/env bash
# SPDX-FileCopyrightText: 2026 The Jalon authors
# SPDX-License-Identifier: Apache-2.0
# clang-tidy 14 over the library and the tool says nothing beyond tidy_exceptions.txt, and something of a wrong program; .clang-tidy has
# the checks. Folder by folder, as they are compiled, which costs a tenth of file by file. Usage: tidy.sh [PATTERN], of the folders' names.
set -uo pipefail
. "$(dirname "$0")/../install/builds.sh"
subject=tidy here=$root/tests/style build=$root/build/tidy pattern=${1:-}
for tool in clang-tidy-14 clang++-14; do
  command -v $tool >/dev/null || { echo "skipped: $tool is missing"; exit 77; }
done

configured() {
  cmake -S "$root" -B "$build" -DCMAKE_BUILD_TYPE=Debug -DCMAKE_EXPORT_COMPILE_COMMANDS=ON -DJALON_BUILD_TESTS=OFF -DJALON_UNITY=ON \
    -DCMAKE_C_COMPILER=clang-14 -DCMAKE_CXX_COMPILER=clang++-14
}
# said_of: "file: check" of each word on standard input, without the folder of the project.
said_of() { sed -nE "s,^($root/|$work/)?([^: ]+):[0-9]+:[0-9]+: (warning|error): .*\[([a-z0-9.,-]+)\]\$,\2: \4,p" | sort -u; }
sees_a_wrong_program() {
  cat >"$work/wrong.cpp" <<'END'
#include <string>
#include <utility>
size_t f(std::string s) {
  const std::string t = std::move(s);
  return t.size() + s.size();
}
END
  clang-tidy-14 --quiet --config-file="$root/.clang-tidy" "$work/wrong.cpp" -- -std=c++20 | said_of | grep -x 'wrong.cpp: bugprone-use-after-move'
}
units() { sed -nE 's/^ *"file": "(.*)",?$/\1/p' "$build/compile_commands.json" | grep -E '\.(cpp|cxx)$' | grep -E "src/.*$pattern"; }
# Each unit is read, whatever is said of it: clang-tidy fails where one does not compile.
one() { clang-tidy-14 --quiet --config-file="$root/.clang-tidy" -p "$build" "$1" >"$work/words.$BASHPID" 2>"$work/counts.$BASHPID"; }
all_are_read() {
  units | xargs -r -d '\n' -P "$(nproc)" -n 1 bash -c 'one "$1"' _ || { cat "$work"/words.* "$work"/counts.* | grep 'error:' | head -n 5; return 1; }
  cat "$work"/words.* >"$work/words"
  said_of <"$work/words" >"$work/said"
  [ -n "$(units)" ]
}
# Exceptions of folders that were not looked at are no matter.
nothing_new() {
  grep -v '^#' "$here/tidy_exceptions.txt" | sed 's/  .*//' | sort >"$work/excepted"
  if [ -n "$pattern" ]; then comm -13 "$work/excepted" "$work/said" >"$work/new"; else diff "$work/excepted" "$work/said" >"$work/new"; fi
  [ ! -s "$work/new" ] && return
  cat "$work/new"
  cut -d: -f1 "$work/new" | sed 's/^[<>] //' | sort -u | grep -F -f - "$work/words" | head -n 20
  return 1
}

export -f one
export root build work
check "is configured" configured
check "sees what is used after it was moved away" sees_a_wrong_program
check "every folder is read" all_are_read
check "says nothing new (>), and all that is excepted (<)" nothing_new
finish

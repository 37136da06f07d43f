#!/usr/bin/env bash
# SPDX-FileCopyrightText: 2026 The Jalon authors
# SPDX-License-Identifier: Apache-2.0
# What each operation costs on clouds that are hard on an index, beside ordinary clouds of as many points: in instructions, counted by
# Valgrind, so that the same tree gives the same figures on a busy machine. Usage: hostile.sh BUILD_FOLDER [POINTS [NAME ...]]
set -uo pipefail
build=$(realpath "${1:?usage: hostile.sh BUILD_FOLDER [POINTS [NAME ...]]}")
points=${2:-3000}
shift
[ $# -gt 0 ] && shift
here=$(cd "$(dirname "$0")" && pwd)
command -v valgrind >/dev/null || { echo "skipped: there is no valgrind"; exit 77; }
program=$build/tests/counted_calls
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

# Every call of counted_call ends with a dump of its own, in the order of the lines that the program prints.
one() {
  local points=$1 name=$2 folder
  folder="$work/$points/${name// /_}"
  mkdir -p "$folder"
  timeout 3000 valgrind --quiet --tool=callgrind --collect-atstart=no --toggle-collect=counted_call --dump-after=counted_call \
    --callgrind-out-file="$folder/out" "$program" "$points" "$name" >"$folder/calls" 2>"$folder/error"
  echo $? >"$folder/code"
  local k=0
  while [ -f "$folder/out.$((k += 1))" ]; do sed -n 's/^totals: //p' "$folder/out.$k"; rm "$folder/out.$k"; done >"$folder/counts"
}
export -f one
export work program
count() { xargs -r -d '\n' -n 1 -P 2 bash -c 'one "$1" "$2"' _ "$1"; }

if [ $# -gt 0 ]; then printf '%s\n' "$@"; else "$program" names; fi | count "$points"
# What is dear with few points is counted with ten times as many: a fixed cost stays what it is, growth does not.
python3 "$here/hostile_counts.py" --dear "$work/$points" | count "$((10 * points))"
python3 "$here/hostile_counts.py" "$work/$((10 * points))" "$work/$points"

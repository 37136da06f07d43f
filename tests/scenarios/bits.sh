#!/usr/bin/env bash
# SPDX-FileCopyrightText: 2026 The Jalon authors
# SPDX-License-Identifier: Apache-2.0
# Same input, parameters and seed: the same bits with 1, 2 and 7 threads (the long run: 3 and 16 too, and more seeds), with AVX2 and
# without, and on the national grid. In the short run two threads go without AVX2, so that one run tells of both.
#   bits.sh BUILD_FOLDER
set -uo pipefail
bits=$1/tests/bits
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
export TMPDIR=$work
passed=0 failed=0

"$bits" 1 >"$work/reference" || { cat "$work/reference"; echo "0 passed, 1 failed, 0 skipped"; exit 1; }
echo "    $(wc -l <"$work/reference") results of $(cut -c1-28 "$work/reference" | sort -u | wc -l) kinds"

# compare NAME COMMAND...: its hashes equal those of one thread.
compare() {
  local name=$1
  shift
  if "$@" >"$work/other" && diff "$work/reference" "$work/other" >"$work/difference"; then
    passed=$((passed + 1)); echo "ok - bits: $name gives the bits of one thread"
  else
    failed=$((failed + 1)); echo "not ok - bits: $name gives the bits of one thread"
    head -n 12 "$work/difference" | sed 's/^/    /'
  fi
}
compare "7 threads" "$bits" 7
if [ -n "${JALON_FULL:-}" ]; then
  compare "one thread again" "$bits" 1
  compare "2 threads" "$bits" 2
  compare "3 threads" "$bits" 3
  compare "16 threads" "$bits" 16
  compare "baseline instructions, 1 thread" env JALON_SIMD=baseline "$bits" 1
fi
compare "baseline instructions, 2 threads" env JALON_SIMD=baseline "$bits" 2

"$bits" --grid >"$work/grid"
grep -v '^[0-9]* passed' "$work/grid"
read -r p _ f _ < <(grep -E '^[0-9]+ passed' "$work/grid" || echo "0 passed, 1 failed")
passed=$((passed + p)) failed=$((failed + f))
echo "$passed passed, $failed failed, 0 skipped"
[ $failed -eq 0 ]

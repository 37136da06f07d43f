#!/usr/bin/env bash
# SPDX-FileCopyrightText: 2026 The Jalon authors
# SPDX-License-Identifier: Apache-2.0
# Sets up, builds and passes the tests. The last line is "N passed, N failed, N skipped".
#   bash tests/run.sh           what every change must pass
#   bash tests/run.sh --full    also what is too long for each commit: unit tests under the sanitizers, fault injection at every
#                               allocation, large tables, the fresh-root check, the peers' benchmarks
#   bash tests/run.sh --only PATTERN   suites whose name matches the (extended) regular expression
set -uo pipefail
root=$(cd "$(dirname "$0")/.." && pwd)
full=0 only=.
while [ $# -gt 0 ]; do
  case $1 in
    --full) full=1 ;;
    --only) only=$2; shift ;;
    *) echo "usage: $0 [--full] [--only PATTERN]" >&2; exit 2 ;;
  esac
  shift
done
[ $full -eq 0 ] || export JALON_FULL=1
. "$root/examples/packages.sh"
need_packages "${build_packages[@]}" doctest-dev libcmocka-dev abigail-tools binutils pkg-config python3 python3-venv locales \
  file librsvg2-bin "${binding_packages[@]}" || exit 1

logs=$root/build/logs work=$root/build/work # programs run in work: some write files of odd names
mkdir -p "$logs" "$work"
passed=0 failed=0 skipped=0 failures=()
started=$SECONDS

# build PRESET [TARGET ...]: configures, then builds; a failure ends the run, because nothing after it would mean anything.
build() {
  local preset=$1
  shift
  echo "== building $preset ($((SECONDS - started)) s)"
  if ! { cmake -S "$root" --preset "$preset" && ninja -C "$root/build/$preset" "$@"; } >"$logs/build_$preset.log" 2>&1; then
    grep -E "error|FAILED" "$logs/build_$preset.log" | head -n 40
    tail -n 20 "$logs/build_$preset.log"
    echo "0 passed, 1 failed, 0 skipped"
    exit 1
  fi
}

# suite NAME COMMAND ...: runs one test program or script and adds up what it counted. doctest, CMocka and lines
# "N passed, N failed, N skipped" are understood; a non-zero exit without a counted failure is a failure, 77 a skip.
suite() {
  local name=$1 log="$logs/$1.log" begin=$SECONDS p=0 f=0 s=0 code
  shift
  [[ $name =~ $only ]] || return 0
  mkdir -p "$(dirname "$log")"
  (cd "$root" && "$@") >"$log" 2>&1 </dev/null
  code=$?
  read -r p f s < <(awk '
    /^\[doctest\] test cases:/ { gsub(/[^0-9|]/, ""); split($0, n, "|"); p += n[2]; f += n[3]; s += n[4] }
    /^\[  PASSED  \] [0-9]+ test/ { p += $4 }
    /^\[  FAILED  \] [0-9]+ test/ { f += $4 }
    /^\[  SKIPPED \] [0-9]+ test/ { s += $4 }
    /^[0-9]+ passed, [0-9]+ failed(, [0-9]+ skipped)?$/ { p += $1; f += $3; s += $5 }
    END { print p + 0, f + 0, s + 0 }' "$log")
  if [ $code -eq 77 ]; then
    [ $((p + f + s)) -gt 0 ] || s=1
  elif [ $code -ne 0 ] && [ $f -eq 0 ]; then
    f=1
  elif [ $code -eq 0 ] && [ $((p + s)) -eq 0 ]; then
    f=1 # a suite that ran nothing proves nothing
  fi
  passed=$((passed + p)) failed=$((failed + f)) skipped=$((skipped + s))
  printf '%-34s %5d passed %3d failed %3d skipped %5d s\n' "$name" "$p" "$f" "$s" $((SECONDS - begin))
  grep -E "^(FIGURE|skipped:)|MESSAGE: *(FIGURE|skipped)" "$log" | sed 's/^.*MESSAGE: */  /; s/^FIGURE/  FIGURE/' | head -n 60
  if [ $f -ne 0 ]; then
    failures+=("$name")
    grep -nE "^not ok|ERROR|error:|FAILED|WARNING: ThreadSanitizer|AddressSanitizer|LeakSanitizer|runtime error" "$log" | head -n 30
    tail -n 15 "$log"
  fi
}

# programs PRESET: all unit and C programs of a build.
programs() {
  local preset=$1 program
  for program in "$root/build/$preset"/tests/unit_* "$root/build/$preset"/tests/capi_*; do
    [ -f "$program" ] && [ -x "$program" ] && suite "$preset/$(basename "$program")" env -C "$work" "$program"
  done
}

build release
release=$root/build/release
programs release
. "$root/tests/suites.sh"

# Under the sanitizers every commit runs what sees the whole library through its C surface; --full adds the unit tests.
build asan jalon_cli c_tests malformed_files
export ASAN_OPTIONS=detect_leaks=1:allocator_may_return_null=1 UBSAN_OPTIONS=print_stacktrace=1
export JALON_SANITIZED=1
programs asan
suite asan/cli bash tests/scenarios/cli.sh "$root/build/asan/src/jalon"
suite asan/malformed bash tests/fuzz/malformed.sh "$root/build/asan"

threaded=(unit_base capi_threads_test capi_search_test)
[ $full -eq 0 ] || threaded+=(unit_spatial unit_cloud unit_segment unit_scan unit_modelling)
build tsan "${threaded[@]}"
export TSAN_OPTIONS=halt_on_error=1
for program in "${threaded[@]}"; do
  suite "tsan/$program" env -C "$work" "$root/build/tsan/tests/$program"
done
unset JALON_SANITIZED

if [ $full -eq 1 ]; then . "$root/tests/full.sh"; fi

[ ${#failures[@]} -eq 0 ] || echo "failed: ${failures[*]}"
echo "took $((SECONDS - started)) s"
echo "$passed passed, $failed failed, $skipped skipped"
[ $failed -eq 0 ]

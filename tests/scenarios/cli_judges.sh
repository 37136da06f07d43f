# SPDX-FileCopyrightText: 2026 The Jalon authors
# SPDX-License-Identifier: Apache-2.0
# Sourced by the scenarios of the command line, with the tool in $jalon: a folder of their own to work in, and their judges.
work=$(mktemp -d) logs=$(mktemp -d)
trap 'rm -rf "$work" "$logs"' EXIT
cd "$work" || exit 1
passed=0 failed=0
ok() { echo "ok - $1" && passed=$((passed + 1)); }
not_ok() { echo "not ok - $1" && failed=$((failed + 1)); }
# judge NAME COMMAND ...
judge() {
  local name=$1
  shift
  if "$@" >"$logs/out" 2>&1; then ok "$name"; else not_ok "$name: $(head -n 4 "$logs/out")"; fi
}
# ends CODE PATTERN ARGUMENT ...: the tool ends with this code, one matching line on standard error and no new file.
ends() {
  local code=$1 pattern=$2 got before
  shift 2
  before=$(find . | sort | sha256sum)
  "$jalon" "$@" >"$logs/out" 2>"$logs/err"
  got=$?
  if [ $got -eq "$code" ] && [ "$(wc -l <"$logs/err")" -eq 1 ] && grep -qE -- "$pattern" "$logs/err" && [ ! -s "$logs/out" ] &&
    [ "$before" = "$(find . | sort | sha256sum)" ]; then ok "$code: jalon $*"; else
    not_ok "jalon $* (exit $got, wanted $code): $(head -n 3 "$logs/err")"
  fi
}
# says PATTERN ARGUMENT ...: the tool succeeds and a line of what it says, warnings too, matches; lacks: none does.
says() {
  local pattern=$1
  shift
  judge "jalon $* says $pattern" bash -c '"${@:2}" >"$0" 2>&1 && grep -qE -- "$1" "$0" || { cat "$0"; exit 1; }' \
    "$logs/said" "$pattern" "$jalon" "$@"
}
lacks() {
  local pattern=$1
  shift
  judge "jalon $* says no $pattern" bash -c '"${@:2}" >"$0" 2>&1 && ! grep -E -- "$1" "$0"' "$logs/said" "$pattern" "$jalon" "$@"
}

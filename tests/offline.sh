#!/usr/bin/env bash
# SPDX-FileCopyrightText: 2026 The Jalon authors
# SPDX-License-Identifier: Apache-2.0
# What a test script does where no package index can be reached: it says so and skips; where CI is set it fails.
# offline.sh SCRIPT PATTERN: its lines "skipped: PATTERN cannot be installed" and "not ok - PATTERN cannot be installed".
set -uo pipefail
script=$1 what=$2
label="$(basename "$script" .sh) offline"
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
passed=0 failed=0

# offline NAME CODE PATTERN [VARIABLE=VALUE]: the script without any package index ends with this code and such a line.
offline() {
  local name=$1 code=$2 pattern=$3 got
  env -u CI PIP_NO_INDEX=1 PIP_FIND_LINKS="$work" "${@:4}" bash "$script" "$work" >"$work/log" 2>&1
  got=$?
  if [ $got -eq "$code" ] && grep -q "$pattern" "$work/log"; then
    passed=$((passed + 1)); echo "ok - $label: $name"
  else
    failed=$((failed + 1)); echo "not ok - $label: $name (exit $got)"; tail -n 5 "$work/log"
  fi
}

offline "skipped, visibly" 77 "^skipped: $what cannot be installed"
offline "a failure where CI is set" 1 "^not ok - $what cannot be installed" CI=1
echo "$passed passed, $failed failed, 0 skipped"
[ $failed -eq 0 ]

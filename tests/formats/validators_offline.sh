#!/usr/bin/env bash
# SPDX-FileCopyrightText: 2026 The Jalon authors
# SPDX-License-Identifier: Apache-2.0
# What validators.sh does where no package index can be reached: it says so and skips; where CI is set it fails.
set -uo pipefail
here=$(cd "$(dirname "$0")" && pwd)
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
passed=0 failed=0

# offline NAME CODE PATTERN [VARIABLE=VALUE]: without any package index it ends with this code and such a line.
offline() {
  local name=$1 code=$2 pattern=$3 got
  env -u CI PIP_NO_INDEX=1 PIP_FIND_LINKS="$work" "${@:4}" bash "$here/validators.sh" "$work" >"$work/log" 2>&1
  got=$?
  if [ $got -eq "$code" ] && grep -q "$pattern" "$work/log"; then
    passed=$((passed + 1)); echo "ok - validators offline: $name"
  else
    failed=$((failed + 1)); echo "not ok - validators offline: $name (exit $got)"; tail -n 5 "$work/log"
  fi
}

offline "skipped, visibly" 77 '^skipped: ezdxf.* cannot be installed'
offline "a failure where CI is set" 1 '^not ok - ezdxf.* cannot be installed' CI=1
echo "$passed passed, $failed failed, 0 skipped"
[ $failed -eq 0 ]

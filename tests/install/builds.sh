# SPDX-FileCopyrightText: 2026 The Jalon authors
# SPDX-License-Identifier: Apache-2.0
# What the long checks of whole builds share; sourced. subject: what is checked, for the lines.
root=$(cd "$(dirname "${BASH_SOURCE[0]}")/../.." && pwd)
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
passed=0 failed=0 skipped=0
export CMAKE_GENERATOR=Ninja

# check NAME COMMAND...: the command succeeds; its output is $work/log.
check() {
  local name=$1
  shift
  if "$@" >"$work/log" 2>&1; then
    passed=$((passed + 1)); echo "ok - $subject: $name"
  else
    failed=$((failed + 1)); echo "not ok - $subject: $name"; tail -n 25 "$work/log" | sed 's/^/    /'
  fi
}
finish() {
  echo "$passed passed, $failed failed, $skipped skipped"
  [ $failed -eq 0 ]
  exit
}

#!/usr/bin/env bash
# SPDX-FileCopyrightText: 2026 The Jalon authors
# SPDX-License-Identifier: Apache-2.0
# The examples run and say what they should. Usage: examples.sh BUILD_FOLDER
set -uo pipefail
build=$1
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
passed=0 failed=0
check() {
  local name=$1
  shift
  if "$@" >"$work/log" 2>&1; then cp "$work/log" "$work/seen" && echo "ok - $name" && passed=$((passed + 1)); else
    echo "not ok - $name" && failed=$((failed + 1)) && tail -n 5 "$work/log"
  fi
}
"$build/src/jalon" scan --scene facade -o "$work/sample.las" --quiet --set horizontal_step_rad=0.004 --set vertical_step_rad=0.004
check "01_planes lists planes" "$build/examples/example_01_planes" "$work/sample.las"
check "01_planes finds at least five" test "$(grep -c '^plane' "$work/seen")" -ge 5
check "01_planes says what is wrong with a missing file" bash -c "! '$build/examples/example_01_planes' '$work/none.las' && '$build/examples/example_01_planes' '$work/none.las' 2>&1 | grep -q none.las"
check "02_progress computes normals" "$build/examples/example_02_progress"
cp "$work/seen" "$work/shown"
check "02_progress: the top of the dome looks up or down" grep -qE 'top: -?0.00[0-9]+ -?0.00[0-9]+ -?(1.0000|0.999[0-9])' "$work/shown"
echo "$passed passed, $failed failed, 0 skipped"
[ $failed -eq 0 ]

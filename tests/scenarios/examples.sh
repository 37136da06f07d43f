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
check "03_model makes a model" "$build/examples/example_03_model" "$work/sample.las" "$work/model.dxf"
check "03_model finds 19 windows and 2 doors" test "$(grep -c '^window' "$work/seen") $(grep -c '^door' "$work/seen")" = "19 2"
check "03_model writes a drawing" grep -q LWPOLYLINE "$work/model.dxf"
"$build/src/jalon" scan --scene facade -o "$work/second.las" --quiet --set horizontal_step_rad=0.004 --set vertical_step_rad=0.004 --set seed=2
check "04_register lays one scan onto another" "$build/examples/example_04_register" "$work/sample.las" "$work/second.las" "$work/registered.las"
check "04_register converges" grep -q '^converged' "$work/seen"
for day in 1 3; do
  "$build/src/jalon" scan --scene earthworks -o "$work/day$day.las" --quiet --scene-set day=$day --set horizontal_step_rad=0.001 --set vertical_step_rad=0.001
done
check "05_changes lists regions" "$build/examples/example_05_changes" "$work/day1.las" "$work/day3.las"
check "05_changes: the largest is the wall or the heap" test "$(grep -c '^region' "$work/seen")" -ge 2
check "05_changes finds none where nothing has changed" "$build/examples/example_05_changes" "$work/day1.las" "$work/day1.las"
check "05_changes says nothing then" test ! -s "$work/seen"
"$build/src/jalon" scan --method mobile -o "$work/drive.ply" --model "$work/street.obj" --trajectory "$work/drive.txt" --quiet \
  --scene-set sigma_position_m=1 --scene-set leg_m=60 --set revolutions_per_s=10
check "06_joint adjusts a drive and a street" "$build/examples/example_06_joint" "$work/street.obj" "$work/drive.ply" "$work/drive.txt" "$work/adjusted.txt"
check "06_joint: each block has its offset and what it is worth" test "$(grep -c '^block .* sigma 0\.' "$work/seen")" -ge 10
check "06_joint writes the trajectory" test "$(wc -l <"$work/adjusted.txt")" -eq "$(wc -l <"$work/drive.txt")"
printf '1;0;0;10;300.2\n2;22;0;10;300.4\n3;22;8;10;300.4\n4;0;8;10;300.4\n5;0;0;0;300.4\n6;0.971;0.2;4.18;360\n7;2.171;0.2;5.827;360\n8;10.4;0;7.347;361\n9;10.4;0.15;7.347;361.8\n10;11.6;0;8.994;361\n' >"$work/codes.txt"
check "07_feature_codes classifies a scan" "$build/examples/example_07_feature_codes" "$work/sample.las" "$work/codes.txt" "$work/classified.las" "$work/objects.dxf"
check "07_feature_codes: three objects hold points" test "$(grep -c '^object [123]: [1-9]' "$work/seen")" -eq 3
check "07_feature_codes: windows stand with their codes" bash -c "'$build/examples/example_07_feature_codes' '$work/sample.las' '$work/codes.txt' '$work/classified.las' '$work/objects.dxf' | grep -q '^window: window 8 (361)$'"
check "07_feature_codes writes a drawing" grep -q LWPOLYLINE "$work/objects.dxf"
echo "$passed passed, $failed failed, 0 skipped"
[ $failed -eq 0 ]

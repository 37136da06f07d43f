#!/usr/bin/env bash
# SPDX-FileCopyrightText: 2026 The Jalon authors
# SPDX-License-Identifier: Apache-2.0
# A new method with a parameter of its own needs three files: a dummy is added to a copy of the tree, which then knows it in C, on
# the command line and in the tables that the bindings are made from. Usage: new_method.sh (it compiles the library once)
set -uo pipefail
root=$(cd "$(dirname "$0")/../.." && pwd)
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
tree=$work/tree build=$work/tree/build/release # where a compiler cache knows the files of other builds
passed=0 failed=0
check() { # check NAME COMMAND ...
  local name=$1
  shift
  if "$@" >"$work/log" 2>&1; then echo "ok - new method: $name" && passed=$((passed + 1)); else
    echo "not ok - new method: $name" && failed=$((failed + 1)) && tail -n 15 "$work/log"
  fi
}
export CMAKE_GENERATOR=Ninja

mkdir "$tree"
(cd "$root" && git ls-files -z | xargs -0 cp --parents -t "$tree") || exit 1
cp -r "$tree" "$work/before"

cat >"$tree/src/segment/dummy.h" <<'CODE'
#pragma once

#include "segment/segmentation.h"

namespace jalon {

struct DummySettings {
  int64_t k = 24;
};
std::span<const ParamRow> dummy_rows();
Segmentation segment_dummy(const CloudPtr& cloud, const DummySettings& settings, Task& task);

}  // namespace jalon
CODE
cat >"$tree/src/segment/dummy.cpp" <<'CODE'
#include "segment/dummy.h"

#include "base/setting_rows.h"
#include "segment/growing_settings.h"

namespace jalon {

std::span<const ParamRow> dummy_rows() {
  static constexpr auto kDummyRows = setting_rows(
      integer_row<&DummySettings::k>("k", 4, 256, "points", "dummy", "Neighbours of a point."));
  return kDummyRows;
}

Segmentation segment_dummy(const CloudPtr& cloud, const DummySettings& settings, Task& task) {
  GrowingSettings growing;
  growing.k = static_cast<uint32_t>(settings.k);
  return segment_region_growing(cloud, growing, task);
}

}  // namespace jalon
CODE
sed -i -e 's|^#include "segment/growing_settings.h"|#include "segment/dummy.h"\n&|' \
  -e 's|^constexpr SegmentMethod kMethods\[\] = {|&\n    {"dummy", "segmenter dummy", dummy_rows, run<DummySettings, segment_dummy>},|' \
  "$tree/src/segment/methods.cpp"

touched=$(diff -rq "$work/before" "$tree" | wc -l)
check "three files are touched" test "$touched" -eq 3
check "the copy is configured" cmake -S "$tree" -B "$build" -DCMAKE_BUILD_TYPE=Release -DJALON_WERROR=ON
check "the copy is compiled" ninja -C "$build" src/libjalon.so src/jalon
tables=$work/tables.json
check "the bindings' tables are read" python3 "$tree/bindings/generator/dump_params.py" "$build/src/libjalon.so" "$tables"
check "they have the method with its parameter" python3 -c "
import json
rows = json.load(open('$tables'))['workers']['segmenter']['dummy']
assert [r['name'] for r in rows] == ['k'] and rows[0]['default_text'] == '24', rows"
check "help lists it" bash -c "'$build/src/jalon' segment --help | grep -q dummy"
check "a scan is made" "$build/src/jalon" scan --scene room -o "$work/room.las" --quiet --set horizontal_step_rad=0.02 --set vertical_step_rad=0.02
check "it runs" "$build/src/jalon" segment "$work/room.las" -o "$work/out" --method dummy --set k=12 --quiet
check "the result tells method and parameters" python3 -c "
import json
told = json.load(open('$work/out/segments.json'))
assert told['method'] == 'dummy' and told['parameters'] == {'k': 12}, told"
check "a wrong name is told of it" bash -c "! '$build/src/jalon' segment '$work/room.las' -o '$work/none' --method nothing >'$work/wrong' 2>&1 && grep -q 'there are: dummy, ransac, region_growing' '$work/wrong'"
echo "$passed passed, $failed failed, 0 skipped"
[ $failed -eq 0 ]

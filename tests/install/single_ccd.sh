#!/usr/bin/env bash
# SPDX-FileCopyrightText: 2026 The Jalon authors
# SPDX-License-Identifier: Apache-2.0
# A libccd of single precision is caught when the build is configured: single_ccd.sh
# The library's own check file (src/solid/fcl.cmake) is run with the installed headers, then with the same headers built for floats.
set -uo pipefail
root=$(cd "$(dirname "$0")/../.." && pwd)
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
passed=0 failed=0
export CMAKE_GENERATOR=Ninja

# configured FOLDER OPTION ...: a project of the check file alone is configured.
configured() {
  local folder=$work/$1
  shift
  mkdir -p "$folder"
  printf 'cmake_minimum_required(VERSION 3.22)\nproject(check C CXX)\nset(CMAKE_CXX_STANDARD 20)\n%s\ninclude(%s)\n' \
    'find_package(Eigen3 3.4 REQUIRED NO_MODULE)' "$root/src/solid/fcl.cmake" >"$folder/CMakeLists.txt"
  cmake -S "$folder" -B "$folder/build" -DJALON_WITH_FCL=ON "$@" >"$work/log" 2>&1
}
check() {
  local name=$1
  shift
  if "$@"; then passed=$((passed + 1)); echo "ok - ccd: $name"; else
    failed=$((failed + 1)); echo "not ok - ccd: $name"; tail -n 8 "$work/log" | sed 's/^/    /'
  fi
}
refused() { ! configured "$@" && grep -q "$pattern" <<<"$(tr -s '\n ' ' ' <"$work/log")"; }

check "the installed libccd is of double precision" configured double
# The package of a libccd built with ENABLE_DOUBLE_PRECISION=OFF: its headers and nothing more.
headers=$(printf '#include <ccd/vec3.h>\n' | c++ -E -x c++ - | sed -n 's|^# 1 "\(.*\)/ccd/vec3.h".*|\1|p' | head -n 1)
mkdir -p "$work/package/include" "$work/package/cmake"
cp -r "$headers/ccd" "$work/package/include/"
printf '#ifndef __CCD_CONFIG_H__\n#define __CCD_CONFIG_H__\n#define CCD_SINGLE\n#endif\n' >"$work/package/include/ccd/config.h"
printf 'set(CCD_INCLUDE_DIRS "%s")\nset(CCD_LIBRARIES ccd)\nset(ccd_FOUND ON)\n' "$work/package/include" \
  >"$work/package/cmake/ccd-config.cmake"
pattern='built for single precision'
check "one of single precision is refused, and says why" refused single "-Dccd_DIR=$work/package/cmake"
check "it is not needed with JALON_WITH_FCL=OFF" configured off -DJALON_WITH_FCL=OFF -DCMAKE_DISABLE_FIND_PACKAGE_ccd=ON

echo "$passed passed, $failed failed, 0 skipped"
[ $failed -eq 0 ]

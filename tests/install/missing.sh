#!/usr/bin/env bash
# SPDX-FileCopyrightText: 2026 The Jalon authors
# SPDX-License-Identifier: Apache-2.0
# What is missing is named before anything is built, with the line that installs it: missing.sh BUILD_FOLDER
# Packages are hidden from CMake one by one and together, also where pip runs it: with the environment of the Python tests, where there
# is one.
set -uo pipefail
root=$(cd "$(dirname "$0")/../.." && pwd)
build=$(realpath "${1:?usage: missing.sh BUILD_FOLDER}")
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
passed=0 failed=0 skipped=0
export CMAKE_GENERATOR=Ninja

result() { # result NAME STATUS
  if [ "$2" -eq 0 ]; then passed=$((passed + 1)); echo "ok - missing: $1"; else
    failed=$((failed + 1)); echo "not ok - missing: $1"; tail -n 20 "$work/log" | sed 's/^/    /'
  fi
}
hidden() { # hidden NAMES OPTION ...: CMake is run as if it found none of the packages of these names.
  local names=$1 name options=()
  shift
  for name in $names; do options+=("-DCMAKE_DISABLE_FIND_PACKAGE_$name=ON"); done
  cmake -S "$root" -B "$work/build" -U 'CMAKE_DISABLE_FIND_PACKAGE_*' -U 'JALON_*' "${options[@]}" "$@" >"$work/log" 2>&1
}
says() { tr -s ' \n' ' ' <"$work/log" | grep -qF -- "$1"; }
# names PACKAGES LINE OPTION ...: CMake stops and has that line.
names() {
  local packages=$1 line=$2
  shift 2
  ! hidden "$packages" "$@" && says "$line"
  result "without $packages: $line" $?
}

names Boost "apt install libboost-dev"
names Eigen3 "apt install libeigen3-dev"
names nlohmann_json "apt install nlohmann-json3-dev"
names ZLIB "apt install zlib1g-dev"
names fcl "apt install libfcl-dev"
names fcl "-DJALON_WITH_FCL=OFF"
names SQLite3 "apt install libsqlite3-dev"
names SQLite3 "-DJALON_WITH_SQLITE=OFF"
names PNG "apt install libpng-dev"
names PNG "-DJALON_WITH_LIBPNG=OFF"
names CLI11 "apt install libcli11-dev"
names "doctest cmocka" "apt install doctest-dev libcmocka-dev" -DJALON_BUILD_TESTS=ON
names SWIG "apt install swig" -DJALON_BUILD_BINDINGS=ON -DJALON_BINDING_LANGUAGES=python
names "Java JNI" "apt install default-jdk-headless" -DJALON_BUILD_BINDINGS=ON -DJALON_BINDING_LANGUAGES=java
names "Boost fcl SWIG" "missing: Boost 1.74, FCL 0.7, SWIG 4. On Debian this installs it: apt install libboost-dev libfcl-dev swig" \
  -DJALON_BUILD_BINDINGS=ON -DJALON_BINDING_LANGUAGES=python
hidden "fcl ccd SQLite3 PNG CLI11 SWIG Java JNI" -DJALON_WITH_FCL=OFF -DJALON_WITH_SQLITE=OFF -DJALON_WITH_LIBPNG=OFF -DJALON_BUILD_CLI=OFF -DJALON_BUILD_BINDINGS=ON
result "what was not asked for may be missing" $?
says "Bindings: none, swig or Python is missing"
result "bindings that nobody named are left out, and the log says so" $?

# pip says the same: what CMake lacks is in its output, before anything is compiled.
# pip_names PACKAGES LINE
pip_names() {
  local name options=()
  for name in $1; do options+=(-C "cmake.define.CMAKE_DISABLE_FIND_PACKAGE_$name=ON"); done
  rm -rf "$work/source/build"
  ! "$python" -m pip install --disable-pip-version-check --no-build-isolation --no-deps --target "$work/target" "${options[@]}" \
    "$work/source" >"$work/log" 2>&1 && says "$2" && ! says "Building CXX object"
  result "pip install . without $1: $2" $?
}
python=$build/bindings_venv/bin/python
if "$python" -c "import scikit_build_core" 2>/dev/null; then
  git clone -q "$root" "$work/source"
  pip_names SWIG "missing: SWIG 4. On Debian this installs it: apt install swig"
  pip_names Boost "missing: Boost 1.74. On Debian this installs it: apt install libboost-dev"
  pip_names fcl "missing: FCL 0.7. On Debian this installs it: apt install libfcl-dev"
  pip_names "Boost fcl ccd SWIG" "apt install libboost-dev libccd-dev libfcl-dev swig"
else
  echo "skipped: pip, no environment with scikit-build-core was made"
  skipped=1
fi

echo "$passed passed, $failed failed, $skipped skipped"
[ $failed -eq 0 ]

#!/usr/bin/env bash
# SPDX-FileCopyrightText: 2026 The Jalon authors
# SPDX-License-Identifier: Apache-2.0
# Install is tested, not assumed: check.sh BUILD_FOLDER
# Into a prefix and through DESTDIR; C99 consumers by pkg-config and by find_package; the tool; a moved prefix; uninstall.
set -uo pipefail
here=$(cd "$(dirname "$0")" && pwd)
root=$(cd "$here/../.." && pwd)
build=$(cd "$1" && pwd)
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
prefix=$work/prefix
release=$(sed -n 's/.*JALON_VERSION_STRING "\(.*\)".*/\1/p' "$root/include/jalon/version.h")
passed=0 failed=0
export CMAKE_GENERATOR=Ninja # what the tests install; a fresh root has no make

# check NAME COMMAND...: the command succeeds.
check() {
  local name=$1
  shift
  if "$@" >"$work/log" 2>&1; then
    passed=$((passed + 1)); echo "ok - install: $name"
  else
    failed=$((failed + 1)); echo "not ok - install: $name"; tail -n 8 "$work/log" | sed 's/^/    /'
  fi
}

mkdir -p "$prefix/lib"
echo "not ours" >"$prefix/lib/stranger.txt"
check "into a prefix" cmake --install "$build" --prefix "$prefix"
pc=$(dirname "$(find "$prefix" -name jalon.pc | head -n 1)")
libdir=$(dirname "$pc")

headers_alike() { diff -r "$root/include/jalon" "$prefix/include/jalon"; }
check "the headers and nothing more than the headers" headers_alike
expected_only() {
  ! (cd "$prefix" && find . ! -type d | sed 's|^\./||') |
    grep -vE '^(bin/jalon|include/jalon/[a-z_]+\.h|lib/stranger\.txt|share/licenses/jalon/.*)$' |
    grep -vE '^lib[^/]*/([^/]+/)?(libjalon\.so(\.[0-9.]+)?|pkgconfig/jalon\.pc|cmake/jalon/jalon(Config|ConfigVersion|Targets|Targets-[a-z]+)\.cmake)$'
}
check "only the tool, the library, its headers, packages and licence" expected_only
no_build_paths() { ! grep -rlF -e "$build" -e "$root" "$prefix"; }
check "no path of the build machine in any installed file" no_build_paths
links_right() {
  local so
  so=$(readelf -dW "$libdir/libjalon.so" | sed -n 's/.*SONAME.*\[\(.*\)\].*/\1/p')
  [ -e "$libdir/$so" ] && [ "$(readlink -f "$libdir/$so")" = "$(readlink -f "$libdir/libjalon.so.$release")" ]
}
check "the links of the library lead to the release" links_right

by_pkg_config() {
  export PKG_CONFIG_PATH=$1
  [ "$(pkg-config --modversion jalon)" = "$release" ] &&
    cc -std=c99 -pedantic -Wall -Wextra -Werror "$here/consumer.c" -o "$work/by_pkg_config" $(pkg-config --cflags --libs jalon) &&
    [ "$(LD_LIBRARY_PATH=$(pkg-config --variable=libdir jalon) "$work/by_pkg_config")" = "jalon $release" ]
}
check "a C99 consumer by pkg-config runs" by_pkg_config "$pc"
by_find_package() {
  rm -rf "$work/consumer"
  cmake -S "$here/find_package" -B "$work/consumer" -DCMAKE_PREFIX_PATH="$1" -Dwanted_version="$2" &&
    cmake --build "$work/consumer" && [ "$("$work/consumer/consumer")" = "jalon $release" ]
}
check "a C99 consumer by find_package runs" by_find_package "$prefix" "${release%.*}"
refuses_other_version() { ! by_find_package "$prefix" 99.0; }
check "find_package refuses another release" refuses_other_version
tool_runs() { [[ $("$1/bin/jalon" --version) == *"$release"* ]]; }
check "the installed tool runs without a library path" tool_runs "$prefix"

mv "$prefix" "$work/moved"
check "a moved prefix serves find_package" by_find_package "$work/moved" "${release%.*}"
check "a moved prefix serves pkg-config" by_pkg_config "$work/moved${pc#"$prefix"}"
check "the tool of a moved prefix runs" tool_runs "$work/moved"
mv "$work/moved" "$prefix"

check "uninstall" cmake --build "$build" --target uninstall
nothing_left() { ! find "$1" -mindepth 1 ! -name stranger.txt ! -path "$1/lib" | grep .; }
check "uninstall leaves no file and no empty folder" nothing_left "$prefix"
check "uninstall spares the files of others" test -f "$prefix/lib/stranger.txt"

check "through DESTDIR" env DESTDIR="$work/stage" cmake --install "$build"
staged() { [ -n "$(find "$work/stage" -name libjalon.so)" ] && [ -n "$(find "$work/stage" -name jalon.h)" ]; }
check "DESTDIR holds the library and the headers" staged
configured=$(sed -n 's/^CMAKE_INSTALL_PREFIX:[A-Z]*=//p' "$build/CMakeCache.txt")
check "a consumer by pkg-config from DESTDIR" by_pkg_config "$(dirname "$(find "$work/stage" -name jalon.pc)")"
check "uninstall from DESTDIR" env DESTDIR="$work/stage" cmake --build "$build" --target uninstall
check "uninstall from DESTDIR leaves nothing" nothing_left "$work/stage$configured"

as_subdirectory() {
  mkdir -p "$work/super"
  printf 'cmake_minimum_required(VERSION 3.22)\nproject(super C CXX)\nadd_subdirectory(%s jalon)\nadd_executable(consumer %s)\n%s\n' \
    "$root" "$here/consumer.c" 'target_link_libraries(consumer jalon::jalon)' >"$work/super/CMakeLists.txt"
  cmake -S "$work/super" -B "$work/super/build"
}
check "configures inside another project" as_subdirectory

echo "$passed passed, $failed failed, 0 skipped"
[ $failed -eq 0 ]

#!/usr/bin/env bash
# SPDX-FileCopyrightText: 2026 The Jalon authors
# SPDX-License-Identifier: Apache-2.0
# -DBUILD_SHARED_LIBS=OFF: the library as one archive, installed, and programs in C that link it: static.sh [BUILD_FOLDER]
set -uo pipefail
here=$(cd "$(dirname "$0")" && pwd)
. "$here/builds.sh"
subject=static
build=${1:-$root/build/static}
prefix=$work/prefix
release=$(sed -n 's/.*JALON_VERSION_STRING "\(.*\)".*/\1/p' "$root/include/jalon/version.h")

check "is configured" cmake -S "$root" -B "$build" -DCMAKE_BUILD_TYPE=Release -DJALON_WERROR=ON -DBUILD_SHARED_LIBS=OFF
check "is built" cmake --build "$build"
check "is installed" cmake --install "$build" --prefix "$prefix"
archive=$(find "$prefix" -name libjalon.a)
alone() { [ -n "$archive" ] && ! find "$prefix" -name '*.so*' -o -name 'libjalon_*' | grep .; }
check "one archive, and no shared library beside it" alone

# Nothing of Jalon is left for the loader; FCL and libccd, which Debian has as shared libraries alone, and SQLite are.
stands_alone() { [ "$("$1")" = "jalon $release" ] && ! readelf -d "$1" | grep 'NEEDED.*jalon'; }
by_pkg_config() {
  export PKG_CONFIG_PATH=${archive%/*}/pkgconfig
  cc -std=c99 -pedantic -Wall -Wextra -Werror "$here/consumer.c" -o "$work/by_pkg_config" $(pkg-config --static --cflags --libs jalon) &&
    stands_alone "$work/by_pkg_config"
}
check "a C99 program by pkg-config --static runs without a shared Jalon" by_pkg_config
by_find_package() {
  cmake -S "$here/find_package" -B "$work/consumer" -DCMAKE_PREFIX_PATH="$prefix" -Dwanted_version="${release%.*}" &&
    cmake --build "$work/consumer" && stands_alone "$work/consumer/consumer"
}
check "a C99 program by find_package runs without a shared Jalon" by_find_package
tool() { [[ $("$prefix/bin/jalon" --version) == *"$release"* ]] && ! readelf -d "$prefix/bin/jalon" | grep 'NEEDED.*jalon'; }
check "the tool has the library in it" tool
refuses_bindings() {
  ! cmake -S "$root" -B "$work/bindings" -DBUILD_SHARED_LIBS=OFF -DJALON_BUILD_BINDINGS=ON &&
    grep -q 'bindings load a shared library' "$work/log"
}
check "the bindings are refused, and the line says why" refuses_bindings

finish

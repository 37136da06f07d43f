#!/usr/bin/env bash
# SPDX-FileCopyrightText: 2026 The Jalon authors
# SPDX-License-Identifier: Apache-2.0
# The library and the tool for Windows: mingw.sh [BUILD_FOLDER]
# Compiled by Debian's cross compiler without a warning, and run by Wine where that is installed, which is not Windows itself.
# Without FCL, SQLite and libpng, which Debian has for its own system alone.
set -uo pipefail
here=$(cd "$(dirname "$0")" && pwd)
. "$here/builds.sh"
subject=mingw
build=${1:-$root/build/mingw}
prefix=$work/prefix
release=$(sed -n 's/.*JALON_VERSION_STRING "\(.*\)".*/\1/p' "$root/include/jalon/version.h")

# The headers of other libraries, and nothing else of the system's: its own would be in the way of those of Windows.
headers=$build/headers
rm -rf "$headers"
mkdir -p "$headers/include" "$headers/share/cmake" "$headers/share/eigen3"
for folder in eigen3 boost nlohmann CLI; do ln -s "/usr/include/$folder" "$headers/include/$folder"; done
cp -r /usr/share/cmake/nlohmann_json /usr/share/cmake/CLI11 "$headers/share/cmake/"
cp -r /usr/share/eigen3/cmake "$headers/share/eigen3/"

configured() {
  cmake -S "$root" -B "$build" -DCMAKE_TOOLCHAIN_FILE="$here/mingw.cmake" -DJALON_HEADERS="$headers" -DCMAKE_BUILD_TYPE=Release \
    -DJALON_WERROR=ON -DJALON_WITH_FCL=OFF -DJALON_WITH_SQLITE=OFF -DJALON_WITH_LIBPNG=OFF -DBoost_NO_BOOST_CMAKE=ON -DBoost_INCLUDE_DIR="$headers/include"
}
check "is configured" configured
[ $failed -eq 0 ] || finish
check "library and tool compile without a warning" cmake --build "$build"
[ $failed -eq 0 ] || finish
check "is installed" cmake --install "$build" --prefix "$prefix"
exports() { # the names that the library gives out
  x86_64-w64-mingw32-objdump -p "$prefix/bin/libjalon.dll" | sed -n '/^\[Ordinal/,/^$/s/^\s*\[ *[0-9]*\] //p' | sort
}
same_exports() { exports >"$work/exports" && diff "$work/exports" <(grep -v '^#' "$root/tests/abi/symbols.txt" | sort); }
check "the library gives out the functions of the headers and nothing else" same_exports
consumer() {
  cmake -S "$here/find_package" -B "$work/consumer" -DCMAKE_TOOLCHAIN_FILE="$here/mingw.cmake" -DJALON_HEADERS="$prefix" \
    -Dwanted_version="${release%.*}" && cmake --build "$work/consumer"
}
check "a C99 consumer by find_package is built" consumer

# ---- run, as far as Wine goes ---------------------------------------------------------------------------------------
wine=$(command -v wine64 || ls /usr/lib/wine/wine64 2>/dev/null)
if [ -z "$wine" ]; then
  echo "skipped: nothing is run, wine64 is missing"
  skipped=$((skipped + 1))
  finish
fi
export WINEPREFIX=$work/wine WINEDEBUG=-all
for library in libstdc++-6.dll libgcc_s_seh-1.dll libwinpthread-1.dll; do
  cp "$(x86_64-w64-mingw32-g++-posix -print-file-name="$library")" "$prefix/bin/"
done
cp /usr/x86_64-w64-mingw32/lib/zlib1.dll "$prefix/bin/"
cp "$work/consumer/consumer.exe" "$prefix/bin/"
cd "$work" && "$wine" wineboot >/dev/null 2>&1
tool() { "$wine" "$prefix/bin/jalon.exe" "$@"; }
prints() { [ "$("$wine" "$prefix/bin/$1" | tr -d '\r')" = "$2" ]; }
check "the consumer runs" prints consumer.exe "jalon $release"
check "the tool scans a facade" tool scan --scene facade --quiet -o 'façade é.las'
check "a name beyond ASCII is the name of the file" test -s 'façade é.las'
told() { tool info "$1" --json | tr -d '\r' | python3 -c "import json, sys; assert json.load(sys.stdin)['points'] > 100000"; }
check "the tool reads it" told 'façade é.las'
check "it replaces a file" tool convert 'façade é.las' again.ply --quiet
check "and again" tool convert 'façade é.las' again.ply --quiet
check "it reads what it replaced" told again.ply
check "it makes planes, a model, drawings and a report" tool facade 'façade é.las' --quiet -o result
for file in model.dxf model.obj elevation.svg report.html segments.las; do check "there is $file" test -s "result/$file"; done
nothing_private() { ! find "$work" -maxdepth 2 -name '*.part' -o -maxdepth 2 -name '.jalon*' | grep .; }
check "no private file or folder is left" nothing_private
missing() { tool info absent.las; [ $? -eq 3 ] && grep -q 'no such file or folder' "$work/log"; }
check "a missing file is told by its code and line" missing
folder() { tool info result; [ $? -ne 0 ] && grep -q 'it is a folder' "$work/log"; }
check "a folder is told from a file" folder
finish

#!/usr/bin/env bash
# SPDX-FileCopyrightText: 2026 The Jalon authors
# SPDX-License-Identifier: Apache-2.0
# The Python tests with the wrapper compiled under AddressSanitizer and UndefinedBehaviorSanitizer, whose allocator then serves
# Python and libjalon too: python_asan.sh BUILD_FOLDER, a release build whose tests of the wheel ran before (their environment is
# used). Leaks of the interpreter itself are not looked for; the live-handle counter is.
set -uo pipefail
here=$(cd "$(dirname "$0")" && pwd)
root=$(cd "$here/../.." && pwd)
build=$(realpath "${1:?usage: python_asan.sh BUILD_FOLDER}")
python=$build/bindings_venv/bin/python
bindings=$build/bindings
[ -x "$python" ] && [ -d "$bindings/python/jalon" ] || { echo "skipped: the Python tests did not run"; exit 77; }
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cp -r "$bindings/python/jalon" "$work"
include=$("$python" -c "import sysconfig; print(sysconfig.get_path('include'))")
g++ -std=c++17 -shared -fPIC -g -O1 -fno-omit-frame-pointer -fno-strict-aliasing -fsanitize=address,undefined -fno-sanitize-recover=all \
  "-I$root/bindings/swig" "-I$bindings/generated" "-I$root/include" "-I$include" "$bindings/jalon_python_wrap.cpp" \
  -o "$work/jalon/_native.so" "$build/src/libjalon.so" "-Wl,-rpath,$build/src" || exit 1
preload="$(g++ -print-file-name=libasan.so) $(g++ -print-file-name=libubsan.so)"
cd "$work" && env LD_PRELOAD="$preload" ASAN_OPTIONS=detect_leaks=0 UBSAN_OPTIONS=print_stacktrace=1 PYTHONMALLOC=malloc \
  PYTHONPATH="$work" JALON_SANITIZED=1 "$python" -P "$here/python/run.py"

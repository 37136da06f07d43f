#!/usr/bin/env bash
# SPDX-FileCopyrightText: 2026 The Jalon authors
# SPDX-License-Identifier: Apache-2.0
# Sets the peers up, builds the drivers and measures. Usage: run.sh [options of run.py]
set -euo pipefail
root=$(cd "$(dirname "$0")/../.." && pwd)
build=$root/build/bench
bash "$root/tests/bench/setup.sh" "$build/peers"
cmake -S "$root" -B "$build" -G Ninja -DCMAKE_BUILD_TYPE=Release -DJALON_BUILD_BENCHMARKS=ON -DJALON_BUILD_TESTS=ON >/dev/null
ninja -C "$build" --quiet tests/bench/all jalon_cli accuracy capi_cancel_test
passed=0 failed=0
count() { if "$@"; then passed=$((passed + 1)); else failed=$((failed + 1)); fi; }
count python3 "$root/tests/bench/promised.py" "$build"
count "$build/peers/venv/bin/python" "$root/tests/bench/run.py" --build "$build" --data "$build/data" --json "$build/result.json" "$@"
echo "$passed passed, $failed failed, 0 skipped"
[ $failed -eq 0 ]

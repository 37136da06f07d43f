#!/usr/bin/env bash
# SPDX-FileCopyrightText: 2026 The Jalon authors
# SPDX-License-Identifier: Apache-2.0
# Sets the peers up, builds the drivers and measures. Usage: run.sh [options of run.py]
set -euo pipefail
root=$(cd "$(dirname "$0")/../.." && pwd)
build=$root/build/bench
bash "$root/tests/bench/setup.sh" "$build/peers"
cmake -S "$root" -B "$build" -G Ninja -DCMAKE_BUILD_TYPE=Release -DJALON_BUILD_BENCHMARKS=ON >/dev/null
ninja -C "$build" --quiet
if "$build/peers/venv/bin/python" "$root/tests/bench/run.py" --build "$build" --data "$build/data" --json "$build/result.json" "$@"; then
  echo "1 passed, 0 failed, 0 skipped"
else
  echo "0 passed, 1 failed, 0 skipped"
  exit 1
fi

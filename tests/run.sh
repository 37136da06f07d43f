#!/usr/bin/env bash
# SPDX-FileCopyrightText: 2026 The Jalon authors
# SPDX-License-Identifier: Apache-2.0
# Sets up, builds and passes the tests. The last line is "N passed, N failed, N skipped".
#   bash tests/run.sh           what every change must pass
#   bash tests/run.sh --full    also what is too long for each commit: unit tests under the sanitizers, fault injection at every
#                               allocation, large tables, the fresh-root check, the peers' benchmarks; --full 1/4 ... 4/4: in parts
#   bash tests/run.sh --only PATTERN   suites whose name matches the regular expression, and what they need built
# tests/README.md has the suites and how long they take; tests/runner does the work.
set -uo pipefail
root=$(cd "$(dirname "$0")/.." && pwd)
. "$root/examples/packages.sh"
need_packages "${build_packages[@]}" doctest-dev libcmocka-dev abigail-tools binutils pkg-config python3 python3-venv clang-format-14 locales \
  file librsvg2-bin "${binding_packages[@]}" || exit 1
exec python3 "$root/tests/runner/run.py" "$@"

#!/usr/bin/env bash
# SPDX-FileCopyrightText: 2026 The Jalon authors
# SPDX-License-Identifier: Apache-2.0
# LAS and LAZ against laspy, E57 against pye57, COPC against laspy and copclib, PLY
# against plyfile, PCD against pypcd4, in both directions: laspy.sh BUILD_FOLDER
# laspy and lazrs come from PyPI into BUILD_FOLDER/laspy_venv, once. Without it the test is skipped (77), visibly;
# where CI is set that is a failure.
set -uo pipefail
here=$(cd "$(dirname "$0")" && pwd)
build=${1:?usage: laspy.sh BUILD_FOLDER}
venv=$build/laspy_venv

has_laspy() { "$venv/bin/python" -c "import laspy, lazrs, numpy" 2>/dev/null; }

if ! has_laspy; then
  log=$build/laspy_setup.log
  python3 -m venv "$venv" >"$log" 2>&1 && "$venv/bin/pip" install --disable-pip-version-check laspy lazrs numpy >>"$log" 2>&1 &&
    { "$venv/bin/pip" install --disable-pip-version-check pye57 >>"$log" 2>&1 || true; }
  if ! has_laspy; then
    tail -n 3 "$log"
    if [ -n "${CI:-}" ]; then
      echo "not ok - laspy cannot be installed"
      echo "0 passed, 1 failed, 0 skipped"
      exit 1
    fi
    echo "skipped: laspy cannot be installed"
    echo "0 passed, 0 failed, 1 skipped"
    exit 77
  fi
fi
for package in copclib plyfile pypcd4 pyproj; do # some have no wheel for some machines
  "$venv/bin/python" -c "import $package" 2>/dev/null ||
    "$venv/bin/pip" install --disable-pip-version-check --retries 0 "$package" >"$build/${package}_setup.log" 2>&1 || true
done
exec "$venv/bin/python" "$here/check_laspy.py" "$build/src/libjalon.so"

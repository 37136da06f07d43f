#!/usr/bin/env bash
# SPDX-FileCopyrightText: 2026 The Jalon authors
# SPDX-License-Identifier: Apache-2.0
# The Python package as a user has it: a wheel from pyproject.toml over the installed library, in a virtual environment of
# its own, where the tests run: python.sh BUILD_FOLDER. The environment's packages come from PyPI, once; without them the
# test is skipped (77), visibly; where CI is set that is a failure.
set -uo pipefail
here=$(cd "$(dirname "$0")" && pwd)
root=$(cd "$here/../.." && pwd)
build=$(realpath "${1:?usage: python.sh BUILD_FOLDER}")
venv=$build/bindings_venv work=$build/bindings_wheel
mkdir -p "$work"

skip() { echo "skipped: $1"; echo "0 passed, 0 failed, 1 skipped"; exit 77; }
fail() { echo "not ok - $1"; tail -n 15 "$work/log"; echo "0 passed, 1 failed, 0 skipped"; exit 1; }

has_packages() { "$venv/bin/python" -c "import numpy, pandas, matplotlib, pyproj, scikit_build_core, mypy" 2>/dev/null; }

if ! has_packages; then
  python3 -m venv "$venv" >"$work/log" 2>&1 &&
    "$venv/bin/pip" install --disable-pip-version-check numpy pandas matplotlib pyproj scikit-build-core pathspec mypy >>"$work/log" 2>&1
  if ! has_packages; then
    [ -z "${CI:-}" ] || fail "numpy and scikit-build-core cannot be installed"
    skip "numpy and scikit-build-core cannot be installed"
  fi
fi
# For the map of the first day, which is skipped without it.
"$venv/bin/python" -c "import geopandas" 2>/dev/null ||
  "$venv/bin/pip" install --disable-pip-version-check --retries 1 --timeout 10 geopandas >"$work/log" 2>&1
[ -f "$build/bindings/generated/_api.py" ] || skip "the bindings were not built, their tools are missing"

rm -rf "$work/prefix" "$work/wheels"
cmake --install "$build" --prefix "$work/prefix" >"$work/log" 2>&1 || fail "the library cannot be installed"
"$venv/bin/pip" wheel --disable-pip-version-check --no-deps --no-build-isolation --wheel-dir "$work/wheels" \
  -C build-dir="$work/build" -C cmake.define.JALON_INSTALLED=ON -C cmake.define.CMAKE_PREFIX_PATH="$work/prefix" "$root" \
  >"$work/log" 2>&1 || fail "no wheel can be built"
"$venv/bin/pip" install --disable-pip-version-check --no-deps --force-reinstall "$work"/wheels/jalon-*.whl \
  >"$work/log" 2>&1 || fail "the wheel cannot be installed"
rm -rf "$work/prefix" # what is tested stands on its own

python3 "$here/closure.py" python "$(echo "$venv"/lib/python3*/site-packages/jalon)" \
  "$(find "$venv"/lib/python3*/site-packages/jalon-*.dist-info -name THIRD-PARTY-LICENSES.txt)" || exit 1

# The scenarios as on a machine without FCL and libccd, where such a place can be made.
hide="bash $here/hidden.sh"
if ! $hide true 2>"$work/log"; then
  echo "skipped: the system's FCL cannot be hidden: $(cat "$work/log")"
  hide=
fi

# Away from the tree, with nothing of it on the path: the installed package alone answers.
mkdir -p "$work/run"
cd "$work/run" && env -u PYTHONPATH -u LD_LIBRARY_PATH JALON_BUILD="$build" JALON_HIDE="$hide" JALON_CALLED="$work/called.txt" \
  "$venv/bin/python" -P "$here/python/run.py" || exit 1
python3 "$here/called.py" python "$work/called.txt"

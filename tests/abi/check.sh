#!/usr/bin/env bash
# SPDX-FileCopyrightText: 2026 The Jalon authors
# SPDX-License-Identifier: Apache-2.0
# The binary interface against what is committed: check.sh BUILD_FOLDER
set -uo pipefail
here=$(dirname "$0")
failed=0
python3 "$here/check.py" "$1" || failed=1
python3 "$here/parameters.py" "$1" || failed=1
python3 "$here/mutants.py" || failed=1
python3 "$here/released.py" "$1" || failed=1
exit $failed

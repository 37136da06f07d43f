#!/usr/bin/env bash
# SPDX-FileCopyrightText: 2026 The Jalon authors
# SPDX-License-Identifier: Apache-2.0
# The binary interface against what is committed: check.sh BUILD_FOLDER
set -euo pipefail
exec python3 "$(dirname "$0")/check.py" "$1"

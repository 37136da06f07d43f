#!/usr/bin/env bash
# SPDX-FileCopyrightText: 2026 The Jalon authors
# SPDX-License-Identifier: Apache-2.0
# Writes symbols.txt, globals.txt, parameters.txt and jalon.abi.xml anew from a finished build: update.sh BUILD_FOLDER
set -euo pipefail
python3 "$(dirname "$0")/parameters.py" "$1" --update
exec python3 "$(dirname "$0")/check.py" "$1" --update

#!/usr/bin/env bash
# SPDX-FileCopyrightText: 2026 The Jalon authors
# SPDX-License-Identifier: Apache-2.0
# All generated malformed files through the readers of a build: malformed.sh BUILD_FOLDER
set -euo pipefail
exec "${1:?usage: malformed.sh BUILD_FOLDER}/tests/fuzz/malformed_files"

#!/usr/bin/env bash
# SPDX-FileCopyrightText: 2026 The Jalon authors
# SPDX-License-Identifier: Apache-2.0
# What fuzzing kept, through the readers of a build: replay.sh BUILD_FOLDER
set -euo pipefail
exec "${1:?usage: replay.sh BUILD_FOLDER}/tests/fuzz/fuzz_replay" "$(dirname "$0")/corpus"

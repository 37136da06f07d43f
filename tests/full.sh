# SPDX-FileCopyrightText: 2026 The Jalon authors
# SPDX-License-Identifier: Apache-2.0
# What is too long for each commit; sourced by run.sh after the default suites.
suite fresh_root bash tests/install/fresh_root.sh
suite bench bash tests/bench/run.sh

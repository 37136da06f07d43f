# SPDX-FileCopyrightText: 2026 The Jalon authors
# SPDX-License-Identifier: Apache-2.0
# What is too long for each commit; sourced by run.sh after the default suites.
build asan
export JALON_SANITIZED=1
for program in "$root"/build/asan/tests/unit_*; do
  [ -f "$program" ] && [ -x "$program" ] && suite "asan/$(basename "$program")" env -C "$work" "$program"
done
unset JALON_SANITIZED
need_packages maven && suite bindings_from_source bash tests/bindings/from_source.sh "$release"
suite bindings_asan bash tests/bindings/python_asan.sh "$release"
suite fresh_root bash tests/install/fresh_root.sh
suite bench bash tests/bench/run.sh

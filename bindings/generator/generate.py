#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The Jalon authors
# SPDX-License-Identifier: Apache-2.0
"""Writes what the bindings are compiled from: generate.py OUT_FOLDER PARAMETERS_JSON"""

import json
import os
import sys

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
import emit_python  # noqa: E402
import emit_swig  # noqa: E402
import python_columns  # noqa: E402


def write(folder, name, text):
    path = os.path.join(folder, name)
    if os.path.exists(path) and open(path, encoding="utf-8").read() == text:
        return
    with open(path, "w", encoding="utf-8") as f:
        f.write(text)


def main():
    folder = sys.argv[1]
    os.makedirs(folder, exist_ok=True)
    write(folder, "jalon_calls.h", emit_swig.calls_header())
    write(folder, "jalon_api.i", emit_swig.interface())
    with open(sys.argv[2], encoding="utf-8") as f:
        tables = json.load(f)
    code, stub = emit_python.module(tables)
    write(folder, "_api.py", code)
    write(folder, "_api.pyi", stub)
    write(folder, "_columns.py", python_columns.module(emit_python.functions()))


if __name__ == "__main__":
    main()

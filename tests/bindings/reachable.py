#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The Jalon authors
# SPDX-License-Identifier: Apache-2.0
"""Everything public in C is reachable in Python, Java and C#: reachable.py BUILD_FOLDER

The exported symbols (tests/abi/symbols.txt) against what each language's generated code calls. What a language has its own form
of stands in bindings/generator/shapes.py, with the reason.
"""

import os
import re
import sys

HERE = os.path.dirname(os.path.abspath(__file__))
sys.path[:0] = [os.path.join(HERE, "..", "style"), os.path.join(HERE, "..", "..", "bindings", "generator")]
from shapes import methods, replaced  # noqa: E402
from source import Tally, read  # noqa: E402


def text_of(*parts):
    path = os.path.join(*parts)
    return open(path, encoding="utf-8").read() if os.path.exists(path) else None


def main():
    build = os.path.join(os.path.abspath(sys.argv[1]), "bindings")
    tally = Tally()
    symbols = {line for line in read("tests/abi/symbols.txt").split("\n") if line.startswith("jalon_")}
    wrapped = {m.c.name: m for m in methods()}
    tally.check("bindings__every_symbol_is_wrapped_or_replaced",
                sorted(s for s in symbols if s not in wrapped and not replaced(s)))
    tally.check("bindings__nothing_is_both_wrapped_and_replaced", sorted(s for s in wrapped if replaced(s)))
    tally.check("bindings__only_symbols_are_wrapped", sorted(set(wrapped) - symbols))
    calls = text_of(build, "generated", "jalon_calls.h") or ""
    tally.check("bindings__every_wrapped_function_is_called",
                sorted(s for s in wrapped if not re.search(r"\b%s\(" % s, calls)))
    for language in ("python", "java", "csharp"):
        name = "bindings__%s_reaches_every_function" % language
        text = text_of(build, "jalon_%s_wrap.cpp" % language)
        if text is None:
            tally.skip(name, "it was not built, its tools are missing")
            continue
        tally.check(name, [m.c.name for m in wrapped.values()
                           if not re.search(r"(calls::%s|\W%s)\(" % (m.full_name, m.full_name), text)])
    big = text_of(build, "java_swig", "org", "jalon", "JalonJNI.java")
    if big is not None:
        folder = os.path.join(build, "java_swig", "org", "jalon")
        tally.check("bindings__java_counts_are_long",
                    [n for n in sorted(os.listdir(folder)) if "BigInteger" in open(os.path.join(folder, n), encoding="utf-8").read()])
    tally.close()


if __name__ == "__main__":
    main()

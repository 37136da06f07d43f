#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The Jalon authors
# SPDX-License-Identifier: Apache-2.0
"""What Clang's integer sanitizer said in logs, of the library's own lines: integer_findings.py ROOT LOG ...

Each place must be one that integer_exceptions.txt gives a reason for, and each reason must still have its line."""

import glob
import os
import re
import sys

EXCEPTIONS = os.path.join(os.path.dirname(os.path.abspath(__file__)), "integer_exceptions.txt")
MOST_TOLD = 30


def read_exceptions():
    """[(file or *, text)]."""
    with open(EXCEPTIONS, encoding="utf-8") as f:
        rows = [line.split("  ")[0].split(": ", 1) for line in f if line.strip() and not line.startswith("#")]
    return [(name, text.lower()) for name, text in rows]


def lines_of(root, name):
    with open(os.path.join(root, name), encoding="utf-8") as f:
        return [line.lower() for line in f]


def findings(root, logs):
    """{(file, line): what was said first} of the files below src."""
    said = re.compile(re.escape(root) + r"/(src/[^:]+):(\d+):\d+: runtime error: (.*)")
    out = {}
    for log in logs:
        with open(log, encoding="utf-8", errors="replace") as f:
            for name, line, words in said.findall(f.read()):
                out.setdefault((name, int(line)), words)
    return out


def is_meant(root, place, exceptions):
    line = lines_of(root, place[0])[place[1] - 1]
    return any(name in ("*", place[0]) and text in line for name, text in exceptions)


def stale_ones(root, exceptions):
    everywhere = "".join("".join(lines_of(root, os.path.relpath(p, root))) for p in glob.glob(os.path.join(root, "src", "**", "*.*"), recursive=True)
                         if p.endswith((".h", ".cpp", ".inc")))
    return [(name, text) for name, text in exceptions
            if text not in (everywhere if name == "*" else "".join(lines_of(root, name)) if os.path.exists(os.path.join(root, name)) else "")]


def main():
    root, logs = os.path.realpath(sys.argv[1]), sys.argv[2:]
    exceptions, found = read_exceptions(), findings(root, logs)
    new = {place: words for place, words in sorted(found.items()) if not is_meant(root, place, exceptions)}
    stale = stale_ones(root, exceptions)
    for (name, line), words in list(new.items())[:MOST_TOLD]:
        print("%s:%d: %s" % (name, line, words))
    for name, text in stale:
        print("%s has no more: %s" % (name, text))
    print("FIGURE integers: %d places of %d logs wrap as they mean to, %d others" % (len(found) - len(new), len(logs), len(new)))
    return 1 if new or stale else 0


if __name__ == "__main__":
    sys.exit(main())

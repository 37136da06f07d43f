# SPDX-FileCopyrightText: 2026 The Jalon authors
# SPDX-License-Identifier: Apache-2.0
"""What a test program said of itself: doctest, CMocka, and lines "N passed, N failed, N skipped"."""

import re

MOST_FIGURES, MOST_TROUBLES, LAST_LINES, SKIPPED = 60, 30, 15, 77
PLAIN = re.compile(r"^(\d+) passed, (\d+) failed(?:, (\d+) skipped)?$")
CMOCKA = re.compile(r"^\[  (PASSED |FAILED |SKIPPED) \] (\d+) test")
TROUBLE = re.compile(r"^not ok|ERROR|error:|FAILED|WARNING: ThreadSanitizer|AddressSanitizer|LeakSanitizer|runtime error")


def counts(text, code):
    """(passed, failed, skipped). An exit that is no success without a counted failure is one; so is a run of nothing."""
    passed = failed = skipped = 0
    for line in text.splitlines():
        if line.startswith("[doctest] test cases:"):
            _, p, f, s = (int(n) for n in (re.findall(r"\d+", line) + ["0"] * 4)[:4])
        elif plain := PLAIN.match(line):
            p, f, s = (int(n or 0) for n in plain.groups())
        elif cmocka := CMOCKA.match(line):
            n = int(cmocka.group(2))
            p, f, s = (n if cmocka.group(1).startswith(word) else 0 for word in ("PASSED", "FAILED", "SKIPPED"))
        else:
            continue
        passed, failed, skipped = passed + p, failed + f, skipped + s
    if code == SKIPPED:
        skipped = skipped if passed + failed + skipped else 1
    elif code != 0 and failed == 0 or code == 0 and passed + skipped == 0:
        failed = 1
    return passed, failed, skipped


def figures(text):
    """Measured figures, and what was skipped and why."""
    found = [line for line in text.splitlines()
             if re.match(r"FIGURE|skipped:", line) or re.search(r"MESSAGE: *(FIGURE|skipped)", line)]
    return [re.sub(r"^.*MESSAGE: *", "", line) for line in found[:MOST_FIGURES]]


def troubles(text):
    lines = text.splitlines()
    marked = ["%d:%s" % (i, line) for i, line in enumerate(lines, 1) if TROUBLE.search(line)]
    return marked[:MOST_TROUBLES] + lines[-LAST_LINES:]

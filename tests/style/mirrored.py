# SPDX-FileCopyrightText: 2026 The Jalon authors
# SPDX-License-Identifier: Apache-2.0
"""Every .cpp with logic has a test at the mirrored path, or stands in tests/covered_elsewhere.txt with the case that covers it."""

import os
import re

from source import ROOT, TOKENS, read, without_comments

LIST = "tests/covered_elsewhere.txt"
MOST = 60  # so that the list stays what it is for: what a test of its own could not show better
LOGIC = re.compile(r"\b(?:if|for|while|switch)\b|\?|&&|\|\|")


def has_logic(path):
    """A branch, a loop or a condition; tables and calls handed on have none."""
    code = TOKENS.sub(lambda m: '""' if m.group(0)[0] in "\"R'" else m.group(0), without_comments(read(path)))
    code = re.sub(r"^\s*#.*$", "", code, flags=re.M)
    return LOGIC.search(code) is not None


def mirrored_path(path):
    """Of src/ROOM/SUB/x.cpp tests/unit/ROOM/SUB/x_test.cpp; the C surface is tested in C."""
    stem = path[len("src/"):-len(".cpp")]
    if stem.startswith("capi/"):
        return "tests/capi/%s_test.c" % os.path.basename(stem)
    return "tests/unit/%s_test.cpp" % stem


def listed():
    """{source: (test file, case)} of the list; a line is the three, separated by ": "."""
    out = {}
    for line in read(LIST).splitlines():
        if line and not line.startswith("#"):
            source, test, case = line.split(": ", 2)
            out["src/" + source] = ("tests/" + test, case)
    return out


def mirrored(files):
    tests, sources = set(files), [f for f in files if re.match(r"src/.*\.cpp$", f)]
    elsewhere = listed()
    if len(elsewhere) > MOST:
        yield "%s has %d names, %d are the most" % (LIST, len(elsewhere), MOST)
    for source, (test, case) in elsewhere.items():
        if source not in sources:
            yield "%s: there is no %s" % (LIST, source)
        elif mirrored_path(source) in tests:
            yield "%s: %s has a test of its own" % (LIST, source)
        if not os.path.isfile(os.path.join(ROOT, test)) or case not in read(test):
            yield "%s: %s has no %s" % (LIST, test, case)
    for source in sources:
        if source not in elsewhere and mirrored_path(source) not in tests and has_logic(source):
            yield "%s has no %s and does not stand in %s" % (source, mirrored_path(source), LIST)

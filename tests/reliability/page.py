#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The Jalon authors
# SPDX-License-Identifier: Apache-2.0
"""tests/RELIABILITY.md from figures.py and from what the last run said: page.py [--write].

--write takes the last values from build/logs, keeps them in measured.json and writes the page. Without it the page is
held against the table, and each test that a row names against the tree: a row of a test that is gone is a failure."""

import json
import os
import re
import sys

HERE = os.path.dirname(os.path.abspath(__file__))
ROOT = os.path.dirname(os.path.dirname(HERE))
PAGE, MEASURED = os.path.join(ROOT, "tests", "RELIABILITY.md"), os.path.join(HERE, "measured.json")
sys.path.insert(0, HERE)
from figures import FIGURES  # noqa: E402

TEXTS = (".c", ".h", ".cpp", ".py", ".sh", ".java", ".cs", ".md")
MOST_SHOWN = 110  # letters of a value


def sources():
    out = []
    for folder, _, names in os.walk(os.path.join(ROOT, "tests")):
        if os.path.samefile(folder, HERE):
            names = [n for n in names if n not in ("figures.py", "page.py")]
        for name in names:
            if name.endswith(TEXTS) and name != "RELIABILITY.md":
                with open(os.path.join(folder, name), encoding="utf-8", errors="replace") as f:
                    out.append(f.read())
    return "\n".join(out)


def log_of(suite):
    path = os.path.join(ROOT, "build", "logs", suite + ".log")
    if not os.path.exists(path):
        return ""
    with open(path, encoding="utf-8", errors="replace") as f:
        return f.read()


def measured_in_logs():
    """Of each figure the line of its suites that gives a value, where the last run left one."""
    values = {}
    for figure in FIGURES:
        found = []
        for suite, pattern in figure.shown_by:
            lines = [re.sub(r"^.*FIGURE ", "", line) for line in log_of(suite).splitlines() if "FIGURE" in line]
            if "FIGURE" in pattern or suite.split("/")[-1].startswith("reliability_"):
                found += [line[:MOST_SHOWN] for line in lines if re.search(pattern.replace("FIGURE ", ""), line) or suite.split("/")[-1].startswith("reliability_")]
        if found:
            values[figure.name] = list(dict.fromkeys(found))[:3]
    return values


def state_of(figure):
    return "reached" if not figure.missing else "in part" if figure.shown_by else "missing"


def row_of(figure, measured):
    suites = ", ".join(dict.fromkeys("`%s`" % suite for suite, _ in figure.shown_by)) or "-"
    run = "long run" if figure.full and figure.shown_by else "each run" if figure.shown_by else "-"
    return "| %s | %s | %s | %s | %s | %s |" % (figure.name, figure.promise, state_of(figure) + (": " + figure.missing if figure.missing else ""),
                                              suites, run, "; ".join(measured.get(figure.name, [])) or "-")


def page(measured):
    states = [state_of(f) for f in FIGURES]
    head = ["# Reliability", "",
            "%d figures: %d reached, %d in part, %d missing. `tests/reliability/page.py --write` makes this page from `figures.py` and the logs of"
            % (len(FIGURES), states.count("reached"), states.count("in part"), states.count("missing")),
            "the last runs; the suite `reliability_page` fails where a test that a row names is gone. A row says \"long run\" where its whole figure",
            "needs `tests/run.sh --full`; each run makes a part of it. Values are the last ones of any run, - where none was kept.", "",
            "| | figure | state | suites | in | last value |", "| --- | --- | --- | --- | --- | --- |"]
    return "\n".join(head + [row_of(f, measured) for f in FIGURES]) + "\n"


def kept():
    if not os.path.exists(MEASURED):
        return {}
    with open(MEASURED, encoding="utf-8") as f:
        return json.load(f)


def main():
    measured = kept()
    if "--write" in sys.argv:
        measured.update(measured_in_logs())
        with open(MEASURED, "w", encoding="utf-8") as f:
            json.dump(measured, f, indent=1, sort_keys=True)
            f.write("\n")
        with open(PAGE, "w", encoding="utf-8") as f:
            f.write(page(measured))
    passed = failed = 0
    text = sources()
    for figure in FIGURES:
        gone = [pattern for _, pattern in figure.shown_by if not re.search(pattern, text)]
        passed, failed = passed + (not gone), failed + bool(gone)
        print("%s - reliability %s: its tests are there%s" % ("not ok" if gone else "ok", figure.name, ": no " + ", ".join(gone) if gone else ""))
    with open(PAGE, encoding="utf-8") as f:
        fits = f.read() == page(measured)
    print("%s - reliability: the page is that of the table" % ("ok" if fits else "not ok"))
    passed, failed = passed + fits, failed + (not fits)
    print("%d passed, %d failed, 0 skipped" % (passed, failed))
    return 1 if failed else 0


if __name__ == "__main__":
    sys.exit(main())

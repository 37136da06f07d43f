#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The Jalon authors
# SPDX-License-Identifier: Apache-2.0
"""tests/RELIABILITY.md from figures.py and from what the last run said: page.py [--write].

--write takes the last values and the long runs from build/logs, keeps them in measured.json and writes the page. Without it
the page is held against the table, and each test that a row names against the tree and the suites: a row of a test that is
gone, or that no run takes, is a failure."""

import json
import os
import re
import sys

HERE = os.path.dirname(os.path.abspath(__file__))
ROOT = os.path.dirname(os.path.dirname(HERE))
PAGE, MEASURED, LOGS = os.path.join(ROOT, "tests", "RELIABILITY.md"), os.path.join(HERE, "measured.json"), os.path.join(ROOT, "build", "logs")
sys.path[:0] = [HERE, os.path.join(ROOT, "tests", "runner")]
from figures import FIGURES  # noqa: E402
from long_runs import commit_of, git, read_long_runs  # noqa: E402
from mutants import MUTANTS  # noqa: E402
from suites import all_suites  # noqa: E402

TEXTS = (".c", ".h", ".cpp", ".py", ".sh", ".java", ".cs", ".md")
MOST_SHOWN, MOST_VALUES = 110, 3  # letters of a value; values of a figure
OF_THE_LIBRARY = ("src", "include", "CMakeLists.txt")
MOST_PLACES = 4  # of a test: what stands in more of them is a word and no name


def sources():
    """The texts of all tests, without the table itself and what is made of it."""
    out = []
    for top in (os.path.join(ROOT, "tests"), os.path.join(ROOT, "bindings", "java", "src", "test")):
        for folder, _, names in os.walk(top):
            for name in names:
                if name.endswith(TEXTS) and name not in ("figures.py", "page.py", "mutants.py", os.path.basename(PAGE)):
                    with open(os.path.join(folder, name), encoding="utf-8", errors="replace") as f:
                        out.append(f.read())
    return "\n".join(out)


def read_source(name):
    path = os.path.join(ROOT, name)
    if not os.path.exists(path):
        return ""
    with open(path, encoding="utf-8") as f:
        return f.read()


def last_run():
    """What the logs of the last run hold: [passed, failed] of each suite, and the values that belong to figures."""
    with open(os.path.join(LOGS, "suites.json"), encoding="utf-8") as f:
        suites = {row["suite"]: [row["passed"], row["failed"]] for row in json.load(f) if "failed" in row}
    values = {}
    for figure in FIGURES:
        lines = []
        for suite, test in figure.shown_by:
            if suite not in suites:
                continue
            with open(os.path.join(LOGS, suite + ".log"), encoding="utf-8", errors="replace") as f:
                told = [line.split("FIGURE ", 1)[1].strip() for line in f if "FIGURE " in line]
            is_own = suite.split("/")[-1].startswith("reliability_")  # all that it tells is of this figure
            lines += [line[:MOST_SHOWN] for line in told if is_own or test.startswith("FIGURE ") and line.startswith(test[7:])]
        if lines:
            values[figure.name] = list(dict.fromkeys(lines))[:MOST_VALUES]
    return suites, values


def changed_since(commit, root=ROOT):
    """How many files of the library have changed since a commit; None where it is in no history at hand."""
    told = git(root, "diff", "--name-only", commit.rstrip("+"), "HEAD", "--", *OF_THE_LIBRARY) if commit else None
    return None if told is None else len(told.splitlines())


def has_passed(suite, figure, kept):
    """By its last run, or where that left it out by the last long one, which must not have failed where the figure needs it."""
    passed, failed = kept["suites"].get(suite, [0, 0])
    if figure.full and suite in kept["long"]:
        passed, failed = passed or kept["long"][suite]["passed"], failed + kept["long"][suite]["failed"]
    return passed > 0 and failed == 0


def state_of(figure, kept):
    if not figure.shown_by:
        return "missing: " + figure.missing
    if figure.missing:
        return "in part: " + figure.missing
    bad = [suite for suite in suites_of(figure) if not has_passed(suite, figure, kept)]
    return "not shown: %s did not pass, or was not run" % ", ".join(bad) if bad else "reached"


def suites_of(figure):
    return list(dict.fromkeys(suite for suite, _ in figure.shown_by))


def told_run(suite, run):
    counts = "%d passed%s" % (run["passed"], ", %d failed" % run["failed"] if run["failed"] else "")
    since = "" if run["changed"] is None else ", %d files changed since" % run["changed"]
    return "`%s` on %s at %s: %s in %.0f min%s" % (suite, run["date"], run["commit"] or "no commit", counts, run["minutes"], since)


def runs_of(figure, kept):
    """Which run makes the whole of it, and of a long one when that was, of which sources."""
    if not figure.shown_by:
        return "-"
    if not figure.full:
        return "each run"
    told = [told_run(suite, kept["long"][suite]) for suite in suites_of(figure) if suite in kept["long"]]
    untold = ", ".join("`%s`" % suite for suite in suites_of(figure) if suite not in kept["long"])
    return "; ".join(["long run"] + told + (["no record of " + untold] if untold else []))


def row_of(figure, kept):
    suites = ", ".join("`%s`" % suite for suite in suites_of(figure)) or "-"
    broken = sum(m.figure == figure.name for m in MUTANTS) or "-"
    return "| %s | %s | %s | %s | %s | %s | %s |" % (figure.name, figure.promise, state_of(figure, kept), suites, runs_of(figure, kept), broken,
                                                   "; ".join(kept["values"].get(figure.name, [])) or "-")


def page(kept):
    states = [state_of(f, kept).split(":")[0] for f in FIGURES]
    counted = ", ".join("%d %s" % (states.count(s), s) for s in ("reached", "in part", "not shown", "missing"))
    head = ["# Reliability", "",
            "%d figures: %s. `tests/reliability/page.py --write` makes this page from `figures.py` and" % (len(FIGURES), counted),
            "from what the last run of each suite said; the suite `reliability_page` fails where a test that a row names is gone. A row says",
            "\"long run\" where its whole figure needs `tests/run.sh --full`, of which each run makes a part, and of each suite on which day it",
            "had that run, at which commit (with + where files stood changed), and how many files of the library have changed between that",
            "and %s, at which this page was made; earlier long runs stand in the figure's text with their days. Values are the" % (kept["counted_at"] or "now"),
            "last ones of any run, - where none was kept. \"Broken\": in how many ways `mutants.py` breaks its subject on purpose, each of",
            "which a test must see (suite `mutation`); %d more breakages are of other promises." % sum(not m.figure for m in MUTANTS), "",
            "| | figure | state | suites | in | broken | last value |", "| --- | --- | --- | --- | --- | --- | --- |"]
    return "\n".join(head + [row_of(f, kept) for f in FIGURES]) + "\n"


def read_kept():
    kept = {"suites": {}, "values": {}, "long": {}, "counted_at": ""}
    if os.path.exists(MEASURED):
        with open(MEASURED, encoding="utf-8") as f:
            kept.update(json.load(f))
    return kept


def write_page(kept):
    suites, values = last_run()
    named = {suite for figure in FIGURES for suite, _ in figure.shown_by}
    kept["suites"].update({suite: counts for suite, counts in suites.items() if suite in named})
    kept["values"].update(values)
    long_runs = read_long_runs(os.path.join(LOGS, "long_runs.json"))
    kept["long"].update({suite: run for suite, run in long_runs.items() if suite in named})
    for run in kept["long"].values():
        run["changed"] = changed_since(run["commit"])
    kept["counted_at"] = commit_of(ROOT).rstrip("+")
    with open(MEASURED, "w", encoding="utf-8") as f:
        json.dump(kept, f, indent=1, sort_keys=True)
        f.write("\n")
    with open(PAGE, "w", encoding="utf-8") as f:
        f.write(page(kept))


def main():
    kept = read_kept()
    if "--write" in sys.argv:
        write_page(kept)
    passed = failed = 0
    text = sources()
    run = {s.name for s in all_suites()}
    never_run = sorted({suite for figure in FIGURES for suite, _ in figure.shown_by} - run)
    print("%s - reliability: its suites are run%s" % (("not ok", ": not " + ", ".join(never_run)) if never_run else ("ok", "")))
    passed, failed = passed + (not never_run), failed + bool(never_run)
    for figure in FIGURES:
        vague = [test for _, test in figure.shown_by if not 0 < len(re.findall(test, text)) <= MOST_PLACES]
        passed, failed = passed + (not vague), failed + bool(vague)
        print("%s - reliability %s: its tests are there%s" % ("not ok" if vague else "ok", figure.name,
                                                             ": none, or too many, are " + ", ".join(vague) if vague else ""))
    stale = [m for m in MUTANTS if read_source(m.file).count(m.text) != 1 or m.test not in text]
    print("%s - reliability: what mutants break stands there, and their tests%s" % (("not ok", ": not " + "; ".join(
        m.file + " " + m.test for m in stale)) if stale else ("ok", "")))
    passed, failed = passed + (not stale), failed + bool(stale)
    with open(PAGE, encoding="utf-8") as f:
        fits = f.read() == page(kept)
    print("%s - reliability: the page is that of the table" % ("ok" if fits else "not ok"))
    passed, failed = passed + fits, failed + (not fits)
    print("%d passed, %d failed, 0 skipped" % (passed, failed))
    return 1 if failed else 0


if __name__ == "__main__":
    sys.exit(main())

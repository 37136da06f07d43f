#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The Jalon authors
# SPDX-License-Identifier: Apache-2.0
"""What the page makes of runs: which figures they reach, and what is told of the long ones."""

import os
import sys
import tempfile
import unittest

from page import changed_since, has_passed, runs_of, state_of
from figures import EACH, LONG, Figure
from long_runs import commit_of, git, read_long_runs, remember

LONG_ONE = Figure("X1", "a promise", [("slow", "a test"), ("quick", "a test")], LONG, "")
EACH_ONE = Figure("X2", "a promise", [("quick", "a test")], EACH, "")


def run_of(passed, failed, changed=3):
    return {"commit": "0123abcd", "date": "2026-01-02", "passed": passed, "failed": failed, "minutes": 41.2, "changed": changed}


def kept_of(suites, long):
    return {"suites": suites, "values": {}, "long": long, "counted_at": ""}


class States(unittest.TestCase):
    def test_a_suite_of_the_long_run_alone_counts_by_its_last_long_run(self):
        self.assertEqual(state_of(LONG_ONE, kept_of({"quick": [7, 0]}, {})), "not shown: slow did not pass, or was not run")
        self.assertEqual(state_of(LONG_ONE, kept_of({"quick": [7, 0]}, {"slow": run_of(5, 0)})), "reached")
        self.assertEqual(state_of(LONG_ONE, kept_of({"quick": [7, 0], "slow": [0, 0]}, {"slow": run_of(5, 0)})), "reached")

    def test_a_failure_of_either_run_is_one(self):
        self.assertFalse(has_passed("slow", LONG_ONE, kept_of({"slow": [5, 0]}, {"slow": run_of(4, 1)})))
        self.assertFalse(has_passed("slow", LONG_ONE, kept_of({"slow": [4, 1]}, {"slow": run_of(5, 0)})))

    def test_a_figure_of_each_run_is_not_reached_by_a_long_one(self):
        self.assertFalse(has_passed("quick", EACH_ONE, kept_of({}, {"quick": run_of(5, 0)})))

    def test_what_is_missing_stays_in_part_whatever_ran(self):
        self.assertEqual(state_of(LONG_ONE._replace(missing="half of it"), kept_of({"quick": [7, 0]}, {"slow": run_of(5, 0)})), "in part: half of it")


class Told(unittest.TestCase):
    def test_a_long_run_is_told_with_day_commit_and_changes(self):
        told = runs_of(LONG_ONE, kept_of({}, {"slow": run_of(5, 0)}))
        self.assertEqual(told, "long run; `slow` on 2026-01-02 at 0123abcd: 5 passed in 41 min, 3 files changed since; no record of `quick`")
        self.assertIn("4 passed, 1 failed in 41 min;", runs_of(LONG_ONE, kept_of({}, {"slow": run_of(4, 1, None)})))
        self.assertEqual(runs_of(EACH_ONE, kept_of({}, {"quick": run_of(5, 0)})), "each run")


class Records(unittest.TestCase):
    def test_runs_of_parts_add_up_and_skipped_ones_take_nothing_away(self):
        with tempfile.TemporaryDirectory() as folder:
            path = os.path.join(folder, "long_runs.json")
            remember(path, {"suite": "a", "passed": 3, "failed": 0, "wall_s": 90}, "1", "2026-01-02")
            remember(path, {"suite": "b", "passed": 0, "failed": 1, "wall_s": 6}, "2", "2026-01-03")
            remember(path, {"suite": "a", "passed": 0, "failed": 0, "wall_s": 1}, "3", "2026-01-04")
            runs = read_long_runs(path)
        self.assertEqual(sorted(runs), ["a", "b"])
        self.assertEqual(runs["a"], {"commit": "1", "date": "2026-01-02", "passed": 3, "failed": 0, "minutes": 1.5})

    def test_changes_are_counted_in_the_library_alone(self):
        def write(*names):
            for name in names:
                os.makedirs(os.path.join(folder, os.path.dirname(name)), exist_ok=True)
                with open(os.path.join(folder, name), "a", encoding="utf-8") as f:
                    f.write("x")

        with tempfile.TemporaryDirectory() as folder:
            self.assertEqual(commit_of(folder), "")
            if git(folder, "init", "-q") is None:
                self.skipTest("no git")
            for who in (("user.name", "a"), ("user.email", "a@b")):
                git(folder, "config", *who)
            write("src/a", "include/b", "tests/c")
            git(folder, "add", ".")
            git(folder, "commit", "-qm", "first")
            first = commit_of(folder)
            write("src/a", "tests/c")
            self.assertEqual(commit_of(folder), first + "+")
            git(folder, "commit", "-qam", "second")
            self.assertEqual([changed_since(c, folder) for c in (first, first + "+", commit_of(folder), "", "0123abcd")], [1, 1, 0, None, None])


if __name__ == "__main__":
    result = unittest.main(argv=sys.argv[:1], exit=False, verbosity=2).result
    bad = len(result.failures) + len(result.errors)
    print("%d passed, %d failed, 0 skipped" % (result.testsRun - bad, bad))
    sys.exit(1 if bad else 0)

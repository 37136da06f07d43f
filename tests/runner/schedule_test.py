#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The Jalon authors
# SPDX-License-Identifier: Apache-2.0
"""The runner's own logic: the order of builds and suites, the counts that it reads."""

import sys
import unittest
from dataclasses import dataclass

from counting import counts
from schedule import Schedule, longest_first
from suites import ALONE, LONGEST_FIRST, all_suites


@dataclass
class One:
    name: str
    build: str = "release"
    is_alone: bool = False


def played(schedule):
    """Lets every build and suite end as soon as nothing more can be started; gives what ran beside what."""
    moments = []
    while not schedule.is_over:
        schedule.next_build()
        while schedule.next_suite():
            pass
        moments.append((schedule.building, [s.name for s in schedule.running]))
        if schedule.running:
            schedule.suite_ended(schedule.running[0])
        elif schedule.building:
            schedule.build_ended()
        else:
            raise AssertionError("nothing runs and nothing is over: %s" % schedule.__dict__)
    return moments


class Order(unittest.TestCase):
    def test_every_suite_runs_once_and_only_after_its_build(self):
        suites = [One("a", "asan"), One("b"), One("c", "asan"), One("d"), One("alone", is_alone=True)]
        seen, built = [], set()
        schedule = Schedule(["release", "asan"], suites, 2)
        for _, running in played(schedule):
            seen += [name for name in running if name not in seen]
        self.assertEqual(sorted(seen), ["a", "alone", "b", "c", "d"])
        self.assertLess(seen.index("d"), seen.index("a"))

    def test_next_build_goes_on_while_suites_of_the_last_run(self):
        moments = played(Schedule(["release", "asan"], [One("a"), One("b"), One("c", "asan")], 2))
        self.assertIn(("asan", ["a", "b"]), moments)

    def test_no_more_than_so_many_at_once(self):
        moments = played(Schedule(["release"], [One(str(i)) for i in range(9)], 2))
        self.assertEqual(max(len(running) for _, running in moments), 2)

    def test_who_wants_no_company_has_none_not_even_a_build(self):
        suites = [One("x", is_alone=True), One("y", is_alone=True), One("a"), One("b", "asan")]
        for building, running in played(Schedule(["release", "asan"], suites, 2)):
            if "x" in running or "y" in running:
                self.assertEqual((building, len(running)), (None, 1))

    def test_builds_alone_are_built(self):
        self.assertEqual([b for b, _ in played(Schedule(["release", "asan"], [], 2))], ["release", "asan"])

    def test_long_ones_come_first_and_nobody_is_lost(self):
        suites = [One("a"), One("b"), One("c")]
        self.assertEqual([s.name for s in longest_first(suites, ["c", "a", "none"])], ["c", "a", "b"])

    def test_names_of_the_table_are_those_of_suites(self):
        names = {s.name for s in all_suites()}
        self.assertEqual([n for n in LONGEST_FIRST if n not in names], [])
        self.assertEqual([n for n in ALONE if n not in names], [])
        self.assertEqual(len(names), len(all_suites()))


class Counts(unittest.TestCase):
    def test_each_kind_of_program_is_read(self):
        self.assertEqual(counts("[doctest] test cases:  5 |  4 passed | 1 failed | 2 skipped\n", 1), (4, 1, 2))
        self.assertEqual(counts("[  PASSED  ] 7 test(s).\n[  SKIPPED ] 1 test(s)\n", 0), (7, 0, 1))
        self.assertEqual(counts("3 passed, 0 failed, 1 skipped\n", 0), (3, 0, 1))

    def test_bad_end_or_a_run_of_nothing_is_a_failure(self):
        self.assertEqual(counts("3 passed, 0 failed, 0 skipped\n", -11), (3, 1, 0))
        self.assertEqual(counts("", 0), (0, 1, 0))
        self.assertEqual(counts("skipped: no network\n", 77), (0, 0, 1))


if __name__ == "__main__":
    result = unittest.main(argv=sys.argv[:1], exit=False, verbosity=2).result
    bad = len(result.failures) + len(result.errors)
    print("%d passed, %d failed, 0 skipped" % (result.testsRun - bad, bad))
    sys.exit(1 if bad else 0)

#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The Jalon authors
# SPDX-License-Identifier: Apache-2.0
"""What the benchmarks make of times and lines, on times and lines that are given: nothing is measured here."""

import sys
import unittest

from promised import Promise, judged
from verdicts import ABSENT, PEERS, absent, summary, verdict


def row(times, operation="planes", wanted=None):
    return verdict(operation, times, times, wanted)


class Verdicts(unittest.TestCase):
    def test_ratio_is_the_median_of_the_rounds_to_the_fastest_peer(self):
        got = row({"Jalon": [1.0, 1.0, 2.0], "PCL": [3.0, 5.0, 4.0]}, "region_growing")
        self.assertEqual((got["best"], got["ratio"], got["lowest"], got["highest"]), ("PCL", 3.0, 2.0, 5.0))
        self.assertEqual(got["mark"], "GOAL")

    def test_marks_follow_gate_and_goal(self):
        for peer_s, mark in ((2.2, "GOAL"), (1.0, "PASS"), (0.99, "FAIL")):
            self.assertEqual(row({"Jalon": [1.0], "CGAL": [peer_s]})["mark"], mark)
        las = {"LASzip-all": [9.0], "Jalon": [1.0]}
        self.assertEqual(row(dict(las, LASzip=[0.7]), "las0")["mark"], "PASS")

    def test_row_that_lost_its_only_peer_is_told(self):
        got = row({"Jalon": [1.0]})
        self.assertEqual((got["mark"], got["absent"]), (ABSENT, ["CGAL"]))

    def test_row_that_lost_one_of_its_peers_is_told_whatever_the_others_say(self):
        got = row({"Jalon": [1.0], "CGAL": [9.0]}, "c2m_1m")
        self.assertEqual((got["mark"], got["absent"], got["best"]), (ABSENT, ["Open3D"], "CGAL"))

    def test_row_without_jalon_is_told(self):
        self.assertEqual(row({"CGAL": [1.0]})["absent"], ["Jalon"])

    def test_row_that_nobody_measured_is_told(self):
        self.assertEqual(row({})["absent"], ["Jalon", "CGAL"])

    def test_operation_that_no_peer_does_has_no_mark(self):
        self.assertNotIn("mark", row({"Jalon": [1.0]}, "outlines"))

    def test_peers_that_were_not_asked_for_are_not_missed(self):
        times = {"Jalon": [1.0], "CGAL": [9.0]}
        self.assertEqual(row(times, "c2m_1m", ["CGAL"])["mark"], "GOAL")
        self.assertEqual(absent("c2m_1m", times, ["Open3D"]), ["Open3D"])

    def test_every_peer_present_misses_nobody(self):
        for operation, peers in PEERS.items():
            self.assertEqual(absent(operation, dict.fromkeys(["Jalon"] + peers, [1.0])), [])

    def test_run_without_a_peer_is_not_good(self):
        self.assertTrue(summary(["GOAL", "PASS", None], 0)[1])
        for marks, differing in ((["GOAL", ABSENT], 0), (["FAIL"], 0), (["GOAL"], 1)):
            self.assertFalse(summary(marks, differing)[1])
        self.assertIn("1 without a peer", summary([ABSENT], 0)[0])


class Promises(unittest.TestCase):
    AT_LEAST = Promise("x", [], r"in all: ([\d.]+) x", at_least=30)
    AT_MOST = Promise("x", [], r"p99 ([\d.]+) ms", at_most=100)

    def test_every_line_that_matches_is_judged(self):
        text = "FIGURE T4 in all: 30.0 x faster\nother\nFIGURE T5 in all: 29.9 x faster\n"
        self.assertEqual([good for good, _ in judged(self.AT_LEAST, text)], [True, False])
        self.assertEqual([good for good, _ in judged(self.AT_MOST, "FIGURE p99 100.0 ms\nFIGURE p99 100.1 ms")], [True, False])

    def test_line_that_does_not_come_is_a_failure(self):
        self.assertEqual([good for good, _ in judged(self.AT_LEAST, "nothing of the kind\n")], [False])


if __name__ == "__main__":
    result = unittest.main(argv=sys.argv[:1], exit=False, verbosity=2).result
    bad = len(result.failures) + len(result.errors)
    print("%d passed, %d failed, 0 skipped" % (result.testsRun - bad, bad))
    sys.exit(1 if bad else 0)

# SPDX-FileCopyrightText: 2026 The Jalon authors
# SPDX-License-Identifier: Apache-2.0
import math
import os
import tempfile
import unittest

import numpy as np

import jalon

NAILS = "id x y z sx sy sz\nA 652000 6861000 40 0 0 0\nB 652000 6861050 40 0 0 0\n"
# C stands at 30, 40, 2 from A: 50 m away in plan; the marks of A and B are 1.5 m below instrument and prism.
PLACE = np.array([652030.0, 6861040.0, 42.0])


def gon(angle):
    return angle * 200 / math.pi % 400


def sights(code="350"):
    lines = ["from;to;direction;zenith;distance;instrument_height;target_height;code"]
    marks = {"A": np.array([652000.0, 6861000, 40]), "B": np.array([652000.0, 6861050, 40]), "C": PLACE}
    for start, end in (("A", "B"), ("A", "C"), ("B", "A"), ("B", "C")):
        d = marks[end] - marks[start]
        level = math.hypot(d[0], d[1])
        lines.append("%s;%s;%.5f;%.5f;%.4f;1.5;1.5;%s" % (
            start, end, gon(math.atan2(d[0], d[1]) - 0.3), gon(math.atan2(level, d[2])), math.hypot(level, d[2]),
            code if end == "C" else ""))
    return "\n".join(lines) + "\n"


class Networks(unittest.TestCase):
    def python__a_network_gives_coded_points_with_their_sigmas(self):
        network = jalon.Network.adjust(sights(), NAILS, refraction=1)
        summary = network.summary
        self.assertEqual((summary["converged"], summary["points"], summary["outliers"]), (1, 3, 0))
        points = network.points
        np.testing.assert_allclose(points["xyz"][2], PLACE, atol=1e-3)
        np.testing.assert_allclose(np.sqrt(np.diag(points["covariance"][2].reshape(3, 3))), points["sigma"][2])
        self.assertTrue(0 < points["ellipse_minor"][2] <= points["ellipse_major"][2] < 0.01)
        self.assertEqual([network.point_name(i) for i in range(3)], ["A", "B", "C"])
        self.assertTrue(network.codes.startswith("C;652030.0"))
        self.assertIn('"sigma_centring_m"', network.parameters)
        kinds = network.observations["kind"]
        self.assertEqual([(kinds == k).sum() for k in (1, 2, 3, 7, 8)], [4, 4, 4, 4, 2])

    def python__a_network_is_reported_as_a_page_and_as_its_plan(self):
        network = jalon.Network.adjust(sights(), NAILS, refraction=1)
        with tempfile.TemporaryDirectory() as folder:
            for name, start in (("network.html", "<!DOCTYPE html"), ("plan.svg", "<svg")):
                path = os.path.join(folder, name)
                jalon.report_write_network(network, path)
                with open(path, encoding="utf-8") as file:
                    self.assertIn(start, file.read(400))

    def python__its_codes_guide_a_segmentation(self):
        network = jalon.Network.adjust(sights("360"), NAILS, refraction=1)
        cloud = jalon.Cloud(PLACE + np.random.default_rng(1).uniform(-5, 5, (1000, 3)))
        segmentation = jalon.Segmenter("survey_codes", codes=network.codes).run(cloud)
        self.assertIn("window", segmentation.notes)

    def python__a_blunder_is_named_by_its_line(self):
        wrong = sights().replace("50.0000", "50.5000", 1)  # from A to B, both fixed
        network = jalon.Network.adjust(wrong, NAILS, refraction=1)
        observations = network.observations
        worst = np.argmax(np.abs(observations["normalised"]))
        self.assertEqual(observations["line"][worst], 2)
        self.assertEqual(observations["outlier"][worst], 1)

    def python__what_is_wrong_is_told_by_its_line(self):
        with self.assertRaisesRegex(jalon.FormatError, "observations, line 2"):
            jalon.Network.adjust("from to distance\nA B long\n", NAILS)
        with self.assertRaisesRegex(ValueError, "nothing holds"):
            jalon.Network.adjust(sights(), "")


if __name__ == "__main__":
    unittest.main()

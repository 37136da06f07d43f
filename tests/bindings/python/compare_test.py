# SPDX-FileCopyrightText: 2026 The Jalon authors
# SPDX-License-Identifier: Apache-2.0
"""Comparisons of two epochs: distances, regions, diagnosis, visibility, reports."""

import os
import tempfile
import unittest

import numpy as np

import jalon
from clouds_test import grid
from scenes import box_cloud, box_model


def heap(points, height=1.0):
    """The ground with a heap of 1 x 1 m on it."""
    made = points.copy()
    made[(np.abs(made[:, :2] - 3) < 0.5).all(1), 2] += height
    return made


def scan_from(x, y, seed):
    scanner = jalon.Scanner("static", horizontal_step_rad=0.01, vertical_step_rad=0.01, seed=seed)
    scanner.add_station(np.array([[1.0, 0, 0, x], [0, 1, 0, y], [0, 0, 1, 1.7], [0, 0, 0, 1]]), "S")
    return scanner.run(box_model())


class Compare(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.before = jalon.Cloud(grid(80, 80, 0.1))
        cls.after = jalon.Cloud(heap(grid(80, 80, 0.1)))
        cls.comparer = jalon.Comparer("distance", max_distance_m=3)
        cls.forward, cls.reverse = cls.comparer.run(cls.before, cls.after), cls.comparer.run(cls.after, cls.before)
        cls.work = tempfile.TemporaryDirectory()

    @classmethod
    def tearDownClass(cls):
        cls.work.cleanup()

    def at(self, name):
        return os.path.join(self.work.name, name)

    def python__distances_and_their_summary_agree(self):
        self.assertEqual(len(self.forward), 6400)
        self.assertEqual(repr(self.forward), "<jalon.Comparison of 6400 points>")
        self.assertAlmostEqual(self.forward.distances.max(), 1)
        summary = self.forward.summary
        self.assertEqual((summary.points, summary.compared), (6400, 6400))
        self.assertAlmostEqual(summary.maximum, 1)
        self.assertEqual(self.forward.points[0].status, jalon.PointStatus.COMPARED)
        self.assertTrue(np.array_equal(self.forward.cloud["distance"], self.forward.distances))
        self.assertIn("max_distance_m", self.forward.parameters)
        closest = self.forward.closest_points(self.before)
        self.assertEqual(len(closest), len(np.unique(self.forward.points["nearest"])))

    def python__clouds_that_lie_apart_are_told(self):
        self.assertEqual(self.before.overlap(self.after).apart, 0)
        swapped = self.before.overlap(jalon.Cloud(self.before.points[:, [2, 1, 0]] + [500, 0, 0]))
        self.assertEqual(swapped.apart, 1)
        self.assertGreater(swapped.gap, 400)

    def python__regions_changes_and_outlines_follow(self):
        points, regions = self.forward.regions(criterion="threshold", threshold_m=0.3, min_points=20)
        self.assertEqual([type(region) for region in regions], [jalon.Region])
        self.assertEqual(regions[0].points, int((points["region"] == 1).sum()))
        outlines = self.forward.outlines(points)
        self.assertEqual([part.name for part in outlines], ["changes", "region 1"])
        self.assertEqual(len(outlines.__geo_interface__["features"]), 1)
        found = self.forward.diagnose(self.reverse, criterion="threshold", threshold_m=0.3, min_points=20)
        self.assertGreaterEqual(len(found.changes), 1)
        self.assertIsInstance(found.changes[0].class_, jalon.Change)
        both = self.forward.outlines(found.forward, self.reverse, found.reverse, found.changes)
        self.assertGreaterEqual(len(both.faces), 1)

    def python__a_landslide_is_told_with_its_sigma_and_what_was_not_measured(self):
        random = np.random.default_rng(5)
        before, after = (random.uniform((0, 0, 0), (30, 30, 0), (40000, 3)) for _ in range(2))
        for points in (before, after):
            points[:, 2] = 0.4 * points[:, 1] + random.normal(0, 0.01, len(points))
        went = (np.abs(after[:, 0] - 15) < 5) & (np.abs(after[:, 1] - 15) < 5)
        after[went, 2] -= 0.5
        after = after[(after[:, 0] < 25) | (after[:, 1] > 5)]  # a corner that was not scanned again
        slide = jalon.Comparer("landslide", cell_m=1).run(jalon.Cloud(before), jalon.Cloud(after))
        self.assertLess(abs(slide.summary.depletion - 50), 4 * slide.summary.depletion_sigma)
        self.assertEqual(slide.summary.accumulation, 0)
        self.assertAlmostEqual(slide.summary.unmeasured_compared, 25, delta=3)
        points, regions = slide.regions()
        self.assertLess(regions[0].mean, 0)
        self.assertGreater(regions[0].volume_sigma, 0)
        names = [part.name for part in slide.outlines(points)]
        self.assertIn("not measured in the compared epoch", names)

    def python__volumes_of_heaps_are_told(self):
        self.assertAlmostEqual(self.before.volume(self.after, cell_m=0.1).summary.fill, 0.01 * (self.after.points[:, 2] > 0).sum(), places=6)

    def python__a_cloud_is_compared_with_a_model_part_by_part(self):
        lifted = jalon.Cloud(box_cloud().points + [0, 0, 0.02])
        comparison = self.comparer.run_model(box_model(), lifted)
        self.assertLess(abs(comparison.distances).max(), 0.02 + 0.05)  # the shift, and the scan's noise
        self.assertEqual(int(comparison.parts["points"].sum()), len(lifted))

    def python__m3c2_takes_files_cores_and_registrations(self):
        comparer = jalon.Comparer("m3c2")
        with open(self.at("m3c2.txt"), "w") as f:
            f.write("[General]\nM3C2VER=1\nNormalScale=0.8\nSearchScale=0.6\nSearchDepth=2\n")
        comparer.read_m3c2_file(self.at("m3c2.txt"))
        self.assertEqual((comparer.normal_radius_m, comparer.max_depth_m), (0.4, 2))
        core = jalon.Cloud([(3, 3, 0), (6, 6, 0)])
        comparison = comparer.run_core(self.before, self.after, core)
        self.assertTrue(np.allclose(np.abs(comparison.distances), [1, 0], atol=1e-6))
        registration = jalon.Registrar("targets", sigma_m=0.002, sigma0="known").run_targets(
            *[[(str(i), p) for i, p in enumerate(((0, 0, 0), (9, 0, 0), (0, 7, 1), (5, 5, 5)))]] * 2)
        comparer.use_registration(registration)
        self.assertEqual(len(comparer.registration_covariance), 36)
        self.assertTrue(any(comparer.registration_covariance))

    def python__what_a_scanner_saw_is_told(self):
        reference, later = scan_from(-15, -15, 1), scan_from(15, 15, 2)
        depth = reference.depth_map(0)
        self.assertEqual(len(depth.fields), depth.rows * depth.columns)
        reference.write_depth_map(0, self.at("depth.png"))
        with open(self.at("depth.png"), "rb") as f:
            self.assertEqual(f.read(4), b"\x89PNG")
        later.compute_visibility(reference)
        labels = set(np.unique(later["visibility"]).tolist())
        self.assertTrue({jalon.VISIBLE, jalon.HIDDEN} <= labels)
        comparer = jalon.Comparer("distance", visibility="stations")
        hidden, across = comparer.run(reference, later), jalon.Comparer("distance").run(box_cloud(), later)
        third = hidden.third_epoch(across, 0.5)
        self.assertIn(jalon.PROBABLY_UNCHANGED, third.points["recovered"].tolist())

    def python__reports_on_comparisons_are_written(self):
        regions = self.forward.regions(criterion="threshold", threshold_m=0.3, min_points=20).regions
        for name, write in (("a.png", lambda p: jalon.report_write_deviations(self.forward, p)),
                            ("b.svg", lambda p: jalon.report_write_histogram(self.forward, p)),
                            ("c.html", lambda p: jalon.report_write_comparison(self.forward, p, self.reverse, regions))):
            write(self.at(name))
            with open(self.at(name), "rb") as f:
                self.assertRegex(f.read(200), b"PNG|<svg|<!DOCTYPE html|<html")

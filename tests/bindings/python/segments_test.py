# SPDX-FileCopyrightText: 2026 The Jalon authors
# SPDX-License-Identifier: Apache-2.0
"""Segmentations: picks, labels, evaluation, precision, and the reports on them."""

import json
import os
import tempfile
import unittest

import numpy as np

import jalon
from clouds_test import grid
from scenes import box_cloud, box_model


class Segments(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.segmentation = jalon.Segmenter(distance_tolerance_m=0.02).run(box_cloud())
        cls.work = tempfile.TemporaryDirectory()

    @classmethod
    def tearDownClass(cls):
        cls.work.cleanup()

    def written(self, name, write):
        """The content of a file that was written by write(path)."""
        path = os.path.join(self.work.name, name)
        write(path)
        with open(path, "rb") as f:
            return f.read()

    def python__a_plane_is_picked_and_the_rest_remains(self):
        floor, wall = grid(40, 40, 0.05), grid(40, 40, 0.05)[:, [0, 2, 1]] + [0, 0, 0.05]
        cloud = jalon.Cloud(np.vstack([floor, wall]))
        start = jalon.Segmentation.start(cloud)
        self.assertEqual(len(start), 0)
        picked = start.pick(jalon.Primitive.PLANE, [(1, 1, 0)], tolerance_m=0.01, gap_m=0.2)
        self.assertEqual((len(picked), len(start)), (1, 0))
        self.assertAlmostEqual(abs(picked[0].normal[2]), 1, places=6)
        remaining = picked.remaining()
        self.assertEqual(len(remaining) + picked[0].inliers, 3200)
        text = self.written("primitives.txt", picked.write_primitives).decode()
        self.assertEqual([float(n) for n in text.split()][0], 1)
        labelled = picked.cloud
        self.assertEqual(int((labelled["label"] == 1).sum()), picked[0].inliers)

    def python__residuals_follow_a_normal_law(self):
        bins, normal = self.segmentation.residuals(0, 20)
        self.assertEqual((len(bins), int(bins["count"].sum()) + normal.below + normal.above), (20, normal.count))
        self.assertEqual(self.segmentation.to_dict()["segments"]["label"][0], 1)
        self.assertEqual(self.segmentation.facade_frame.shape, (4, 4))
        self.assertEqual(self.segmentation.facade_frame[3].tolist(), [0, 0, 0, 1])

    def python__long_edges_have_a_curve_and_contour_points(self):
        lengths, points, summary = self.segmentation.long_edges(1)
        self.assertTrue((np.diff(lengths["length"]) >= 0).all())
        self.assertEqual(summary.longer, (lengths["length"] > summary.threshold).sum())
        self.assertEqual(summary.points, len(points))
        self.assertTrue((self.segmentation.cloud["label"][points["point"]] == 1).all())
        self.assertEqual(self.segmentation.long_edges(1, threshold_m=0.5)[2].threshold, 0.5)

    def python__labels_of_the_truth_evaluate_a_segmentation(self):
        truth = jalon.Segmentation.from_labels(box_cloud(), "segment")
        evaluation = self.segmentation.evaluate(truth)
        self.assertEqual(evaluation.totals.pairs, len(evaluation.pairs))
        self.assertGreater(evaluation.pairs["iou"].min(), 0.95)
        self.assertEqual(len(evaluation.automatic), len(self.segmentation))
        self.assertEqual(len(evaluation.reference), len(truth))
        labelled = self.segmentation.cloud
        labelled["truth"] = labelled["label"]
        classes, totals = labelled.confusion("label", "truth")
        self.assertEqual((totals.points, totals.accuracy), (len(labelled), 1))
        self.assertEqual(len(classes), len(np.unique(labelled["label"])))
        true = jalon.Scanner("sample").truth(box_model(), box_cloud())
        self.assertEqual(int(true["count"].sum()), int((box_cloud()["segment"] > 0).sum()))

    def python__models_are_evaluated(self):
        evaluation = box_model().evaluate(box_model())
        self.assertEqual(len(evaluation.pairs), len(evaluation.automatic))
        self.assertEqual(len(evaluation.reference), len(evaluation.automatic))
        self.assertEqual(evaluation.totals.max_distance, 0)
        self.assertGreater(len(evaluation.vertices), 0)

    def python__indices_of_areas_polygons_and_vertices_are_computed(self):
        rows, totals = jalon.area_indices([2, 4], [4, 4], [2, 4])
        self.assertEqual((len(rows), rows["area_automatic"].tolist()), (2, [2, 4]))
        self.assertEqual(totals.area_automatic, 6)
        square = [(0, 0), (2, 0), (2, 2), (0, 2)]
        half = [(0, 0), (1, 0), (1, 2), (0, 2)]
        indices = jalon.polygon_indices(half, [4], square, [4])
        self.assertAlmostEqual(indices.intersection, 2)
        rows, totals = jalon.vertex_deviations([(0, 0, 0), (1, 0, 0)], [(0, 0, 0), (1, 0, 3)])
        self.assertEqual((totals.vertices, totals.max_distance), (2, 3))
        self.assertEqual(rows["distance"].tolist(), [0, 3])

    def python__precision_is_told_before_and_after(self):
        budget = jalon.precision_budget([10, 100], vertical_rad=0.1, sigma_range_m=0.004)
        self.assertEqual(len(budget), 2)
        self.assertGreater(budget["point"][1], budget["point"][0])
        self.assertEqual(jalon.precision_budget(10).to_dict()["range"], jalon.precision_budget([10]).to_dict()["range"])
        constant = jalon.baseline_constant([10.003, 20.003, 30.003], [10, 20, 30])
        self.assertAlmostEqual(constant.constant, 0.003)
        angles = jalon.angular_precision([1.001, 0.999], [1, 1], [10, 10])
        self.assertAlmostEqual(angles.rms, 1e-4)
        self.assertAlmostEqual(jalon.phase_range([1.0, 10.0], [0.25, 3.25]), 1.625)
        flat = jalon.Cloud(grid(30, 30) + np.c_[np.zeros((900, 2)), np.random.default_rng(1).normal(0, 0.004, 900)])
        self.assertAlmostEqual(flat.range_precision().sigma, 0.004, delta=5e-4)

    def python__planes_are_adjusted_with_what_the_scanner_is_worth(self):
        scanner = jalon.Scanner("static", horizontal_step_rad=0.01, vertical_step_rad=0.01, seed=2)
        scanner.add_station(np.array([[1.0, 0, 0, -15], [0, 1, 0, -15], [0, 0, 1, 1.7], [0, 0, 0, 1]]), "S1")
        cloud = scanner.run(box_model())
        self.assertEqual(cloud.stations[0].name, "S1")
        cloud.compute_covariances()
        self.assertEqual(cloud["covariance"].shape, (len(cloud), 6))
        segmentation = jalon.Segmenter().run(cloud)
        planes = segmentation.plane_covariances()
        self.assertEqual(len(planes), len(segmentation))
        self.assertTrue((planes["sigma_prior"] > 0).all())

    def python__reports_are_written(self):
        model = jalon.Modeller("outlines").run(box_cloud(), self.segmentation)
        self.assertTrue(self.written("picture.png", lambda p: jalon.report_write_picture(self.segmentation, p)).startswith(b"\x89PNG"))
        image = self.written("ortho.tif", lambda p: jalon.report_write_orthoimage(self.segmentation, model, p, content="distance"))
        self.assertTrue(image.startswith(b"II*\0"))
        page = self.written("page.html", lambda p: jalon.report_write_html(self.segmentation, p, model, '{"title": "a <box>"}')).decode()
        self.assertIn("a &lt;box&gt;", page)
        told = json.loads(self.written("page.json", lambda p: jalon.report_write_json(self.segmentation, p)))
        self.assertTrue(told)

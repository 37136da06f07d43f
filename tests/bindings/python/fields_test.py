# SPDX-FileCopyrightText: 2026 The Jalon authors
# SPDX-License-Identifier: Apache-2.0
"""What is done with a field of a cloud: laws, histograms, filters, fronts, maps of distances."""

import unittest

import numpy as np

import jalon
from clouds_test import grid


class Fields(unittest.TestCase):
    def setUp(self):
        self.cloud = jalon.Cloud(grid(60, 60, 0.1))
        rng = np.random.default_rng(4)
        self.noise = rng.normal(0, 0.003, 3600)
        self.cloud["error"] = self.noise
        self.cloud["wear"] = self.noise + np.where(self.cloud.points[:, 0] > 4, 0.05, 0)

    def python__a_noise_law_is_fitted_kept_and_used(self):
        law = jalon.NoiseLaw.fit(self.cloud, "error", law="gauss")
        self.assertAlmostEqual(law.table["scale"], self.noise.std(), places=5)
        self.assertEqual(law.table.samples, 3600)
        again = jalon.NoiseLaw.from_json(law.json)
        self.assertEqual(again.json, law.json)
        found = law.evaluate([law.table.mean])
        self.assertAlmostEqual(float(found.cumulative[0]), 0.5)
        self.assertAlmostEqual(found.density[0] * law.table.scale * np.sqrt(2 * np.pi), 1)
        median, high = law.quantiles([0.5, 0.975])
        self.assertAlmostEqual((high - median) / law.table.scale, 1.96, places=2)
        self.assertEqual(law.quantiles(0.5).tolist(), [median])
        histogram = self.cloud.field_histogram("error", law, bins=20)
        self.assertEqual(int(histogram.bins["count"].sum()), 3600)
        self.assertGreater(histogram.summary.p_value, 1e-4)
        tested = self.cloud.compute_chi_square("wear", law, neighbours=16, error_margin=1e-4)
        self.assertEqual(tested["tested"], 3600)
        changed = self.cloud["changed"] != 0
        self.assertGreater(changed[self.cloud.points[:, 0] > 4.3].mean(), 0.99)
        self.assertLess(changed[self.cloud.points[:, 0] < 3.7].mean(), 0.02)

    def python__values_are_grouped(self):
        summary = self.cloud.classify_field("wear")
        self.assertGreater(summary["low_cut"], 0.01)
        self.assertEqual(summary["count_1"], int((self.cloud.points[:, 0] > 4).sum()))
        self.assertTrue(np.array_equal(self.cloud["class"] == 1, self.cloud.points[:, 0] > 4))

    def python__fields_are_filtered_and_computed(self):
        self.cloud["height"] = self.cloud.points[:, 0] * 0.25
        self.cloud.compute_gradient("height", method="least_squares", radius_m=0.25)
        self.assertTrue(np.allclose(self.cloud["gradient"], 0.25, atol=1e-4))
        self.cloud.filter_field("error", method="mean", radius_m=0.5)
        self.assertLess(np.std(self.cloud["filtered"]), 0.4 * self.noise.std())
        self.cloud.compute_field("height", "error", operation="add", name="sum")
        self.assertTrue(np.allclose(self.cloud["sum"], self.cloud["height"] + self.noise))
        self.cloud.compute_field("height", operation="multiply", constant=4)
        self.assertTrue(np.allclose(self.cloud["computed"], self.cloud.points[:, 0]))

    def python__fronts_run_along_surfaces(self):
        self.cloud.compute_geodesic([0], cell_m=0.2)
        straight = np.linalg.norm(self.cloud.points, axis=1)
        far = straight > 2
        self.assertLess(np.abs(self.cloud["geodesic"][far] / straight[far] - 1).max(), 0.05)
        self.cloud.compute_gradient("wear", radius_m=0.25)
        regions = self.cloud.segment_propagation("wear", "gradient", cell_m=0.1, minimum_seed=0.03, min_points=20)
        self.assertGreaterEqual(len(regions), 1)
        self.assertIs(type(regions[0]), jalon.Record)
        self.assertEqual(regions[0].points, int((self.cloud["region"] == 1).sum()))

    def python__maps_of_distances_are_within_a_cell(self):
        above = jalon.Cloud(self.cloud.points + [0, 0, 1])
        above.compute_map_distance(self.cloud, method="fast_marching", cell_m=0.1)
        self.assertLess(np.nanmax(np.abs(above["map_distance"] - 1)), 0.11)
        cells = self.cloud.distance_map(cell_m=0.1, max_distance_m=0.5)
        self.assertGreater(len(cells), 3600)
        self.assertLessEqual(np.nanmax(cells["map_distance"]), 0.61)

    def python__one_number_stands_for_all_values(self):
        for value, dtype in ((3, np.int64), (0.5, np.float64), (True, np.uint8), (np.float32(2), np.float32), (np.uint16(7), np.uint16),
                             (2 ** 63 + 1, np.uint64), (np.True_, np.uint8)):
            self.cloud["same"] = value
            self.assertEqual((self.cloud["same"].dtype, self.cloud["same"].shape), (dtype, (3600,)))
            self.assertTrue((self.cloud["same"] == value).all())
        for wrong in ("3", None, 1j):
            with self.assertRaisesRegex(TypeError, "^data: "):
                self.cloud["same"] = wrong

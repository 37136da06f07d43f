# SPDX-FileCopyrightText: 2026 The Jalon authors
# SPDX-License-Identifier: Apache-2.0
"""Masks choose points; truth values are never taken for numbers."""

import array
import subprocess
import sys
import unittest

import numpy as np

import jalon


class Masks(unittest.TestCase):
    def setUp(self):
        self.xyz = np.random.default_rng(3).random((1000, 3)) * 10
        self.cloud = jalon.Cloud(self.xyz)
        self.mask = self.xyz[:, 2] > 5

    def forms(self):
        """The same mask in all forms that a user may have."""
        wide = np.zeros((1000, 3), bool)
        wide[:, 1] = self.mask
        return (self.mask, self.mask.tolist(), tuple(self.mask), memoryview(self.mask), wide[:, 1], self.mask[::-1][::-1],
                wide.T[1], [np.bool_(b) for b in self.mask])

    def python__a_mask_selects_the_points_where_it_is_true(self):
        wanted = self.xyz[self.mask]
        self.assertGreater(len(wanted), 2)
        for mask in self.forms():
            self.assertTrue(np.array_equal(self.cloud.select(mask).points, wanted))
            if not isinstance(mask, tuple):  # of two dimensions, for NumPy's ears
                self.assertTrue(np.array_equal(self.cloud[mask].points, wanted))
        self.assertEqual(len(self.cloud.select(np.zeros(1000, bool))), 0)
        self.assertTrue(np.array_equal(self.cloud.select(np.ones(1000, bool)).points, self.xyz))

    def python__a_mask_must_have_one_truth_value_a_point(self):
        for wrong in (np.ones(999, bool), np.ones(1001, bool), [True, False], np.ones((1000, 1), bool), np.zeros(0, bool)):
            with self.assertRaisesRegex(ValueError, "indices.*mask.*1000"):
                self.cloud.select(wrong)

    def python__truth_values_and_indices_do_not_mix(self):
        for mixed in ([True, 2], [0, False], [np.True_, 5]):
            with self.assertRaisesRegex(TypeError, "indices.*mask"):
                self.cloud.select(mixed)

    def python__masks_do_wherever_indices_of_points_do(self):
        sphere = np.random.default_rng(1).normal(size=(500, 3))
        sphere /= np.linalg.norm(sphere, axis=1)[:, None]
        both = jalon.Cloud(np.vstack([self.xyz + 100, sphere]))
        mask = np.arange(1500) >= 1000
        chosen = np.flatnonzero(mask)
        self.assertAlmostEqual(both.fit_sphere(mask)["radius"], 1, places=9)
        self.assertEqual(repr(both.fit_sphere(mask).to_dict()), repr(both.fit_sphere(chosen).to_dict()))
        ring = jalon.Cloud(np.c_[np.cos(np.arange(60.0)), np.sin(np.arange(60.0)), np.arange(60) % 3.0])
        half = np.arange(60) < 30
        self.assertEqual(repr(ring.fit_cylinder(half, (0, 0, 1)).to_dict()), repr(ring.fit_cylinder(range(30), (0, 0, 1)).to_dict()))
        flat = jalon.Cloud(ring.points * [1, 1, 0])
        self.assertEqual(repr(flat.fit_circle(half).to_dict()), repr(flat.fit_circle(np.arange(30)).to_dict()))
        grid = jalon.Cloud(np.stack(np.meshgrid(np.arange(30.0), np.arange(30.0), [0.0]), -1).reshape(-1, 3))
        seeds = np.arange(900) < 30
        distances = []
        for form in (seeds, np.arange(30)):
            grid.compute_geodesic(form, cell_m=1)
            distances.append(grid["geodesic"].copy())
        self.assertTrue(np.array_equal(*distances, equal_nan=True))
        for name in ("fit_sphere", "fit_circle", "compute_geodesic", "range_precision"):
            with self.assertRaisesRegex(ValueError, "a mask has one truth value a point, 900 and not 3"):
                getattr(grid, name)([True, False, True])

    def python__indices_do_not_count_from_the_end(self):
        with self.assertRaisesRegex(ValueError, r"^indices must hold whole numbers from 0 to 2\^64 - 1, not -1$"):
            self.cloud.select([3, -1])

    def python__an_empty_choice_of_points_is_not_all_of_them(self):
        calls = {"fit_sphere": (), "fit_circle": (), "fit_cylinder": ((0, 0, 1),), "range_precision": ()}
        for name, more in calls.items():
            for none in (np.zeros(1000, bool), [False] * 1000, [], (), np.array([], int), self.mask & ~self.mask, range(0)):
                with self.assertRaisesRegex(jalon.InsufficientDataError, "^indices means no point: where all points are meant, leave it out$"):
                    getattr(self.cloud, name)(none, *more)
        for none in (np.zeros(1000, bool), []):
            with self.assertRaises(jalon.InsufficientDataError):
                self.cloud.compute_geodesic(none)
            self.assertEqual(len(self.cloud.select(none)), 0)
        self.assertEqual(self.cloud.range_precision().points, 1000)
        self.assertEqual(self.cloud.range_precision(None).points, 1000)
        self.assertEqual(self.cloud.range_precision(self.mask).points, self.mask.sum())

    def python__a_mask_becomes_a_field_of_zeros_and_ones(self):
        for mask in self.forms():
            self.cloud["high"] = mask
            self.assertEqual(self.cloud["high"].dtype, np.uint8)
            self.assertTrue(np.array_equal(self.cloud["high"] != 0, self.mask))
        self.assertTrue(np.array_equal(self.cloud[self.cloud["high"] != 0].points, self.xyz[self.mask]))
        with self.assertRaisesRegex(ValueError, "999"):
            self.cloud["high"] = self.mask[:999]
        builder = jalon.CloudBuilder()
        builder.declare_field("high", jalon.UINT8)
        builder.append_points(self.xyz)
        builder.append_field("high", self.mask)
        self.assertTrue(np.array_equal(builder.seal()["high"] != 0, self.mask))

    def python__truth_values_are_no_numbers(self):
        three = np.ones((10, 3), bool)
        for call, name in ((lambda: jalon.Cloud(three), "xyz"), (lambda: jalon.Cloud([(True, 0, 1)]), "xyz"),
                           (lambda: jalon.Cloud.create_columns(three[:, 0], three[:, 1], three[:, 2]), "x"),
                           (lambda: self.cloud.knn(three, 2), "queries"), (lambda: self.cloud.radius_search(three, 1), "queries"),
                           (lambda: self.cloud.transform(np.eye(4) > 0), "transform"), (lambda: self.cloud.crop_box(three[:2]), "box"),
                           (lambda: self.cloud.crop_polygon(three[:, :2], 0, 1), "polygon_uv"),
                           (lambda: self.cloud.crop_cylinder([True] * 3, (0, 0, 1), 1), "foot"),
                           (lambda: jalon.Model.create_mesh(self.xyz[:3], [(True, False, True)]), "triangles"),
                           (lambda: jalon.Model.create_mesh(self.xyz[:3], [(0, 1, 2)], np.ones(1, bool)), "face_ids"),
                           (lambda: jalon.phase_range(three[:2, 0], [0.1, 0.2]), "wavelengths_m"),
                           (lambda: jalon.area_indices([True], [1], [1]), "automatic_m2"),
                           (lambda: jalon.Targets([("A", three[0])]), "xyz"), (lambda: jalon.Gauge().add_box(three[0]), "size")):
            with self.assertRaisesRegex(TypeError, "^%s: " % name):
                call()

    def python__masks_work_without_numpy(self):
        code = ("import sys; sys.modules['numpy'] = None\n"
                "import array, jalon\n"
                "cloud = jalon.Cloud([(0, 0, 0), (1, 2, 3), (4, 5, 6)])\n"
                "for mask in ([False, True, True], memoryview(bytes([0, 1, 1])).cast('?')):\n"
                "    assert cloud.select(mask).points.tolist() == [[1, 2, 3], [4, 5, 6]]\n"
                "    assert cloud[mask][0].xyz == (1, 2, 3)\n"
                "    cloud['late'] = mask\n"
                "    assert cloud['late'].tolist() == [0, 1, 1]\n"
                "for wrong in ([True], memoryview(bytes(2)).cast('?')):\n"
                "    try: cloud.select(wrong)\n"
                "    except ValueError as error: assert '3 and not' in str(error), error\n"
                "    else: raise SystemExit('taken')\n")
        subprocess.run([sys.executable, "-c", code], check=True)
        self.assertEqual(self.cloud.select(array.array("B", [3, 1])).points.tolist(), self.xyz[[3, 1]].tolist())

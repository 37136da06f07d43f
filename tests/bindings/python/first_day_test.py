# SPDX-FileCopyrightText: 2026 The Jalon authors
# SPDX-License-Identifier: Apache-2.0
"""The first day of the page is examples/python/first_day.py, and what it finds in a street of known sizes is right."""

import contextlib
import importlib.util
import io
import os
import pickle
import subprocess
import sys
import tempfile
import unittest

import numpy as np

import jalon
import page
from page import says

PATH = os.path.join(page.ROOT, "examples", "python", "first_day.py")
BUILD = os.environ.get("JALON_BUILD", "")
GEOPANDAS = importlib.util.find_spec("geopandas") is not None
TESTS = os.path.join(page.ROOT, "tests", "bindings")
# The street's second epoch has a new box from (22, -4.6, 0), of this size, and a new pole of 0.1 m about (27, 4): src/scan/scenes/street.cpp
BOX_FROM, BOX_SIZE, POLE = np.array([22, -4.6, 0]), np.array([4.2, 1.8, 1.5]), np.array([27, 4.0])


def script():
    with open(PATH, encoding="utf-8") as file:
        return file.read()


def national(x, y):
    """The control points turn the scan by a right angle."""
    return 652000 - y, 6861000 + x


class Page(unittest.TestCase):
    @says("Two scans read, points chosen by a mask, planes, a registration with control points, a gauge through the scan, what has changed, pickled and "
          "as a GeoDataFrame:", "This is `examples/python/first_day.py`.")
    def python__the_first_day_of_the_page_is_the_example(self):
        code = script().split('"""\n', 1)[1].strip("\n")
        self.assertEqual([block for block in page.blocks() if "import pickle" in block], [code])
        lines = [line for line in code.split("\n") if line.strip()]
        self.assertLessEqual(len(lines), 40)


@unittest.skipIf(not BUILD, "JALON_BUILD names no build folder")
class FirstDay(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.work = tempfile.TemporaryDirectory()
        files = [os.path.join(cls.work.name, name) for name in ("before.las", "after.las", "results")]
        subprocess.run(["bash", os.path.join(TESTS, "first_day.sh"), "scan", os.path.join(BUILD, "src", "jalon"), cls.work.name], check=True)
        code = script() if GEOPANDAS else script().split("import geopandas")[0]
        arguments, sys.argv = sys.argv, [PATH, *files]
        said = io.StringIO()
        try:
            with contextlib.redirect_stdout(said):
                cls.told = {"__name__": "__main__"}
                exec(compile(code, PATH, "exec"), cls.told)
        finally:
            sys.argv = arguments
        cls.scan, cls.results, cls.said = jalon.Cloud.read(files[0]), files[2], said.getvalue()

    @classmethod
    def tearDownClass(cls):
        cls.told.clear()
        cls.work.cleanup()

    def python__first_day_prints_what_all_languages_print(self):
        with open(os.path.join(TESTS, "first_day.txt"), encoding="utf-8") as file:
            wanted = file.read().splitlines()
        self.assertEqual(len(wanted), 11)
        self.assertEqual([line for line in wanted if line not in self.said], [])

    def python__first_day_chooses_what_is_near(self):
        close = self.told["close"]
        wanted = np.flatnonzero(self.scan["range"] < 20)
        self.assertTrue(0 < len(wanted) < len(self.scan))
        self.assertTrue(np.array_equal(close.points, self.scan.points[wanted]))
        self.assertIn("%d of %d points are nearer" % (len(wanted), len(self.scan)), self.said)

    def python__first_day_finds_the_planes_of_the_street(self):
        planes, close = self.told["planes"], self.told["close"]
        ground, *walls = planes[:3]
        self.assertTrue(abs(ground.normal[2]) > 1 - 1e-6 and abs(ground.offset) < 0.002)
        for wall in walls:
            self.assertGreater(abs(wall.normal[1]), 1 - 1e-6)
            self.assertLess(min(abs(abs(wall.offset) - y) for y in (7.7, 7.75, 7.8, 8, 8.2, 8.35)), 0.002)
        for plane in planes[:3]:
            own = close["segment"][planes.labels == plane.label]
            self.assertGreater((own == np.bincount(own).argmax()).mean(), 0.98)

    def python__first_day_registers_as_least_squares_does(self):
        known, measured = (np.array([self.told[name][key] for key in "ABCD"], float) for name in ("known", "measured"))
        a, b = measured - measured.mean(0), known - known.mean(0)
        u, _, v = np.linalg.svd(a.T @ b)
        turned = a @ u @ np.diag([1, 1, np.linalg.det(u @ v)]) @ v
        found = self.told["national"]
        self.assertEqual([found.pair_name(i) for i in range(4)], list("ABCD"))
        self.assertLess(np.abs(found.residuals["residual"] - (turned - b)).max(), 1e-6)
        self.assertGreater(np.abs(turned - b).max(), 0.002)
        self.assertLess(np.abs(self.told["shift_sigmas"] - 0.003 * np.sqrt(2) / np.sqrt(4)).max(), 1e-9)  # both sides 3 mm, four pairs
        self.assertIn("pose ACCEPTED, sigmas of its shift 2.1 2.1 2.1 mm", self.said)

    def python__first_day_drives_past_the_box(self):
        gap = self.told["gap"]
        self.assertAlmostEqual(gap.clearance, 2.5 - 0.9 - 1.25, delta=0.01)
        self.assertTrue(10 <= gap.xyz[0] <= 14.2 and abs(gap.xyz[1] - 2.5) < 0.01)

    def python__first_day_sees_the_new_box_and_the_new_pole(self):
        box, pole = self.told["regions"][:2]
        corners = np.array([BOX_FROM, BOX_FROM + BOX_SIZE])
        easting, northing = national(corners[:, 0], corners[:, 1])
        self.assertLess(np.abs(np.sort(easting) - [box.box_min[0], box.box_max[0]]).max(), 0.02)
        self.assertLess(np.abs(np.sort(northing) - [box.box_min[1], box.box_max[1]]).max(), 0.02)
        self.assertAlmostEqual(box.box_max[2], 41.5, delta=0.02)
        self.assertLess(np.abs(np.array(pole.centroid[:2]) - national(*POLE)).max(), 0.1)

    def python__first_day_keeps_its_comparison(self):
        with open(self.results + ".pickle", "rb") as file:
            back = pickle.load(file)
        self.assertTrue(np.array_equal(back.distances, self.told["changes"].distances, equal_nan=True))
        self.assertEqual(back.summary.rms, self.told["changes"].summary.rms)
        written = jalon.Cloud.read(self.results + ".las")
        self.assertEqual((written.count, "2154" in written.crs), (self.told["after"].count, True))
        self.assertGreater(os.path.getsize(self.results + ".html"), 1000)

    @unittest.skipIf(not GEOPANDAS, "geopandas is not installed")
    def python__first_day_makes_a_map_of_the_changes(self):
        import geopandas
        frame, regions = self.told["frame"], self.told["regions"]
        self.assertEqual(frame.crs.to_epsg(), 2154)
        self.assertEqual(frame["area"].tolist(), regions["area"].tolist())
        size = regions["box_max"][:, :2] - regions["box_min"][:, :2]
        self.assertTrue(np.allclose(frame.geometry.area, size.prod(1), rtol=1e-6))
        self.assertAlmostEqual(frame.geometry.area[0], BOX_SIZE[0] * BOX_SIZE[1], delta=0.15)
        back = geopandas.read_file(self.results + ".gpkg")
        self.assertEqual((back.crs.to_epsg(), back["points"].tolist()), (2154, regions["points"].tolist()))

# SPDX-FileCopyrightText: 2026 The Jalon authors
# SPDX-License-Identifier: Apache-2.0
"""Registrations: targets measured and given, clouds laid on each other, poses in and out."""

import os
import tempfile
import unittest

import numpy as np

import jalon
from scenes import box_cloud, box_model

PLACES = np.array([(0.0, 0, 1), (9, 1, 2), (8, 11, 1.2), (-2, 10, 3)])
TURN = np.array([[0.0, -1, 0, 652000], [1, 0, 0, 6861000], [0, 0, 1, 100], [0, 0, 0, 1]])


def spheres(radius=0.0725):
    """Points all round four spheres."""
    v, a = np.meshgrid(np.pi * (np.arange(24) + 0.5) / 24, 2 * np.pi * np.arange(48) / 48)
    r = radius + 0.0005 * np.sin(12.9898 * np.arange(v.size))
    ball = np.c_[np.sin(v.ravel()) * np.cos(a.ravel()), np.sin(v.ravel()) * np.sin(a.ravel()), np.cos(v.ravel())] * r[:, None]
    return jalon.Cloud(np.vstack([ball + place for place in PLACES]))


def moved(points, pose):
    return points @ pose[:3, :3].T + pose[:3, 3]


class Register(unittest.TestCase):
    def python__targets_are_measured_and_registered(self):
        measured = spheres().measure_targets(PLACES + 0.01, radius_m=0.0725)
        self.assertIs(measured[0].status, jalon.Status.OK)
        self.assertIs(measured[0].kind, jalon.TargetKind.SPHERE)
        moving = [("T%d" % i, row.centre, row.covariance) for i, row in enumerate(measured)]
        control = [("T%d" % i, xyz) for i, xyz in enumerate(moved(PLACES, TURN))]
        registration = jalon.Registrar("targets", sigma_m=0.002).run_targets(control, moving)
        self.assertTrue(np.allclose(moved(PLACES, registration.pose), moved(PLACES, TURN), atol=0.002))
        self.assertEqual([registration.pair_name(i) for i in range(4)], ["T0", "T1", "T2", "T3"])
        self.assertEqual(len(registration.residuals), 4)
        self.assertEqual(len(registration.directions), 6)
        self.assertGreaterEqual(len(registration.iterations), 1)
        self.assertIn("sigma_m", registration.parameters)
        self.assertEqual(repr(registration), "<jalon.Registration of stopped CONVERGED, converged 1, verdict DOUBTFUL>")

    def python__targets_are_lists_of_their_own(self):
        targets = jalon.Targets()
        targets.add("A", (0, 0, 0))
        targets.add("", [9, 0, 0], np.eye(3) * 1e-6)
        targets.add(None, np.array([0, 7, 1.0]))
        self.assertEqual(len(targets), 3)
        same = jalon.Targets([("A", (0, 0, 0)), ("", (9, 0, 0), np.eye(3) * 1e-6), (None, (0, 7, 1))])
        pose = jalon.Registrar("targets").run_targets(targets, same).pose
        self.assertTrue(np.allclose(pose, np.eye(4), atol=1e-9))
        by_name = {"A": (0, 0, 0), "B": [9, 0, 0], "C": np.array([0, 7, 1.0])}
        found = jalon.Registrar("targets").run_targets(by_name, jalon.Targets(by_name))
        self.assertEqual([found.pair_name(i) for i in range(3)], ["A", "B", "C"])

    def python__clouds_are_registered_from_a_start_and_applied(self):
        reference = box_cloud()
        shift = np.eye(4)
        shift[:3, 3] = 0.05, -0.04, 0.03
        moving = reference.transform(np.linalg.inv(shift))
        for start in (None, np.eye(4), np.eye(4)[:3]):
            registration = jalon.Registrar("icp").run(reference, moving, start)
            self.assertEqual(registration.pose.shape, (4, 4))
            self.assertTrue(np.allclose(registration.pose, shift, atol=0.01))
        laid = registration.apply(moving)
        self.assertLess(np.abs(laid.points - reference.points).max(), 0.02)
        self.assertTrue(np.allclose(moving.transform(registration.pose).points, laid.points, atol=1e-9))

    def python__a_registration_says_whether_its_pose_may_be_used_and_why_not(self):
        accepted = jalon.Registrar("icp").run(box_cloud(), box_cloud())
        self.assertIs(accepted.summary.verdict, jalon.Verdict.ACCEPTED)
        self.assertEqual(accepted.reasons, "")
        turned = jalon.Registrar().run(box_cloud(), box_cloud())  # a box looks alike from several sides
        self.assertIs(turned.summary.verdict, jalon.Verdict.DOUBTFUL)
        self.assertIn("a clearly different pose fits about as well", turned.reasons.split("\n"))

    def python__a_report_on_a_registration_is_written(self):
        cloud = jalon.Scanner("sample", spacing_m=0.3).run(box_model())
        registration = jalon.Registrar("icp").run(cloud, cloud)
        with tempfile.TemporaryDirectory() as folder:
            path = os.path.join(folder, "report.html")
            jalon.report_write_registration(registration, path, cloud, cloud)
            with open(path, encoding="utf-8") as f:
                self.assertIn("<html", f.read())

    def python__a_crs_is_a_text_or_an_object_that_tells_its_wkt(self):
        class Crs:
            def to_wkt(self):
                return 'LOCAL_CS["site"]'
        cloud = jalon.Cloud([(0, 0, 0)])
        cloud.crs = Crs()
        self.assertEqual(cloud.crs, 'LOCAL_CS["site"]')
        cloud.crs = None
        self.assertEqual(cloud.crs, "")
        for wrong in (2154, b"EPSG:2154"):
            with self.assertRaisesRegex(TypeError, "^crs: a str is needed"):
                cloud.crs = wrong
        try:
            import pyproj
        except ImportError:
            self.skipTest("pyproj is not installed")
        cloud.crs = pyproj.CRS.from_epsg(2154)
        self.assertEqual(pyproj.CRS(cloud.crs).to_epsg(), 2154)
        builder = jalon.CloudBuilder()
        builder.set_crs(pyproj.CRS.from_epsg(2154))
        builder.append_points([(0, 0, 0)])
        self.assertEqual(builder.seal().crs, cloud.crs)

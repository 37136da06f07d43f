# SPDX-FileCopyrightText: 2026 The Jalon authors
# SPDX-License-Identifier: Apache-2.0
"""Trajectories of mobile mapping."""

import os
import tempfile
import unittest

import numpy as np

import jalon

TIMES = np.arange(0, 30, 0.5)


def bent_drive(**more):
    """A minute's bend at 5 m/s, with sigmas that grow."""
    turned = TIMES * 0.05
    xyz = np.c_[100 * np.sin(turned), 100 * (1 - np.cos(turned)), np.full(len(TIMES), 2.0)] + (652000, 6861000, 40)
    sigma = np.repeat(0.02 + 0.001 * TIMES, 3).reshape(-1, 3)
    return jalon.Trajectory(TIMES, xyz, np.c_[0 * turned, 0 * turned, turned], sigma, 0 * sigma + 0.01, 0 * sigma + 1e-4,
                            crs="EPSG:2154", **more)


class Trajectories(unittest.TestCase):
    def python__a_trajectory_gives_back_what_it_was_made_of(self):
        drive = bent_drive()
        self.assertEqual((drive.count, drive.crs, drive.axes), (len(TIMES), "EPSG:2154", "enu"))
        np.testing.assert_array_equal(drive.epochs["time"], TIMES)
        self.assertEqual(drive.epochs["xyz"].shape, (len(TIMES), 3))
        self.assertTrue(np.isnan(drive.epochs["velocity"]).all())
        self.assertEqual(bent_drive(axes="ned").axes, "ned")
        bare = jalon.Trajectory(TIMES, drive.epochs["xyz"], drive.epochs["attitude"])
        self.assertTrue(np.isnan(bare.epochs["position_sigma"]).all())
        with self.assertRaisesRegex(ValueError, "no position sigmas"):
            bare.prior

    def python__a_trajectory_names_epoch_and_field_of_what_is_wrong(self):
        drive = bent_drive().epochs
        late = TIMES.copy()
        late[3] = 0
        with self.assertRaisesRegex(ValueError, "^epoch 3 of the trajectory: time 0 is not after time 1 of the epoch before"):
            jalon.Trajectory(late, drive["xyz"], drive["attitude"])

    def python__poses_are_told_between_epochs_and_at_control_times(self):
        drive = bent_drive()
        some = drive.interpolate([0.25, 29.5])
        np.testing.assert_allclose(some.epochs["xyz"][0], drive.epochs["xyz"][:2].mean(axis=0))
        np.testing.assert_allclose(some.epochs["attitude"][0], drive.epochs["attitude"][:2].mean(axis=0), atol=1e-12)
        self.assertEqual(drive.control(1.0).epochs["time"][-1], 29.5)
        with self.assertRaisesRegex(ValueError, "time 30 of item 0 is outside"):
            drive.interpolate([30.0])

    def python__the_prior_has_a_tridiagonal_inverse(self):
        drive = bent_drive().control(1.0)
        prior = drive.prior
        n = drive.count
        covariance = np.zeros((n, n))
        for i in range(n):
            factors = np.r_[1.0, np.cumprod(prior["factor"][i:n - 1, 0])]
            covariance[i, i:] = covariance[i:, i] = prior["sigma"][i, 0] ** 2 * factors
        beside = prior["beside"][:n - 1, 0]
        information = np.diag(prior["information"][:, 0]) + np.diag(beside, 1) + np.diag(beside, -1)
        np.testing.assert_allclose(information @ covariance, np.eye(n), atol=1e-10)

    def python__trajectories_in_files_come_back(self):
        drive = bent_drive(axes="ned")
        with tempfile.TemporaryDirectory() as folder:
            text, sbet, sigmas = (os.path.join(folder, name) for name in ("drive.txt", "sbet.out", "smrmsg.out"))
            drive.write(text)
            back = jalon.Trajectory.read(text)
            self.assertEqual((back.axes, back.crs), ("ned", "EPSG:2154"))
            for column in ("time", "xyz", "attitude", "position_sigma", "attitude_sigma"):
                np.testing.assert_array_equal(back.epochs[column], drive.epochs[column])
            drive.write(sbet, sigmas, projection="lambert93")
            self.assertEqual(os.path.getsize(sbet), 136 * drive.count)
            back = jalon.Trajectory.read(sbet, sigmas, projection="lambert93")
            self.assertEqual(back.crs, "EPSG:2154")
            np.testing.assert_allclose(back.epochs["xyz"], drive.epochs["xyz"], atol=1e-5, rtol=0)
            np.testing.assert_allclose(back.epochs["attitude"], drive.epochs["attitude"], atol=1e-11)
            with open(sbet, "r+b") as file:
                file.truncate(136 * 3 + 8)
            with self.assertRaisesRegex(ValueError, "record 3 is cut off: 8 of its 136 bytes are there"):
                jalon.Trajectory.read(sbet)

    def python__returns_become_points_with_covariances(self):
        drive = bent_drive()
        times = np.linspace(0, 29.5, 500)
        cloud = drive.georeference(times, np.full(500, 10.0), np.linspace(0, 60, 500), np.full(500, 1.5), lever_arm_m=[0.5, 0.2, 1.8])
        self.assertEqual(cloud["covariance"].shape, (500, 6))
        np.testing.assert_allclose(np.linalg.norm(cloud.points - cloud["beam_origin"], axis=1), 10, atol=1e-6)
        np.testing.assert_allclose(cloud["point_sigma"] ** 2, cloud["covariance"][:, [0, 3, 5]].sum(axis=1), rtol=1e-5)
        mesh = cloud.ellipsoids(every=100, fineness=2, confidence=0.95)
        self.assertEqual(sorted(set(mesh.triangles["face"])), [0, 100, 200, 300, 400])
        with self.assertRaisesRegex(ValueError, "return 2: the range is 0"):
            drive.georeference([1.0, 2, 3], [1.0, 1, 0], [0.0, 0, 0], [1.0, 1, 1])

    def python__normality_of_values_and_fields(self):
        report = jalon.normality([148.0, 154, 158, 160, 161, 162, 166, 170, 182, 195, 236])
        self.assertAlmostEqual(report.W, 0.7888146, places=6)
        self.assertAlmostEqual(report.p, 0.0067038, places=6)
        cloud = jalon.Cloud(np.random.default_rng(1).normal(size=(7000, 3)))
        cloud["x"] = cloud.points[:, 0]
        report = cloud.field_normality("x")
        self.assertEqual((report["values"], report["tested"], report["is_normal"]), (7000, 5000, 1))

    def python__a_drive_through_a_street_of_strips_has_perfect_matches(self):
        street = jalon.scene_street_drive(seed=3)
        made = street.model.building_strips(touch_m=2.0)
        self.assertEqual((made.strips["block"].max(), made.strips["facade"].max()), (13, 55))
        scanner = jalon.Scanner("mobile", boresight_rad=[0, np.pi / 2, 0.4], revolutions_per_s=5, pulses=200)
        cloud = scanner.drive(made.model, street.trajectory)
        strip = cloud["strip"]
        off = ((cloud.points - made.strips["place"][strip]) * made.strips["normal"][strip]).sum(axis=1)
        self.assertLess(abs(off).max(), 1e-9)
        moved = made.model.perturb_strips(sigma_block_m=1, sigma_facade_m=0.5, sigma_strip_m=0.3, seed=5)
        by = (moved.block_offsets["offset"][made.strips["block"]] * made.strips["normal"][:, :2]).sum(axis=1)
        by += moved.facade_offsets["offset"][made.strips["facade"]] + moved.strip_offsets["offset"]
        np.testing.assert_allclose(moved.model.faces["offset"] - made.model.faces["offset"], by, atol=1e-9)

    def python__a_cloud_and_a_model_are_adjusted_together(self):
        drive = jalon.scene_drive_scenario(scenario=5, leg_m=60, revolutions_per_s=10, pulses=400, seed=4)
        made = drive.trajectory.adjust(drive.cloud, drive.model, covariance=True)
        summary = made.summary
        self.assertEqual((summary["converged"], summary["weak_is_held"]), (1, 1))

        def off(trajectory):
            return np.sqrt(((trajectory.epochs["xyz"] - drive.true_trajectory.epochs["xyz"]) ** 2).mean())
        self.assertLess(off(made.trajectory), off(drive.trajectory))
        controls, strips = made.controls, made.strips
        self.assertTrue((controls["sigma"] <= controls["prior_sigma"] + 1e-12).all())
        seen = strips["points"] > 0
        self.assertEqual(seen.sum(), summary["strips"])
        np.testing.assert_array_equal(strips["offset"][~seen], 0)
        # Without weights the planes of the adjusted model pass through the adjusted points of their strips.
        exact = drive.trajectory.adjust(drive.cloud, drive.model, kernel="none", sigma_point_m=0.0)
        seen = exact.strips["points"] > 0
        matches, cloud = exact.matches, exact.apply(drive.cloud)
        use = (matches["weight"] > 0) & seen[np.minimum(matches["strip"], len(seen) - 1)]
        faces = exact.model.faces
        strip = matches["strip"][use]
        distance = (cloud.points[matches["point"][use]] * faces["normal"][strip]).sum(axis=1) - faces["offset"][strip]
        sums = np.bincount(strip, matches["weight"][use] * distance, len(seen))
        means = sums[seen] / np.bincount(strip, matches["weight"][use], len(seen))[seen]
        self.assertLess(abs(means).max(), 1e-6)
        moved = cloud["beam_origin"] - drive.cloud["beam_origin"]
        np.testing.assert_allclose(moved, cloud.points - drive.cloud.points, atol=1e-9)
        self.assertEqual(made.iterations["matched"][-1], summary["matched"])
        self.assertEqual((made.blocks["offset"].shape[0], made.facades["offset"].shape[0]), (14, 56))
        covariance = made.covariance
        n = covariance["group"].size
        self.assertEqual(n, 2 * (len(controls["time"]) + 14))
        np.testing.assert_allclose(np.sqrt(np.diag(covariance["covariance"]))[:len(controls["time"])], controls["sigma"][:, 0])
        self.assertIn('"sigma_strip_m"', made.parameters)
        with tempfile.TemporaryDirectory() as folder:
            path = os.path.join(folder, "adjusted.html")
            jalon.report_write_adjustment(made, path, drive.true_trajectory)
            with open(path, encoding="utf-8") as page:
                self.assertIn("east, true", page.read())
        with self.assertRaisesRegex(ValueError, "covariance was not asked for"):
            drive.trajectory.adjust(drive.cloud, drive.model).covariance
        with self.assertRaisesRegex(ValueError, "no field \"time\""):
            drive.trajectory.adjust(jalon.Cloud(drive.cloud.points), drive.model)

    def python__trajectories_are_perturbed_by_a_seed(self):
        drive = bent_drive()
        moved = drive.perturb(3).epochs["xyz"] - drive.epochs["xyz"]
        np.testing.assert_array_equal(moved, drive.perturb(3).epochs["xyz"] - drive.epochs["xyz"])
        self.assertTrue((moved[:, 2] == 0).all() and (moved[:, :2] != 0).all())
        self.assertLess(abs(moved).max(), 0.5)


if __name__ == "__main__":
    unittest.main()

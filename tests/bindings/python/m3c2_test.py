# SPDX-FileCopyrightText: 2026 The Jalon authors
# SPDX-License-Identifier: Apache-2.0
"""Comparisons by M3C2 in drawn scenes, against the same written in NumPy (m3c2_slow.py). JALON_FULL=1: ten times as many."""

import os
import unittest

import numpy as np

import jalon
from m3c2_slow import COMPARED, NOTHING_NEAR, TOO_FEW_POINTS, m3c2

SCENES = 500 if "JALON_FULL" in os.environ else 50
# Of the coordinates' size: some tens of roundings of what both programs begin with.
NEAR = 1e-12
# Of a level: the quantile of the library is good to 1e-9 of itself from four degrees of freedom on.
NEAR_LEVEL = 2e-9


def turned(random):
    q, r = np.linalg.qr(random.standard_normal((3, 3)))
    return q * np.sign(np.diag(r)) * np.sign(np.linalg.det(q * np.sign(np.diag(r))))


def surface(random, n, size, noise, lift):
    """A bowed ground with a step and strays above it."""
    uv = random.uniform(-0.5, 0.5, (n, 2)) * size
    height = 0.05 * np.sin(3 * uv[:, 0] / size) * size + (uv[:, 0] > 0.2 * size) * 0.3 + lift(uv / size)
    height += noise * random.standard_normal(n)
    strays = random.random(n) < 0.03
    height[strays] += random.uniform(-2, 2, strays.sum())
    return np.column_stack([uv, height])


def covariance(random):
    a = random.standard_normal((6, 6)) * [1e-5, 1e-5, 1e-5, 1e-3, 1e-3, 1e-3]
    return (a.T @ a).ravel().tolist()


def scene(seed):
    """(reference, compared, core, normals, settings)"""
    random = np.random.default_rng(seed)
    size, noise = random.uniform(3, 12), 10 ** random.uniform(-4, -1.5)
    moved = 10 ** random.uniform(-3, -0.5)
    reference = surface(random, int(random.integers(400, 5000)), size, noise, lambda uv: 0)
    compared = surface(random, int(random.integers(400, 5000)), size * random.uniform(0.6, 1), noise * random.uniform(0.5, 2),
                       lambda uv: moved * np.exp(-20 * (uv ** 2).sum(1)))
    core = np.concatenate([reference[random.choice(len(reference), 30)], random.uniform(-0.7, 0.7, (8, 3)) * size])
    origin = [np.zeros(3), np.array([652000.0, 6861000, 100]), np.array([-3.2e6, 2.1e5, 4e3])][int(random.integers(3))]
    turn = turned(random) if random.random() < 0.5 else np.eye(3)
    reference, compared, core = (points @ turn.T + origin for points in (reference, compared, core))
    radius = size * random.uniform(0.03, 0.15)
    settings = {
        "surfaces": "all", "position": str(random.choice(["mean", "median"])), "normal_radius_m": radius,
        "normals": str(random.choice(["scale", "scale", "scale", "vertical", "horizontal", "given"])),
        "normals_from": str(random.choice(["reference", "compared", "core"], p=[0.6, 0.3, 0.1])),
        "orientation": str(random.choice(["direction", "point"])), "orientation_direction": random.standard_normal(3).tolist(),
        "viewpoint": (origin + random.uniform(-1, 1, 3) * 3 * size).tolist(), "cylinder_radius_m": size * random.uniform(0.02, 0.12),
        "max_depth_m": random.uniform(0.2, 3), "min_points": int(random.integers(5, 20)), "confidence": random.uniform(0.6, 0.999),
        "registration_error_m": random.choice([0, 0.003])}
    if random.random() < 0.3:
        settings["normal_radii_m"] = (radius * random.uniform(0.5, 2, 3)).tolist()
    if random.random() < 0.3:
        settings.update(registration_covariance=covariance(random), registration_centre=origin.tolist())
    return reference, compared, core, random.standard_normal((len(core), 3)), settings


class M3c2(unittest.TestCase):
    def compare(self, seed):
        """(statuses, largest difference over the coordinates' size, the same of levels over themselves)"""
        reference, compared, core, normals, settings = scene(seed)
        at = jalon.Cloud(core)
        at["normal"] = normals
        got = jalon.Comparer("m3c2", **settings).run_core(jalon.Cloud(reference), jalon.Cloud(compared), at).points
        status, distance, lod, normal, radius, counts, spreads = m3c2(reference, compared, core, normals, settings)
        name = "scene %d: %s" % (seed, settings)
        self.assertEqual(got["status"].tolist(), status.tolist(), name)
        self.assertEqual(np.column_stack([got["count_reference"], got["count_compared"]]).tolist(), counts.tolist(), name)
        self.assertEqual(got["normal_radius"].tolist(), radius.tolist(), name)
        ok = status == COMPARED
        self.assertTrue(np.isnan(got["distance"][~ok]).all() and np.isnan(got["lod"][~ok]).all(), name)
        size = np.abs(reference).max()
        pairs = [(got["distance"][ok], distance[ok]), (got["spread_reference"][ok], spreads[ok, 0]), (got["spread_compared"][ok], spreads[ok, 1])]
        known = np.isfinite(normal).all(1)
        self.assertEqual(np.isfinite(got["normal"]).all(1).tolist(), known.tolist(), name)
        off = max((float(np.abs(a - b).max()) for a, b in pairs if len(a)), default=0.0) / size
        off_normal = float(np.abs(got["normal"][known] - normal[known]).max()) if known.any() else 0.0
        off_lod = float((np.abs(got["lod"][ok] - lod[ok]) / (np.abs(lod[ok]) + NEAR / NEAR_LEVEL * size)).max()) if ok.any() else 0.0
        self.assertLess(off, NEAR, name)
        self.assertLess(off_lod, NEAR_LEVEL, name)
        self.assertLess(off_normal, 1e-9, name)
        significant = np.abs(distance) > lod
        self.assertEqual(got["significant"].astype(bool).tolist(), (ok & significant).tolist(), name)
        return status, off, off_lod

    def python__m3c2_is_what_numpy_makes_of_drawn_scenes(self):
        found = [self.compare(1000 + i) for i in range(SCENES)]
        status = np.concatenate([f[0] for f in found])
        told = [int((status == s).sum()) for s in (COMPARED, NOTHING_NEAR, TOO_FEW_POINTS)]
        self.assertGreater(min(told), SCENES)  # each of them is there
        print("FIGURE M3C2 against NumPy: %d scenes, %d core points (%d compared, %d in empty cylinders, %d with too few points); at most "
              "%.1g of the coordinates' size off, levels %.1g of themselves" % (SCENES, len(status), *told, max(f[1] for f in found),
                                                                             max(f[2] for f in found)))

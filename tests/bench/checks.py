# SPDX-FileCopyrightText: 2026 The Jalon authors
# SPDX-License-Identifier: Apache-2.0
"""Do the libraries do the same work? Results on some points beside brute force in doubles."""

import os
import tempfile

import numpy as np

SAMPLES, NEIGHBOURS, BRUTE_FORCE_QUERIES = 2000, 16, 200
# Floats carry 24 bits; a squared distance is a sum of three squares of coordinate differences.
SQUARED_DISTANCE_TOLERANCE = 2e-5
# Normals of a least squares plane from the same neighbours agree but for rounding; equal distances
# may swap the last neighbour, and round or thread-like neighbourhoods have no firm normal, so one in
# a hundred may differ.
NORMAL_TOLERANCE_DEG, NORMAL_SHARE = 0.5, 0.99
LAS_STEP_M = 0.0001


def neighbours_by_force(xyz, query):
    """Sorted squared distances of the nearest points and these points."""
    radius = 0.25
    while True:
        near = xyz[np.abs(xyz - query).max(axis=1) <= radius]
        squared = ((near - query) ** 2).sum(axis=1)
        if (squared <= radius * radius).sum() >= NEIGHBOURS:
            order = np.argsort(squared, kind="stable")[:NEIGHBOURS]
            return squared[order], near[order]
        radius *= 4


def truth(xyz):
    rows = np.arange(0, len(xyz), max(1, len(xyz) // SAMPLES))
    step = max(1, len(rows) // BRUTE_FORCE_QUERIES)
    squared, normals = [], []
    for row in rows[::step]:
        distances, points = neighbours_by_force(xyz, xyz[row])
        squared.append(distances)
        normals.append(np.linalg.eigh(np.cov(points.T))[1][:, 0])
    return step, np.array(squared), np.array(normals)


def angles_deg(a, b):
    norms = np.linalg.norm(a, axis=1) * np.linalg.norm(b, axis=1)
    cosines = np.abs((a * b).sum(axis=1)) / np.where(norms > 0, norms, np.nan)
    return np.degrees(np.arccos(np.clip(cosines, 0, 1)))


def same_work(drivers, operations, prefix):
    """Runs each operation once with a sample and prints how far each library is from the truth.

    Returns Jalon's failures."""
    xyz = np.fromfile(f"{prefix}.f64").reshape(-1, 3)
    step, squared, normals = truth(xyz)
    rows = np.arange(0, len(xyz), max(1, len(xyz) // SAMPLES))
    failures = []
    with tempfile.TemporaryDirectory() as folder:
        for operation in operations:
            for driver in drivers:
                if operation not in driver.operations:
                    continue
                path = os.path.join(folder, "sample")
                _, count = driver.run(operation, path)
                sample = np.fromfile(path) if os.path.exists(path) else np.zeros(0)
                text, good = compare(
                    operation, sample, xyz[rows], step, squared, normals, count, len(xyz)
                )
                print(
                    f"check {driver.name} {operation}: {text}{'' if good else '  DIFFERS'}",
                    flush=True,
                )
                if not good and driver.name == "Jalon":
                    failures.append(f"{operation}: {text}")
                if os.path.exists(path):
                    os.remove(path)
    return failures


def compare(operation, sample, sampled_xyz, step, squared, normals, count, points):
    if operation == "knn16":
        if len(sample) != NEIGHBOURS * len(sampled_xyz):
            return f"{len(sample)} numbers in the sample", False
        found = sample.reshape(-1, NEIGHBOURS)[::step]
        error = np.abs(found - squared) / np.maximum(squared, 1e-6)
        return (
            f"squared distances within {error.max():.1e} (relative) of brute force",
            error.max() <= SQUARED_DISTANCE_TOLERANCE,
        )
    if operation == "normals16":
        if len(sample) != 3 * len(sampled_xyz):
            return f"{len(sample)} numbers in the sample", False
        angle = angles_deg(sample.reshape(-1, 3)[::step], normals)
        share = float(np.mean(angle <= NORMAL_TOLERANCE_DEG))
        return (
            f"{100 * share:.1f} % of the normals within {NORMAL_TOLERANCE_DEG} deg of brute force",
            share >= NORMAL_SHARE,
        )
    if operation in ("las0", "las3"):
        if len(sample) != 3 * len(sampled_xyz):
            return f"{len(sample)} numbers in the sample", False
        error = np.abs(sample.reshape(-1, 3) - sampled_xyz).max()
        return (
            f"{count} points, coordinates within {1000 * error:.3f} mm",
            count == points and error <= 0.51 * LAS_STEP_M,
        )
    if operation == "region_growing":
        return f"{count} segments", count > 0  # how right they are is tests/accuracy's matter
    return f"{count} points", count > 0

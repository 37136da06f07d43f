# SPDX-FileCopyrightText: 2026 The Jalon authors
# SPDX-License-Identifier: Apache-2.0
"""Do the libraries do the same work? Results on some points beside brute force in doubles."""

import os
import tempfile

import numpy as np

SAMPLES, NEIGHBOURS, BRUTE_FORCE_QUERIES = 2000, 16, 200
# Floats carry 24 bits; a distance is the root of three squares of coordinate differences.
DISTANCE_TOLERANCE = 1e-6
# Jalon's batch search gives distances of its grid, 2^31 steps an edge of the cube.
GRID_STEPS = 2.0**31
# Normals of a least squares plane from the same neighbours agree but for rounding; equal distances
# may swap the last neighbour, and round or thread-like neighbourhoods have no firm normal, so one in
# a hundred may differ.
NORMAL_TOLERANCE_DEG, NORMAL_SHARE = 0.5, 0.99
LAS_STEP_M = 0.0001
# Of a distance to the nearest point: exact but for the last bits; peers that work in floats differ by more.
NEAREST_TOLERANCE = 1e-9
# Of the distances between two scans of 3 mm noise where nothing moved; outliers have none.
M3C2_TOLERANCE_MM, M3C2_SHARE = 1.5, 0.9
# Of a true plane found: CGAL's epsilon; less than half of what lies between any two of them.
PLANE_TOLERANCE_DEG, PLANE_TOLERANCE_M = 1.0, 0.015
# Of Jalon's pose at the middle of the street; icp_exactness.cpp asks for less, of many seeds.
ICP_TOLERANCE_MM, ICP_TOLERANCE_DEG = 0.5, 0.003


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


def grid_error_m(xyz):
    """Largest error of a distance between two points that were rounded down to Jalon's grid.

    The cube's edge is a power of two, its origin on whole metres."""
    edge_m = 2.0 ** np.ceil(np.log2(np.ptp(xyz, axis=0).max() + 1))
    return np.sqrt(3) * edge_m / GRID_STEPS


def truth(xyz):
    rows = np.arange(0, len(xyz), max(1, len(xyz) // SAMPLES))
    step = max(1, len(rows) // BRUTE_FORCE_QUERIES)
    squared, normals = [], []
    for row in rows[::step]:
        distances, points = neighbours_by_force(xyz, xyz[row])
        squared.append(distances)
        normals.append(np.linalg.eigh(np.cov(points.T))[1][:, 0])
    return step, np.array(squared), np.array(normals)


# Models and local models are compared with the truth in tests/accuracy and tests/unit/compare.
UNCHECKED = ("outlines", "facade_dxf", "c2c_plane", "c2c_quadric")


def nearest_by_force(xyz, queries):
    """Distances of the queries from their nearest points."""
    squared = []
    for query in queries:
        radius = 0.25
        while True:
            near = xyz[np.abs(xyz - query).max(axis=1) <= radius]
            least = ((near - query) ** 2).sum(axis=1).min(initial=np.inf)
            if least <= radius * radius:
                break
            radius *= 4
        squared.append(least)
    return np.sqrt(squared)


def compare_distances(prefix, xyz, sample):
    second = np.fromfile(f"{prefix}_second.f64").reshape(-1, 3)
    rows = np.arange(0, len(second), max(1, len(second) // SAMPLES))
    if len(sample) != len(rows):
        return f"{len(sample)} numbers in the sample", False
    step = max(1, len(rows) // BRUTE_FORCE_QUERIES)
    truth_m = nearest_by_force(xyz, second[rows[::step]])
    error = np.abs(sample[::step] - truth_m) / np.maximum(truth_m, 1e-6)
    return f"distances within {error.max():.1e} of brute force", bool(
        error.max() <= NEAREST_TOLERANCE
    )


def triangle_distances(point, corners):
    """Distances of a point from triangles (n x 3 x 3): from their sides and, where it is above them, their planes."""
    best = np.full(len(corners), np.inf)
    for k in range(3):
        side = corners[:, (k + 1) % 3] - corners[:, k]
        to = point - corners[:, k]
        length2 = (side**2).sum(axis=1)
        t = np.clip((to * side).sum(axis=1) / np.where(length2 > 0, length2, 1), 0, 1)
        best = np.minimum(best, np.linalg.norm(to - t[:, None] * side, axis=1))
    normal = np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
    length = np.linalg.norm(normal, axis=1)
    above = length > 0
    for k in range(3):
        left = np.cross(corners[:, (k + 1) % 3] - corners[:, k], point - corners[:, k])
        above &= (left * normal).sum(axis=1) > 0
    height = np.abs(((point - corners[:, 0]) * normal).sum(axis=1)) / np.where(above, length, 1)
    return np.where(above, np.minimum(best, height), best)


def compare_triangles(prefix, xyz, rows, step, operation, sample):
    """Distances from triangles beside brute force over those whose box is near."""
    if len(sample) != len(rows):
        return f"{len(sample)} numbers in the sample", False
    corners = np.fromfile(f"{prefix}_mesh{operation[4:]}.f64").reshape(-1, 3, 3)
    low, high = corners.min(axis=1), corners.max(axis=1)
    error = 0.0
    for found, point in zip(sample[::step], xyz[rows[::step]]):
        reach = found * 1.01 + 1e-3
        near = ((low <= point + reach) & (high >= point - reach)).all(axis=1)
        truth_m = triangle_distances(point, corners[near]).min(initial=np.inf)
        error = max(error, abs(found - truth_m) / max(truth_m, 1e-6))
    return f"distances within {error:.1e} of brute force", error <= NEAREST_TOLERANCE


def compare_surfaces(sample):
    """Nothing moved between the two scans, so the distances themselves are what they are off."""
    finite = np.abs(sample[np.isfinite(sample)])
    if len(finite) == 0:
        return "no distances", False
    median, high = 1000 * np.median(finite), 1000 * np.percentile(finite, 95)
    share = len(finite) / len(sample)
    text = f"{median:.2f} mm off (95 %: {high:.1f} mm), {100 * share:.1f} % of the core points have a distance"
    return text, bool(median <= M3C2_TOLERANCE_MM and share >= M3C2_SHARE)


def compare_poses(prefix, sample):
    """How far the pose is off at the middle of the street, and its turn."""
    if len(sample) != 12:
        return f"{len(sample)} numbers in the sample", False
    motion = np.fromfile(f"{prefix}_moved.motion")
    pose, planted = sample.reshape(3, 4), np.vstack([motion[:12].reshape(3, 4), [0, 0, 0, 1]])
    left = pose @ planted
    off_mm = 1000 * np.linalg.norm(left @ np.append(motion[12:], 1) - motion[12:])
    turn = left[:, :3] - left[:, :3].T
    turn_deg = np.degrees(np.arcsin(np.clip(np.linalg.norm(turn) / np.sqrt(8), 0, 1)))
    text = f"{off_mm:.4f} mm at the middle and {turn_deg:.6f} deg off"
    return text, bool(off_mm <= ICP_TOLERANCE_MM and turn_deg <= ICP_TOLERANCE_DEG)


def angles_deg(a, b):
    norms = np.linalg.norm(a, axis=1) * np.linalg.norm(b, axis=1)
    cosines = np.abs((a * b).sum(axis=1)) / np.where(norms > 0, norms, np.nan)
    return np.degrees(np.arccos(np.clip(cosines, 0, 1)))


def same_work(drivers, operations, prefix):
    """Runs each operation once with a sample and prints how far each library is from the truth.

    Returns Jalon's failures."""
    xyz = np.fromfile(f"{prefix}.f64").reshape(-1, 3)
    step, squared, normals = truth(xyz)
    planes = np.fromfile(f"{prefix}.planes").reshape(-1, 7)
    rows = np.arange(0, len(xyz), max(1, len(xyz) // SAMPLES))
    failures = []
    with tempfile.TemporaryDirectory() as folder:
        for operation in operations:
            for driver in drivers:
                if operation not in driver.operations or operation in UNCHECKED:
                    continue
                path = os.path.join(folder, "sample")
                _, count, _ = driver.run(operation, path)
                sample = np.fromfile(path) if os.path.exists(path) else np.zeros(0)
                if operation in ("planes", "region_growing"):
                    text, good = compare_planes(sample, planes)
                elif operation.startswith("m3c2"):
                    text, good = compare_surfaces(sample)
                elif operation == "icp":
                    text, good = compare_poses(prefix, sample)
                elif operation.startswith("c2m"):
                    text, good = compare_triangles(prefix, xyz, rows, step, operation, sample)
                elif operation == "c2c":
                    text, good = compare_distances(prefix, xyz, sample)
                else:
                    text, good = compare(
                        operation, sample, xyz, rows, step, squared, normals, count
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


def compare_planes(sample, true_planes):
    """How many of the true planes were found, and how far off the largest segment on each is."""
    if len(sample) % 7 != 0:
        return f"{len(sample)} numbers in the sample", False
    found = sample.reshape(-1, 7)
    angle, shift = [], []
    for plane in true_planes:
        angles = angles_deg(found[:, :3], plane[None, :3])
        shifts = np.abs(((plane[3:6] - found[:, 3:6]) * found[:, :3]).sum(axis=1))
        on = np.flatnonzero((angles <= PLANE_TOLERANCE_DEG) & (shifts <= PLANE_TOLERANCE_M))
        if len(on) == 0:
            continue
        largest = on[np.argmax(found[on, 6])]
        angle.append(angles[largest])
        shift.append(shifts[largest])
    text = f"{len(angle)} of {len(true_planes)} true planes among {len(found)}"
    if angle:
        text += (
            f"; {np.median(angle):.4f} deg and {1000 * np.median(shift):.2f} mm off "
            f"(worst {np.max(angle):.3f} and {1000 * np.max(shift):.2f})"
        )
    return text, len(angle) == len(true_planes)


def compare(operation, sample, xyz, rows, step, squared, normals, count):
    sampled_xyz, points = xyz[rows], len(xyz)
    if operation == "knn16":
        if len(sample) != NEIGHBOURS * len(sampled_xyz):
            return f"{len(sample)} numbers in the sample", False
        found = sample.reshape(-1, NEIGHBOURS)[::step]
        distances = np.sqrt(squared)
        error = np.abs(np.sqrt(found) - distances)
        limit = grid_error_m(xyz) + DISTANCE_TOLERANCE * distances
        return (
            f"distances within {error.max():.1e} m of brute force, {(error / limit).max():.2f} "
            f"of the limit ({grid_error_m(xyz):.1e} m and {DISTANCE_TOLERANCE:.0e})",
            bool((error <= limit).all()),
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
    if operation in ("las0", "las3", "laz0", "laz3"):
        if len(sample) != 3 * len(sampled_xyz):
            return f"{len(sample)} numbers in the sample", False
        error = np.abs(sample.reshape(-1, 3) - sampled_xyz).max()
        return (
            f"{count} points, coordinates within {1000 * error:.3f} mm",
            count == points and error <= 0.51 * LAS_STEP_M,
        )
    return f"{count} points", count > 0

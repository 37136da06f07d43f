# SPDX-FileCopyrightText: 2026 The Jalon authors
# SPDX-License-Identifier: Apache-2.0
"""bench_open3d_icp.py PREFIX [tukey|scales]: Open3D's point-to-plane ICP of PREFIX_moved.f64 on PREFIX.f64.

Plain or with a Tukey kernel through registration_icp, or in three scales through multi_scale_icp, one call each; tree
and the reference's normals are part of the time. The protocol is that of driver.h."""

import sys
import time

import numpy as np
import open3d as o3d

NEIGHBOURS, PAIRS_M, KERNEL_M, ITERATIONS = 16, 1.0, 0.05, 30
prefix, kind = sys.argv[1], sys.argv[2] if len(sys.argv) > 2 else ""
peer = "Open3D-" + kind if kind else "Open3D"
o3d.utility.set_verbosity_level(o3d.utility.VerbosityLevel.Error)


def loaded(suffix):
    xyz = np.fromfile(prefix + suffix).reshape(-1, 3)
    if kind == "scales":
        return o3d.t.geometry.PointCloud(o3d.core.Tensor(xyz))
    return o3d.geometry.PointCloud(o3d.utility.Vector3dVector(xyz))


reference, moving = loaded(".f64"), loaded("_moved.f64")
n = len(reference.point.positions) if kind == "scales" else len(reference.points)


def run_legacy():
    reference.normals = o3d.utility.Vector3dVector()
    start = time.perf_counter()
    reference.estimate_normals(o3d.geometry.KDTreeSearchParamKNN(NEIGHBOURS))
    module = o3d.pipelines.registration
    kernel = [module.TukeyLoss(KERNEL_M)] if kind == "tukey" else []
    found = module.registration_icp(
        moving,
        reference,
        PAIRS_M,
        np.eye(4),
        module.TransformationEstimationPointToPlane(*kernel),
        module.ICPConvergenceCriteria(max_iteration=ITERATIONS),
    )
    return time.perf_counter() - start, found.transformation


def run_scales():
    start = time.perf_counter()
    fresh = o3d.t.geometry.PointCloud(reference.point.positions)
    fresh.estimate_normals(NEIGHBOURS)
    module = o3d.t.pipelines.registration
    found = module.multi_scale_icp(
        moving,
        fresh,
        o3d.utility.DoubleVector([0.4, 0.1, -1]),
        [module.ICPConvergenceCriteria(max_iteration=ITERATIONS) for _ in range(3)],
        o3d.utility.DoubleVector([PAIRS_M, 0.2, 0.05]),
        o3d.core.Tensor(np.eye(4)),
        module.TransformationEstimationPointToPlane(),
    )
    return time.perf_counter() - start, found.transformation.numpy()


print(f"ready|{peer}|icp", flush=True)
for line in sys.stdin:
    name, threads, *path = line.split()
    seconds, pose = run_scales() if kind == "scales" else run_legacy()
    if path:
        np.ascontiguousarray(pose[:3]).tofile(path[0])
    print(f"{peer}|{name}|{n}|{threads}|{seconds:.6f}|0", flush=True)

# SPDX-FileCopyrightText: 2026 The Jalon authors
# SPDX-License-Identifier: Apache-2.0
"""bench_open3d.py PREFIX [tensor]: Open3D through its Python module, whose work is C++.

The protocol is that of driver.h. The legacy point cloud (doubles), or, with "tensor", the tensor
one (floats). The number of threads is fixed when the process starts (OMP_NUM_THREADS and the
processors it is pinned to, both set by run.py)."""

import sys
import time

import numpy as np
import open3d as o3d

NEIGHBOURS, VOXEL_M, SAMPLES = 16, 0.05, 2000
prefix, tensor = sys.argv[1], len(sys.argv) > 2
peer = "Open3D-tensor" if tensor else "Open3D"
o3d.utility.set_verbosity_level(o3d.utility.VerbosityLevel.Error)
xyz = np.fromfile(prefix + ".f64").reshape(-1, 3)
n = len(xyz)
positions = o3d.core.Tensor(xyz.astype(np.float32)) if tensor else None
legacy = None if tensor else o3d.geometry.PointCloud(o3d.utility.Vector3dVector(xyz))
if not tensor:
    del xyz
index = second = None


def timed(work):
    start = time.perf_counter()
    result = work()
    return time.perf_counter() - start, result


def sampled(rows):
    return rows[:: max(1, n // SAMPLES)].astype(np.float64)


def build_tensor():
    search = o3d.core.nns.NearestNeighborSearch(positions)
    search.knn_index()
    return search


def run_index():
    global index
    index = None
    seconds, index = timed(build_tensor if tensor else lambda: o3d.geometry.KDTreeFlann(legacy))
    return seconds, n, None


def run_knn16():
    global index
    index = index or build_tensor()
    seconds, (_, distances) = timed(lambda: index.knn_search(positions, NEIGHBOURS))
    return seconds, n, lambda: sampled(distances.numpy())


def run_normals16():
    if tensor:
        fresh = o3d.t.geometry.PointCloud(positions)
        seconds, _ = timed(lambda: fresh.estimate_normals(NEIGHBOURS))
        return seconds, n, lambda: sampled(fresh.point.normals.numpy())
    search = o3d.geometry.KDTreeSearchParamKNN(NEIGHBOURS)
    legacy.normals = o3d.utility.Vector3dVector()
    seconds, _ = timed(lambda: legacy.estimate_normals(search))
    return seconds, n, lambda: sampled(np.asarray(legacy.normals))


def run_voxel5cm():
    if tensor:
        cloud = o3d.t.geometry.PointCloud(positions)
        seconds, thinned = timed(lambda: cloud.voxel_down_sample(VOXEL_M))
        return seconds, thinned.point.positions.shape[0], None
    legacy.normals = o3d.utility.Vector3dVector()
    seconds, thinned = timed(lambda: legacy.voxel_down_sample(VOXEL_M))
    return seconds, len(thinned.points), None


def run_c2c():
    global second
    if second is None:
        other = np.fromfile(prefix + "_second.f64").reshape(-1, 3)
        if tensor:
            second = o3d.core.Tensor(other.astype(np.float32))
        else:
            second = o3d.geometry.PointCloud(o3d.utility.Vector3dVector(other))
    if tensor:
        def work():
            _, squared = build_tensor().knn_search(second, 1)
            return np.sqrt(squared.numpy())
    else:
        def work():
            return np.asarray(second.compute_point_cloud_distance(legacy))
    seconds, distances = timed(work)
    return seconds, n, lambda: sampled(distances)


operations = {"c2c": run_c2c, "index": run_index, "normals16": run_normals16, "voxel5cm": run_voxel5cm}
if tensor:
    operations["knn16"] = (
        run_knn16  # the legacy tree has no batch form: one Python call a point would measure Python
    )
print(f"ready|{peer}|{','.join(operations)}", flush=True)
for line in sys.stdin:
    name, threads, *path = line.split()
    seconds, count, sample = operations[name]()
    if path and sample:
        sample().tofile(path[0])
    print(f"{peer}|{name}|{n}|{threads}|{seconds:.6f}|{count}", flush=True)

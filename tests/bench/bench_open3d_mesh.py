# SPDX-FileCopyrightText: 2026 The Jalon authors
# SPDX-License-Identifier: Apache-2.0
"""bench_open3d_mesh.py PREFIX: Open3D's RaycastingScene (Embree, floats), unsigned distances.

The protocol is that of driver.h. The number of threads is fixed when the process starts."""

import sys
import time

import numpy as np
import open3d as o3d

SAMPLES = 2000
prefix = sys.argv[1]
o3d.utility.set_verbosity_level(o3d.utility.VerbosityLevel.Error)
points = o3d.core.Tensor(np.fromfile(prefix + ".f64").reshape(-1, 3).astype(np.float32))
n = points.shape[0]


def mesh(name):
    corners = np.fromfile(f"{prefix}_{name}.f64").reshape(-1, 3).astype(np.float32)
    numbers = np.arange(len(corners), dtype=np.uint32).reshape(-1, 3)
    return o3d.core.Tensor(corners), o3d.core.Tensor(numbers)


meshes = {"c2m_13k": mesh("mesh13k"), "c2m_1m": mesh("mesh1m")}
print(f"ready|Open3D|{','.join(meshes)}", flush=True)
for line in sys.stdin:
    name, threads, *path = line.split()
    start = time.perf_counter()
    scene = o3d.t.geometry.RaycastingScene(int(threads))
    scene.add_triangles(*meshes[name])
    distances = scene.compute_distance(points, int(threads)).numpy()
    seconds = time.perf_counter() - start
    if path:
        distances[:: max(1, n // SAMPLES)].astype(np.float64).tofile(path[0])
    print(f"Open3D|{name}|{n}|{threads}|{seconds:.6f}|{n}", flush=True)

# SPDX-FileCopyrightText: 2026 The Jalon authors
# SPDX-License-Identifier: Apache-2.0
"""bench_py4dgeo.py PREFIX [median]: M3C2 of py4dgeo, whose work is C++ with OpenMP.

PREFIX.f64 against PREFIX_second.f64; the protocol is that of driver.h. Mean positions, its default and
faster way, or medians. Building the trees is part of the time."""

import os
import sys
import time

import numpy as np

SAMPLES = 2000
CORE_POINTS = {"m3c2_100k": 100_000, "m3c2_1m": 1_000_000}
prefix, median = os.path.abspath(sys.argv[1]), len(sys.argv) > 2
os.chdir(os.path.dirname(prefix))  # its log file goes where the process stands when it is imported
import py4dgeo  # noqa: E402

peer = "py4dgeo-median" if median else "py4dgeo"
py4dgeo.set_num_threads(int(os.environ.get("OMP_NUM_THREADS", "1")))
reference = np.fromfile(prefix + ".f64").reshape(-1, 3)
compared = np.fromfile(prefix + "_second.f64").reshape(-1, 3)


def run(core_count):
    core = np.ascontiguousarray(reference[:: max(1, len(reference) // core_count)])
    start = time.perf_counter()
    epochs = py4dgeo.Epoch(reference), py4dgeo.Epoch(compared)
    for epoch in epochs:
        epoch.build_kdtree()
    m3c2 = py4dgeo.M3C2(
        epochs=epochs, corepoints=core, cyl_radius=0.15, normal_radii=[0.25], max_distance=1.0, robust_aggr=median
    )
    distances, _ = m3c2.run()
    return time.perf_counter() - start, distances


print(f"ready|{peer}|{','.join(CORE_POINTS)}", flush=True)
for line in sys.stdin:
    name, threads, *path = line.split()
    seconds, distances = run(CORE_POINTS[name])
    if path:
        distances[:: max(1, len(distances) // SAMPLES)].astype(np.float64).tofile(path[0])
    print(f"{peer}|{name}|{len(reference)}|{threads}|{seconds:.6f}|{len(distances)}", flush=True)

# SPDX-FileCopyrightText: 2026 The Jalon authors
# SPDX-License-Identifier: Apache-2.0
"""A first day with two scans of a street: first_day.py BEFORE AFTER RESULTS"""

import pickle
import sys

import numpy as np

import jalon

before, after = jalon.Cloud.read(sys.argv[1]), jalon.Cloud.read(sys.argv[2])
near = before["range"] < 20  # m, as the scanner saw it: a mask, one truth value a point
close = before[near]
print("%d of %d points are nearer than 20 m" % (len(close), len(before)))

planes = jalon.Segmenter("ransac", distance_tolerance_m=0.02).run(close)
for plane in planes[:3]:
    print("plane %d: %.0f m2, sigma %.1f mm, %s" % (plane.label, plane.area, 1000 * plane.sigma, plane.orientation.name))

measured = {"A": (0, 8, 3), "B": (40, 7.75, 9), "C": (20, -8, 4), "D": (60, -7.7, 12)}  # in the scan
known = {"A": (651992.004, 6861000.003, 43.004), "B": (651992.246, 6861040.000, 48.996),
         "C": (652007.997, 6861019.998, 44.004), "D": (652007.701, 6861060.002, 51.995)}  # control points, national
national = jalon.Registrar("targets", sigma_m=0.003).run_targets(known, measured)
for i, target in enumerate(national.residuals):
    name, residual, sigma = national.pair_name(i), 1000 * np.array(target.residual), 1000 * np.array(target.sigma)
    print("%s: residuals %.1f %.1f %.1f mm, sigmas %.1f %.1f %.1f mm" % (name, *residual, *sigma))
shift_sigmas = np.sqrt(np.diag(national.summary.covariance.reshape(6, 6)))[3:]
print("pose %s, sigmas of its shift %.1f %.1f %.1f mm" % (national.summary.verdict.name, *(1000 * shift_sigmas)))

lorry, path = jalon.Gauge(), np.array([np.eye(4), np.eye(4)])
lorry.add_box((2.5, 2.5, 4))
path[:, :3, 3] = (2, 0.9, 2.5), (50, 0.9, 2.5)  # where its middle drives
gap = jalon.gauge_sweep(lorry, path, before).intervals[0]
print("the lorry passes at %.2f m, nearest at x = %.1f m" % (gap.clearance, gap.xyz[0]))

before, after = national.apply(before), national.apply(after)
before.crs = after.crs = "EPSG:2154"
after.write(sys.argv[3] + ".las")
changes = jalon.Comparer("distance").run(before, after)
regions = changes.regions(criterion="threshold", threshold_m=0.3).regions
jalon.report_write_comparison(changes, sys.argv[3] + ".html")
with open(sys.argv[3] + ".pickle", "wb") as file:
    pickle.dump(changes, file)
print("%d changes, the largest of %.1f m2" % (len(regions), regions[0].area))

import geopandas  # of PyPI: pip install geopandas

frame = geopandas.GeoDataFrame.from_features(regions, crs=after.crs)
frame.to_file(sys.argv[3] + ".gpkg")
print(frame[["region", "points", "area", "geometry"]])

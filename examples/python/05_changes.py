# SPDX-FileCopyrightText: 2026 The Jalon authors
# SPDX-License-Identifier: Apache-2.0
"""What has changed between two scans: 05_changes.py BEFORE AFTER"""

import sys

import jalon

before, after = jalon.Cloud.read(sys.argv[1]), jalon.Cloud.read(sys.argv[2])
comparison = jalon.Comparer("distance", local_model="plane", max_distance_m=2).run(before, after)
regions = comparison.regions(criterion="threshold", threshold_m=0.1, min_points=50).regions
for i in range(len(regions)):
    print("region %d: %d points, %.3f m2, mean %.3f m"
          % (i + 1, regions["points"][i], regions["area"][i], regions["mean"][i]))

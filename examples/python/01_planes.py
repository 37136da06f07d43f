# SPDX-FileCopyrightText: 2026 The Jalon authors
# SPDX-License-Identifier: Apache-2.0
"""The planes of a scan: 01_planes.py SCAN"""

import sys

import jalon

cloud = jalon.Cloud.read(sys.argv[1])
segments = jalon.Segmenter("ransac").run(cloud).segments
for i, (area, sigma) in enumerate(zip(segments["area"], segments["sigma"]), 1):
    print("plane %2d: %7.2f m2, sigma %.1f mm" % (i, area, 1000 * sigma))

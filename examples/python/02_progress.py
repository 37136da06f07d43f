# SPDX-FileCopyrightText: 2026 The Jalon authors
# SPDX-License-Identifier: Apache-2.0
"""Points from an array of the program's own, a call with progress, the result without a copy, and a cancel."""

import sys

import numpy

import jalon


def show(fraction, stage):
    print("\r%3.0f %% %s" % (100 * fraction, stage), end="", file=sys.stderr)


SIDE = 1000  # a gentle dome of a million points
line = numpy.arange(SIDE).astype("f4") * numpy.float32(0.01) - numpy.float32(5)
y, x = numpy.meshgrid(line, line, indexing="ij")
xyz = numpy.stack([x, y, numpy.float32(-0.02) * (x * x + y * y)], axis=-1).reshape(-1, 3)

cloud = jalon.Cloud(xyz)
cloud.compute_normals(k=16, progress=show)
print("\nnormal at the top: %.4f %.4f %.4f" % tuple(cloud["normal"][SIDE * SIDE // 2 + SIDE // 2]))


def enough(fraction, stage):
    return fraction < 0.2  # False cancels


try:
    cloud.compute_normals(k=64, progress=enough)
except jalon.CancelledError as cancelled:
    print(cancelled, file=sys.stderr)

# SPDX-FileCopyrightText: 2026 The Jalon authors
# SPDX-License-Identifier: Apache-2.0
"""Clouds for the tests, made once."""

import functools
import os

import jalon

SANITIZED = bool(os.environ.get("JALON_SANITIZED"))  # times and resident memory mean nothing then


@functools.lru_cache(None)
def box_model():
    return jalon.scene_create(name="box")


@functools.lru_cache(None)
def box_cloud():
    return jalon.Scanner("sample", spacing_m=0.1, seed=7).run(box_model())


@functools.lru_cache(None)
def large_cloud(points=3000000):
    """So many points that normals take seconds."""
    import numpy
    return jalon.Cloud(numpy.random.default_rng(1).random((points, 3)) * [50, 50, 5])

#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The Jalon authors
# SPDX-License-Identifier: Apache-2.0
"""Writes shapiro_wilk_table.inc: W and p of SciPy for samples that normality_test.cpp makes again.

    shapiro_wilk_fixture.py > shapiro_wilk_table.inc

A sample follows from its kind, size and seed by the generator of Knuth's MMIX, so that values need not be kept.
"""

import math

import scipy
from scipy import stats

MASK = 2 ** 64 - 1


def uniforms(seed, n):
    """In (0, 1), 53 bits."""
    state = seed
    for _ in range(n):
        state = (state * 6364136223846793005 + 1442695040888963407) & MASK
        yield ((state >> 11) + 0.5) * 2.0 ** -53


def normals(seed, n):
    u = list(uniforms(seed, 2 * n))
    return [math.sqrt(-2 * math.log(u[2 * i])) * math.cos(2 * math.pi * u[2 * i + 1]) for i in range(n)]


KINDS = [
    lambda seed, n: normals(seed, n),
    lambda seed, n: list(uniforms(seed, n)),
    lambda seed, n: [-math.log(u) for u in uniforms(seed, n)],
    lambda seed, n: [math.floor(10 * u) for u in uniforms(seed, n)],  # ties
    lambda seed, n: [1e6 + 0.01 * v + (1 if i % 10 == 0 else 0) * 0.03 for i, v in enumerate(normals(seed, n))],
]
SIZES = [3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 20, 31, 54, 100, 333, 1000, 1999, 3000, 4999, 5000]


def main():
    print("// SPDX-FileCopyrightText: 2026 The Jalon authors")
    print("// SPDX-License-Identifier: Apache-2.0")
    print("// SciPy %s, scipy.stats.shapiro: kind, size, seed, W, p; by shapiro_wilk_fixture.py." % scipy.__version__)
    print("// clang-format off")
    for kind, sample in enumerate(KINDS):
        for i, n in enumerate(SIZES):
            seed = 1000 * kind + i + 1
            result = stats.shapiro(sample(seed, n))
            print("{%d, %d, %d, %.12g, %.12g}," % (kind, n, seed, result.statistic, result.pvalue))


if __name__ == "__main__":
    main()

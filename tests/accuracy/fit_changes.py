# SPDX-FileCopyrightText: 2026 The Jalon authors
# SPDX-License-Identifier: Apache-2.0
r"""Fits the weights of src/compare/changes/confidence_weights.h and prints that file; needs numpy.

    JALON_FULL=1 JALON_CHANGE_SEEDS=1-10 JALON_CHANGE_ROWS=rows.txt \
        build/release/tests/accuracy/accuracy -tc='change_confidence__of_developed_kinds'
    python3 tests/accuracy/fit_changes.py rows.txt > src/compare/changes/confidence_weights.h

A row, of one statement: the seed, what it says (0 came, 1 went, 2 moved, 3 gave way), whether it is right, the features.
Logistic regression for each of three families (came and went are one) with a Gaussian prior (Bishop 2006, 4.3.4 and
5.5) on the weights of standardised features; its width is that of the least loss over five parts of the seeds, each told
by what was fitted to the other four.
"""

import sys

import numpy as np

FAMILIES = [("came or went", (0, 1)), ("moved", (2,)), ("gave way", (3,))]
PRIORS = [0.0003, 0.001, 0.003, 0.01, 0.03]  # of the squared weights, a row
PARTS = 5
STEPS = 60


def probabilities(w, x):
    return 1 / (1 + np.exp(-np.clip(x @ w, -40, 40)))


def loss_of(p, y):
    return -np.mean(np.log(np.maximum(1e-12, np.where(y > 0, p, 1 - p))))


def fitted(x, y, prior):
    """Newton's method; no prior on the first weight, whose feature is 1."""
    w = np.zeros(x.shape[1])
    keep = prior * len(x) * np.eye(x.shape[1])
    keep[0, 0] = 1e-6
    for _ in range(STEPS):
        p = probabilities(w, x)
        gradient = x.T @ (p - y) + keep @ w
        curvature = (x.T * (p * (1 - p))) @ x + keep + 1e-9 * np.eye(len(w))
        step = np.linalg.solve(curvature, gradient)
        w = w - step * min(1, 2 / max(1e-9, np.abs(step).max()))
    return w


def calibration(p, y):
    order = np.argsort(p, kind="stable")
    return sum(abs(p[b].sum() - y[b].sum()) for b in np.array_split(order, 10)) / len(p)


def main():
    rows = [line.split("#")[0].split() for path in sys.argv[1:] for line in open(path, encoding="utf-8")]
    table = np.array(rows, dtype=float)
    seed, said, right, features = table[:, 0].astype(int), table[:, 1], table[:, 2], table[:, 3:]
    part = seed % PARTS
    all_told, all_right, weights = [], [], []
    for name, classes in FAMILIES:
        of = np.isin(said, classes)
        x, y, fold = features[of], right[of], part[of]
        mean, width = x.mean(axis=0), x.std(axis=0)
        mean[0], width[0] = 0, 1
        width[width < 1e-6] = 1e9
        z = (x - mean) / width
        best = None
        for prior in PRIORS:
            told = np.zeros(len(z))
            for k in range(PARTS):
                if (fold == k).any():
                    told[fold == k] = probabilities(fitted(z[fold != k], y[fold != k], prior), z[fold == k])
            loss = loss_of(told, y)
            if best is None or loss < best[0]:
                best = (loss, prior, told)
        base = loss_of(np.full(len(y), y.mean()), y)
        print(f"{name}: {len(y)} statements, {y.mean():.3f} right, prior {best[1]}, loss {best[0]:.4f} (of the share alone"
              f" {base:.4f})", file=sys.stderr)
        w = fitted(z, y, best[1])
        print("   standardised " + " ".join(f"{v:.2f}" for v in w), file=sys.stderr)
        w = w / width
        w[0] -= (w[1:] * mean[1:]).sum()
        weights.append((name, w))
        all_told.append(best[2])
        all_right.append(y)
    told, y = np.concatenate(all_told), np.concatenate(all_right)
    for limit in (0, 0.3, 0.5, 0.9):
        kept = told >= limit
        print(f"told at least {limit}: {kept.sum()} statements, right {y[kept].mean():.4f}, calibration error"
              f" {calibration(told[kept], y[kept]):.4f}", file=sys.stderr)
    print("""// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "compare/changes/change_features.h"

namespace jalon {

/// Of each family of statements, each feature. Written by tests/accuracy/fit_changes.py, which says from what.
// clang-format off
inline constexpr double kConfidenceWeights[kChangeFamilies][kChangeFeatures] = {""")
    for name, w in weights:
        print(f"    {{  // {name}")
        for i in range(0, len(w), 8):
            print("        " + " ".join(f"{v:.4f}," for v in w[i:i + 8]))
        print("    },")
    print("""};
// clang-format on

}  // namespace jalon""")


main()

# SPDX-FileCopyrightText: 2026 The Jalon authors
# SPDX-License-Identifier: Apache-2.0
r"""Fits the weights of src/compare/changes/confidence_weights.h and prints that file; needs numpy.

    JALON_FULL=1 JALON_CHANGE_SEEDS=1-12 JALON_CHANGE_KIND=-street JALON_CHANGE_ROWS=rows.txt \
        build/release/tests/accuracy/accuracy -tc='change_confidence__of_developed_kinds'
    JALON_FULL=1 JALON_CHANGE_SEEDS=1-6 JALON_CHANGE_KIND=street JALON_CHANGE_ROWS=rows.txt \
        build/release/tests/accuracy/accuracy -tc='change_confidence__of_developed_kinds'
    OMP_NUM_THREADS=1 python3 tests/accuracy/fit_changes.py rows.txt > src/compare/changes/confidence_weights.h

A family behind --keep, as "--keep moved", has the weights that the header holds, and none for features that it lacks;
one behind --extend its score by these as one feature, beside those that it lacks: where few kinds tell of what is new.

A row, of one statement: the seed, what it says (0 came, 1 went, 2 moved, 3 gave way), whether it is right, the features,
and behind # the kind of scene, threshold, stations, confidence, whether it is about what changed, and right by class.
Logistic regression for each of three families (came and went are one) with a Gaussian prior (Bishop 2006, 4.3.4 and
5.5) on the weights of standardised features; its width is that of the least loss over the kinds of scenes, each told by
what was fitted to the others: the weights are for kinds that they have not seen. What is told of such a kind is too sure
of itself: the scores are scaled and shifted by what fits those told (Platt 1999).
"""

import argparse
import pathlib
import re
import sys

import numpy as np

HEADER = pathlib.Path(__file__).parents[2] / "src/compare/changes/confidence_weights.h"
FAMILIES = [("came or went", (0, 1)), ("moved", (2,)), ("gave way", (3,))]
PRIORS = [0.001, 0.003, 0.01, 0.03, 0.1, 0.3]  # of the squared weights, a row
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


def weights_of(x, y, prior):
    """Of the features as they are; the prior is on those standardised over these statements."""
    mean, width = x.mean(axis=0), x.std(axis=0)
    mean[0], width[0] = 0, 1
    width[width < 1e-6] = 1e9
    w = fitted((x - mean) / width, y, prior) / width
    w[0] -= (w[1:] * mean[1:]).sum()
    return w


def calibration(p, y):
    order = np.argsort(p, kind="stable")
    return sum(abs(p[b].sum() - y[b].sum()) for b in np.array_split(order, 10)) / len(p)


def scores(p):
    p = np.clip(p, 1e-6, 1 - 1e-6)
    return np.log(p / (1 - p))


def scaled(p, y):
    """A scale and a shift of the scores of what was told of kinds that were left out."""
    x = np.column_stack([np.ones(len(p)), scores(p)])
    shift, scale = fitted(x, y, 0)
    return shift, scale


def as_it_stands(name):
    """The weights of a family in the header."""
    numbers = re.search(r"// " + name + r"\n([^}]*)\}", HEADER.read_text(encoding="utf-8")).group(1)
    return np.array([float(v) for v in numbers.replace(",", " ").split()])


def extended(x, stood):
    """One, the score as it stands, and the features that it lacks."""
    return np.column_stack([np.ones(len(x)), x[:, : len(stood)] @ stood, x[:, len(stood) :]])


def of_features(w, stood):
    """Weights of extended features as weights of the features."""
    out = np.concatenate([w[1] * stood, w[2:]])
    out[0] += w[0]
    return out


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("rows", nargs="+")
    for option in ("--keep", "--extend"):
        parser.add_argument(option, action="append", default=[], choices=[name for name, _ in FAMILIES])
    asked = parser.parse_args()
    lines = [line.split("#") for path in asked.rows for line in open(path, encoding="utf-8")]
    table = np.array([line[0].split() for line in lines], dtype=float)
    said, right, features = table[:, 1], table[:, 2], table[:, 3:]
    kind = np.array([" ".join(line[1].split()[:-5]) for line in lines])
    all_told, all_right, weights = [], [], []
    for name, classes in FAMILIES:
        stood = as_it_stands(name)
        if name in asked.keep:
            weights.append((name, np.pad(stood, (0, features.shape[1] - len(stood)))))
            continue
        of = np.isin(said, classes)
        x = extended(features[of], stood) if name in asked.extend else features[of]
        y, fold = right[of], kind[of]
        best = None
        for prior in PRIORS:
            told = np.zeros(len(y))
            for k in np.unique(fold):
                told[fold == k] = probabilities(weights_of(x[fold != k], y[fold != k], prior), x[fold == k])
            loss = loss_of(told, y)
            if best is None or loss < best[0]:
                best = (loss, prior, told)
        base = loss_of(np.full(len(y), y.mean()), y)
        print(f"{name}: {len(y)} statements, {y.mean():.3f} right, prior {best[1]}, loss {best[0]:.4f} (of the share alone"
              f" {base:.4f})", file=sys.stderr)
        shift, scale = scaled(best[2], y)
        print(f"   scores scaled by {scale:.3f}, shifted by {shift:.3f}", file=sys.stderr)
        w = scale * weights_of(x, y, best[1])
        w[0] += shift
        print("   standardised " + " ".join(f"{v:.2f}" for v in w * x.std(axis=0)), file=sys.stderr)
        weights.append((name, of_features(w, stood) if name in asked.extend else w))
        all_told.append(probabilities(np.array([shift, scale]), np.column_stack([np.ones(len(y)), scores(best[2])])))
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

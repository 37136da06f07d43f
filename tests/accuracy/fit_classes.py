# SPDX-FileCopyrightText: 2026 The Jalon authors
# SPDX-License-Identifier: Apache-2.0
"""Fits the weights of src/modelling/facade/class_weights.h and prints that file; needs numpy.

    JALON_GRAMMAR_SEEDS=1-100 JALON_CLASS_ROWS=rows.txt build/release/tests/accuracy/accuracy -tc='opening_classes__*'
    python3 tests/accuracy/fit_classes.py rows.txt > src/modelling/facade/class_weights.h

A row: the true classes, comma-separated where a label does not tell several apart, then the features. Multinomial
logistic regression with a Gaussian prior (Bishop 2006, 4.3.4 and 5.5), whose width is that of the least loss over five
parts of the rows, each told by what was fitted to the other four; rows stay in the order of their seeds, so that the
parts share no facade but one. A row with several classes counts for what they have together.

    python3 tests/accuracy/fit_classes.py --from old/class_weights.h rows.txt > src/modelling/facade/class_weights.h

The weights of an earlier fit stay, and those of features that it lacks, flags from 0 to 1, are added. So rows of kinds
that know such a feature change nothing else: what they show nothing of (glass of real shop fronts) is told as before.
"""

import re
import sys

import numpy as np

CLASSES = ["opening", "window", "door", "gateway", "shop_front", "vent", "recess"]
PRIORS = [0.001, 0.002, 0.003, 0.005]  # of the squared weights of standardised features, a row
ADDED_PRIORS = [0.0001, 0.0003, 0.001, 0.003]  # the same of weights of flags
PARTS = 5
STEPS = 600


def read(paths):
    allowed, features = [], []
    for path in paths:
        for line in open(path, encoding="utf-8"):
            words = line.split()
            allowed.append([1.0 if c in words[0].split(",") else 0.0 for c in CLASSES])
            features.append([float(w) for w in words[1:]])
    return np.array(features), np.array(allowed)


def probabilities(weights, x):
    score = x @ weights.T
    score = np.exp(score - score.max(axis=1, keepdims=True))
    return score / score.sum(axis=1, keepdims=True)


def fitted(x, allowed, prior, earlier):
    """Accelerated gradient descent (Nesterov 1983); the step by the largest curvature of a softmax. The columns of
    earlier stand as they are."""
    had = earlier.shape[1]
    weights = np.zeros((len(CLASSES), x.shape[1]))
    weights[:, :had] = earlier
    ahead = weights
    free = np.ones_like(weights)
    free[:, :had] = 0
    kept = free.copy()
    kept[:, 0] = 0  # the first feature is 1: no prior on it
    fitted_to = x[:, had:]
    step = 1 / (0.5 * np.linalg.norm(fitted_to.T @ fitted_to / len(x), 2) + prior)
    for k in range(STEPS):
        p = probabilities(ahead, x)
        target = p * allowed
        target /= np.maximum(1e-12, target.sum(axis=1, keepdims=True))
        gradient = free * ((p - target).T @ x) / len(x) + prior * kept * ahead
        new = ahead - step * gradient
        ahead = new + k / (k + 3) * (new - weights)
        weights = new
    return weights


def written(path):
    rows = re.findall(r"\{  // \w+\n(.*?)\},", open(path, encoding="utf-8").read(), re.S)
    return np.array([[float(w) for w in row.replace("\n", " ").split(",") if w.strip()] for row in rows])


def main():
    is_added = sys.argv[1] == "--from"
    earlier = written(sys.argv[2]) if is_added else np.zeros((len(CLASSES), 0))
    x, allowed = read(sys.argv[3 if is_added else 1:])
    mean, width = x.mean(axis=0), x.std(axis=0)
    mean[0], width[0] = 0, 1
    width[width < 1e-6] = 1
    if is_added:
        mean[:], width[:] = 0, 1
    z = (x - mean) / width
    part = np.arange(len(z)) * PARTS // len(z)
    best = None
    for prior in ADDED_PRIORS if is_added else PRIORS:
        told = np.zeros_like(allowed)
        for k in range(PARTS):
            told[part == k] = probabilities(fitted(z[part != k], allowed[part != k], prior, earlier), z[part == k])
        loss = -np.mean(np.log(np.maximum(1e-12, (told * allowed).sum(axis=1))))
        likeliest = told.argmax(axis=1)
        right = allowed[np.arange(len(z)), likeliest] > 0
        print(f"prior {prior}: loss {loss:.4f}, likeliest right {right.mean():.4f}", file=sys.stderr)
        for limit in (0.5, 0.6, 0.7, 0.8, 0.9):
            sure = (told.max(axis=1) >= limit) & (likeliest > 0)
            print(f"  limit {limit}: {sure.mean():.3f} have a class, {right[sure].mean():.4f} of them right",
                  file=sys.stderr)
        if best is None or loss < best[0]:
            best = (loss, prior)
    weights = fitted(z, allowed, best[1], earlier)
    if not is_added:
        weights -= weights.mean(axis=0)  # the same probabilities, the smallest numbers
    weights = weights / width
    weights[:, 0] -= weights[:, 1:] @ mean[1:]
    print("""// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "modelling/facade/opening_features.h"

namespace jalon {

/// Of each kind, each feature. Written by tests/accuracy/fit_classes.py, which says from what.
// clang-format off
inline constexpr double kClassWeights[kOpeningKinds][kOpeningFeatures] = {""")
    for name, row in zip(CLASSES, weights):
        print(f"    {{  // {name}")
        for i in range(0, len(row), 8):
            print("        " + " ".join(f"{w:.4f}," for w in row[i:i + 8]))
        print("    },")
    print("""};
// clang-format on

}  // namespace jalon""")


main()

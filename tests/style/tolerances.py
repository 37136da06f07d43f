# SPDX-FileCopyrightText: 2026 The Jalon authors
# SPDX-License-Identifier: Apache-2.0
"""Tolerances that pass anything: doctest's Approx adds its scale of 1 to the number before it takes the epsilon of it, so that
Approx(0.003).epsilon(0.05) takes 0 and 0.05."""

import re

from source import read

# What is compared (with up to two pairs of parentheses in it), and what is asked of Approx.
APPROX = re.compile(r"Approx\(((?:[^()]|\((?:[^()]|\([^()]*\))*\))*)\)((?:\s*\.\w+\([^()]*\))*)")
EPSILON = re.compile(r"\.epsilon\(([-+.\de]+)\)")
NUMBER = re.compile(r"[-+.\de]+")
USUAL_EPSILON = 1.1920929e-5  # of doctest: 100 x that of float
WIDEST = 0.5  # of the number
WIDEST_OF_UNKNOWN = 1e-3  # a number that is not written here may be as small as a millimetre


def is_wide(number, rest):
    """Whether Approx(number) with what is asked of it takes a range as wide as the number."""
    given = EPSILON.search(rest)
    epsilon = float(given.group(1)) if given else USUAL_EPSILON
    if ".scale" in rest:
        return False
    if not NUMBER.fullmatch(number):
        return epsilon > WIDEST_OF_UNKNOWN
    return epsilon * (1 + abs(float(number))) > WIDEST * abs(float(number)) > 0


def wide_tolerances(files):
    for path in files:
        if not path.startswith("tests/") or not path.endswith((".cpp", ".h")):
            continue
        text = read(path)
        for found in APPROX.finditer(text):
            if is_wide(found.group(1), found.group(2)):
                yield "%s:%d: %s takes a wide range: .scale(0)" % (path, text.count("\n", 0, found.start()) + 1, found.group(0))

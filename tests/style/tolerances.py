# SPDX-FileCopyrightText: 2026 The Jalon authors
# SPDX-License-Identifier: Apache-2.0
"""Tolerances that pass anything: doctest's Approx adds its scale of 1 to the number before it takes the epsilon of it, so that
Approx(0.003).epsilon(0.05) takes 0 and 0.05."""

import re

from source import read

APPROX = re.compile(r"Approx\(([-+.\de]+)\)((?:\s*\.\w+\([^()]*\))*)")
EPSILON = re.compile(r"\.epsilon\(([-+.\de]+)\)")
USUAL_EPSILON = 1.1920929e-5  # of doctest: 100 x that of float
WIDEST = 0.5  # of the number


def wide_tolerances(files):
    for path in files:
        if not path.startswith("tests/") or not path.endswith((".cpp", ".h")):
            continue
        text = read(path)
        for found in APPROX.finditer(text):
            number, rest = abs(float(found.group(1))), found.group(2)
            given = EPSILON.search(rest)
            epsilon = float(given.group(1)) if given else USUAL_EPSILON
            scale = 0 if ".scale" in rest else 1
            if number > 0 and epsilon * (scale + number) > WIDEST * number:
                yield "%s:%d: %s takes a wide range: .scale(0)" % (path, text.count("\n", 0, found.start()) + 1, found.group(0))

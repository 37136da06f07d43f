# SPDX-FileCopyrightText: 2026 The Jalon authors
# SPDX-License-Identifier: Apache-2.0
"""M3C2 written once more, from the literature, point by point, sharing nothing with the library.

Lague, Brodu & Leroux (2013): (1) at each core point the normal of the plane through the points of a ball, the third
principal axis; of several balls the flattest; (2) the points of each epoch in a cylinder along it; (3) the mean or median of
their places along the axis, compared minus reference; (4) the level of detection, q sqrt(v1 + v2) + q_inf reg. Where the
level has few points, q is Student's at the degrees of freedom of Welch (1947) and Satterthwaite (1946); v of a mean is
s^2 / n; v of a median comes from order statistics (Price & Bonett 2001), scaled as jalon/comparer.h says.
"""

import math
from statistics import NormalDist

import numpy as np

COMPARED, NOTHING_NEAR, TOO_FEW_POINTS = 0, 4, 5
NORMAL = NormalDist()


def of_student(t, dof):
    """P(|T| < t): the regularised incomplete beta function by its continued fraction (Lentz; Press et al., 6.4)."""
    if t * t > dof:
        return 1 - beta_share(dof / (dof + t * t), dof / 2, 0.5)
    return beta_share(t * t / (dof + t * t), 0.5, dof / 2)


def beta_share(x, a, b):
    if x > (a + 1) / (a + b + 2):
        return 1 - beta_share(1 - x, b, a)
    front = math.exp(math.lgamma(a + b) - math.lgamma(a) - math.lgamma(b) + a * math.log(x) + b * math.log1p(-x)) / a
    c, d = 1.0, 1 / (1 - (a + b) * x / (a + 1))
    fraction = d
    for m in range(1, 5000):
        for step in (m * (b - m) * x / ((a + 2 * m - 1) * (a + 2 * m)),
                     -(a + m) * (a + b + m) * x / ((a + 2 * m) * (a + 2 * m + 1))):
            d, c = 1 / (1 + step * d), 1 + step / c
            fraction *= c * d
        if abs(c * d - 1) < 1e-16:
            break
    return front * fraction


def quantile(dof, confidence):
    """Of Student's distribution, two-sided: by Newton's steps from the normal one, which is below; the function is concave."""
    t = NORMAL.inv_cdf(0.5 + confidence / 2)
    if math.isinf(dof):
        return t
    scale = math.exp(math.lgamma((dof + 1) / 2) - math.lgamma(dof / 2)) / math.sqrt(dof * math.pi)
    for _ in range(50):
        step = (confidence - of_student(t, dof)) / (2 * scale * (1 + t * t / dof) ** (-(dof + 1) / 2))
        t += step
        if abs(step) < 1e-14 * t:
            break
    return t


def plane_of(offsets):
    """(normal, flatness) of points about a core point; None: fewer than three, or on a line."""
    if len(offsets) < 3:
        return None
    values, vectors = np.linalg.eigh(np.cov(offsets.T, bias=True))
    if values[1] <= 1e-12 * values[2]:
        return None
    return vectors[:, 0], max(0.0, values[0]) / values.sum()


def normal_at(core, source, given, s):
    """(normal, radius of its ball), or None."""
    if s["normals"] == "vertical":
        return np.array([0.0, 0, 1]), 0.0
    if s["normals"] == "given":
        return given / np.linalg.norm(given), 0.0
    offsets = source - core
    squares = (offsets ** 2).sum(1)
    planes = []
    for radius in sorted(s.get("normal_radii_m") or [s["normal_radius_m"]]):
        found = plane_of(offsets[squares <= radius * radius])
        if found is not None:
            planes.append((found[1], radius, found[0]))
    if not planes:
        return None
    _, radius, normal = min(planes, key=lambda plane: plane[0])
    if s["normals"] == "horizontal":
        normal = np.array([normal[0], normal[1], 0]) / np.hypot(normal[0], normal[1])
    toward = np.array(s["viewpoint"]) - core if s["orientation"] == "point" else np.array(s["orientation_direction"])
    return (-normal if toward @ normal < 0 else normal), radius


def along(core, normal, points, s):
    offsets = points - core
    places = offsets @ normal
    across = offsets - np.outer(places, normal)
    inside = ((across ** 2).sum(1) <= s["cylinder_radius_m"] ** 2) & (np.abs(places) <= s["max_depth_m"])
    return np.sort(places[inside])


def position(places, s):
    """(place, spread, variance of the place, degrees of freedom)"""
    n = len(places)
    if s["position"] == "mean":
        return places.mean(), places.std(ddof=1), places.var(ddof=1) / n, n - 1
    rank = max(1, math.floor((n + 1) / 2 - math.sqrt(n) + 0.5))
    scatter_dof = math.sqrt(n) + 2
    sigma_of_median = math.sqrt(math.pi / 2 / (n + (0.46 if n % 2 else 1.36)))
    expected = 2 * NORMAL.inv_cdf((n + 5 / 8 - rank) / (n + 1 / 4)) * math.sqrt(1 + 1 / (2 * scatter_dof))
    sigma = (places[n - rank] - places[rank - 1]) * sigma_of_median / expected
    quartiles = np.percentile(places, [25, 75])
    return np.median(places), (quartiles[1] - quartiles[0]) / (2 * NORMAL.inv_cdf(0.75)), sigma ** 2, scatter_dof


def level(a, b, core, normal, s):
    of_pose = 0.0
    if s.get("registration_covariance"):
        arm = np.concatenate([np.cross(core - s["registration_centre"], normal), normal])
        of_pose = arm @ np.reshape(s["registration_covariance"], (6, 6)) @ arm
    variance = a[2] + b[2] + of_pose
    sampled = a[2] ** 2 / a[3] + b[2] ** 2 / b[3]
    dof = variance ** 2 / sampled if sampled else math.inf
    return quantile(dof, s["confidence"]) * math.sqrt(variance) + quantile(math.inf, s["confidence"]) * s["registration_error_m"]


def m3c2(reference, compared, core, given, s):
    """A row a core point: (status, distance, level, normal, ball's radius, counts, spreads)."""
    rows, nan = [], math.nan
    source = {"reference": reference, "compared": compared, "core": core}[s["normals_from"]]
    for i, place in enumerate(core):
        found = normal_at(place, source, given[i], s)
        if found is None:
            rows.append((TOO_FEW_POINTS, nan, nan, [nan] * 3, 0.0, [0, 0], [nan, nan]))
            continue
        normal, radius = found
        sides = [along(place, normal, points, s) for points in (reference, compared)]
        counts = [len(side) for side in sides]
        if min(counts) < s["min_points"]:
            rows.append((TOO_FEW_POINTS if min(counts) else NOTHING_NEAR, nan, nan, normal, radius, counts, [nan, nan]))
            continue
        a, b = (position(side, s) for side in sides)
        rows.append((COMPARED, b[0] - a[0], level(a, b, place, normal, s), normal, radius, counts, [a[1], b[1]]))
    return [np.array(column) for column in zip(*rows)]

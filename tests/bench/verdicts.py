# SPDX-FileCopyrightText: 2026 The Jalon authors
# SPDX-License-Identifier: Apache-2.0
"""What a row of times is worth: the fastest peer, the ratio to it, and whether all its peers were there."""

import os
import statistics

# What Jalon must reach, as fastest peer / Jalon: at least as fast, LAS no slower than 1.5 times
# LASzip; and the goals: twice as fast, LAS 0.15 s where LASzip takes 0.22 s, planes 1.5 s where CGAL
# takes 3.2 s, region growing 1.5 s where PCL takes 4.3 s.
GATE = {"las0": 1 / 1.5, "las3": 1 / 1.5}
GOAL = {"las0": 0.22 / 0.15, "las3": 0.22 / 0.15, "planes": 3.2 / 1.5, "region_growing": 4.3 / 1.5}
CLOCK_TICK_S = 1 / os.sysconf("SC_CLK_TCK")  # processor seconds are counted in these

TREES = ["small_gicp", "nanoflann", "nanoflann-f64", "PCL", "CGAL", "Open3D", "Open3D-tensor"]
# The peers that a row is measured beside; an operation that no peer here does is not named.
PEERS = {
    "las0": ["LASzip", "LASzip-all"],
    "las3": ["LASzip", "LASzip-all"],
    "laz0": ["LASzip", "LASzip-all"],
    "laz3": ["LASzip", "LASzip-all"],
    "index": TREES,
    "knn16": [peer for peer in TREES if peer != "Open3D"],  # its old tree has no batch form
    "normals16": [peer for peer in TREES if not peer.startswith("nanoflann")],
    "voxel5cm": [peer for peer in TREES if not peer.startswith("nanoflann")],
    "c2c": TREES,
    "m3c2_100k": ["py4dgeo", "py4dgeo-median"],
    "m3c2_1m": ["py4dgeo", "py4dgeo-median"],
    "c2m_13k": ["CGAL", "Open3D"],
    "c2m_1m": ["CGAL", "Open3D"],
    "icp": ["small_gicp", "small_gicp-gicp", "small_gicp-cauchy", "PCL", "Open3D", "Open3D-tukey", "Open3D-scales"],
    "planes": ["CGAL"],
    "region_growing": ["PCL"],
}
ABSENT = "PEER ABSENT"


def absent(operation, times, wanted=None):
    """Who should have times in this row and has none: Jalon itself, or a peer; wanted: the only peers that were asked for."""
    peers = [peer for peer in PEERS.get(operation, []) if wanted is None or peer in wanted]
    return [name for name in ["Jalon"] + peers if not times.get(name)]


def median_ratio(peer, jalon):
    return statistics.median(p / max(j, CLOCK_TICK_S) for p, j in zip(peer, jalon))


def verdict(operation, times, processor, wanted=None):
    """The row of the table: fastest peer, ratio to it and its range over the rounds; the ratio of processor seconds.

    A row that lost a peer has no verdict: the fastest of those left may not be the fastest."""
    medians = {peer: statistics.median(values) for peer, values in times.items()}
    peers = {peer: value for peer, value in medians.items() if peer != "Jalon"}
    row = {"operation": operation, "medians": medians, "times": times, "processor": processor}
    if "Jalon" in medians and peers:
        best = min(peers, key=peers.get)
        ratios = [peer / jalon for peer, jalon in zip(times[best], times["Jalon"])]
        ratio = statistics.median(ratios)
        gate, goal = GATE.get(operation, 1.0), GOAL.get(operation, 2.0)
        mark = "GOAL" if ratio >= goal else "PASS" if ratio >= gate else "FAIL"
        row["processor_ratio"] = median_ratio(processor[best], processor["Jalon"])
        row.update(best=best, ratio=ratio, lowest=min(ratios), highest=max(ratios), mark=mark)
    if missing := absent(operation, times, wanted):
        row.update(mark=ABSENT, absent=missing)
    return row


def summary(marks, differing):
    """The last line and whether the run is good: nothing failed, nobody was absent, no result was wrong."""
    text = "%d at the goal, %d passed, %d failed, %d without a peer, %d results differ" % (
        marks.count("GOAL"), marks.count("PASS"), marks.count("FAIL"), marks.count(ABSENT), differing)
    return text, not (marks.count("FAIL") or marks.count(ABSENT) or differing)

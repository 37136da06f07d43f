# SPDX-FileCopyrightText: 2026 The Jalon authors
# SPDX-License-Identifier: Apache-2.0
"""An EPT data set in its binary form read by nothing but its definition (entwine.io/entwine-point-tile.html) and Python's
struct: check_ept.py EPT.JSON SCAN.CSV COLUMN=DIMENSION ...

The CSV has the same points in any order, in steps of the data set. Coordinates come back to half a step, fields as they are; the hierarchy's
numbers add up to the points, each node's to its file, and each point lies in its node's cell."""

import csv
import json
import math
import pathlib
import struct
import sys

CODES = {"signed": "bhiq", "unsigned": "BHIQ", "float": "  fd"}


def code_of(dimension):
    return CODES[dimension["type"]][dimension["size"].bit_length() - 1]


def nodes_of(folder, name="0-0-0-0"):
    """Name and number of points of each node, following the files of the hierarchy."""
    for key, count in json.loads((folder / "ept-hierarchy" / (name + ".json")).read_text()).items():
        if count == -1:
            yield from nodes_of(folder, key)
        else:
            yield key, count


def cell_of(index, key):
    level, *number = [int(part) for part in key.split("-")]
    edge = (index["bounds"][3] - index["bounds"][0]) / 2**level
    low = [index["bounds"][k] + edge * number[k] for k in range(3)]
    return low, [value + edge for value in low]


def points_of(folder, index):
    schema = index["schema"]
    record = struct.Struct("<" + "".join(code_of(dimension) for dimension in schema))
    slack = 1e-6 * (index["bounds"][3] - index["bounds"][0])
    for key, count in nodes_of(folder):
        if count == 0:
            continue
        data = (folder / "ept-data" / (key + ".bin")).read_bytes()
        if len(data) != count * record.size:
            sys.exit("%s: %d bytes of %d points" % (key, len(data), count))
        low, high = cell_of(index, key)
        for values in record.iter_unpack(data):
            point = {d["name"]: v * d.get("scale", 1) + d.get("offset", 0) if "scale" in d else v for d, v in zip(schema, values)}
            at = [point[axis] for axis in "XYZ"]
            if any(not low[k] - slack <= at[k] <= high[k] + slack for k in range(3)):
                sys.exit("%s: a point at %s outside of its cell" % (key, at))
            if any(not index["boundsConforming"][k] <= at[k] <= index["boundsConforming"][k + 3] for k in range(3)):
                sys.exit("%s: a point at %s outside of boundsConforming" % (key, at))
            yield point


def main(path, scan, *pairs):
    path = pathlib.Path(path)
    index = json.loads(path.read_text())
    if [index["dataType"], index["hierarchyType"], index["span"]] != ["binary", "json", 32]:
        sys.exit("another kind of data set")
    points = list(points_of(path.parent, index))
    names = [pair.split("=") for pair in pairs]
    with open(scan, newline="") as file:
        rows = list(csv.DictReader(file))
    if not index["points"] == len(points) == len(rows):
        sys.exit("%d points by the index, %d in the nodes, %d in the scan" % (index["points"], len(points), len(rows)))
    steps = {d["name"]: d["scale"] for d in index["schema"] if "scale" in d}
    ours = sorted([tuple(round(p[a] / steps[a]) for a in "XYZ") + tuple(p[d] for _, d in names) for p in points])
    given = sorted([tuple(round(float(r[a]) / steps[a.upper()]) for a in "xyz") + tuple(float(r[c]) for c, _ in names) for r in rows])
    if ours != given:
        sys.exit("the points are others: %s, %s" % next(pair for pair in zip(ours, given) if pair[0] != pair[1]))
    for dimension in index["schema"]:
        values = [point[dimension["name"]] for point in points if math.isfinite(point[dimension["name"]])]
        if "minimum" in dimension and (dimension["minimum"], dimension["maximum"]) != (min(values), max(values)):
            sys.exit("the extremes of %s are others" % dimension["name"])
        if "counts" in dimension and {c["value"]: c["count"] for c in dimension["counts"]} != {v: values.count(v) for v in set(values)}:
            sys.exit("the counts of %s are others" % dimension["name"])
    print("%d points of %d nodes" % (len(points), sum(1 for _ in nodes_of(path.parent))))


if __name__ == "__main__":
    main(*sys.argv[1:])

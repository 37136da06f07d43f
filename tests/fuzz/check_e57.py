# SPDX-FileCopyrightText: 2026 The Jalon authors
# SPDX-License-Identifier: Apache-2.0
"""E57 files of Jalon read by pye57 (libE57Format), and those of pye57 read by Jalon."""

import numpy
import pye57

POINTS = 30000  # several packets
NEAR_M = 5e-9   # two turns at coordinates of seven digits


def cloud_of(random):
    xyz = random.uniform(-50, 50, (POINTS, 3)) + (652000, 6861000, 100)
    fields = {"intensity": random.uniform(0, 1, POINTS).astype("f4"), "row": random.integers(0, 900, POINTS).astype("u4"),
              "column": random.integers(0, 3000, POINTS).astype("u4"), "label": random.integers(-5, 90, POINTS).astype("i4")}
    fields.update((name, random.integers(0, 256, POINTS).astype("u1")) for name in ("red", "green", "blue"))
    return xyz, fields


SEEN = {"intensity": "intensity", "colorRed": "red", "colorGreen": "green", "colorBlue": "blue", "rowIndex": "row",
        "columnIndex": "column"}


def far(a, b):
    return float(numpy.abs(numpy.asarray(a, "f8") - numpy.asarray(b, "f8")).max())


def seen_by_pye57(path, xyz, fields):
    file = pye57.E57(str(path))
    if file.scan_count != 1 or file.get_header(0).point_count != len(xyz):
        yield "%d scans, %d points" % (file.scan_count, file.get_header(0).point_count)
        return
    data = file.read_scan(0, intensity=True, colors=True, row_column=True, ignore_missing_fields=True)
    places = numpy.stack([data["cartesian" + axis] for axis in "XYZ"], 1)
    if far(places, xyz) > NEAR_M:
        yield "a point is %g m away" % far(places, xyz)
    for column, name in SEEN.items():
        if column not in data or far(data[column], fields[name]) != 0:
            yield "%s is not the field %s" % (column, name)


def pye57_reads_what_jalon_wrote(jalon, folder, tally):
    for seed in (1, 2, 3):
        xyz, fields = cloud_of(numpy.random.default_rng(seed))
        path = folder / ("jalon_%d.e57" % seed)
        jalon.write(path, xyz, fields, "auto")
        tally.case("Jalon's E57 read by pye57: %d fields" % len(fields), list(seen_by_pye57(path, xyz, fields)))


def read_what_pye57_wrote(jalon, folder, tally):
    for seed in (11, 12):
        random = numpy.random.default_rng(seed)
        path, wanted = folder / ("pye57_%d.e57" % seed), []
        file = pye57.E57(str(path), mode="w")
        for scan in range(2):
            xyz, fields = cloud_of(random)
            local = (xyz - (652000, 6861000, 100)).astype("f4").astype("f8")  # pye57 writes no more
            q = random.standard_normal(4)
            q /= numpy.linalg.norm(q)
            q *= numpy.sign(q[0])
            turn, move = pye57.scan_header.Quaternion(q).rotation_matrix, numpy.array([652000.5, 6861000, 100 + scan])
            wanted.append((local @ turn.T + move, fields))
            data = {"cartesian" + axis: local[:, k] for k, axis in enumerate("XYZ")}
            data.update((column, fields[name]) for column, name in SEEN.items())
            file.write_scan_raw(data, rotation=q, translation=move)
        file.close()
        xyz, got, _ = jalon.read(path)
        problems = []
        if far(xyz, numpy.concatenate([w[0] for w in wanted])) > NEAR_M:
            problems.append("a point is %g m away" % far(xyz, numpy.concatenate([w[0] for w in wanted])))
        for name in SEEN.values():
            if far(got[name], numpy.concatenate([w[1][name] for w in wanted])) > 1e-6:
                problems.append("%s differs" % name)
        tally.case("pye57's E57 of two scans read by Jalon", problems)


def check(jalon, folder, tally):
    pye57_reads_what_jalon_wrote(jalon, folder, tally)
    read_what_pye57_wrote(jalon, folder, tally)

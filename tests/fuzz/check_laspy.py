#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The Jalon authors
# SPDX-License-Identifier: Apache-2.0
"""LAS files of laspy read by Jalon, and those of Jalon read by laspy: check_laspy.py LIBJALON_SO

Every dimension of every point format has random content over its whole range and must come out exactly;
coordinates to half a step. LAZ by lazrs, both ways, where Jalon was built with it. Then drawn files: 30 a format, with
JALON_FULL=1 300 others."""

import os
import pathlib
import sys
import tempfile

import laspy
import numpy
from laspy.vlrs.known import WktCoordinateSystemVlr

import drawn_clouds
import drawn_las
from jalon_las import Jalon
from las_fields import (LOST_BY_LAZRS, SCALARS, VERSIONS, WAVES, WKT, WRITTEN_VERSIONS, add_extra, asked_version, differences,
                        fill, off_step, random_values, seen_by_laspy, standard_fields)

POINTS = 1500
# Of the drawn files; those of the long run are others.
SEEDS = range(1000, 1300) if "JALON_FULL" in os.environ else range(30)


class Tally:
    def __init__(self):
        self.passed = self.failed = 0

    def case(self, name, problems):
        self.passed, self.failed = self.passed + (not problems), self.failed + bool(problems)
        print("%s - %s" % ("not ok" if problems else "ok", name))
        for problem in problems:
            print("    " + problem)


def read_what_laspy_wrote(jalon, folder, tally):
    for point_format, versions in VERSIONS.items():
        for version in versions:
            for extra in (False, True):
                random = numpy.random.default_rng(1000 * point_format + 10 * int(version[2]) + extra)
                header = laspy.LasHeader(version=version, point_format=point_format)
                header.scales = numpy.array([0.01, 0.001, 0.0001])
                header.offsets = numpy.array([652000.0, 6861000.0, -12.0])
                las = laspy.LasData(header)
                las.x = numpy.zeros(POINTS)
                las.header.vlrs.append(WktCoordinateSystemVlr(WKT))
                expected = fill(las, random)
                if extra:
                    add_extra(las, random, expected)
                path = folder / ("laspy_%d_%s.las" % (point_format, version))
                las.write(path)
                xyz, fields, crs = jalon.read(path)
                problems = list(differences(expected, fields))
                if jalon.has_laz():
                    if point_format in LOST_BY_LAZRS:
                        las["scanner_channel"] = fields["scanner_channel"] = numpy.zeros(POINTS, "u1")
                    las.write(path.with_suffix(".laz"))
                    packed = jalon.read(path.with_suffix(".laz"))
                    problems += ["LAZ: " + text for text in differences(fields, packed[1])]
                    problems += ["LAZ: other coordinates"] * (packed[0].tobytes() != xyz.tobytes())
                raw = numpy.stack([las.X, las.Y, las.Z], 1).astype("f8")
                problems += off_step(xyz, raw * header.scales + header.offsets, header.scales)
                if crs != WKT:
                    problems.append("the CRS is %r" % crs)
                waves = sum(name in expected for name in WAVES)
                tally.case("laspy %s format %d read: %d points, %d fields%s" %
                           (version, point_format, len(xyz), len(expected), ", wave packets" if waves else ""), problems)


def header_problems(header, las, xyz):
    slots = 15 if str(header.version) == "1.4" else 5
    returns = numpy.bincount(numpy.asarray(las.return_number), minlength=16)[1:slots + 1]
    counts = numpy.asarray(header.number_of_points_by_return)[:slots]
    if not (counts == returns).all():
        yield "points by return are %s, not %s" % (counts, returns)
    steps = numpy.asarray(header.scales)
    for name, corner, wanted in (("mins", header.mins, xyz.min(0)), ("maxs", header.maxs, xyz.max(0))):
        if (numpy.abs(numpy.asarray(corner) - wanted) > 0.51 * steps).any():
            yield "%s are %s, not %s" % (name, corner, wanted)
    if header.creation_date is not None and header.creation_date.year < 1900:
        yield "creation date %s" % header.creation_date


def laz_problems(jalon, path, cloud, las):
    """The same cloud compressed, unpacked by lazrs: the records, the bounds and the counts of the LAS file."""
    jalon.write(path.with_suffix(".laz"), *cloud)
    packed = laspy.read(path.with_suffix(".laz"))
    if not packed.header.are_points_compressed:
        yield "the points are not compressed"
    if numpy.asarray(packed.points.array).tobytes() != numpy.asarray(las.points.array).tobytes():
        yield "other records"
    yield from header_problems(packed.header, packed, cloud[0])


def laspy_reads_what_jalon_wrote(jalon, folder, tally):
    for point_format in VERSIONS:
        random = numpy.random.default_rng(77 + point_format)
        xyz = random.uniform(-80, 80, (POINTS, 3)) + (652000, 6861000, 100)
        fields = standard_fields(random, point_format, POINTS)
        for code in SCALARS:
            fields["own_" + code] = random_values(random, code, POINTS)
        fields["triple"] = random_values(random, "f4", (POINTS, 3))
        path = folder / ("jalon_%d.las" % point_format)
        version = WRITTEN_VERSIONS[point_format]
        jalon.write(path, xyz, fields, asked_version(point_format))
        las = laspy.read(path)
        problems = list(differences(fields, seen_by_laspy(las)))
        if las.header.point_format.id != point_format or str(las.header.version) != version:
            problems.append("it became %s format %d" % (las.header.version, las.header.point_format.id))
        problems += off_step(numpy.asarray(las.xyz), xyz, numpy.asarray(las.header.scales))
        problems += header_problems(las.header, las, xyz)
        if jalon.has_laz():
            if point_format in LOST_BY_LAZRS:
                fields["scanner_channel"] = las["scanner_channel"] = numpy.zeros(POINTS, "u1")
            cloud = (xyz, fields, asked_version(point_format))
            problems += ["LAZ: " + text for text in laz_problems(jalon, path, cloud, las)]
        tally.case("Jalon's %s format %d read by laspy: %d fields" % (version, point_format, len(fields)), problems)


def check_copc(jalon, folder, tally):
    if not jalon.has_laz():
        print("skipped: COPC was not built")
        return 1
    import check_copc as copc
    return copc.check(jalon, folder, tally)


def check_e57(jalon, folder, tally):
    """E57 by pye57, which has no wheel for some machines: then one skipped."""
    try:
        import check_e57 as e57
    except ImportError:
        print("skipped: pye57 cannot be installed")
        return 1
    if not jalon.has_laz():
        print("skipped: E57 was not built")
        return 1
    import drawn_e57
    e57.check(jalon, folder, tally)
    drawn_e57.check(jalon, folder, tally, SEEDS)
    return 0


def main():
    jalon, tally = Jalon(sys.argv[1]), Tally()
    with tempfile.TemporaryDirectory() as name:
        read_what_laspy_wrote(jalon, pathlib.Path(name), tally)
        laspy_reads_what_jalon_wrote(jalon, pathlib.Path(name), tally)
        drawn_las.check(jalon, pathlib.Path(name), tally, SEEDS)
        skipped = check_copc(jalon, pathlib.Path(name), tally)
        skipped += check_e57(jalon, pathlib.Path(name), tally)
        skipped += drawn_clouds.check(jalon, pathlib.Path(name), tally, SEEDS)
    print("laspy %s, LAZ %s" % (laspy.__version__, "both ways" if jalon.has_laz() else "not built"))
    print("%d passed, %d failed, %d skipped" % (tally.passed, tally.failed, skipped))
    return 1 if tally.failed else 0


if __name__ == "__main__":
    sys.exit(main())

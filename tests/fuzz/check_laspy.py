#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The Jalon authors
# SPDX-License-Identifier: Apache-2.0
"""LAS files of laspy read by Jalon, and those of Jalon read by laspy: check_laspy.py LIBJALON_SO

Every dimension of every point format has random content over its whole range and must come out exactly;
coordinates to half a step. LAZ by lazrs, both ways, where Jalon was built with it."""

import pathlib
import sys
import tempfile

import laspy
import numpy
from laspy.vlrs.known import WktCoordinateSystemVlr

from jalon_las import Jalon

POINTS = 1500
ANGLE_STEP = 0.006  # degrees, of formats 6-10
WKT = 'PROJCS["RGF93 / Lambert-93",GEOGCS["RGF93",UNIT["degree",0.0174532925199433]],UNIT["metre",1]]'
VERSIONS = {0: ("1.2", "1.3", "1.4"), 1: ("1.2", "1.3", "1.4"), 2: ("1.2", "1.3", "1.4"), 3: ("1.2", "1.3", "1.4"),
            4: ("1.3", "1.4"), 5: ("1.3", "1.4"), 6: ("1.4",), 7: ("1.4",), 8: ("1.4",), 9: ("1.4",), 10: ("1.4",)}
# Jalon's name where it is not laspy's.
NAMES = {"scan_direction_flag": "scan_direction", "scan_angle_rank": "scan_angle"}
WAVES = ("wavepacket_index", "wavepacket_offset", "wavepacket_size", "return_point_wave_location", "x_t", "y_t", "z_t")
# lazrs 0.8.2 reads other wave packets than it wrote where points are of several scanner channels.
LOST_BY_LAZRS = (9, 10)
SCALARS = ("i1", "u1", "i2", "u2", "i4", "u4", "i8", "u8", "f4", "f8")


class Tally:
    def __init__(self):
        self.passed = self.failed = 0

    def case(self, name, problems):
        self.passed, self.failed = self.passed + (not problems), self.failed + bool(problems)
        print("%s - %s" % ("not ok" if problems else "ok", name))
        for problem in problems:
            print("    " + problem)


def random_values(random, dtype, shape):
    """Random bits; floats are finite."""
    dtype = numpy.dtype(dtype)
    if dtype.kind == "f":
        return (random.standard_normal(shape) * 10.0 ** random.integers(-6, 7, shape)).astype(dtype)
    return random.integers(0, 256, (*numpy.atleast_1d(shape), dtype.itemsize), dtype="u1").view(dtype).reshape(shape)


def add_extra(las, random, expected):
    for code in SCALARS:
        las.add_extra_dim(laspy.ExtraBytesParams("own " + code, code, "random " + code))
        las["own " + code] = expected["own " + code] = random_values(random, code, POINTS)
    for code in ("3f4", "2u2", "3i4", "2f8"):
        las.add_extra_dim(laspy.ExtraBytesParams("some " + code, code))
        values = random_values(random, code[1:], (POINTS, int(code[0])))
        las["some " + code] = expected["some " + code] = values
    las.add_extra_dim(laspy.ExtraBytesParams("height", "i4", scales=numpy.array([0.001]), offsets=numpy.array([100.0])))
    raw = random.integers(-10**6, 10**6, POINTS)
    las["height"] = raw * 0.001 + 100.0
    expected["height"] = raw.astype("f8") * 0.001 + 100.0


def fill(las, random):
    """Random content for all dimensions; gives the fields that Jalon must show."""
    expected = {}
    for dimension in las.point_format.standard_dimensions:
        name = dimension.name
        if name in ("X", "Y", "Z"):
            values = random.integers(-2**31, 2**31, POINTS).astype("i4")
        elif str(dimension.kind) == "DimensionKind.BitField" or dimension.num_bits % 8 != 0:
            values = random.integers(0, 1 << dimension.num_bits, POINTS).astype("u1")
        else:
            values = random_values(random, dimension.dtype, POINTS)
        las[name] = values
        if name == "scan_angle_rank":
            expected["scan_angle"] = values.astype("f4")
        elif name == "scan_angle":
            expected["scan_angle"] = (values * ANGLE_STEP).astype("f4")
        elif name not in ("X", "Y", "Z"):
            expected[NAMES.get(name, name)] = values
    return expected


def differences(expected, got):
    for name in sorted(set(expected) | set(got)):
        if name not in got or name not in expected:
            yield "field %s is %s" % (name, "missing" if name in expected else "not expected")
            continue
        a, b = numpy.asarray(expected[name]), numpy.asarray(got[name])
        if a.dtype != b.dtype or a.shape != b.shape:
            yield "%s: %s %s became %s %s" % (name, a.dtype, a.shape, b.dtype, b.shape)
        elif a.tobytes() != b.tobytes():
            i = int(numpy.flatnonzero((a != b).reshape(len(a), -1).any(1))[0])
            yield "%s: item %d is %s, not %s" % (name, i, b[i], a[i])


def off_step(xyz, wanted, scales):
    """Coordinates farther than half a step, and the largest distance."""
    steps = numpy.abs(xyz - wanted) / scales
    # Half a step, and the rounding of double at the size of the coordinate.
    allowed = 0.5 + 4 * numpy.finfo("f8").eps * numpy.abs(wanted) / scales
    bad = numpy.flatnonzero((steps > allowed).any(1))
    return ["coordinates of point %d are %s, not %s" % (bad[0], xyz[bad[0]], wanted[bad[0]])] if len(bad) else []


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


def standard_fields(random, point_format):
    """Fields that make Jalon choose this point format."""
    extended, n = point_format >= 6, POINTS
    wide = 16 if extended else 8
    flags = ["scan_direction", "edge_of_flight_line", "synthetic", "key_point", "withheld"] + ["overlap"] * extended
    out = {name: random.integers(0, 2, n).astype("u1") for name in flags}
    out["intensity"] = random_values(random, "u2", n)
    out["return_number"] = random.integers(0, wide, n).astype("u1")
    out["number_of_returns"] = random.integers(0, wide, n).astype("u1")
    out["classification"] = random.integers(0, 256 if extended else 32, n).astype("u1")
    out["user_data"] = random_values(random, "u1", n)
    out["point_source_id"] = random_values(random, "u2", n)
    if extended:
        out["scanner_channel"] = random.integers(0, 4, n).astype("u1")
        out["scan_angle"] = (random_values(random, "i2", n) * ANGLE_STEP).astype("f4")
    else:
        out["scan_angle"] = random_values(random, "i1", n).astype("f4")
    if point_format in (1, 3, 6, 7, 8):
        out["gps_time"] = random_values(random, "f8", n)
    if point_format in (2, 3, 7, 8):
        out.update((name, random_values(random, "u2", n)) for name in ("red", "green", "blue"))
    if point_format == 8:
        out["nir"] = random_values(random, "u2", n)
    return out


def seen_by_laspy(las):
    """laspy's dimensions under Jalon's names."""
    out = {}
    for name in las.point_format.dimension_names:
        values = numpy.asarray(las[name])
        if name == "scan_angle_rank":
            out["scan_angle"] = values.astype("f4")
        elif name == "scan_angle":
            out["scan_angle"] = (values * ANGLE_STEP).astype("f4")
        elif name not in ("X", "Y", "Z"):
            out[NAMES.get(name, name)] = values
    return out


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
    for point_format in (0, 1, 2, 3, 6, 7, 8):
        random = numpy.random.default_rng(77 + point_format)
        xyz = random.uniform(-80, 80, (POINTS, 3)) + (652000, 6861000, 100)
        fields = standard_fields(random, point_format)
        for code in SCALARS:
            fields["own_" + code] = random_values(random, code, POINTS)
        fields["triple"] = random_values(random, "f4", (POINTS, 3))
        path = folder / ("jalon_%d.las" % point_format)
        version = "1.4" if point_format >= 6 else "1.2"
        jalon.write(path, xyz, fields, version)
        las = laspy.read(path)
        problems = list(differences(fields, seen_by_laspy(las)))
        if las.header.point_format.id != point_format or str(las.header.version) != version:
            problems.append("it became %s format %d" % (las.header.version, las.header.point_format.id))
        problems += off_step(numpy.asarray(las.xyz), xyz, numpy.asarray(las.header.scales))
        problems += header_problems(las.header, las, xyz)
        if jalon.has_laz():
            problems += ["LAZ: " + text for text in laz_problems(jalon, path, (xyz, fields, version), las)]
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
    e57.check(jalon, folder, tally)
    return 0


def main():
    jalon, tally = Jalon(sys.argv[1]), Tally()
    with tempfile.TemporaryDirectory() as name:
        read_what_laspy_wrote(jalon, pathlib.Path(name), tally)
        laspy_reads_what_jalon_wrote(jalon, pathlib.Path(name), tally)
        skipped = check_copc(jalon, pathlib.Path(name), tally)
        skipped += check_e57(jalon, pathlib.Path(name), tally)
    print("laspy %s, LAZ %s" % (laspy.__version__, "both ways" if jalon.has_laz() else "not built"))
    print("%d passed, %d failed, %d skipped" % (tally.passed, tally.failed, skipped))
    return 1 if tally.failed else 0


if __name__ == "__main__":
    sys.exit(main())

# SPDX-FileCopyrightText: 2026 The Jalon authors
# SPDX-License-Identifier: Apache-2.0
"""LAS dimensions with random content, as laspy and as Jalon name them, and how two readings of them differ."""

import laspy
import numpy

ANGLE_STEP = 0.006  # degrees, of formats 6-10
WKT = 'PROJCS["RGF93 / Lambert-93",GEOGCS["RGF93",UNIT["degree",0.0174532925199433]],UNIT["metre",1]]'
VERSIONS = {0: ("1.2", "1.3", "1.4"), 1: ("1.2", "1.3", "1.4"), 2: ("1.2", "1.3", "1.4"), 3: ("1.2", "1.3", "1.4"),
            4: ("1.3", "1.4"), 5: ("1.3", "1.4"), 6: ("1.4",), 7: ("1.4",), 8: ("1.4",), 9: ("1.4",), 10: ("1.4",)}
# Jalon's name where it is not laspy's.
NAMES = {"scan_direction_flag": "scan_direction", "scan_angle_rank": "scan_angle"}
WAVES = ("wavepacket_index", "wavepacket_offset", "wavepacket_size", "return_point_wave_location", "x_t", "y_t", "z_t")
# lazrs 0.8.2 reads other wave packets than were written where points are of several scanner channels.
LOST_BY_LAZRS = (9, 10)
SCALARS = ("i1", "u1", "i2", "u2", "i4", "u4", "i8", "u8", "f4", "f8")


def random_values(random, dtype, shape):
    """Random bits; floats are finite."""
    dtype = numpy.dtype(dtype)
    if dtype.kind == "f":
        return (random.standard_normal(shape) * 10.0 ** random.integers(-6, 7, shape)).astype(dtype)
    return random.integers(0, 256, (*numpy.atleast_1d(shape), dtype.itemsize), dtype="u1").view(dtype).reshape(shape)


def add_extra(las, random, expected):
    n = len(las.points)
    for code in SCALARS:
        las.add_extra_dim(laspy.ExtraBytesParams("own " + code, code, "random " + code))
        las["own " + code] = expected["own " + code] = random_values(random, code, n)
    for code in ("3f4", "2u2", "3i4", "2f8"):
        las.add_extra_dim(laspy.ExtraBytesParams("some " + code, code))
        values = random_values(random, code[1:], (n, int(code[0])))
        las["some " + code] = expected["some " + code] = values
    las.add_extra_dim(laspy.ExtraBytesParams("height", "i4", scales=numpy.array([0.001]), offsets=numpy.array([100.0])))
    raw = random.integers(-10**6, 10**6, n)
    las["height"] = raw * 0.001 + 100.0
    expected["height"] = raw.astype("f8") * 0.001 + 100.0


def fill(las, random):
    """Random content for all dimensions; gives the fields that Jalon must show."""
    expected, n = {}, len(las.points)
    for dimension in las.point_format.standard_dimensions:
        name = dimension.name
        if name in ("X", "Y", "Z"):
            values = random.integers(-2**31, 2**31, n).astype("i4")
        elif str(dimension.kind) == "DimensionKind.BitField" or dimension.num_bits % 8 != 0:
            values = random.integers(0, 1 << dimension.num_bits, n).astype("u1")
        else:
            values = random_values(random, dimension.dtype, n)
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


WRITTEN_VERSIONS = {**dict.fromkeys(range(4), "1.2"), **dict.fromkeys((4, 5), "1.3"), **dict.fromkeys(range(6, 11), "1.4")}


def asked_version(point_format):
    """What Jalon is told for this point format: 1.3 it takes by itself."""
    version = WRITTEN_VERSIONS[point_format]
    return "auto" if version == "1.3" else version


def standard_fields(random, point_format, n):
    """Fields that make Jalon choose this point format."""
    extended = point_format >= 6
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
    if point_format not in (0, 2):
        out["gps_time"] = random_values(random, "f8", n)
    if point_format in (2, 3, 5, 7, 8, 10):
        out.update((name, random_values(random, "u2", n)) for name in ("red", "green", "blue"))
    if point_format in (8, 10):
        out["nir"] = random_values(random, "u2", n)
    if point_format in (4, 5, 9, 10):
        out.update((name, random_values(random, code, n)) for name, code in zip(WAVES, ("u1", "u8", "u4", "f4", "f4", "f4", "f4")))
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

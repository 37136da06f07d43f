# SPDX-FileCopyrightText: 2026 The Jalon authors
# SPDX-License-Identifier: Apache-2.0
"""Drawn small files of LAS and LAZ: versions, point formats, steps, offsets, extra dimensions, records, both ways."""

import laspy
import numpy
from laspy.vlrs.known import WktCoordinateSystemVlr

from las_fields import (LOST_BY_LAZRS, SCALARS, VERSIONS, WKT, asked_version, differences, fill, off_step, random_values,
                        seen_by_laspy, standard_fields)

MOST_POINTS = 300
STEPS = (1.0, 2.0, 2.5, 5.0)
PLACES = ((0, 0, 0), (652000, 6861000, -12), (-3.5e6, 0.125, 4e3), (1e-3, -77.7, 9999999))
RECORDS_BEYOND = ("1.4",)  # whose records may also stand behind the points


def header_of(random):
    point_format = int(random.choice(list(VERSIONS)))
    header = laspy.LasHeader(version=str(random.choice(VERSIONS[point_format])), point_format=point_format)
    header.scales = random.choice(STEPS, 3) * 10.0 ** -random.integers(1, 7, 3)
    header.offsets = numpy.array(PLACES[random.integers(len(PLACES))], "f8")
    return header


def drawn_extra(random):
    """Some dimensions of any type, one to three wide, some in steps: [(description, type, shape of an item)]."""
    out = []
    for k in range(int(random.integers(0, 6))):
        code, wide, steps = str(random.choice(SCALARS)), int(random.integers(1, 4)), {}
        if code in ("i2", "i4") and random.random() < 0.4:
            steps = {"scales": 10.0 ** -random.integers(1, 5, wide), "offsets": random.integers(-100, 100, wide).astype("f8")}
        name = code if wide == 1 else "%d%s" % (wide, code)
        out.append((laspy.ExtraBytesParams("dim %d" % k, name, "number %d" % k, **steps), code, () if wide == 1 else (wide,)))
    return out


def fill_extra(las, random, extra, expected):
    for params, code, item in extra:
        values = random_values(random, code, (len(las.points), *item))
        las.points.array[params.name] = values  # the item itself, which laspy would make of a quotient
        expected[params.name] = values
        if params.scales is not None:
            expected[params.name] = values.astype("f8") * params.scales.reshape(item) + params.offsets.reshape(item)


def add_records(las, random):
    """Records of others before and behind the points. Returns the CRS."""
    for k in range(int(random.integers(0, 4))):
        las.vlrs.append(laspy.VLR("others", int(random.integers(1, 60000)), "record %d" % k, random.bytes(int(random.integers(0, 200)))))
    if str(las.header.version) in RECORDS_BEYOND and random.random() < 0.4:
        las.evlrs = laspy.vlrs.vlrlist.VLRList([laspy.VLR("others", 7, "beyond", random.bytes(int(random.integers(0, 2000))))])
    if random.random() < 0.5:
        las.vlrs.append(WktCoordinateSystemVlr(WKT))
        return WKT
    return ""


def drawn_by_laspy(seed):
    """(file in memory, fields, CRS)"""
    random = numpy.random.default_rng([57, seed])
    header, extra = header_of(random), drawn_extra(random)
    header.add_extra_dims([params for params, _, _ in extra])
    las = laspy.LasData(header)
    las.points = laspy.ScaleAwarePointRecord.zeros(int(random.integers(1, MOST_POINTS)), header=header)
    expected = fill(las, random)
    fill_extra(las, random, extra, expected)
    return las, expected, add_records(las, random)


def read_problems(jalon, path, las, expected, crs):
    xyz, fields, told = jalon.read(path)
    yield from differences(expected, fields)
    raw = numpy.stack([las.X, las.Y, las.Z], 1).astype("f8")
    yield from off_step(xyz, raw * las.header.scales + las.header.offsets, las.header.scales)
    if told != crs:
        yield "the CRS is %r" % told


def reads(jalon, folder, seeds):
    """(problems of LAS, problems of LAZ)"""
    plain, packed = [], []
    for seed in seeds:
        las, expected, crs = drawn_by_laspy(seed)
        name = "file %d, %s format %d: " % (seed, las.header.version, las.header.point_format.id)
        las.write(folder / "drawn.las")
        plain += [name + text for text in read_problems(jalon, folder / "drawn.las", las, expected, crs)]
        if jalon.has_laz():
            if las.header.point_format.id in LOST_BY_LAZRS:
                las["scanner_channel"] = expected["scanner_channel"] = numpy.zeros(len(las.points), "u1")
            las.write(folder / "drawn.laz")
            packed += [name + text for text in read_problems(jalon, folder / "drawn.laz", las, expected, crs)]
    return plain, packed


def drawn_by_jalon(seed):
    """(coordinates, fields, version)"""
    random = numpy.random.default_rng([58, seed])
    point_format, n = int(random.choice(list(VERSIONS))), int(random.integers(1, MOST_POINTS))
    xyz = random.uniform(-1, 1, (n, 3)) * 10 ** random.uniform(0, 3, 3) + PLACES[random.integers(len(PLACES))]
    fields = standard_fields(random, point_format, n)
    for k in range(int(random.integers(0, 5))):
        wide = int(random.integers(1, 4))
        fields["own %d" % k] = random_values(random, str(random.choice(SCALARS)), (n,) if wide == 1 else (n, wide))
    if point_format in LOST_BY_LAZRS:
        fields["scanner_channel"] = numpy.zeros(n, "u1")
    return xyz, fields, asked_version(point_format)


def seen_problems(path, xyz, fields):
    las = laspy.read(path)
    yield from differences(fields, seen_by_laspy(las))
    yield from off_step(numpy.asarray(las.xyz), xyz, numpy.asarray(las.header.scales))


def writes(jalon, folder, seeds):
    plain, packed = [], []
    for seed in seeds:
        xyz, fields, version = drawn_by_jalon(seed)
        for problems, path in ((plain, folder / "drawn.las"), (packed, folder / "drawn.laz")):
            if path.suffix == ".las" or jalon.has_laz():
                jalon.write(path, xyz, fields, version)
                problems += ["file %d: %s" % (seed, text) for text in seen_problems(path, xyz, fields)]
    return plain, packed


def check(jalon, folder, tally, seeds):
    back = seeds[:(len(seeds) + 2) // 3]
    for way, count, found in (("of laspy read by Jalon", len(seeds), reads(jalon, folder, seeds)),
                              ("of Jalon read by laspy", len(back), writes(jalon, folder, back))):
        for name, problems in zip(("LAS", "LAZ") if jalon.has_laz() else ("LAS",), found):
            tally.case("%d drawn files %s %s" % (count, name, way), problems)
            print("FIGURE drawn files: %d %s %s, %d differ" % (count, name, way, len({p.split(":")[0].split(",")[0] for p in problems})))

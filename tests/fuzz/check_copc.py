# SPDX-FileCopyrightText: 2026 The Jalon authors
# SPDX-License-Identifier: Apache-2.0
"""COPC files of Jalon read by laspy and copclib, and those of copclib read by Jalon: whole, by box and by level."""

import laspy
import numpy
from laspy.copc import Bounds, CopcReader
from laspy.vlrs.known import WktCoordinateSystemVlr

POINTS = 40000
WKT = 'PROJCS["RGF93 / Lambert-93",GEOGCS["RGF93",UNIT["degree",0.0174532925199433]],UNIT["metre",1]]'
STEP_M = 1e-4  # what Jalon writes without being asked


def wall(random):
    """A wall and its ground on coordinates of a national grid, with fields that point format 7 has and one of our own."""
    xyz = random.uniform((0, -0.01, 0), (30, 0.01, 12), (POINTS, 3))
    xyz[::3] = random.uniform((0, -20, -0.01), (30, 0, 0.01), (len(xyz[::3]), 3))
    fields = {"id": numpy.arange(POINTS, dtype="u4"), "intensity": random.uniform(0, 1, POINTS).astype("f4"),
              "gps_time": random.uniform(-5, 5, POINTS), "classification": random.integers(0, 256, POINTS).astype("u1"),
              "scan_angle": random.uniform(-90, 90, POINTS).astype("f4")}
    fields.update((name, random.integers(0, 65536, POINTS).astype("u2")) for name in ("red", "green", "blue"))
    return xyz + (652000, 6861000, 100), fields


def boxes(xyz, random, header):
    low, high = xyz.min(0), xyz.max(0)
    for number in range(20):
        a, b = (low + random.uniform(0, 1, 3) * (high - low) for _ in range(2))
        if number % 2 == 0:  # through the wall, or the ground
            b[1] = high[1]
        else:
            a[2] = low[2]
        # On steps of the file, as it gives them back: laspy rounds to them.
        steps = (numpy.round((c - header.offsets) / header.scales) for c in (numpy.minimum(a, b), numpy.maximum(a, b)))
        yield tuple(c * header.scales + header.offsets for c in steps)


def seen_by_laspy(jalon, path, xyz, fields, random):
    with CopcReader.open(path) as reader:
        las = reader.query()
        order = numpy.argsort(las["id"])
        if numpy.abs(numpy.column_stack([las.x, las.y, las.z])[order] - xyz).max() > 0.51 * STEP_M:
            yield "other coordinates"
        for name in ("gps_time", "classification", "red", "green", "blue"):
            if (numpy.asarray(las[name])[order] != fields[name]).any():
                yield "other %s" % name
        for name in ("intensity", "scan_angle"):
            if (numpy.asarray(las[name + "_exact"])[order] != fields[name]).any():
                yield "other %s" % name
        if numpy.abs(numpy.asarray(las["scan_angle"])[order] * 0.006 - fields["scan_angle"]).max() > 0.0031:
            yield "angles are not rounded to 0.006 degrees"
        spacing = reader.copc_info.spacing
        for level in range(6):
            seen = set(reader.query(level=range(level + 1))["id"])
            if seen != set(jalon.read(path, spacing_m=spacing / 2**level)[1]["id"]):
                yield "other points down to level %d" % level
        inside = 0
        for low, high in boxes(xyz, random, reader.header):
            seen = set(reader.query(bounds=Bounds(mins=low, maxs=high))["id"])
            inside += len(seen)
            if seen != set(jalon.read(path, box=(*low, *high))[1]["id"]):
                yield "other points in %s %s" % (low, high)
        if inside == 0 or reader.copc_info.gps_min != fields["gps_time"].min():
            yield "no points in any box, or other times"


def seen_by_copclib(copclib, path):
    reader = copclib.FileReader(str(path))
    if not reader.ValidateSpatialBounds():
        yield "points lie outside of their nodes"
    nodes = reader.GetAllNodes()
    if sum(node.point_count for node in nodes) != POINTS or len(reader.GetAllPoints()) != POINTS:
        yield "%d points in %d nodes" % (len(reader.GetAllPoints()), len(nodes))
    if len(nodes) < 5:
        yield "%d nodes" % len(nodes)


def write_by_copclib(copclib, path, random):
    """Eight cells under a root that has a share of each."""
    config = copclib.CopcConfigWriter(6, [0.01] * 3, [652000, 6861000, 0], WKT)
    config.copc_info.center_x, config.copc_info.center_y, config.copc_info.center_z = 652016, 6861016, 16
    config.copc_info.halfsize, config.copc_info.spacing = 16, 0.5
    config.las_header.min, config.las_header.max = (652000, 6861000, 0), (652032, 6861032, 32)
    writer = copclib.FileWriter(str(path), config)
    written = []
    for number, key in enumerate([(0, 0, 0, 0)] + [(1, i >> 2 & 1, i >> 1 & 1, i & 1) for i in range(8)]):
        edge = 32 / 2**key[0]
        points = copclib.Points(config.las_header)
        places = numpy.round(random.uniform(0.01, edge - 0.01, (500, 3)), 2) + edge * numpy.array(key[1:]) + (652000, 6861000, 0)
        for i, (x, y, z) in enumerate(places):
            point = points.CreatePoint()
            point.x, point.y, point.z = x, y, z
            point.classification = (number * 31 + i) % 256
            points.AddPoint(point)
        # Each node of level 1 in a page of its own.
        writer.AddNode(copclib.VoxelKey(*key), points, copclib.VoxelKey(*key))
        written.append((places, numpy.array([(number * 31 + i) % 256 for i in range(500)])))
    writer.Close()
    return tuple(numpy.concatenate(parts) for parts in zip(*written))


def rows_of(xyz, classes):
    """Sorted, in steps of the file."""
    rows = numpy.column_stack([numpy.round((numpy.asarray(xyz) - (652000, 6861000, 0)) * 100).astype("i8"), classes])
    return rows[numpy.lexsort(rows.T)].tolist()


def seen_by_jalon(jalon, path, xyz, classes, random):
    got, fields, crs = jalon.read(path)
    if rows_of(got, fields["classification"]) != rows_of(xyz, classes):
        yield "other points"
    if crs != WKT:
        yield "the CRS is %r" % crs
    if len(jalon.read(path, spacing_m=0.5)[0]) != 500:
        yield "other points at level 0"
    for _ in range(20):
        low, high = numpy.sort(random.uniform(0, 32, (2, 3)), 0).round(2) + (652000, 6861000, 0) + 0.005
        inside = ((xyz >= low) & (xyz <= high)).all(1)
        got, fields, _ = jalon.read(path, box=(*low, *high))
        if rows_of(got, fields["classification"]) != rows_of(xyz[inside], classes[inside]):
            yield "other points in %s %s" % (low, high)


def texts_of_codes(jalon, folder, pyproj):
    """The WKT that a COPC file has for the code of its CRS, against the dataset of PROJ."""
    codes = [*range(32601, 32661), *range(32701, 32761), *range(25828, 25838), 2154, *range(3942, 3951)]
    for code in codes:
        path = folder / "code.copc.laz"
        jalon.write(path, numpy.array([[700000.0, 6600000.0, 1.0]]), {}, "1.4", crs="EPSG:%d" % code)
        with laspy.open(path) as file:
            texts = [vlr.string for vlr in file.header.vlrs if isinstance(vlr, WktCoordinateSystemVlr)]
        wanted = pyproj.CRS.from_epsg(code)
        if len(texts) != 1 or pyproj.CRS.from_wkt(texts[0]) != pyproj.CRS.from_wkt(wanted.to_wkt("WKT1_GDAL")):
            yield "EPSG:%d is %s" % (code, texts)


def check(jalon, folder, tally):
    """How many checks were skipped."""
    skipped = 0
    try:
        import pyproj
        tally.case("PROJ takes the WKT of the 140 codes of EPSG that Jalon knows for the same systems",
                   list(texts_of_codes(jalon, folder, pyproj)))
    except ImportError:
        print("skipped: pyproj cannot be installed")
        skipped = 1
    random = numpy.random.default_rng(2026)
    xyz, fields = wall(random)
    path = folder / "jalon.copc.laz"
    jalon.write(path, xyz, fields, "1.4")
    tally.case("Jalon's COPC read by laspy: whole, down to six levels, in 20 boxes",
               list(seen_by_laspy(jalon, path, xyz, fields, random)))
    try:
        import copclib
    except ImportError:
        print("skipped: copclib cannot be installed")
        return skipped + 1
    tally.case("Jalon's COPC read by copclib, which finds all points in their nodes", list(seen_by_copclib(copclib, path)))
    path = folder / "copclib.copc.laz"
    written = write_by_copclib(copclib, path, random)
    tally.case("COPC of copclib read by Jalon: whole, coarsest, in 20 boxes", list(seen_by_jalon(jalon, path, *written, random)))
    return skipped

# SPDX-FileCopyrightText: 2026 The Jalon authors
# SPDX-License-Identifier: Apache-2.0
"""Drawn small files of E57: scans with and without poses, columns of any kind and width, both ways, by libE57Format (pye57)."""

import numpy
import pye57
from pye57 import libe57

MOST_POINTS = 300
NEAR_M = 5e-9  # two turns at coordinates of seven digits
OWN = "own"  # prefix of an extension's columns
PLACE = numpy.array([652000.5, 6861000, 100])
# The smallest that holds a range.
WHOLE = [numpy.dtype(code) for code in ("u1", "i1", "u2", "i2", "u4", "i4")]


class Columns:
    """The columns of one scan: each with its node, what is written, and what Jalon shall show."""

    def __init__(self, file, random, n):
        self.file, self.random, self.n = file, random, n
        self.prototype, self.buffers = libe57.StructureNode(file), libe57.VectorSourceDestBuffer()
        self.kept = []  # the buffers look at them

    def _add(self, name, node, values, is_scaled=False):
        values = numpy.ascontiguousarray(values)
        self.kept.append(values)
        self.prototype.set(name, node)
        self.buffers.append(libe57.SourceDestBuffer(self.file, name, values, max(1, len(values)), True, is_scaled))

    def single(self, name, values):
        values = values.astype("f4")
        self._add(name, libe57.FloatNode(self.file, 0.0, libe57.E57_SINGLE), values)
        return values.astype("f8")

    def double(self, name, values):
        self._add(name, libe57.FloatNode(self.file, 0.0, libe57.E57_DOUBLE), values.astype("f8"))
        return values.astype("f8")

    def whole(self, name, values, low, high):
        self._add(name, libe57.IntegerNode(self.file, low, low, high), values.astype("f8"))
        return values.astype("f8")

    def steps(self, name, values):
        """A scaled integer, of which the values are the nearest."""
        scale, offset = 10.0 ** -self.random.integers(3, 7), float(numpy.round(self.random.uniform(-1, 1), 3))
        raw = numpy.round((values - offset) / scale).astype("i8")
        low, high = int(raw.min(initial=0)) - int(self.random.integers(0, 100)), int(raw.max(initial=0)) + int(self.random.integers(0, 100))
        values = raw * scale + offset
        self._add(name, libe57.ScaledIntegerNode(self.file, low, low, high, scale, offset), values, True)
        return values

    def any(self, name, values):
        return (self.single, self.double, self.steps)[self.random.integers(3)](name, values)

    def flags(self, name, most=1):
        """Which items hold nothing, or None where no column says so."""
        if self.random.random() < 0.6:
            return numpy.zeros(self.n, bool)
        values = self.random.integers(0, most + 1, self.n)
        self.whole(name, values, 0, most)
        return values != 0


def places(columns):
    """Coordinates in the scanner's frame, and which of them are none."""
    random, n = columns.random, columns.n
    xyz = random.uniform(-1, 1, (n, 3)) * 10 ** random.uniform(0, 2)
    if random.random() < 0.3:
        spherical = [numpy.linalg.norm(xyz, axis=1), numpy.arctan2(xyz[:, 1], xyz[:, 0]), numpy.arcsin(xyz[:, 2] / numpy.linalg.norm(xyz, axis=1))]
        r, a, e = (columns.double("spherical" + name, values) for name, values in zip(("Range", "Azimuth", "Elevation"), spherical))
        xyz = numpy.stack([r * numpy.cos(e) * numpy.cos(a), r * numpy.cos(e) * numpy.sin(a), r * numpy.sin(e)], 1)
        return xyz, columns.flags("sphericalInvalidState", 2)
    kind = (columns.single, columns.double, columns.steps)[random.integers(3)]
    xyz = numpy.stack([kind("cartesian" + axis, xyz[:, k]) for k, axis in enumerate("XYZ")], 1)
    return xyz, columns.flags("cartesianInvalidState", 2)


def smallest(low, high):
    for dtype in WHOLE:
        if numpy.iinfo(dtype).min <= low and high <= numpy.iinfo(dtype).max:
            return dtype
    return numpy.dtype("i8" if low < 0 else "u8")


def fields_of(columns, wide, owns):
    """{name: values}; owns: the columns of the extension, which are of one kind in the file."""
    random, n, out = columns.random, columns.n, {}
    if random.random() < 0.7:
        most = int(random.choice([255, 4095, 65535]))
        values = columns.whole("intensity", random.integers(0, most + 1, n), 0, most) if random.random() < 0.4 else columns.any("intensity", random.random(n))
        out["intensity"] = numpy.where(columns.flags("isIntensityInvalid"), numpy.nan, values).astype("f4")
    if random.random() < 0.6:
        low, high = int(random.integers(0, 50)), int(random.integers(60, 5000))
        for name, column in (("row", "rowIndex"), ("column", "columnIndex")):
            out[name] = columns.whole(column, random.integers(low, high + 1, n), low, high).astype("u4")
    if random.random() < 0.5:
        colours = [random.integers(0, (65536 if wide else 256), n) for _ in range(3)]
        for name, values in zip(("Red", "Green", "Blue"), colours):
            out[name.lower()] = columns.whole("color" + name, values, 0, 65535 if wide else 255).astype("u2" if wide else "u1")
        none = columns.flags("isColorInvalid")
        for name in ("red", "green", "blue"):
            out[name] = numpy.where(none, 0, out[name]).astype(out[name].dtype)
    if random.random() < 0.4:
        counts = random.integers(1, 6, n)
        out["number_of_returns"] = columns.whole("returnCount", counts, 0, 7).astype("u1")
        out["return_number"] = columns.whole("returnIndex", random.integers(0, counts), 0, 7).astype("u1") + numpy.uint8(1)
    if random.random() < 0.4:
        out["time"] = numpy.where(columns.flags("isTimeStampInvalid"), numpy.nan, columns.double("timeStamp", random.uniform(0, 1e6, n)))
    for name, low, high in owns:
        values = columns.double(OWN + ":" + name, random.standard_normal(n)) if high is None else columns.whole(
            OWN + ":" + name, random.integers(low, high + 1, n), low, high).astype(smallest(low, high))
        out[name] = values
    return out


def drawn_owns(random):
    """[(name, least, largest)], None for a float."""
    out = []
    for k in range(int(random.integers(0, 4))):
        low = int(random.choice([0, 0, -1, -200, -70000, -2 ** 40]))
        high = int(random.choice([1, 100, 255, 256, 65535, 70000, 2 ** 33]))
        out.append(("mine_%d" % k, low, high if random.random() < 0.7 else None))
    return out


def pose_node(file, q, move):
    pose, rotation, translation = (libe57.StructureNode(file) for _ in range(3))
    for name, value in zip("wxyz", q):
        rotation.set(name, libe57.FloatNode(file, value))
    for name, value in zip("xyz", move):
        translation.set(name, libe57.FloatNode(file, value))
    pose.set("rotation", rotation)
    pose.set("translation", translation)
    return pose


def drawn_pose(random):
    q = random.standard_normal(4)
    q *= numpy.sign(q[0]) / numpy.linalg.norm(q)
    return q, pye57.scan_header.Quaternion(q).rotation_matrix, PLACE * random.integers(0, 2) + random.uniform(-50, 50, 3)


def write_by_pye57(path, seed):
    """[(coordinates, {field: values})], one a scan, as Jalon shall read them."""
    random = numpy.random.default_rng([59, seed])
    whole = pye57.E57(str(path), mode="w")
    file, scans = whole.image_file, []
    file.extensionsAdd(OWN, "http://www.example.com/own")
    wide, owns = random.random() < 0.3, drawn_owns(random)
    for number in range(int(random.integers(1, 4))):
        n = int(random.integers(1, MOST_POINTS)) if number == 0 or random.random() < 0.9 else 0
        scan, columns = libe57.StructureNode(file), Columns(file, random, n)
        scan.set("guid", libe57.StringNode(file, "{scan %d}" % number))
        scan.set("name", libe57.StringNode(file, "scan <%d> & façade" % number))
        xyz, none = places(columns)
        fields = fields_of(columns, wide, owns)
        if random.random() < 0.7:
            q, turn, move = drawn_pose(random)
            scan.set("pose", pose_node(file, q, move))
            xyz = xyz @ turn.T + move
        points = libe57.CompressedVectorNode(file, columns.prototype, libe57.VectorNode(file, True))
        scan.set("points", points)
        whole.data3d.append(scan)
        writer = points.writer(columns.buffers)
        if n:
            writer.write(n)
        writer.close()
        scans.append((xyz[~none], {name: values[~none] for name, values in fields.items()}))
    whole.close()
    return scans


def joined(scans):
    """The clouds of the scans as one: what a scan lacks is 0, or no number."""
    types = {}
    for _, fields in scans:
        for name, values in fields.items():
            types.setdefault(name, values.dtype)
    out = {}
    for name, dtype in types.items():
        nothing = numpy.nan if dtype.kind == "f" else 0
        out[name] = numpy.concatenate([fields.get(name, numpy.full(len(xyz), nothing)).astype(dtype) for xyz, fields in scans])
    return numpy.concatenate([xyz for xyz, _ in scans]), out


def far(a, b):
    return float(numpy.abs(numpy.asarray(a, "f8") - numpy.asarray(b, "f8")).max(initial=0))


def problems_of(wanted, got):
    (xyz, fields), (places_read, read) = wanted, got
    if len(xyz) != len(places_read):
        yield "%d points, not %d" % (len(places_read), len(xyz))
        return
    if far(xyz, places_read) > NEAR_M:
        yield "a point is %g m away" % far(xyz, places_read)
    for name in sorted(set(fields) | set(read)):
        if name not in read or name not in fields:
            yield "field %s is %s" % (name, "missing" if name in fields else "not expected")
        elif read[name].dtype != fields[name].dtype:
            yield "%s is %s, not %s" % (name, read[name].dtype, fields[name].dtype)
        elif not numpy.array_equal(read[name], fields[name], equal_nan=fields[name].dtype.kind == "f"):
            i = int(numpy.flatnonzero(read[name] != fields[name])[0])
            yield "%s: item %d is %s, not %s" % (name, i, read[name][i], fields[name][i])


def write_by_jalon(jalon, path, seed):
    """(coordinates, {column of the file: values})"""
    random = numpy.random.default_rng([60, seed])
    n = int(random.integers(1, MOST_POINTS))
    xyz, fields, columns = random.uniform(-50, 50, (n, 3)) + PLACE * random.integers(0, 2), {}, {}
    for name, column, values in (
            ("intensity", "intensity", random.random(n).astype("f4") if random.random() < 0.5 else random.integers(0, 65536, n).astype("u2")),
            ("row", "rowIndex", random.integers(0, 900, n).astype("u4")), ("column", "columnIndex", random.integers(0, 3000, n).astype("u2")),
            ("time", "timeStamp", random.uniform(0, 1e5, n))):
        if random.random() < 0.6:
            fields[name] = columns[column] = values
    if random.random() < 0.6:
        for name in ("Red", "Green", "Blue"):
            fields[name.lower()] = columns["color" + name] = random.integers(0, 256, n).astype("u1")
    for k in range(int(random.integers(0, 4))):
        code = str(random.choice(["i1", "u1", "i2", "u2", "i4", "u4", "f4", "f8"]))
        values = random.standard_normal(n).astype(code) if code[0] == "f" else random.integers(0, 256, (n, int(code[1])), "u1").view(code)[:, 0]
        fields["own_%d" % k] = columns["jalon:own_%d" % k] = values
    _, turn, move = drawn_pose(random)
    pose = numpy.column_stack([turn, move]) if random.random() < 0.6 else None
    jalon.write(path, xyz, fields, "auto", pose)
    return xyz, columns


def seen_by_pye57(path, xyz, columns):
    file = pye57.E57(str(path))
    header = file.get_header(0)
    if file.scan_count != 1 or header.point_count != len(xyz):
        yield "%d scans, %d points" % (file.scan_count, header.point_count)
        return
    names, buffers, got = ["cartesian" + axis for axis in "XYZ"] + list(columns), libe57.VectorSourceDestBuffer(), {}
    lost = set(names) ^ set(header.point_fields)
    if lost:
        yield "columns %s" % ", ".join(sorted(lost))
        return
    for name in names:
        got[name] = numpy.empty(len(xyz), "f8")
        buffers.append(libe57.SourceDestBuffer(file.image_file, name, got[name], len(xyz), True, True))
    header.points.reader(buffers).read()
    places_read = numpy.stack([got["cartesian" + axis] for axis in "XYZ"], 1)
    if header.has_pose():
        places_read = places_read @ header.rotation_matrix.T + header.translation
    if far(places_read, xyz) > NEAR_M:
        yield "a point is %g m away" % far(places_read, xyz)
    for name, values in columns.items():
        if far(got[name], values):
            yield "%s differs by %g" % (name, far(got[name], values))


def check(jalon, folder, tally, seeds):
    read, written, back = [], [], seeds[:(len(seeds) + 2) // 3]
    for seed in seeds:
        path = folder / ("drawn_%d.e57" % seed)
        scans = write_by_pye57(path, seed)
        read += ["file %d: %s" % (seed, text) for text in problems_of(joined(scans), jalon.read(path)[:2])]
    for seed in back:
        path = folder / ("own_%d.e57" % seed)
        written += ["file %d: %s" % (seed, text) for text in seen_by_pye57(path, *write_by_jalon(jalon, path, seed))]
    for way, count, problems in (("of pye57 read by Jalon", len(seeds), read), ("of Jalon read by pye57", len(back), written)):
        tally.case("%d drawn files E57 %s" % (count, way), problems)
        print("FIGURE drawn files: %d E57 %s, %d differ" % (count, way, len({p.split(":")[0] for p in problems})))

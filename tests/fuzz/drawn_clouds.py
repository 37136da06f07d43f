# SPDX-FileCopyrightText: 2026 The Jalon authors
# SPDX-License-Identifier: Apache-2.0
"""Drawn small files of PLY by plyfile and of PCD by pypcd4, in each of their encodings, both ways."""

import numpy

from las_fields import differences, random_values

MOST_POINTS = 300
TYPES = ("i1", "u1", "i2", "u2", "i4", "u4", "f4", "f8")


def drawn(random):
    """(coordinates, {name: values}): values that any text tells whole."""
    n = int(random.integers(1, MOST_POINTS))
    dtype = str(random.choice(["f4", "f8"]))
    xyz = (random.integers(-80000, 80000, (n, 3)) / 1024).astype(dtype)
    fields = {}
    for k in range(int(random.integers(0, 6))):
        code = str(random.choice(TYPES))
        fields["own_%d" % k] = (random.integers(-2000, 2000, n) / 8).astype(code) if code[0] == "f" else random_values(random, code, n)
    return xyz, fields


def rows_of(xyz, fields):
    columns = {axis: xyz[:, k] for k, axis in enumerate("xyz")}
    columns.update(fields)
    rows = numpy.empty(len(xyz), [(name, values.dtype) for name, values in columns.items()])
    for name, values in columns.items():
        rows[name] = values
    return rows


def write_ply(path, random, xyz, fields):
    import plyfile
    elements = [plyfile.PlyElement.describe(rows_of(xyz, fields), "vertex", comments=["drawn"])]
    if random.random() < 0.4:  # that the cloud passes over
        faces = numpy.empty(int(random.integers(1, 9)), [("vertex_indices", "i4", (3,))])
        faces["vertex_indices"] = random.integers(0, len(xyz), (len(faces), 3))
        elements.insert(int(random.integers(0, 2)), plyfile.PlyElement.describe(faces, "face"))
    plyfile.PlyData(elements, text=random.random() < 0.4, byte_order=str(random.choice(["<", ">"])), comments=["of another program"]).write(str(path))


def read_ply(path):
    import plyfile
    vertex = plyfile.PlyData.read(str(path))["vertex"]
    return {p.name: numpy.asarray(vertex[p.name]) for p in vertex.properties}


def write_pcd(path, random, xyz, fields):
    import pypcd4
    rows = rows_of(xyz, fields)
    cloud = pypcd4.PointCloud.from_points([rows[name] for name in rows.dtype.names], rows.dtype.names, [rows.dtype[name] for name in rows.dtype.names])
    cloud.save(path, encoding=[pypcd4.Encoding.ASCII, pypcd4.Encoding.BINARY, pypcd4.Encoding.BINARY_COMPRESSED][random.integers(3)])


def read_pcd(path):
    import pypcd4
    cloud = pypcd4.PointCloud.from_path(path)
    return {name: cloud.pc_data[name] for name in cloud.fields}


def check_format(jalon, folder, tally, seeds, form):
    name, library, write, read = form
    problems, back = [], []
    for seed in seeds:
        random = numpy.random.default_rng([61, seed])
        xyz, fields = drawn(random)
        path = folder / ("drawn." + name.lower())
        write(path, random, xyz, fields)
        places, got, _ = jalon.read(path)
        problems += ["file %d: %s" % (seed, text) for text in differences(dict(fields, xyz=xyz.astype("f8")), dict(got, xyz=places))]
        path = folder / ("own." + name.lower())
        jalon.write(path, xyz, fields, "auto")
        seen = read(path)
        places = numpy.stack([seen.pop(axis).astype("f8") for axis in "xyz"], 1)
        back += ["file %d: %s" % (seed, text) for text in differences(dict(fields, xyz=xyz.astype("f8")), dict(seen, xyz=places))]
    for way, found in (("of %s read by Jalon" % library, problems), ("of Jalon read by %s" % library, back)):
        tally.case("%d drawn files %s %s" % (len(seeds), name, way), found)
        print("FIGURE drawn files: %d %s %s, %d differ" % (len(seeds), name, way, len({p.split(":")[0] for p in found})))


FORMS = (("PLY", "plyfile", write_ply, read_ply), ("PCD", "pypcd4", write_pcd, read_pcd))


def check(jalon, folder, tally, seeds):
    """How many formats were skipped, for want of the other reader."""
    skipped = 0
    for form in FORMS:
        try:
            __import__(form[1])
        except ImportError:
            print("skipped: %s cannot be installed" % form[1])
            skipped += 1
            continue
        check_format(jalon, folder, tally, seeds, form)
    return skipped

# SPDX-FileCopyrightText: 2026 The Jalon authors
# SPDX-License-Identifier: Apache-2.0
"""A model from the tables that house_files and scan_files write, with areas and arcs worked out anew."""

import json

import numpy

CHORD_ERROR_M = 0.001  # the writers' default
OPENINGS = ("window", "door", "gateway", "shop_front", "vent", "recess", "opening")
COPIED = 5             # JALON_EVIDENCE_COPIED
NO_PART = 2**32 - 1


def bulge_area(points, bulges):
    """Signed area of a polygon of lines and arcs in a plane; bulge: tangent of a quarter of the angle (DXF)."""
    x, y = points[:, 0], points[:, 1]
    area = (x * numpy.roll(y, -1) - y * numpy.roll(x, -1)).sum() / 2
    chords = numpy.hypot(numpy.roll(x, -1) - x, numpy.roll(y, -1) - y)
    for c, b in zip(chords, bulges):
        if b:
            angle = 4 * numpy.arctan(abs(b))
            radius = c * (1 + b * b) / (4 * abs(b))
            area += numpy.sign(b) * radius**2 * (angle - numpy.sin(angle)) / 2
    return area


def along_arc(start, end, bulge, normal, pieces=64):
    """Points between the ends of an arc that turns about the normal; it lies right of its chord where the bulge is positive."""
    middle, chord = (start + end) / 2, end - start
    right = numpy.cross(chord, normal) / 2  # as long as half the chord
    centre = middle - right * (1 - bulge**2) / (2 * bulge)
    outwards = middle + right * bulge - centre
    along = chord / numpy.linalg.norm(chord) * numpy.linalg.norm(outwards)
    angles = 4 * numpy.arctan(abs(bulge)) * (numpy.arange(1, pieces) / pieces - 0.5)
    return centre + numpy.outer(numpy.cos(angles), outwards) + numpy.outer(numpy.sin(angles), along)


class Ring:
    def __init__(self, index, points, sagittas, part, normal):
        self.index, self.points, self.part = index, points, part
        chords = numpy.linalg.norm(numpy.roll(points, -1, axis=0) - points, axis=1)
        self.bulges = [2 * s / c if c > 0 else 0 for s, c in zip(sagittas, chords)]
        self.drawn = len(points) >= (2 if any(self.bulges) else 3)
        u = numpy.cross(normal, [1, 0, 0] if abs(normal[0]) < 0.6 else [0, 1, 0])
        u /= numpy.linalg.norm(u)
        local = points - points[0]
        self.area = bulge_area(numpy.column_stack([local @ u, local @ numpy.cross(normal, u)]), self.bulges)
        angles = 4 * numpy.arctan(numpy.abs(self.bulges))
        lengths = [c if b == 0 else a * c * (1 + b * b) / (4 * abs(b)) for c, b, a in zip(chords, self.bulges, angles)]
        self.length = sum(lengths)
        self.arc_length = sum(l for l, b in zip(lengths, self.bulges) if b)
        self.reach = max((abs(s) for s in sagittas), default=0)
        arcs = [along_arc(points[k], points[(k + 1) % len(points)], b, normal) for k, b in enumerate(self.bulges) if b]
        self.outline = numpy.concatenate([points] + arcs)


class Face:
    def __init__(self, row, rings):
        self.part, self.id, self.area_m2, self.rings = row[0], row[3], row[4], rings
        self.normal = numpy.array(row[5:8])


class Model:
    def __init__(self, path):
        with open(path, encoding="utf-8") as file:
            tables = json.load(file)
        self.vertices = numpy.array(tables["vertices"], float).reshape(-1, 3)
        corners = numpy.array(tables["corners"], int)
        sagittas = numpy.array(tables["sagittas"], float)
        self.parts, self.solids = tables["parts"], tables["solids"]
        self.faces, self.rings = [], []
        for row in tables["faces"]:
            rings = []
            for index in range(row[1], row[1] + row[2]):
                first, count, part = tables["rings"][index]
                span = slice(first, first + count)
                rings.append(Ring(index, self.vertices[corners[span]], sagittas[span], row[0] if not rings else part,
                                  numpy.array(row[5:8])))
            self.faces.append(Face(row, rings))
            self.rings += rings
        drawn = [r for r in self.rings if r.drawn]
        self.arc_count = sum(b != 0 for r in self.rings for b in r.bulges)
        self.area = sum(f.area_m2 for f in self.faces)
        self.chord_area = CHORD_ERROR_M * sum(r.arc_length for r in drawn) + 1e-6  # the most that chords cut off
        self.border_m = sum(r.length for r in drawn)
        self.arc_reach_m = max((r.reach for r in drawn), default=0)

    def class_of(self, part):
        return self.parts[part][1] if part < len(self.parts) else None

    def layer_of(self, part):
        if part >= len(self.parts):
            return "OPENING"
        return (self.class_of(part).upper() or "ELEMENT") + ("-COPIED" if self.parts[part][2] == COPIED else "")

    def openings_without_face(self):
        """Parts that are openings and have no face of their own."""
        own = {f.part for f in self.faces}
        return [p for p in range(len(self.parts)) if self.class_of(p) in OPENINGS and p not in own]

    def drawn_lines(self):
        """(ring, part) of each polyline of a drawing: all rings, and once more, for its opening, the outline of the first face
        that stands in an opening without hole and face of its own (a door at the foot of its wall)."""
        holes = {r.part for f in self.faces for r in f.rings[1:]}
        waiting = [p for p in self.openings_without_face() if p not in holes]
        lines = []
        for face in self.faces:
            lines += [(r, r.part) for r in face.rings if r.drawn]
            around = -1 if self.class_of(face.part) == "reveal" else face.part
            while 0 <= around < len(self.parts) and self.class_of(around) not in OPENINGS:
                around = self.parts[around][3]
            if around in waiting:
                waiting.remove(around)
                lines += [(face.rings[0], around)]
        return lines

    def wrong_areas(self):
        for i, face in enumerate(self.faces):
            area = sum(r.area for r in face.rings)
            if abs(area - face.area_m2) > 1e-6 * (1 + face.area_m2):
                yield "face %d: the table says %.9g m2, its rings %.9g" % (i, face.area_m2, area)

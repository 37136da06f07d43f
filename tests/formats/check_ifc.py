#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The Jalon authors
# SPDX-License-Identifier: Apache-2.0
"""The IFC files of one model read by ifcopenshell, against the model's tables: check_ifc.py NAME FOLDER

FOLDER holds model.json (the tables), model.ifc with walls as surfaces and solid.ifc with walls as bodies, as house_files and
scan_files write them."""

import collections
import math
import pathlib
import subprocess
import sys

import ifcopenshell
import ifcopenshell.geom
import ifcopenshell.util.element
import ifcopenshell.util.geolocation
import ifcopenshell.util.shape
import numpy

from model_tables import CHORD_ERROR_M, OPENINGS, Model
from told import tell

SHARE = 1e-6        # of an area or a volume: ours against theirs
PLACE_M = 1e-6      # of a corner on a national grid
THICKNESS_M = 0.3   # of the walls of solid.ifc


def problems_of_schema(path):
    run = subprocess.run([sys.executable, "-m", "ifcopenshell.validate", "--rules", path], capture_output=True, text=True)
    if run.returncode or "No validation issues found" not in run.stdout + run.stderr:
        yield "ifcopenshell.validate: " + (run.stdout + run.stderr)[-500:]


def geometry(product, cut, in_world=False):
    """In its own coordinates, which are short: volumes of large ones would be sums of large terms. What is not cut comes by CGAL, which
    is exact: OpenCASCADE's triangles of a ground with many holes may overlap (3 of 50 facades; a tenth of a square metre to three)."""
    settings = ifcopenshell.geom.settings()
    settings.set("use-world-coords", in_world)
    settings.set("disable-opening-subtractions", not cut)
    library = "opencascade" if cut else "cgal"
    return ifcopenshell.geom.create_shape(settings, product, geometry_library=library).geometry


def quantity(product, name):
    return ifcopenshell.util.element.get_psets(product).get("Jalon_Measured", {}).get(name)


def is_far(a, b, chords=0.0):
    """chords: what these may cut off, where there are arcs."""
    return not abs(a - b) <= SHARE * max(1e-3, abs(b)) + chords


def chords_of(model):
    """Of each name of a part: the most that chords cut off its faces, m2."""
    out = collections.Counter()
    for face in model.faces:
        for ring in face.rings:
            out[model.parts[face.part][0] if face.part < len(model.parts) else "mesh"] += CHORD_ERROR_M * ring.arc_length
    return out


def counts(model, file):
    """Windows and doors are found as such, each opening in its wall once."""
    holed = {r.part for f in model.faces for r in f.rings[1:] if r.drawn and model.class_of(r.part) in OPENINGS}
    for name, entity in (("window", "IfcWindow"), ("door", "IfcDoor")):
        wanted = sum(model.class_of(part) == name for part in holed)
        filling = [w for w in file.by_type(entity) if w.FillsVoids and w.ObjectType == name]
        if len(filling) != wanted:
            yield "%d of class %s fill openings instead of %d" % (len(filling), name, wanted)
    openings = file.by_type("IfcOpeningElement")
    if len(openings) != len(holed):
        yield "%d openings instead of %d" % (len(openings), len(holed))
    for opening in openings:
        if len(opening.VoidsElements) != 1:
            yield "%s voids %d elements" % (opening.Name, len(opening.VoidsElements))


def areas(model, file):
    """The area of each flat product that tells one is that of its triangles."""
    told, chords = 0, chords_of(model)
    for product in file.by_type("IfcElement"):
        area = quantity(product, "NetSurfaceArea")
        told += area is not None or quantity(product, "GrossVolume") is not None
        if area is None or quantity(product, "GrossVolume") is not None or not product.Representation:
            continue
        if product.is_a("IfcWindow") or product.is_a("IfcDoor"):
            continue  # shown with what stands in them
        found = ifcopenshell.util.shape.get_area(geometry(product, cut=False))
        if is_far(found, area, chords[product.Name]):
            yield "%s: %.9g m2 instead of %.9g" % (product.Name, found, area)
    if told == 0:
        yield "no product tells an area or a volume"


def volumes(file):
    for product in file.by_type("IfcElement"):
        volume = quantity(product, "GrossVolume")
        if volume is None:
            continue
        found = ifcopenshell.util.shape.get_volume(geometry(product, cut=False))
        if is_far(found, volume):
            yield "%s: %.9g m3 instead of %.9g" % (product.Name, found, volume)


def solid_walls(model, file):
    """A wall that its openings cut has the volume of what is left of its surface."""
    chords = chords_of(model)
    for wall in file.by_type("IfcWall"):
        area = quantity(wall, "NetSurfaceArea")
        if area is None or wall.ObjectType != "wall":
            continue
        found = ifcopenshell.util.shape.get_volume(geometry(wall, cut=True))
        if is_far(found, area * THICKNESS_M, chords[wall.Name] * THICKNESS_M):
            yield "%s: %.9g m3 left instead of %.9g" % (wall.Name, found, area * THICKNESS_M)


def places(model, file):
    """The corners of all products, moved by map conversion or site, span the box of the model."""
    low, high = [math.inf] * 3, [-math.inf] * 3
    for product in file.by_type("IfcProduct"):
        if not product.Representation or product.is_a("IfcOpeningElement"):
            continue
        vertices = geometry(product, cut=False, in_world=True).verts
        for k in range(3):
            low[k], high[k] = min(low[k], *vertices[k::3]), max(high[k], *vertices[k::3])
    if file.by_type("IfcMapConversion"):
        low = ifcopenshell.util.geolocation.auto_xyz2enh(file, *low)
        high = ifcopenshell.util.geolocation.auto_xyz2enh(file, *high)
    drawn = numpy.concatenate([r.outline for f in model.faces for r in f.rings])
    tolerance_m = PLACE_M + (CHORD_ERROR_M if model.arc_count else 0)
    for found, wanted in ((low, drawn.min(axis=0)), (high, drawn.max(axis=0))):
        if max(abs(a - b) for a, b in zip(found, wanted)) > tolerance_m:
            yield "the box ends at %s instead of %s" % (found, wanted)


def main():
    name, folder = sys.argv[1], pathlib.Path(sys.argv[2])
    model = Model(folder / "model.json")
    flat, solid = ifcopenshell.open(str(folder / "model.ifc")), ifcopenshell.open(str(folder / "solid.ifc"))
    checks = {
        "keeps the rules of the schema": lambda: problems_of_schema(str(folder / "model.ifc")),
        "keeps them with solid walls": lambda: problems_of_schema(str(folder / "solid.ifc")),
        "has its windows, doors and openings": lambda: counts(model, flat),
        "has the model's areas": lambda: areas(model, flat),
        "has the model's volumes": lambda: volumes(flat),
        "has walls of a thickness that their openings cut": lambda: solid_walls(model, solid),
        "stands where the model does": lambda: places(model, flat),
    }
    return tell("IFC of " + name, checks)


if __name__ == "__main__":
    sys.exit(main())

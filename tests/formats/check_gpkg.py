#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The Jalon authors
# SPDX-License-Identifier: Apache-2.0
"""The GeoPackage of one model read by GDAL, against the model's tables: check_gpkg.py NAME FOLDER

FOLDER holds model.json (the tables) and model.gpkg, as house_files and scan_files write them. Wants python3-gdal of Debian, with its
sample validate_gpkg.py."""

import pathlib
import subprocess
import sys

import numpy
from osgeo import ogr

from model_tables import Model
from told import tell

ogr.UseExceptions()
PLACE_M = 1e-6  # of a corner on a national grid
AREA_M2 = 1e-6


def rings_of(polygon):
    return [numpy.array(polygon.GetGeometryRef(r).GetPoints())[:-1] for r in range(polygon.GetGeometryCount())]


def area_of(rings):
    """Of a flat polygon in space: that of its outline less those of its holes."""
    def one(points):
        p = points - points[0]
        return numpy.linalg.norm(numpy.cross(p, numpy.roll(p, -1, axis=0)).sum(axis=0)) / 2
    return one(rings[0]) - sum(one(r) for r in rings[1:])


def problems_of_standard(path):
    run = subprocess.run([sys.executable, "-m", "osgeo_utils.samples.validate_gpkg", path], capture_output=True, text=True)
    if run.returncode or run.stdout.strip() or run.stderr.strip():
        yield "validate_gpkg: " + (run.stdout + run.stderr)[-500:]


def faces(model, package):
    """Each drawn face is a polygon with its holes, corners and area."""
    drawn = [f for f in model.faces if f.rings and len(f.rings[0].points) >= (2 if any(f.rings[0].bulges) else 3)]
    features = list(package.GetLayer("faces"))
    if len(features) != len(drawn):
        yield "%d faces instead of %d" % (len(features), len(drawn))
        return
    for face, feature in zip(drawn, features):
        rings = rings_of(feature.geometry())
        if len(rings) != sum(r.drawn for r in face.rings):
            yield "face %d: %d rings instead of %d" % (face.id, len(rings), len(face.rings))
        first = numpy.abs(rings[0] - face.rings[0].points[0]).max(axis=1).min()
        if first > PLACE_M:
            yield "face %d: no corner where the model has one" % face.id
        chords = sum(0.001 * r.arc_length for r in face.rings)
        if abs(area_of(rings) - face.area_m2) > chords + AREA_M2 * (1 + face.area_m2):
            yield "face %d: %.9g m2 instead of %.9g" % (face.id, area_of(rings), face.area_m2)
        if abs(feature["area_m2"] - face.area_m2) > 0:
            yield "face %d: its column says %.17g m2" % (face.id, feature["area_m2"])


def is_in_metres(package):
    """Never degrees, whatever the model knows of its place."""
    for layer in package:
        system = layer.GetSpatialRef()
        if system is None or system.IsGeographic() or system.GetLinearUnits() != 1:
            yield "%s: %s" % (layer.GetName(), system and system.ExportToWkt())


def boxes(package):
    for layer in package:
        if layer.GetFeatureCount() == 0:
            continue
        told = layer.GetExtent()
        spans = numpy.array([f.geometry().GetEnvelope() for f in layer])
        found = spans[:, 0].min(), spans[:, 1].max(), spans[:, 2].min(), spans[:, 3].max()
        if max(abs(a - b) for a, b in zip(told, found)) > PLACE_M:  # GDAL reads it as text of 15 digits
            yield "%s: the box is %s instead of %s" % (layer.GetName(), told, found)


def elevation(package):
    """Nothing left of zero; walls that face the viewer keep their area."""
    features = [f for f in package.GetLayer("elevation") if f["kind"] == "face"]
    if features and abs(min(f.geometry().GetEnvelope()[0] for f in features)) > PLACE_M:
        yield "it begins at %.9g" % min(f.geometry().GetEnvelope()[0] for f in features)
    for feature in features:
        flat = abs(feature.geometry().GetArea())
        if flat > feature["area_m2"] + 1e-3 * (1 + feature["area_m2"]):
            yield "%s: %.9g m2 in the elevation, %.9g in space" % (feature["name"], flat, feature["area_m2"])


def plan(model, package):
    """Each line lies in the plane of its face."""
    by_id = {}
    for face in model.faces:
        by_id.setdefault(face.id, []).append(face)
    lines = list(package.GetLayer("plan"))
    upright = [f for f in model.faces if f.rings and abs(f.normal[2]) < 0.5]
    if upright and not lines:
        yield "no line"
    for line in lines:
        points = numpy.array(line.geometry().GetPoints())
        away = min(numpy.abs((points - f.rings[0].points[0]) @ f.normal).max() for f in by_id[line["face"]])
        if away > 0.05:  # measured corners lie near their plane
            yield "%s: %.3g m off its face" % (line["name"], away)
        if abs(numpy.linalg.norm(points[1] - points[0]) - line["length_m"]) > PLACE_M:
            yield "%s: its column says %.9g m" % (line["name"], line["length_m"])


def main():
    name, folder = sys.argv[1], pathlib.Path(sys.argv[2])
    model, package = Model(folder / "model.json"), ogr.Open(str(folder / "model.gpkg"))
    checks = {
        "keeps the standard": lambda: problems_of_standard(str(folder / "model.gpkg")),
        "has the model's faces": lambda: faces(model, package),
        "is in metres": lambda: is_in_metres(package),
        "tells the boxes of its layers": lambda: boxes(package),
        "unrolls the facades": lambda: elevation(package),
        "cuts the plan out of the faces": lambda: plan(model, package),
    }
    return tell("GeoPackage of " + name, checks)


if __name__ == "__main__":
    sys.exit(main())

#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The Jalon authors
# SPDX-License-Identifier: Apache-2.0
"""The files of one model, read by ezdxf, OGR, cjval and trimesh, against its tables: check_files.py NAME FOLDER [CJVAL]

FOLDER holds model.json (the tables) and the files that house_files and scan_files write."""

import collections
import json
import pathlib
import re
import subprocess
import sys

import ezdxf
import ezdxf.recover
import numpy
import pyogrio.raw
import shapely
import trimesh

from model_tables import CHORD_ERROR_M, Model, bulge_area

PLACE_M = 5e-9  # of a corner on a national grid after it went through the axes of its face and back
STEP_M = 1e-4   # of coordinates in CityJSON


def far(a, b):
    """The largest distance of corners that should be the same."""
    a, b = numpy.asarray(a, float), numpy.asarray(b, float)
    return float(numpy.abs(a - b).max()) if a.shape == b.shape else float("inf")


# ---- DXF by ezdxf

def audit(path):
    for read in (lambda: (lambda d: (d, d.audit()))(ezdxf.readfile(path)), lambda: ezdxf.recover.readfile(path)):
        _, auditor = read()
        for entry in auditor.errors + auditor.fixes:
            yield "%s: %s" % (path.name, entry.message)


def closed_polylines(path):
    """(layer, corners in space, bulges, corners in the plane) of each."""
    for entity in ezdxf.readfile(path).modelspace():
        if entity.dxftype() == "LWPOLYLINE":
            flat = numpy.array([(x, y, entity.dxf.elevation) for x, y in entity.get_points("xy")])
            bulges = [p[0] for p in entity.get_points("b")]
            closed, planar = entity.closed, True
        elif entity.dxftype() == "POLYLINE":
            flat = numpy.array([v.dxf.location.xyz for v in entity.vertices])
            bulges = [v.dxf.get("bulge", 0) for v in entity.vertices]
            closed, planar = entity.is_closed, entity.is_2d_polyline
        else:
            continue
        space = flat
        if planar:
            ocs = entity.ocs()
            space = numpy.array([ocs.to_wcs(ezdxf.math.Vec3(p)).xyz for p in flat])
        yield entity.dxf.layer, space, bulges, flat if planar else None, closed


def dxf_world(model, path):
    lines = list(closed_polylines(path))
    wanted = model.drawn_lines()
    if len(lines) != len(wanted):
        yield "%d polylines instead of %d" % (len(lines), len(wanted))
        return
    for (ring, part), (layer, space, bulges, flat, closed) in zip(wanted, lines):
        if not closed:
            yield "ring %d is open" % ring.index
        if not far(space, ring.points) <= PLACE_M:
            yield "ring %d is %g m away" % (ring.index, far(space, ring.points))
        if not far(bulges, ring.bulges) <= 1e-8:
            yield "ring %d: bulges differ by %g" % (ring.index, far(bulges, ring.bulges))
        if flat is not None and abs(abs(bulge_area(flat - flat[0], bulges)) - abs(ring.area)) > 1e-6 * (1 + abs(ring.area)):
            yield "ring %d: %g m2 instead of %g" % (ring.index, bulge_area(flat - flat[0], bulges), ring.area)
        if not layer.startswith(model.layer_of(part)):
            yield "ring %d lies on layer %s" % (ring.index, layer)


def dxf_elevation(model, path):
    """Every ring that lies in the plane of a facade has its area in the drawing; heights are true."""
    areas = sorted(abs(bulge_area(flat - flat[0], bulges)) for _, _, bulges, flat, _ in closed_polylines(path))
    if not areas:
        yield "the drawing is empty"
        return
    largest = max((f for f in model.faces if abs(f.normal[2]) < 0.5), key=lambda f: f.area_m2, default=None)
    if largest is None:
        return
    upright = numpy.hypot(largest.normal[0], largest.normal[1])
    wanted = abs(largest.rings[0].area) * upright
    nearest = min(areas, key=lambda a: abs(a - wanted))
    if abs(nearest - wanted) > 1e-6 * wanted:
        yield "no outline of %g m2: the nearest has %g" % (wanted, nearest)


# ---- DXF and GeoJSON by OGR

def features(path):
    meta, _, wkb, columns = pyogrio.raw.read(path)
    return meta, shapely.from_wkb(wkb), dict(zip(meta["fields"], columns))


def ogr_dxf(model, path):
    _, shapes, columns = features(path)
    is_line = shapely.get_type_id(shapes) != 0  # texts are points
    shapes, columns = shapes[is_line], {name: column[is_line] for name, column in columns.items()}
    wanted = model.drawn_lines()
    if len(shapes) != len(wanted):
        yield "%d features instead of %d" % (len(shapes), len(wanted))
        return
    for (ring, part), shape, layer in zip(wanted, shapes, columns["Layer"]):
        points = shapely.get_coordinates(shape, include_z=True)
        if not layer.startswith(model.layer_of(part)):
            yield "ring %d lies on layer %s" % (ring.index, layer)
        if any(ring.bulges):
            away = max(numpy.abs(points - p).max(axis=1).min() for p in ring.points)
        else:
            away = far(points[:-1] if len(points) == len(ring.points) + 1 else points, ring.points)
        if not away <= 2 * PLACE_M:
            yield "ring %d is %g m away" % (ring.index, away)


def ogr_geojson(model, path):
    meta, shapes, columns = features(path)
    faces = [f for f in model.faces if f.rings[0].drawn]
    if meta["crs"] != "EPSG:2154" and "metre" not in (meta["crs"] or ""):
        yield "CRS %s" % meta["crs"]
    openings = model.openings_without_face()
    if len(shapes) != len(faces) + len(openings):
        yield "%d features for %d faces and %d openings" % (len(shapes), len(faces), len(openings))
        return
    if list(columns["class"][len(faces):]) != [model.class_of(part) for part in openings]:
        yield "the openings' classes are %s" % columns["class"][len(faces):]
    for i, (face, shape) in enumerate(zip(faces, shapes)):
        holes = [r for r in face.rings[1:] if r.drawn]
        if len(shape.interiors) != len(holes):
            yield "face %d has %d holes instead of %d" % (i, len(shape.interiors), len(holes))
            continue
        for ring, line in zip([face.rings[0]] + holes, [shape.exterior, *shape.interiors]):
            points = {p for p in map(tuple, shapely.get_coordinates(line, include_z=True).tolist())}
            if not {tuple(p) for p in ring.points.tolist()} <= points:
                yield "face %d: corners are not exactly ours" % i
        if columns["face"][i] != face.id or columns["class"][i] != model.class_of(face.part):
            yield "face %d: face %s of class %s" % (i, columns["face"][i], columns["class"][i])
        if abs(columns["area_m2"][i] - face.area_m2) > 1e-9 * (1 + face.area_m2):
            yield "face %d: area %g" % (i, columns["area_m2"][i])


# ---- CityJSON

def city_by_cjval(path, cjval):
    run = subprocess.run([cjval, str(path)], capture_output=True, text=True, check=False)
    try:
        report = json.loads(run.stdout)
    except ValueError:
        yield "no report: %s" % (run.stderr.strip() or run.stdout.strip())[:300]
        return
    for kind in ("errors", "warnings"):
        for name, result in report["checks"][kind].items():
            for problem in result["errors"]:
                yield "%s: %s" % (name, str(problem)[:300])
    if not report["valid"] or report["has_warnings"]:
        yield "cjval says: not valid"


def vector_area(points):
    d = points - points[0]
    return numpy.cross(d, numpy.roll(d, -1, axis=0)).sum(axis=0) / 2


def city_surfaces(city):
    """(rings, semantic surface or None, solid number or None) of all polygons."""
    solid = 0
    for thing in city["CityObjects"].values():
        for geometry in thing["geometry"]:
            surfaces, values = geometry["boundaries"], geometry.get("semantics", {}).get("values")
            if geometry["type"] == "Solid":
                surfaces, values, solid = surfaces[0], values and values[0], solid + 1
            for i, rings in enumerate(surfaces):
                value = None if values is None else values[i]
                yield rings, None if value is None else geometry["semantics"]["surfaces"][value], \
                    solid if geometry["type"] == "Solid" else None


def city_against(model, path):
    with open(path, encoding="utf-8") as file:
        city = json.load(file)
    vertices = numpy.array(city["vertices"], float).reshape(-1, 3) * city["transform"]["scale"] + city["transform"]["translate"]
    polygons = [s for s in city_surfaces(city) if not (s[1] or {}).get("closes_opening")]
    faces = [f for f in model.faces if f.rings[0].drawn]
    if len(polygons) != len(faces):
        yield "%d polygons for %d faces" % (len(polygons), len(faces))
    area = sum(numpy.linalg.norm(sum(vector_area(vertices[r]) for r in rings)) for rings, _, _ in polygons)
    allowed = model.chord_area + STEP_M * model.border_m
    if abs(area - model.area) > allowed:
        yield "%g m2 instead of %g, beyond %g" % (area, model.area, allowed)
    tree = shapely.STRtree(shapely.points(vertices[:, :2]))
    for face in faces:
        for p in face.rings[0].points:
            near = tree.query(shapely.Point(p[:2]).buffer(2 * STEP_M))
            if not len(near) or numpy.abs(vertices[near] - p).max(axis=1).min() > STEP_M / 2 + PLACE_M:
                yield "corner %s is more than half a step away" % p
                return
    yield from open_edges(polygons)


def open_edges(polygons):
    """Solids are closed: each edge is walked once in either sense."""
    walks = collections.defaultdict(collections.Counter)
    for rings, _, solid in polygons:
        if solid is None:
            continue
        for ring in rings:
            walks[solid].update(zip(ring, ring[1:] + ring[:1]))
    for solid, edges in walks.items():
        bad = sum(n != 1 or edges[(b, a)] != 1 for (a, b), n in edges.items())
        if bad:
            yield "solid %d: %d edges of %d are not walked once in either sense" % (solid, bad, len(edges))


# ---- meshes by trimesh

def mesh_against(model, path):
    mesh = trimesh.load(path, force="mesh", process=False)
    shift = numpy.zeros(3)
    if path.name == "binary.stl":
        shift = numpy.array(path.read_bytes()[:80].split(b"add")[1].split(), float)
    exact = path.suffix != ".stl" or path.name == "ascii.stl"
    place = PLACE_M if exact else 4e-6
    if abs(mesh.area - model.area) > model.chord_area + 10 * place * model.border_m:
        yield "%.9g m2 instead of %.9g, beyond the chords' %g" % (mesh.area, model.area, model.chord_area)
    corners = numpy.vstack([r.points for f in model.faces if f.rings[0].drawn for r in f.rings if not any(r.bulges)])
    used = mesh.vertices[numpy.unique(mesh.faces)] + shift
    for side in ("min", "max"):
        if far(getattr(used, side)(axis=0), getattr(corners, side)(axis=0)) > place + model.arc_reach_m:
            yield "the %s corner is %s" % (side, getattr(used, side)(axis=0))
    if path.suffix == ".obj" and not set(map(tuple, model.vertices.tolist())) <= set(map(tuple, obj_vertices(path))):
        yield "vertices are not exactly ours"


def obj_vertices(path):
    for line in path.read_text(encoding="utf-8").splitlines():
        if line.startswith("v "):
            yield [float(word) for word in line.split()[1:]]


# ---- all of them

def gathered(problems):
    """The problems as a list; a program that cannot read a file at all has one too."""
    found = []
    try:
        found.extend(problems)
    except Exception as error:  # whatever a foreign reader throws
        found.append("%s: %s" % (type(error).__name__, error))
    return found


def main():
    name, folder = sys.argv[1], pathlib.Path(sys.argv[2])
    model = Model(folder / "model.json")
    checks = [("tables: areas are those of the rings", model.wrong_areas())]
    for file in ("r2000.dxf", "r12.dxf", "elevation.dxf"):
        checks.append(("ezdxf: %s has no errors and no fixes" % file, audit(folder / file)))
    for file in ("r2000.dxf", "r12.dxf"):
        checks.append(("ezdxf: %s has our rings, arcs, areas and layers" % file, dxf_world(model, folder / file)))
        checks.append(("OGR: %s has our rings" % file, ogr_dxf(model, folder / file)))
    checks.append(("ezdxf: elevation.dxf has our areas", dxf_elevation(model, folder / "elevation.dxf")))
    checks.append(("OGR: model.geojson has our faces", ogr_geojson(model, folder / "model.geojson")))
    if len(sys.argv) > 3:
        checks.append(("cjval: model.city.json is valid", city_by_cjval(folder / "model.city.json", sys.argv[3])))
    checks.append(("json: model.city.json has our faces and closed solids", city_against(model, folder / "model.city.json")))
    for file in ("model.obj", "binary.stl", "ascii.stl", "model.ply"):
        checks.append(("trimesh: %s has our area and extent" % file, mesh_against(model, folder / file)))
    passed = failed = 0
    for title, problems in checks:
        problems = gathered(problems)
        passed, failed = passed + (not problems), failed + bool(problems)
        print("%s - %s: %s" % ("not ok" if problems else "ok", name, title))
        for problem in problems[:5]:
            print("    " + re.sub(r"\s+", " ", problem))
    print("    FIGURE %s: %d faces, %d rings, %d arcs, %d solids, %.3f m2"
          % (name, len(model.faces), len(model.rings), model.arc_count, len(model.solids), model.area))
    print("%d passed, %d failed, 0 skipped" % (passed, failed))
    return 1 if failed else 0


if __name__ == "__main__":
    sys.exit(main())

# SPDX-FileCopyrightText: 2026 The Jalon authors
# SPDX-License-Identifier: Apache-2.0
"""The rooms of src, the rooms within them, and which may see which: arrows run one way."""

import os
import re
from collections import defaultdict

from source import read

# The rooms and the rooms straight below them (CONTRIBUTING.md has the table); arrows are transitive.
ROOMS = {
    "base": [], "geometry": ["base"], "spatial": ["geometry"], "solid": ["spatial"], "cloud": ["spatial"],
    "model": ["spatial"], "fieldtools": ["cloud"], "formats": ["cloud", "model"], "scan": ["cloud", "model"],
    "segment": ["cloud"], "modelling": ["segment", "model"], "registration": ["segment", "model"],
    "compare": ["fieldtools", "model", "solid"],
    "report": ["formats", "modelling", "segment", "registration", "compare"],
    "bytes": ["formats", "modelling", "segment", "registration", "compare"],
    "capi": ["report", "bytes", "scan"], "cli": [],
}

# The sub-rooms of a room and those straight below them in the same room; transitive as well. What stands in the room's own
# folder is either shared (sees no sub-room, seen by all of them) or its front (sees any, seen by none).
SUBROOMS = {
    "cloud": {"sections": []},
    "geometry": {"geodesy": []},
    "model": {"relations": [], "trajectory": [], "buildings": []},
    "spatial": {"octree": [], "neighbours": ["octree"], "triangles": [], "voxels": []},
    "scan": {"mobile": [], "builder": [], "grammar": ["builder"], "yard": ["builder"], "scenes": ["grammar", "yard"]},
    "formats": {
        "files": [], "units": ["files"], "text": ["files"], "codecs": ["files"], "las": ["units", "codecs"], "e57": ["codecs"], "ept": ["las"], "ply": ["text"], "obj": ["text"],
        "stl": ["text"], "ptx": ["text"], "pts": ["text"], "pcd": ["text"], "city": ["units"], "dxf": ["text", "units"], "geojson": ["units"], "geopackage": ["units"], "glb": ["files"], "ifc": ["units"], "drawings": ["files"], "png": ["drawings"], "tiff": ["drawings", "units"],
        "trajectory": ["text"],
    },
    "segment": {
        "surface": [], "front": [], "labels": ["surface", "result"], "result": ["front"], "ransac": ["surface"],
        "settle": ["ransac", "result"], "growing": ["ransac"], "picks": ["surface", "result"], "evaluation": ["labels"],
        "codes": ["labels"], "raster": ["surface"], "profiles": ["surface"], "triangles": [], "cells": [],
        "hough": ["ransac"], "lines": ["surface"],
    },
    "modelling": {
        "plane": [], "contour": ["plane"], "edges/find": ["plane"], "edges/adjust": ["edges/find"],
        "edges/join": ["edges/adjust", "contour"], "evidence": ["edges/join"],
        "walls": ["contour", "edges/adjust", "evidence"], "patterns": ["walls"],
        "facade": ["patterns", "edges/join", "evidence"], "evaluation": ["plane"], "codes": [],
    },
    "compare": {
        "visibility": [], "overlap": [], "detection": ["visibility"], "distance": ["detection"], "preview": [], "m3c2": [], "matching": [],
        "volumes": ["distance"], "landslide": ["volumes", "detection"], "changes": ["matching", "detection", "landslide"],
        "clearance": [],
    },
    "registration": {"ground": [], "solvers": [], "joint": ["ground", "solvers"], "surface": [], "verdict": ["surface"], "icp": ["surface", "verdict"], "coarse": [], "targets": [], "network": ["targets"]},
    "report": {
        "sheet": [], "names": [], "elevation": ["sheet", "names"], "charts": ["sheet"],
        "pictures": ["elevation"], "viewer": ["sheet"], "pages": ["pictures", "charts", "viewer"],
    },
    "capi": {"support": [], "sections": ["support"]},
    "cli": {"inputs": [], "outputs": ["system"], "system": [], "comparing": ["outputs"]},
}
MOST_FILES = 45  # of one folder: above, a room wants sub-rooms
CODE = (".c", ".cpp", ".h", ".inc")


def below(arrows, start):
    seen, todo = {start}, [start]
    while todo:
        for lower in arrows[todo.pop()]:
            if lower not in seen:
                seen.add(lower)
                todo.append(lower)
    return seen


def includes(path):
    for number, line in enumerate(read(path).splitlines(), 1):
        match = re.match(r'\s*#\s*include\s*([<"])([^>"]+)[>"]', line)
        if match:
            yield number, match.group(1), match.group(2)


def sources(files):
    return [path for path in files if path.startswith("src/") and path.endswith(CODE) and path.count("/") > 1]


def layers(files):
    """Arrows between rooms."""
    for path in sources(files):
        room = path.split("/")[1]
        if room not in ROOMS:
            yield "%s: %s/ is no room of the architecture" % (path, room)
            continue
        allowed = below(ROOMS, room)
        for number, quote, name in includes(path):
            top = name.split("/")[0]
            if top == "jalon" and room not in ("capi", "cli"):
                yield "%s:%d: only capi and cli see include/jalon" % (path, number)
            elif top in ROOMS and "/" in name and top not in allowed:
                yield "%s:%d: %s may not see %s" % (path, number, room, name)
            elif quote == '"' and top not in ROOMS and top != "jalon" and not re.match(r"[\w.]+\.(inc|h)$", name):
                yield '%s:%d: "%s" is in no room' % (path, number, name)


def bindings_alone(files):
    """Tests may see the bindings, never the other way round."""
    for path in files:
        if path.startswith("bindings/"):
            for number, line in enumerate(read(path).splitlines(), 1):
                if re.search(r"""["'/]tests["'/]""", line):
                    yield "%s:%d: %s" % (path, number, line.strip())


def subroom(name):
    """Room and sub-room of "room/sub/file.h"; the sub-room of a file in the room's own folder is ""."""
    parts = name.split("/")
    return parts[0], "/".join(parts[1:-1])


def fronts(files):
    """Stems in rooms' own folders that see a sub-room, or another front."""
    sees = defaultdict(set)
    for path in sources(files):
        room, sub = subroom(path[4:])
        if not sub:
            sees[os.path.splitext(path[4:])[0]] |= {n for _, _, n in includes(path) if n.split("/")[0] == room}
    found = {stem for stem, names in sees.items() if any(subroom(n)[1] for n in names)}
    while True:
        more = {stem for stem, names in sees.items() if any(os.path.splitext(n)[0] in found for n in names)} - found
        if not more:
            return found
        found |= more


def sublayers(files):
    """Arrows between the sub-rooms of a room."""
    front = fronts(files)
    for path in sources(files):
        room, sub = subroom(path[4:])
        arrows = SUBROOMS.get(room, {})
        if sub and sub not in arrows:
            yield "%s: %s/%s is no sub-room" % (path, room, sub)
        elif sub:
            allowed = below(arrows, sub)
            for number, _, name in includes(path):
                other, seen = subroom(name)
                if other != room:
                    continue
                if seen and seen not in allowed:
                    yield "%s:%d: %s may not see %s" % (path, number, sub, name)
                elif not seen and os.path.splitext(name)[0] in front:
                    yield "%s:%d: %s is the room's front: no sub-room sees it" % (path, number, name)


def crowds(files):
    count = defaultdict(int)
    for path in files:
        if path.startswith("src/"):
            count[os.path.dirname(path)] += 1
    for folder, n in sorted(count.items()):
        if n > MOST_FILES:
            yield "%s holds %d files; above %d it wants sub-rooms" % (folder, n, MOST_FILES)

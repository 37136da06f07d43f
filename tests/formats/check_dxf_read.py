#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The Jalon authors
# SPDX-License-Identifier: Apache-2.0
"""Drawings that ezdxf writes, read by jalon: check_dxf_read.py JALON FOLDER. Areas and extents against what was drawn."""

import math
import pathlib
import subprocess
import sys

import ezdxf
import trimesh
from ezdxf.render import forms

SHARE = 2e-3  # of an area: arcs become chords within 1 mm


def outline(layout, corners, **attributes):
    """Closed, by (x, y) or (x, y, bulge); release 12 knows the old form alone."""
    if layout.doc.dxfversion >= "AC1015":
        layout.add_lwpolyline(corners, format="xyb", close=True, dxfattribs=attributes)
    else:
        layout.add_polyline2d(corners, format="xyb", close=True, dxfattribs=attributes)


def of_polylines(msp, doc):
    outline(msp, [(0, 0), (4, 0), (4, 3), (0, 3)])
    # A half disc of radius 1 standing upright, and a circle.
    outline(msp, [(10, 0, 0), (12, 0, 1)], extrusion=(0, -1, 0))
    msp.add_circle((20, 0), 2)
    msp.add_polyline3d([(0, 0, 5), (1, 0, 5), (1, 1, 6), (0, 1, 6)], close=True)
    return 12 + math.pi / 2 + 4 * math.pi + math.sqrt(2)


def of_meshes(msp, doc):
    msp.add_3dface([(0, 0, 0), (2, 0, 0), (2, 2, 0), (0, 2, 0)])
    msp.add_solid([(10, 0), (11, 0), (10, 1), (11, 1)])
    cube = forms.cube()
    cube.scale_uniform(2)
    cube.translate(20, 0, 0)
    cube.render_mesh(msp)
    cube.translate(20, 0, 0)
    cube.render_polyface(msp)
    return 4 + 1 + 24 + 24


def of_blocks(msp, doc):
    pane = doc.blocks.new("pane", base_point=(1, 1))
    outline(pane, [(1, 1), (2, 1), (2, 2), (1, 2)])
    pane.add_circle((5, 5), 1)
    row = doc.blocks.new("row")
    row.add_blockref("pane", (0, 0), dxfattribs={"column_count": 3, "column_spacing": 10})
    msp.add_blockref("row", (100, 0), dxfattribs={"xscale": 2, "yscale": 3, "rotation": 30})
    msp.add_blockref("pane", (0, 100), dxfattribs={"xscale": -2, "yscale": 2, "extrusion": (0, 0, -1)})
    return (3 * 6 + 4) * (1 + math.pi)


def main():
    jalon, folder = sys.argv[1], pathlib.Path(sys.argv[2])
    passed = failed = 0
    for draw in (of_polylines, of_meshes, of_blocks):
        for version in ("R12", "R2000", "R2018"):
            if version == "R12" and draw is of_meshes:
                continue  # it has no MESH
            for insunits, metres in ((6, 1.0), (4, 0.001)):
                doc = ezdxf.new(version, units=insunits)
                wanted = draw(doc.modelspace(), doc) * metres**2
                path = folder / "drawn.dxf"
                doc.saveas(path)
                run = subprocess.run([jalon, "convert", "--quiet", path, folder / "drawn.stl", "--set", "chord_error_m=%r" % (0.001 * metres)],
                                     capture_output=True, text=True)
                area = trimesh.load(folder / "drawn.stl").area if run.returncode == 0 else math.nan
                # Release 12 names no unit.
                factor = 1 if version != "R12" else metres**-2
                good = abs(area - wanted * factor) <= SHARE * wanted * factor
                passed, failed = passed + good, failed + (not good)
                print("%s - DXF %s, unit of %g m: %s%s" % ("ok" if good else "not ok", version, metres, draw.__name__,
                                                          "" if good else " %.6g m2 instead of %.6g; %s" % (area, wanted * factor, run.stderr)))
    print("%d passed, %d failed, 0 skipped" % (passed, failed))
    return 1 if failed else 0


if __name__ == "__main__":
    sys.exit(main())

#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The Jalon authors
# SPDX-License-Identifier: Apache-2.0
"""The orthoimage that a drawing links, as ezdxf reads it: check_images.py NAME FOLDER

FOLDER holds model.dxf, orthoimage.png and orthoimage.pgw of one facade."""

import pathlib
import struct
import sys

import ezdxf

from told import tell

PLACE_M = 1e-6


def audited(drawing):
    audit = drawing.audit()
    for problem in audit.errors + audit.fixes:
        yield problem.message


def links(image, folder):
    """The file stands beside the drawing and has the size that the drawing tells."""
    path = folder / image.image_def.dxf.filename
    if not path.is_file():
        yield "there is no %s" % path
        return
    size = struct.unpack(">II", path.read_bytes()[16:24])
    if size != tuple(image.dxf.image_size)[:2]:
        yield "%s instead of %s" % (tuple(image.dxf.image_size), size)


def place(image, walls, folder):
    """In true scale, upright, in the plane of the wall."""
    pixel = float((folder / "orthoimage.pgw").read_text().split()[0])
    right, up, at = image.dxf.u_pixel, image.dxf.v_pixel, image.dxf.insert
    for axis in (right, up):
        if abs(axis.magnitude - pixel) > PLACE_M * pixel:
            yield "a pixel of %.9g m instead of %.9g" % (axis.magnitude, pixel)
    if abs(up.x) + abs(up.y) + abs(right.z) > PLACE_M * pixel:
        yield "it leans: %s, %s" % (right, up)
    normal = right.cross(up).normalize()
    wall = max(walls, key=lambda w: len(w))
    extrusion = wall.dxf.extrusion
    if normal.dot(extrusion.normalize()) < 1 - 1e-4:
        yield "it looks to %s, the wall to %s" % (normal, extrusion)
    corner = wall.ocs().to_wcs((wall[0][0], wall[0][1], wall.dxf.elevation))
    if abs((corner - at).dot(normal)) > 0.05:  # measured walls lean by some millimetres
        yield "it lies %.3g m off the wall" % (corner - at).dot(normal)


def main():
    name, folder = sys.argv[1], pathlib.Path(sys.argv[2])
    drawing = ezdxf.readfile(folder / "model.dxf")
    images = list(drawing.modelspace().query("IMAGE"))
    walls = list(drawing.modelspace().query('LWPOLYLINE[layer=="WALL"]'))
    checks = {
        "has no errors and no fixes": lambda: audited(drawing),
        "links one image": lambda: [] if len(images) == 1 else ["%d images" % len(images)],
        "links a file beside it": lambda: links(images[0], folder),
        "shows it on its wall": lambda: place(images[0], walls, folder),
    }
    return tell("drawing with the orthoimage of " + name, checks)


if __name__ == "__main__":
    sys.exit(main())

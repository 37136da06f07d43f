#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The Jalon authors
# SPDX-License-Identifier: Apache-2.0
"""Orthoimages as GDAL reads them, the GeoTIFF against the PNG with its world file: check_tiff.py NAME FOLDER

FOLDER holds orthoimage.png, orthoimage.pgw and orthoimage.tif of one facade, of colours or of distances, and model.gpkg. Wants
python3-gdal of Debian."""

import pathlib
import sys

import numpy
from osgeo import gdal, ogr

from told import tell

gdal.UseExceptions()
ogr.UseExceptions()
PLACE_M = 1e-6


def place(png, tiff):
    """Both lie at the same place, which the TIFF tells in a local system in metres."""
    if png.GetGeoTransform(can_return_null=True) is None:
        yield "GDAL finds no world file"
        return
    far = max(abs(a - b) for a, b in zip(png.GetGeoTransform(), tiff.GetGeoTransform()))
    if far > PLACE_M:
        yield "%s and %s" % (png.GetGeoTransform(), tiff.GetGeoTransform())
    system = tiff.GetSpatialRef()
    if system is None or not system.IsLocal() or system.GetLinearUnits() != 1:
        yield "its system is %s" % (system and system.ExportToWkt())


def pixels(png, tiff):
    """What has data in one has it in the other; colours are the same."""
    opaque = png.GetRasterBand(4).ReadAsArray() > 0
    if tiff.RasterCount == 1:
        band = tiff.GetRasterBand(1)
        values = band.ReadAsArray()
        if ((values != band.GetNoDataValue()) != opaque).any():
            yield "no-data pixels differ"
        if opaque.any() and not numpy.isfinite(values[opaque]).all():
            yield "a pixel is no number"
        # Blue behind, red before: the sign of the distance is that of red less blue.
        red, blue = (png.GetRasterBand(b).ReadAsArray().astype(int) for b in (1, 3))
        clear = opaque & (numpy.abs(values) > 0.05)
        if (numpy.sign(red - blue)[clear] != numpy.sign(values)[clear]).any():
            yield "colours tell another sign than the numbers"
    elif (png.ReadAsArray() != tiff.ReadAsArray()).any():
        yield "colours differ"
    if opaque.mean() < 0.5:
        yield "%.0f %% of the pixels have data" % (100 * opaque.mean())


def elevation(tiff, folder):
    """It covers the facade of the layer "elevation"."""
    package = ogr.Open(str(folder / "model.gpkg"))  # which its layers do not keep
    left, right, bottom, top = package.GetLayer("elevation").GetExtent()
    x, pixel, _, y, _, _ = tiff.GetGeoTransform()
    covered = x, x + pixel * tiff.RasterXSize, y - pixel * tiff.RasterYSize, y
    if max(abs(a - b) for a, b in zip(covered, (left, right, bottom, top))) > 1.001 * pixel:
        yield "%s instead of %s" % (covered, (left, right, bottom, top))


def main():
    name, folder = sys.argv[1], pathlib.Path(sys.argv[2])
    png, tiff = gdal.Open(str(folder / "orthoimage.png")), gdal.Open(str(folder / "orthoimage.tif"))
    checks = {
        "lies where its world file says": lambda: place(png, tiff),
        "has the pixels of the PNG": lambda: pixels(png, tiff),
        "covers its elevation": lambda: elevation(tiff, folder),
    }
    return tell("GeoTIFF of " + name, checks)


if __name__ == "__main__":
    sys.exit(main())

#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The Jalon authors
# SPDX-License-Identifier: Apache-2.0
"""Depth maps and a depth image as GDAL reads them, against the points that they are of: check_depths.py NAME FOLDER

FOLDER holds scan.xyz with scan.stations.json, depth_reference_K.tif and .png of each station, and front.png, a depth image of the whole
scan. Wants python3-gdal of Debian."""

import json
import pathlib
import sys

import numpy
from osgeo import gdal

from told import tell

gdal.UseExceptions()
RANGE = 2e-6  # of a range: sums of float32
EDGE = 1e-3  # of a pixel: angles are float32, so points that near a border may belong to either side


def stations_of(folder):
    """Position and points of each."""
    points = numpy.loadtxt(folder / "scan.xyz", usecols=(0, 1, 2), comments="#")
    for told in json.loads((folder / "scan.stations.json").read_text())["stations"]:
        position = numpy.array(told["pose"]).reshape(3, 4)[:, 3]
        yield position, points[told["first"]:told["first"] + told["count"]]


def pixels_of(rows, columns, shape, values):
    """Sum, number and most of the values in each pixel; where points near its border leave no doubt of them."""
    total, count, most = numpy.zeros(shape), numpy.zeros(shape), numpy.full(shape, -numpy.inf)
    sure = numpy.ones(shape, bool)
    within = (columns >= 0) & (columns < shape[1]) & (rows >= 0) & (rows < shape[0])
    at = rows[within].astype(int), columns[within].astype(int)
    numpy.add.at(total, at, values[within])
    numpy.add.at(count, at, 1)
    numpy.maximum.at(most, at, values[within])
    corners = [(numpy.floor(rows + up), numpy.floor(columns + aside)) for up in (-EDGE, EDGE) for aside in (-EDGE, EDGE)]
    near = numpy.any([(r != corners[0][0]) | (c != corners[0][1]) for r, c in corners], axis=0)
    for r, c in corners:  # that beyond the raster: its border
        sure[numpy.clip(r[near], 0, shape[0] - 1).astype(int), numpy.clip(c[near], 0, shape[1] - 1).astype(int)] = False
    return total, count, most, sure & (count > 0), within.mean()


def map_of(folder, k):
    return gdal.Open(str(folder / ("depth_reference_%d.tif" % k)))


def ranges(folder):
    """In each pixel that GDAL places in degrees the mean range of its points stands."""
    for k, (position, points) in enumerate(stations_of(folder), 1):
        raster = map_of(folder, k)
        x, width, _, y, _, height = raster.GetGeoTransform()
        away = points - position
        far = numpy.linalg.norm(away, axis=1)
        columns = (numpy.degrees(numpy.arctan2(away[:, 0], away[:, 1])) - x) / width
        rows = (numpy.degrees(numpy.arcsin(away[:, 2] / far)) - y) / height
        values = raster.GetRasterBand(1).ReadAsArray().astype(float)
        total, count, _, sure, within = pixels_of(rows, columns, values.shape, far)
        if within < 0.99 or sure.sum() < 1000:
            yield "station %d: %.3g of the points lie in the raster, %d pixels are sure" % (k, within, sure.sum())
            continue
        mean = total[sure] / count[sure]
        off = numpy.abs(values[sure] - mean) > RANGE * mean
        if off.any():
            yield "station %d: %d of %d pixels are not the mean range" % (k, off.sum(), sure.sum())


def pictures(folder):
    """The picture beside has a grey where the raster has a range, darker farther away."""
    for k, _ in enumerate(stations_of(folder), 1):
        raster, picture = map_of(folder, k), gdal.Open(str(folder / ("depth_reference_%d.png" % k)))  # which bands do not keep
        band, pixels = raster.GetRasterBand(1), picture.GetRasterBand(1)
        values, empty = band.ReadAsArray(), band.GetNoDataValue()
        table = pixels.GetColorTable()
        colours = numpy.array([table.GetColorEntry(i)[:3] for i in range(table.GetCount())])[pixels.ReadAsArray()]
        grey = (colours == colours[..., :1]).all(axis=2)
        if grey.shape != values.shape or (grey != (values != empty)).any():
            yield "station %d: empty pixels differ" % k
            continue
        if (numpy.diff(colours[..., 0][grey][numpy.argsort(values[grey])]) > 0).any():
            yield "station %d: a farther pixel is brighter" % k


def image(folder):
    """Each value of the depth image is the front-most point's of its pixel, as the text chunk tells origin and steps."""
    picture = gdal.Open(str(folder / "front.png"))
    band = picture.GetRasterBand(1)
    values, empty = band.ReadAsArray().astype(int), band.GetNoDataValue()
    grid = numpy.array([float(t) for t in picture.GetMetadataItem("Depth_image_grid").split()]).reshape(4, 3)
    points = numpy.vstack([p for _, p in stations_of(folder)])
    columns, rows, greys = numpy.linalg.solve(grid[1:].T, (points - grid[0]).T)
    _, count, most, sure, within = pixels_of(rows + 0.5, columns + 0.5, values.shape, greys)
    if within < 0.99 or sure.sum() < 1000:
        yield "%.3g of the points lie in the image, %d pixels are sure" % (within, sure.sum())
    if ((values != empty) != (count > 0))[sure].any():
        yield "pixels with points are empty"
    off = numpy.abs(values - most)[sure] > 0.5 + EDGE
    if off.any():
        yield "%d of %d pixels are not their front-most point" % (off.sum(), sure.sum())


def main():
    name, folder = sys.argv[1], pathlib.Path(sys.argv[2])
    checks = {
        "have the mean range in each pixel": lambda: ranges(folder),
        "have the pixels of their pictures": lambda: pictures(folder),
        "have the front-most point in each pixel of an image": lambda: image(folder),
    }
    return tell("depths of " + name, checks)


if __name__ == "__main__":
    sys.exit(main())

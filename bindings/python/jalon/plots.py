# SPDX-FileCopyrightText: 2026 The Jalon authors
# SPDX-License-Identifier: Apache-2.0
"""Pictures: the elevation of a model (SVG, nothing else needed), and with matplotlib histograms and views from above.

Functions that draw take axes (ax=None: new ones) and give them back; nothing is shown or saved by itself.
"""

import os
import tempfile

from . import _api


def elevation(segmentation, model, path=None, **options):
    """The elevation drawing of a model as SVG text, a sheet to print at its scale; written to path too if there is one.

    Options are those of report_write_elevation. In a notebook: IPython.display.SVG(jalon.plots.elevation(...)).
    """
    with tempfile.TemporaryDirectory() as folder:
        target = path if path is not None else os.path.join(folder, "elevation.svg")
        _api.report_write_elevation(segmentation, model, target, **options)
        with open(target, encoding="utf-8") as f:
            return f.read()


def _axes(ax):
    if ax is not None:
        return ax
    from matplotlib import pyplot
    return pyplot.subplots()[1]


def histogram(cloud, field, law=None, ax=None, **options):
    """The histogram of a field, with the noise law where one is given. Options are those of Cloud.field_histogram."""
    ax = _axes(ax)
    found = cloud.field_histogram(field, law=law, **options)
    bins = found.bins
    begin, end = bins["from"], bins["to"]
    ax.bar(begin, bins["count"], width=end - begin, align="edge", color="0.7", edgecolor="0.4", linewidth=0.3)
    if "expected" in bins:
        ax.plot((begin + end) / 2, bins["expected"], color="tab:red", label="noise law")
        ax.legend()
    unit = next((info.unit for info in map(cloud.fields.info, range(cloud.fields.count)) if info.name == field), "")
    ax.set_xlabel("%s (%s)" % (field, unit) if unit else field)
    ax.set_ylabel("points")
    return ax


def top_view(cloud, field=None, ax=None, limit=200000, **scatter):
    """The points seen from above, x and y at one scale, in the colours of a field (None: of the height).

    Of more than limit points every n-th is drawn. scatter: keywords of matplotlib's scatter.
    """
    ax = _axes(ax)
    points = cloud.points
    step = max(1, -(-len(points) // limit))
    values = (points[:, 2] if field is None else cloud[field])[::step]
    style = {"s": 1, "linewidths": 0, **scatter}
    drawn = ax.scatter(points[::step, 0], points[::step, 1], c=values, **style)
    ax.figure.colorbar(drawn, ax=ax, label="height (m)" if field is None else field)
    ax.set_aspect("equal")
    ax.ticklabel_format(useOffset=False)
    ax.set_xlabel("x (m)")
    ax.set_ylabel("y (m)")
    return ax

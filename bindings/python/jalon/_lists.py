# SPDX-FileCopyrightText: 2026 The Jalon authors
# SPDX-License-Identifier: Apache-2.0
"""Lists that are filled piece by piece: gauges, targets, clouds."""

from collections.abc import Mapping
from typing import Any

from . import _native
from ._arguments import instance, number, text, wrong_type
from ._arrays import numbers
from ._shapes import point, pose, square


class _List:
    """A list of the C side; closing is left to Python."""

    __slots__ = ("this",)
    this: Any

    def __len__(self):
        return getattr(_native, type(self).__name__.lstrip("_") + "_count")(self)

    def __repr__(self):
        name, count = type(self).__name__, len(self)
        return "<jalon.%s of %d %s%s>" % (name, count, self._item, "" if count == 1 else "s")


class Gauge(_List):
    """Convex pieces of a gauge. frame: T_gauge_piece (4 x 4 or 3 x 4); None = the gauge's own frame. Lengths in metres."""

    __slots__ = ()
    _item = "piece"
    __swig_destroy__ = _native.delete_Gauge

    def __init__(self):
        self.this = _native.new_Gauge()

    def add_box(self, size, frame=None):
        """size: edges along x, y, z."""
        _native.Gauge_add_box(self, point(size, "size"), pose(frame, "frame", optional=True))

    def add_sphere(self, radius_m, frame=None):
        """Its middle at the origin of its frame."""
        _native.Gauge_add_sphere(self, number(radius_m, "radius_m"), pose(frame, "frame", optional=True))

    def add_cylinder(self, radius_m, length_m, frame=None):
        """Along z, its middle at the origin of its frame."""
        _native.Gauge_add_cylinder(self, number(radius_m, "radius_m"), number(length_m, "length_m"), pose(frame, "frame", optional=True))

    def add_hull(self, points, frame=None):
        """points: (N, 3), 4 to 4096 of them."""
        _native.Gauge_add_hull(self, numbers(points, "points", 3), pose(frame, "frame", optional=True))


_native.Gauge_swigregister(Gauge)


class Targets(_List):
    """Points known in one frame: Targets([("A", (x, y, z)), ...]) or Targets({"A": (x, y, z), ...}); a third item of a tuple is a
    3 x 3 covariance (m2)."""

    __slots__ = ()
    _item = "target"
    __swig_destroy__ = _native.delete_Targets

    def __init__(self, targets=()):
        self.this = _native.new_Targets()
        for target in targets.items() if isinstance(targets, Mapping) else targets:
            if not isinstance(target, (tuple, list)) or not 2 <= len(target) <= 3 or not isinstance(target[0], (str, type(None))):
                raise wrong_type("targets: an item", "(name, (x, y, z)) or (name, (x, y, z), covariance)", target)
            self.add(*target)

    def add(self, name, xyz, covariance=None):
        """One more. name: "" or None where it has none; xyz (m); covariance: 3 x 3 (m2), None where it is not known."""
        _native.Targets_add(self, text(name, "name", optional=True), point(xyz, "xyz"), square(covariance, "covariance"))


_native.Targets_swigregister(Targets)


class _CloudList:
    __slots__ = ("this",)
    this: Any
    __swig_destroy__ = _native.delete_CloudList


_native.CloudList_swigregister(_CloudList)


def targets(value, name):
    """Targets, or what makes them."""
    if isinstance(value, Targets):
        return value
    if isinstance(value, (str, bytes)) or not hasattr(value, "__iter__"):
        raise wrong_type(name, "a jalon.Targets, a dict of names and (x, y, z), or a sequence of (name, (x, y, z))", value)
    return Targets(value)


def gauge(value, name):
    """A gauge."""
    return instance(value, name, Gauge)


def clouds(value, name):
    """Clouds as one argument."""
    from ._api import Cloud
    if not hasattr(value, "__iter__") or isinstance(value, (str, Cloud)):
        raise wrong_type(name, "a sequence of jalon.Cloud", value)
    made = _native.new_CloudList()
    for i, cloud in enumerate(value):
        _native.CloudList_add(made, instance(cloud, "%s[%d]" % (name, i), Cloud))
    return made

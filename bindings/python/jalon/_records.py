# SPDX-FileCopyrightText: 2026 The Jalon authors
# SPDX-License-Identifier: Apache-2.0
"""Rows of tables as small read-only records: a value by its name, as an attribute or in brackets."""

import collections.abc
from typing import Any, Dict, Iterator, Mapping, Tuple

from . import _columns


def plain(value):
    """Python's own numbers; those of one row of several as a tuple."""
    return tuple(map(plain, value)) if isinstance(value, list) else value


def known(enum, value):
    """The member of the enum; the number where a newer library has one that is not known here."""
    try:
        return enum(value)
    except ValueError:
        return value


class Record(collections.abc.Mapping):
    """One row of a table: row.area, row["area"], dict(row). Read-only; several numbers are a tuple; "class" is also row.class_."""

    __slots__ = ("_columns", "_owner", "_row")
    _columns: Dict[str, Any]
    _owner: Any
    _row: int

    def __init__(self, columns: Mapping[str, Any], owner: Any = None, row: int = 0) -> None:
        for name, value in (("_columns", dict(columns)), ("_owner", owner), ("_row", row)):
            object.__setattr__(self, name, value)

    def __getitem__(self, name: str) -> Any:
        try:
            return self._columns[name]
        except KeyError:
            raise KeyError("%s has no %r, but %s" % (type(self).__name__, name, ", ".join(self._columns))) from None

    def __getattr__(self, name: str) -> Any:
        columns = object.__getattribute__(self, "_columns")
        found = name if name in columns else name.rstrip("_")
        if name.startswith("__") or found not in columns:
            raise AttributeError("%s has no %r, but %s" % (type(self).__name__, name, ", ".join(columns)))
        return columns[found]

    def __setattr__(self, name: str, value: Any) -> None:
        raise AttributeError("%s is read-only" % type(self).__name__)

    def __iter__(self) -> Iterator[str]:
        return iter(self._columns)

    def __len__(self) -> int:
        return len(self._columns)

    def __dir__(self):
        return [*super().__dir__(), *self._columns]

    def __eq__(self, other: object) -> bool:
        return isinstance(other, Record) and self.to_dict() == other.to_dict()

    def __reduce__(self):
        return type(self), (self._columns,)

    def to_dict(self) -> Dict[str, Any]:
        """The values by name."""
        return dict(self._columns)

    def __repr__(self) -> str:
        short = ("%s=%s" % (name, _short(value)) for name, value in self._columns.items())
        return "%s(%s)" % (type(self).__name__, ", ".join(short))


def _short(value):
    if hasattr(value, "tolist"):
        value = tuple(value.tolist())
    if isinstance(value, tuple):
        return "(%s)" % ", ".join(map(_short, value[:4])) if len(value) <= 4 else "<%d numbers>" % len(value)
    return "%.6g" % value if isinstance(value, float) and abs(value) < 1e5 else repr(value)


class Summary(Record):
    """What a table of one row says: summary.rms, summary["rms"]. Several numbers are an array (without NumPy a tuple)."""

    __slots__ = ()

    @property
    def table(self) -> Any:
        """The table itself, with units and meanings (Fields.info)."""
        return self._owner

    def __reduce__(self):
        if self._owner is None or self._owner.closed:
            return super().__reduce__()
        from ._tables import summary  # which needs this module
        return summary, (self._owner, self._owner._rows[1])

    def to_dict(self) -> Dict[str, Any]:
        """The values by name, several numbers as lists."""
        return {name: value.tolist() if hasattr(value, "tolist") else list(value) if isinstance(value, tuple) else value
                for name, value in self._columns.items()}


class Point(Record):
    """A point of a cloud: index, xyz, and its fields by their names."""

    __slots__ = ()

    @property
    def x(self) -> float:
        """m"""
        return self._columns["xyz"][0]

    @property
    def y(self) -> float:
        """m"""
        return self._columns["xyz"][1]

    @property
    def z(self) -> float:
        """m"""
        return self._columns["xyz"][2]


class Segment(Record, _columns.SegmentColumns):
    """A segment: a row of Segmentation.segments."""

    __slots__ = ()


class Part(Record, _columns.PartColumns):
    """A part of a model: its row of Model.parts; of parts that a model gives also index, name and part_class."""

    __slots__ = ()
    index: int
    name: str
    part_class: str


class Face(Record, _columns.FaceColumns):
    """A face of a model: a row of Model.faces."""

    __slots__ = ()

    @property
    def __geo_interface__(self) -> Dict[str, Any]:
        """The GeoJSON feature of the face: a polygon with its openings, in the model's coordinates."""
        return self._owner.feature_of(self._row)


class Region(Record, _columns.RegionColumns):
    """A region of changed points: a row of what Comparison.regions gives."""

    __slots__ = ()

    @property
    def __geo_interface__(self) -> Dict[str, Any]:
        """A GeoJSON feature: the plan of the box around the region. Comparison.outlines has the outlines themselves."""
        (west, south), (east, north) = self._columns["box_min"][:2], self._columns["box_max"][:2]
        ring: Tuple[Any, ...] = ((west, south), (east, south), (east, north), (west, north), (west, south))
        return {"type": "Feature", "id": self._columns["region"], "properties": self.to_dict(),
                "geometry": {"type": "Polygon", "coordinates": (ring,)}}


__all__ = ["Record", "Summary", "Point", "Segment", "Part", "Face", "Region"]

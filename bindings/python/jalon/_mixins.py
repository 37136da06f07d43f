# SPDX-FileCopyrightText: 2026 The Jalon authors
# SPDX-License-Identifier: Apache-2.0
"""What the classes have beyond the functions of C: lookups by name, rows to run through, dictionaries."""

import json
import tempfile
from typing import TYPE_CHECKING, Any, Dict, Iterator, List, overload

from . import _arguments, _native
from ._arrays import flat
from ._clouds import Cloud  # noqa: F401 (base() finds it)
from ._handles import Handle
from ._records import Part, Record, Segment
from ._tables import Fields  # noqa: F401

if TYPE_CHECKING:
    from numpy.typing import NDArray

_DOUBLE, _INT64, _BOOL, _STRING, _CHOICE, _DOUBLES = range(1, 7)


class ResultMixin:
    """What the named tuples of several results have."""

    __slots__ = ()

    def to_dict(self):
        """The parts by name; tables as dictionaries of columns."""
        return {name: value.to_dict() if isinstance(value, (Fields, Record)) else value.tolist() if hasattr(value, "tolist") else value
                for name, value in self._asdict().items()}


class Params(Handle):
    """A parameter set as a mapping: names and values, checked when set."""

    _getters = {_DOUBLE: "get_double", _INT64: "get_int64", _BOOL: "get_bool", _STRING: "get_string", _CHOICE: "get_string",
                _DOUBLES: "get_doubles"}

    @property
    def rows(self):
        """The rows of the table, as ParamsInfo tuples."""
        return [self.info(i) for i in range(self.count)]

    def _type_of(self, name):
        for row in self.rows:
            if row.name == name:
                return row.type
        self.get_double(name)  # fails, with the names that there are
        return _DOUBLE

    def keys(self):
        """The names of the parameters."""
        return [row.name for row in self.rows]

    def __iter__(self):
        return iter(self.keys())

    def __len__(self):
        return self.count

    def __contains__(self, name):
        return name in self.keys()

    def __getitem__(self, name):
        return getattr(self, self._getters[self._type_of(name)])(name)

    def __setitem__(self, name, value):
        kind = self._type_of(_arguments.text(name, "name"))
        if kind == _BOOL:
            _native.Params_set_bool(self, name, _arguments.flag(value, name))
        elif kind in (_STRING, _CHOICE):
            convert = _arguments.crs if name == "crs" and value is not None else _arguments.text
            _native.Params_set_string(self, name, convert(value, name))
        elif kind == _DOUBLES:
            _native.Params_set_doubles(self, name, flat(value, name))
        elif kind == _INT64:
            _native.Params_set_int64(self, name, _arguments.integer(value, name, -2 ** 63, 2 ** 63 - 1))
        else:
            _native.Params_set_double(self, name, _arguments.number(value, name))

    def items(self):
        """Names and values."""
        return [(name, self[name]) for name in self.keys()]

    def to_dict(self):
        """The values by name."""
        return json.loads(self.to_json())

    def __repr__(self):
        return "<jalon.Params closed>" if self.closed else "<jalon.Params %s>" % self.to_json()


class _Worker(Handle):
    """Holds parameters and no data: set them as keywords or attributes, then run."""

    _settable = "parameter"

    def _set(self, **given):
        given = {name: value for name, value in given.items() if value is not None}
        if given:
            with self.params as params:
                for name, value in given.items():
                    params[name] = value

    def to_dict(self):
        """The parameters by name."""
        with self.params as params:
            return params.to_dict()

    def __repr__(self):
        name = type(self).__name__
        return "<jalon.%s closed>" % name if self.closed else "<jalon.%s %r>" % (name, self.to_dict())


def base(name, worker):
    """The class that the class of this name in _api.py extends."""
    return globals().get(name, _Worker if worker else Handle)


def parameter(name, help_text):
    """An attribute that is one of the worker's parameters."""
    def get(self):
        with self.params as params:
            return params[name]

    def put(self, value):
        with self.params as params:
            params[name] = value
    return property(get, put, doc=help_text)


class Segmentation(Handle):
    """Labels and segments: running through it gives the segments, as records."""

    @property
    def labels(self: Any) -> "NDArray[Any]":
        """One label a point: 0 = noise, s = row s - 1 of the segments."""
        return self.points["label"]

    def __len__(self: Any) -> int:
        return len(self.segments)

    def __iter__(self: Any) -> Iterator[Segment]:
        return iter(self.segments)

    @overload
    def __getitem__(self, i: int) -> Segment: ...
    @overload
    def __getitem__(self, i: slice) -> List[Segment]: ...

    def __getitem__(self: Any, i: Any) -> Any:
        return self.segments[_row(i)]


class Model(Handle):
    """A tree of parts with faces: running through it gives the parts, as records."""

    def __len__(self: Any) -> int:
        return self.part_count

    def __iter__(self: Any) -> Iterator[Part]:
        for i, row in enumerate(self.parts):
            yield self._part(i, row)

    @overload
    def __getitem__(self, i: int) -> Part: ...
    @overload
    def __getitem__(self, i: slice) -> List[Part]: ...

    def __getitem__(self: Any, i: Any) -> Any:
        count = self.part_count
        if isinstance(_row(i), slice):
            parts = self.parts
            return [self._part(k, parts[k]) for k in range(*i.indices(count))]
        row = self.parts[i]
        return self._part(_arguments.integer(i, "part") % count, row)

    def _part(self, i, row):
        told = self.part(i)
        return Part({"index": i, "name": told.name, "part_class": told.part_class, **row})

    def _parts(self):
        for name in ("parts", "faces", "triangles"):
            yield "%d %s" % (len(getattr(self, name)), name)

    @property
    def __geo_interface__(self: Any) -> Dict[str, Any]:
        """The faces as a GeoJSON feature collection, in the model's coordinates, arcs as chords: what write makes of it."""
        with tempfile.TemporaryDirectory() as folder:
            path = folder + "/model.geojson"
            self.write(path)
            with open(path, encoding="utf-8") as file:
                return json.load(file)


class FacesOf:
    """The model that faces belong to, for their geometry: written once, when first asked for."""

    def __init__(self, model):
        self._model, self._features = model, None

    def feature_of(self, row):
        """The GeoJSON feature of the face of that row; one without an outline has no geometry."""
        if self._features is None:
            self._features = {feature.get("id"): feature for feature in self._model.__geo_interface__["features"]}
        return self._features.get(row, {"type": "Feature", "id": row, "geometry": None, "properties": {}})


def _row(i):
    """An index or a slice."""
    return i if isinstance(i, slice) else _arguments.integer(i, "index")


class Comparison(Handle):
    """Distances."""

    @property
    def distances(self: Any) -> "NDArray[Any]":
        """One distance a point (m); NaN where there is none."""
        return self.points["distance"]

    def __len__(self: Any) -> int:
        return len(self.points)

    def _parts(self):
        yield "%d points" % len(self)
        if len(self.parts):
            yield "%d parts" % len(self.parts)


class Registration(Handle):
    """A pose and what it is worth."""

    def _parts(self):
        summary = self.summary
        for name in ("stopped", "converged", "verdict"):
            if name in summary:
                value = summary[name]
                yield "%s %s" % (name, getattr(value, "name", value))


class Task(Handle):
    """How a call runs."""

    def _begin(self, threads, progress, log, memory_limit):
        for name, value, signature in (("progress", progress, "fraction, stage"), ("log", log, "level, text")):
            if value is not None and not callable(value):
                raise _arguments.wrong_type(name, "a callable of (%s)" % signature, value)
        object.__setattr__(self, "_callables", (progress, log))  # which native code calls and does not keep
        _native.set_callbacks(self, progress, log)
        threads = _arguments.integer(threads, "threads", 0, 2 ** 31 - 1)
        if threads:
            self.set_threads(threads)
        memory_limit = _arguments.integer(memory_limit, "memory_limit", 0, 2 ** 64 - 1)
        if memory_limit:
            self.set_memory_limit(memory_limit)

    def _parts(self):
        yield "a call" + (" that is cancelled" if self.is_cancelled else "")

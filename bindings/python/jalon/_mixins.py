# SPDX-FileCopyrightText: 2026 The Jalon authors
# SPDX-License-Identifier: Apache-2.0
"""What the classes have beyond the functions of C: with-blocks, lookups by name, dictionaries."""

import json
import operator

from . import _native, _pickling
from ._support import _array, _numbers, _out, numpy

_DOUBLE, _INT64, _BOOL, _STRING, _CHOICE, _DOUBLES = range(1, 7)


def _plain(value):
    """Python's own numbers and lists."""
    return value.tolist() if hasattr(value, "tolist") else value


class Handle:
    """An object of the C library. It is given back by close(), by the end of a with-block, or when Python forgets it."""

    _tables = ()

    def __init__(self, *_, **__):
        raise TypeError("%s objects are made by functions, not by calling the class" % type(self).__name__)

    def _take(self, made):
        self.this = made.this

    def close(self):
        """Gives the native memory back now. Closing twice is harmless; any other use afterwards raises ClosedError.

        BusyError while a call on another thread uses the object. Arrays that came from it stay valid.
        """
        self._native_close()

    @property
    def closed(self):
        """Whether close() was called."""
        return self._native_closed()

    def __enter__(self):
        return self

    def __exit__(self, *_):
        self.close()

    def __copy__(self):
        return _pickling.copied(self)

    def __deepcopy__(self, memo):
        return _pickling.copied(self)

    def __reduce_ex__(self, protocol):
        return _pickling.reduced(self, protocol)

    def __init_subclass__(cls, **kwargs):
        super().__init_subclass__(**kwargs)
        if "_native_close" in cls.__dict__:  # functions of C are no methods by themselves
            close, closed = cls._native_close, cls._native_closed
            cls._native_close = lambda self: close(self)
            cls._native_closed = lambda self: closed(self)

    def to_dict(self):
        """What the object tells, as a dictionary of Python's own values: tables of results, texts, counts."""
        found = {}
        for name in self._tables:
            if name in ("points", "params", "cloud"):  # a value a point, or another object
                continue
            value = getattr(self, name)
            if isinstance(value, Fields):
                value = value.to_dict()
            elif isinstance(value, Handle):
                continue
            elif name in ("parameters", "json") and isinstance(value, str) and value:
                value = json.loads(value)
            found[name] = _plain(value)
        return found


class _ResultMixin:
    __slots__ = ()

    def to_dict(self):
        """The parts by name; tables as dictionaries of columns."""
        return {name: value.to_dict() if isinstance(value, Fields) else value if isinstance(value, Handle) else _plain(value)
                for name, value in self._asdict().items()}


class Fields(Handle):
    """A table: columns by name, each an array with one item (or one row) a row of the table."""

    def keys(self):
        """The names of the columns."""
        return [self.info(i).name for i in range(self.count)]

    def __iter__(self):
        return iter(self.keys())

    def __contains__(self, name):
        return name in self.keys()

    def __getitem__(self, name):
        return self.view(name)

    def __len__(self):
        """The number of rows."""
        return self.info(0).count if self.count else 0

    def items(self):
        """Names and columns."""
        return [(name, self.view(name)) for name in self.keys()]

    def to_dict(self):
        """{column: list}; of a table of one row {column: value}."""
        single = len(self) == 1
        return {name: _plain(column)[0] if single else _plain(column) for name, column in self.items()}

    def to_pandas(self):
        """A pandas.DataFrame; columns of several components become name_0, name_1, ..."""
        import pandas
        columns = {}
        for name, column in self.items():
            view = memoryview(column)
            if view.ndim == 1:
                columns[name] = column
            else:
                for c in range(view.shape[1]):
                    columns["%s_%d" % (name, c)] = column[:, c] if numpy else [row[c] for row in view.tolist()]
        return pandas.DataFrame(columns)

    def __repr__(self):
        return "<jalon.Fields closed>" if self.closed else "<jalon.Fields of %d rows: %s>" % (len(self), ", ".join(self.keys()))


class Cloud(Handle):
    """Points with fields and stations."""

    def __len__(self):
        return self.count

    def __getitem__(self, name):
        """A field's values."""
        return self.fields.view(name)

    def __setitem__(self, name, values):
        self.set_field(name, values)

    def __delitem__(self, name):
        self.remove_field(name)

    def __contains__(self, name):
        return name in self.fields

    def __array__(self, dtype=None, copy=None):
        if copy is False and dtype not in (None, float):
            raise ValueError("another type needs a copy")
        made = numpy.asarray(self.points, dtype=dtype)
        return made.copy() if copy else made

    @property
    def stations(self):
        """All stations, as CloudStation tuples."""
        return [self.station(i) for i in range(self.station_count)]

    def __repr__(self):
        return "<jalon.Cloud closed>" if self.closed else "<jalon.Cloud of %d points>" % self.count


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
        kind = self._type_of(name)
        if kind == _BOOL:
            _native.Params_set_bool(self, name, bool(value))
        elif kind in (_STRING, _CHOICE):
            _native.Params_set_string(self, name, value)
        elif kind == _DOUBLES:
            _native.Params_set_doubles(self, name, _array(value, name, 0))
        elif kind == _INT64:
            _native.Params_set_int64(self, name, operator.index(value))
        else:
            _native.Params_set_double(self, name, float(value))

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

    def _set(self, **given):
        given = {name: value for name, value in given.items() if value is not None}
        if given:
            with self.params as params:
                for name, value in given.items():
                    params[name] = value

    def __setattr__(self, name, value):
        if name != "this" and not hasattr(type(self), name):
            raise AttributeError("%r object has no parameter %r" % (type(self).__name__, name))
        super().__setattr__(name, value)

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
    """Labels and segments."""

    @property
    def labels(self):
        """One label a point: 0 = noise, s = row s - 1 of the segments."""
        return self.points["label"]

    def __len__(self):
        return len(self.segments)


class Comparison(Handle):
    """Distances."""

    @property
    def distances(self):
        """One distance a point (m); NaN where there is none."""
        return self.points["distance"]


class Task(Handle):
    """How a call runs."""

    def _begin(self, threads, progress, log):
        _native.set_callbacks(self, progress, log)
        if threads:
            self.set_threads(threads)


class Gauge:
    """Convex pieces of a gauge. frame: T_gauge_piece (3 x 4 or 4 x 4); None = the gauge's own frame. Lengths in metres."""

    __swig_destroy__ = _native.delete_Gauge

    def __init__(self):
        self.this = _native.new_Gauge().this

    def add_box(self, size, frame=None):
        """size: edges along x, y, z."""
        _native.Gauge_add_box(self, _numbers(size, "size"), _numbers(frame, "frame"))

    def add_sphere(self, radius_m, frame=None):
        """Its middle at the origin of its frame."""
        _native.Gauge_add_sphere(self, radius_m, _numbers(frame, "frame"))

    def add_cylinder(self, radius_m, length_m, frame=None):
        """Along z, its middle at the origin of its frame."""
        _native.Gauge_add_cylinder(self, radius_m, length_m, _numbers(frame, "frame"))

    def add_hull(self, points, frame=None):
        """points: (N, 3), 4 to 4096 of them."""
        _native.Gauge_add_hull(self, _array(points, "points", 3), _numbers(frame, "frame"))

    def __len__(self):
        return _native.Gauge_count(self)


_native.Gauge_swigregister(Gauge)


class Targets:
    """Points known in one frame: Targets([("A", (x, y, z)), ...]); a third item is a 3 x 3 covariance (m2)."""

    __swig_destroy__ = _native.delete_Targets

    def __init__(self, targets=()):
        self.this = _native.new_Targets().this
        for target in targets:
            self.add(*target)

    def add(self, name, xyz, covariance=None):
        """One more. name: "" where it has none; xyz (m); covariance: 3 x 3 (m2), None where it is not known."""
        _native.Targets_add(self, name, _numbers(xyz, "xyz"), _numbers(covariance, "covariance"))

    def __len__(self):
        return _native.Targets_count(self)


_native.Targets_swigregister(Targets)


class _CloudList:
    __swig_destroy__ = _native.delete_CloudList


_native.CloudList_swigregister(_CloudList)

# SPDX-FileCopyrightText: 2026 The Jalon authors
# SPDX-License-Identifier: Apache-2.0
"""A cloud as a sequence of points with fields by their names."""

import operator
from typing import TYPE_CHECKING, Any, Iterator, List, Union, overload

from ._arguments import is_bool, numpy
from ._handles import Handle
from ._records import Point, plain
from ._tables import BLOCK_ROWS, frame_columns

if TYPE_CHECKING:
    from numpy.typing import NDArray

    from . import _api


class Cloud(Handle):
    """Points with fields and stations."""

    def __len__(self: Any) -> int:
        return self.count

    @overload
    def __getitem__(self, key: str) -> "NDArray[Any]": ...
    @overload
    def __getitem__(self, key: int) -> Point: ...
    @overload
    def __getitem__(self, key: Union[slice, Any]) -> "_api.Cloud": ...

    def __getitem__(self: Any, key: Any) -> Any:
        """A field's values by its name; a point by its index; a new cloud of a slice, of a mask or of indices."""
        if isinstance(key, str):
            return self.fields.view(key)
        if isinstance(key, slice):
            chosen = range(*key.indices(self.count))
            return self.select(numpy.arange(chosen.start, chosen.stop, chosen.step) if numpy else chosen)
        if is_bool(key) or isinstance(key, (float, tuple)):
            raise TypeError("a name, an index, a slice, a mask or indices are needed, not %s" % type(key).__name__)
        try:
            i = operator.index(key)
        except TypeError:
            return self.select(key)
        count = self.count
        if not -count <= i < count:
            raise IndexError("point %d of a cloud of %d" % (i, count))
        return next(self._points(i % count, i % count + 1))

    def __iter__(self: Any) -> Iterator[Point]:
        return self._points(0, self.count)

    def _points(self, begin, end):
        fields = self.fields
        names = fields.keys()
        columns = [memoryview(self.points)] + [memoryview(fields.view(name)) for name in names]
        for first in range(begin, end, BLOCK_ROWS):
            block = [column[first:min(first + BLOCK_ROWS, end)].tolist() for column in columns]
            for i, (xyz, *values) in enumerate(zip(*block), first):
                yield Point({"index": i, "xyz": tuple(xyz), **dict(zip(names, map(plain, values)))})

    def __setitem__(self: Any, name: str, values: Any) -> None:
        self.set_field(name, values)

    def __delitem__(self: Any, name: str) -> None:
        self.remove_field(name)

    def __contains__(self: Any, name: object) -> bool:
        return name in self.fields

    def __array__(self, dtype=None, copy=None):
        if copy is False and dtype not in (None, float):
            raise ValueError("another type needs a copy")
        if numpy is None:
            raise ImportError("an array of a cloud needs numpy")
        made = numpy.asarray(self.points, dtype=dtype)
        return made.copy() if copy else made

    @property
    def stations(self: Any) -> List[Any]:
        """All stations, as CloudStation tuples."""
        return [self.station(i) for i in range(self.station_count)]

    def to_pandas(self: Any) -> Any:
        """A pandas.DataFrame of x, y, z and the fields (needs pandas)."""
        import pandas
        columns = frame_columns("xyz", self.points)
        for name, column in self.fields.items():
            columns.update(frame_columns(name, column))
        return pandas.DataFrame(columns)

    def __repr__(self: Any) -> str:
        if self.closed:
            return "<jalon.Cloud closed>"
        names = self.fields.keys()
        return "<jalon.Cloud of %d points%s>" % (self.count, ": " + ", ".join(names) if names else "")

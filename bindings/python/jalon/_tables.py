# SPDX-FileCopyrightText: 2026 The Jalon authors
# SPDX-License-Identifier: Apache-2.0
"""Tables: columns by name, rows as records; a summary is the row of a table of one."""

from typing import TYPE_CHECKING, Any, Dict, Generic, Iterator, List, Tuple, TypeVar, Union, overload

from . import _arguments
from ._arguments import numpy
from ._handles import Handle
from ._records import Record, Summary, known, plain

if TYPE_CHECKING:
    from numpy.typing import NDArray

R = TypeVar("R", bound=Record)
BLOCK_ROWS = 4096  # turned into Python's numbers at once: large blocks are quick, small ones cost little memory
# How the parts of a vector are called, by their number.
AXES = {2: ("u", "v"), 3: ("x", "y", "z"), 9: ("xx", "xy", "xz", "yx", "yy", "yz", "zx", "zy", "zz")}
LARGEST_SPLIT = 9  # of a 3 x 3 matrix; those of planes and poses are taken whole
COLOURS = {"rgb": ("r", "g", "b"), "colour": ("r", "g", "b"), "color": ("r", "g", "b")}


def frame_columns(name, column):
    """{name: column} for a frame: vectors become a column a component, xyz becomes x, y, z; large matrices stay whole, one a row."""
    view = memoryview(column)
    if view.ndim == 1:
        return {name: column}
    count = view.shape[1]
    if count > LARGEST_SPLIT:
        return {name: list(column) if numpy else view.tolist()}
    ends = (COLOURS.get(name) if count == 3 else None) or AXES.get(count) or range(count)
    prefix = "" if name in ("xyz", "uv") else name + "_"
    return {"%s%s" % (prefix, end): column[:, i] if numpy else [row[i] for row in view.tolist()] for i, end in enumerate(ends)}


class Fields(Handle, Generic[R]):
    """A table: table["area"] is a column (an array with one item, or one row, a row of the table), table[3] a row, table[2:5]
    some rows; running through it gives rows, len() tells how many there are."""

    _rows: Any = (Record, {}, None)  # class of the rows, {column: enum}, whose rows they are

    def keys(self: Any) -> List[str]:
        """The names of the columns."""
        return [self.info(i).name for i in range(self.count)]

    def __contains__(self: Any, name: object) -> bool:
        return name in self.keys()

    @overload
    def __getitem__(self, name: str) -> "NDArray[Any]": ...
    @overload
    def __getitem__(self, name: int) -> R: ...
    @overload
    def __getitem__(self, name: slice) -> List[R]: ...

    def __getitem__(self: Any, name: Union[str, int, slice]) -> Any:
        if isinstance(name, str):
            return self.view(name)
        if isinstance(name, slice):
            return [self[i] for i in range(*name.indices(self._row_count()))]
        count, i = self._row_count(), _arguments.integer(name, "row")
        if not -count <= i < count:
            raise IndexError("row %d of a table of %d" % (i, count))
        return next(self._records(i % count, i % count + 1))

    def __iter__(self: Any) -> Iterator[R]:
        return self._records(0, self._row_count())

    def __len__(self: Any) -> int:
        """The number of rows."""
        return self._row_count()

    def _row_count(self):
        return self.info(0).count if self.count else 0

    def _records(self, begin, end):
        make, enums, owner = self._rows
        names = self.keys()
        columns = [memoryview(self.view(name)) for name in names]
        converters = [enums.get(name) for name in names]
        for first in range(begin, end, BLOCK_ROWS):
            block = [column[first:min(first + BLOCK_ROWS, end)].tolist() for column in columns]
            for row, values in enumerate(zip(*block), first):
                yield make({name: plain(value) if enum is None else known(enum, value)
                            for name, value, enum in zip(names, values, converters)}, owner, row)

    def _manner(self):
        make, enums, owner = self._rows
        return make, enums, owner is self, None if owner is self else owner

    def __setstate__(self, manner):
        make, enums, owns_itself, owner = manner
        self._rows = (make, enums, self if owns_itself else owner)

    def items(self: Any) -> "List[Tuple[str, NDArray[Any]]]":
        """Names and columns."""
        return [(name, self.view(name)) for name in self.keys()]

    def to_dict(self: Any) -> Dict[str, Any]:
        """{column: list}."""
        return {name: memoryview(column).tolist() for name, column in self.items()}

    def to_pandas(self: Any) -> Any:
        """A pandas.DataFrame (needs pandas). Vectors become a column a component: normal_x, normal_y, normal_z; xyz becomes x, y, z."""
        import pandas
        columns = {}
        for name, column in self.items():
            columns.update(frame_columns(name, column))
        return pandas.DataFrame(columns)

    def __repr__(self: Any) -> str:
        return "<jalon.%s closed>" % type(self).__name__ if self.closed else "<jalon.%s of %d rows: %s>" % (
            type(self).__name__, self._row_count(), ", ".join(self.keys()))


def table(made, record=None, enums=None, owner=None):
    """A table that a function gave, with what its rows are."""
    made._rows = (record or Record, enums or {}, owner)
    return made


def summary(made, enums=None):
    """A table of one row that a function gave, as its row."""
    row = table(made, Summary, enums, made)[0]
    vectors = {name: numpy.array(value) for name, value in row.items() if isinstance(value, tuple)} if numpy else {}
    for vector in vectors.values():
        vector.flags.writeable = False
    return Summary({**row.to_dict(), **vectors}, made)

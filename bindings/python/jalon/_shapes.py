# SPDX-FileCopyrightText: 2026 The Jalon authors
# SPDX-License-Identifier: Apache-2.0
"""Small arrays of a fixed shape, in and out: points, boxes, poses. Poses go out 4 x 4 and come in 4 x 4 or 3 x 4."""

import array

from ._arguments import numpy
from ._arrays import numbers

LAST_ROW = [0.0, 0.0, 0.0, 1.0]


def _shaped(value, name, shapes, optional):
    if value is None and optional:
        return None
    found = numbers(value, name)
    shape = memoryview(found).shape
    if shape not in shapes:
        raise ValueError("%s: the shape %s is needed, not %s" % (name, " or ".join(map(str, shapes)), shape))
    return found


def point(value, name, optional=False):
    """x, y, z."""
    return _shaped(value, name, [(3,)], optional)


def box(value, name, optional=False):
    """Lowest and highest corner."""
    return _shaped(value, name, [(2, 3)], optional)


def square(value, name):
    """A 3 x 3 covariance, as such or in the nine numbers of a table, or None."""
    return _shaped(value, name, [(3, 3), (9,)], True)


def pose(value, name, optional=False):
    """A transform; of a 4 x 4 one the last row must be 0 0 0 1."""
    return _shaped(value, name, [(4, 4), (3, 4)], optional)


def poses(value, name):
    """One pose or many, as rows of twelve numbers."""
    if isinstance(value, (list, tuple)) and value and hasattr(value[0], "__array__"):
        value = [pose(each, "%s[%d]" % (name, i)).tolist() for i, each in enumerate(value)]
    found = numbers(value, name)
    view = memoryview(found)
    shape = view.shape
    if view.ndim not in (2, 3) or shape[-2:] not in ((4, 4), (3, 4)):
        raise ValueError("%s: the shape (N, 4, 4) or (N, 3, 4), or one pose, is needed, not %s" % (name, shape))
    rows = _rows(found, view)
    for i in range(0, len(rows), shape[-2]):
        if shape[-2] == 4 and rows[i + 3] != LAST_ROW:
            raise ValueError("%s[%d]: the last row must be 0 0 0 1" % (name, i // 4))
    kept = [number for i, row in enumerate(rows) if shape[-2] == 3 or i % 4 != 3 for number in row]
    return memoryview(array.array("d", kept)).cast("B").cast("d", [len(kept) // 12, 12]) if kept else numbers([], name)


def _rows(found, view):
    """The rows of four numbers of all poses."""
    nested = view.tolist() if numpy is None or view.ndim == 2 else numpy.asarray(found).reshape(-1, 4).tolist()
    return nested if view.ndim == 2 or numpy is not None else [row for each in nested for row in each]


def nested(view, rows, columns):
    """A small result as lists, for those without NumPy."""
    found = view.tolist()
    flat = [n for row in found for n in row] if view.ndim == 2 else found
    return flat if rows == 1 else [flat[i * columns:(i + 1) * columns] for i in range(rows)]


def pose_out(view):
    """A pose of C as 4 x 4."""
    if numpy is None:
        return nested(view, 3, 4) + [list(LAST_ROW)]
    return numpy.vstack([view, LAST_ROW])


def out(view, rows=0, columns=0):
    """What a user gets: a NumPy array that shares the memory, or the memoryview; small ones as lists without NumPy."""
    if numpy is None:
        return nested(view, rows, columns) if rows else view
    made = numpy.asarray(view)
    return made.reshape(columns) if rows == 1 else made

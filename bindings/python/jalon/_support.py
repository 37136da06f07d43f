# SPDX-FileCopyrightText: 2026 The Jalon authors
# SPDX-License-Identifier: Apache-2.0
"""Arguments on their way in, answers on their way out."""

import array
import contextlib
import os

from . import _native
from ._errors import MissingFileError, NotFoundError

try:
    import numpy
except ImportError:  # everything works without; arrays are memoryviews then
    numpy = None  # type: ignore[assignment]


def _has_buffer(value):
    try:
        memoryview(value)
    except TypeError:
        return False
    return True


def _flattened(value, name):
    """Numbers of nested sequences, and the length of the innermost ones (1 for a flat one)."""
    rows = list(value)
    if rows and not isinstance(rows[0], (int, float)):
        inner = [list(row) for row in rows]
        if len({len(row) for row in inner}) != 1:
            raise ValueError("%s: its rows differ in length" % name)
        numbers = [number for row in inner for number in row]
        return numbers, len(inner[0])
    return rows, 0


def _array(value, name, columns):
    """Anything with a buffer as it is; nested sequences of numbers as an array. columns: elements a row, 0 = any."""
    if value is None or _has_buffer(value):
        if columns > 1 and value is not None:
            view = memoryview(value)
            if view.ndim == 1 and view.shape[0] != 0:
                raise ValueError("%s must have the shape (N, %d), not (%d,)" % (name, columns, view.shape[0]))
        return value
    if numpy is not None and hasattr(value, "__array__"):
        return numpy.asarray(value)
    numbers, width = _flattened(value, name)
    if columns > 1 and numbers and width != columns:
        raise ValueError("%s must have rows of %d numbers" % (name, columns))
    whole = columns == 1 and all(isinstance(n, int) for n in numbers)
    try:
        flat = array.array("q" if whole else "d", numbers)
    except OverflowError:
        flat = array.array("Q", numbers)
    if width < 2 or not numbers:
        return flat
    return memoryview(flat).cast("B").cast(flat.typecode, [len(numbers) // width, width])


def _new_cloud(xyz, flags):
    """A cloud; of an array in column order it takes the columns, so that such an array is copied once too."""
    if (numpy is not None and isinstance(xyz, numpy.ndarray) and xyz.ndim == 2 and xyz.shape[1] == 3 and len(xyz) > 1
            and xyz.dtype == numpy.float64 and xyz.dtype.isnative and xyz.strides[0] == xyz.itemsize):
        return _native.Cloud_create_columns(xyz[:, 0], xyz[:, 1], xyz[:, 2], flags)
    return _native.Cloud_create(xyz, flags)


def _numbers(value, name):
    """A transform, box, point: its numbers, however nested."""
    return _array(value, name, 0)


def _nested(view, rows, columns):
    numbers = view.tolist()
    flat = [n for row in numbers for n in row] if view.ndim == 2 else numbers
    return flat if rows == 1 else [flat[i * columns:(i + 1) * columns] for i in range(rows)]


def _out(view, rows=0, columns=0):
    """What a user gets: a NumPy array that shares the memory, or the memoryview; small ones as lists without NumPy."""
    if numpy is None:
        return _nested(view, rows, columns) if rows else view
    made = numpy.asarray(view)
    return made.reshape(columns) if rows == 1 else made


def _path(value):
    return os.fsdecode(os.fspath(value))


@contextlib.contextmanager
def _files(path):
    """A file that is not there is a FileNotFoundError with its name."""
    try:
        yield
    except NotFoundError as error:
        if os.path.exists(path) and not isinstance(error, FileNotFoundError):
            raise
        missing = MissingFileError(str(error))
        missing.errno, missing.filename = 2, _path(path)
        raise missing from None


def _options(operation, options, **given):
    """The parameter set of an operation; None when nothing differs from its defaults."""
    given = {name: value for name, value in given.items() if value is not None}
    if options is None and not given:
        return None
    from ._api import Params
    if options is not None and not isinstance(options, Params):
        given = {**dict(options), **given}
        options = None
    if options is None or given:
        fresh = Params(operation)
        if options is not None:
            fresh.from_json(options.to_json())
        for name, value in given.items():
            fresh[name] = value
        return fresh
    return options


def _task(progress, task):
    """The task, or the callable of a task for this call alone, or None."""
    if task is not None and progress is not None:
        raise TypeError("give progress= to the task, or no task=")
    return task if task is not None else progress


def _clouds(clouds):
    made = _native.new_CloudList()
    for cloud in clouds:
        _native.CloudList_add(made, cloud)
    return made

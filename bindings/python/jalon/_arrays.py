# SPDX-FileCopyrightText: 2026 The Jalon authors
# SPDX-License-Identifier: Apache-2.0
"""Arrays on their way in: anything with a buffer of numbers, or nested sequences of them. Nothing is copied that need not be.

Numbers are those of 8 to 64 bits. An array of truth values is a mask, never numbers: it chooses points where indices would
(indices), and makes a field of 0 and 1 (values); anywhere else it is refused.
"""

import array
import collections.abc
import itertools
import math
import sys

from ._arguments import integer, is_bool, number, numpy, wrong_type

# Formats of the struct module that the C library has an element type for; "n" and "N" are sizes, of NumPy's intp.
NUMBERS = frozenset("bBhHiIlLqQnNfd")
WHOLE = NUMBERS - frozenset("fd")
NATIVE = ("@", "=", "<" if sys.byteorder == "little" else ">")


def _of_numpy(value, name):
    """Of NumPy and what turns into it: numbers in native byte order; half precision, which C has not, as single."""
    if isinstance(value, numpy.ma.MaskedArray):
        if numpy.ma.is_masked(value):
            raise ValueError("%s: %d of its values are masked: give value.compressed() or value.filled(...)"
                             % (name, numpy.ma.count_masked(value)))
        value = value.data
    value = numpy.asarray(value)
    if value.dtype.kind not in "biuf" or value.dtype.itemsize > 8:
        raise TypeError("%s: an array of numbers of at most 64 bits is needed, not of %s" % (name, value.dtype))
    if value.dtype == numpy.float16:
        return value.astype(numpy.float32)
    return value if value.dtype.isnative else value.astype(value.dtype.newbyteorder("="))


def _format(view):
    """The letter of a memoryview's elements, "" for what C has no type for."""
    letters = view.format
    letter = letters[1:] if letters[:1] in NATIVE else letters
    return letter if letter in NUMBERS or letter == "?" else ""


def buffer(value, name):
    """(what holds the elements, their letter) of anything with a buffer; (None, "") of anything else."""
    if numpy is not None and hasattr(value, "__array__") and not isinstance(value, memoryview):
        value = _of_numpy(value, name)
    try:
        view = memoryview(value)
    except TypeError:
        return None, ""
    letter = _format(view)
    if not letter and numpy is not None and not hasattr(value, "__array__"):
        value = _of_numpy(value, name)  # such as big-endian ones from elsewhere
        letter = _format(memoryview(value))
    if not letter:
        raise TypeError("%s: numbers of 8 to 64 bits in this machine's byte order are needed, not elements of format '%s'"
                        % (name, view.format))
    return value, letter


def _sequence(value, name):
    """The items of a sequence or of what can be run through, but of no text, set or mapping: those have no order of numbers."""
    if isinstance(value, (str, bytes, collections.abc.Set, collections.abc.Mapping)):
        raise wrong_type(name, "an array or a sequence of numbers", value)
    try:
        return list(value)
    except TypeError:
        raise wrong_type(name, "an array or a sequence of numbers", value) from None


def _is_row(item):
    return getattr(item, "ndim", 0) > 0 or not (isinstance(item, str) or hasattr(item, "__float__") or hasattr(item, "__index__"))


def _flattened(items, name):
    """Numbers of nested sequences, and the lengths of the inner ones, outermost first."""
    shape = []
    while items and _is_row(items[0]):
        inner = [_sequence(row, name) for row in items]
        if len({len(row) for row in inner}) != 1:
            raise ValueError("%s: its rows differ in length" % name)
        shape.append(len(inner[0]))
        items = list(itertools.chain.from_iterable(inner))
    return items, shape


def _checked(items, name):
    """Elements of a sequence, each a real number."""
    for item in items:
        if type(item) not in (int, float):
            number(item, name + ": an item")
    return items


def _packed(items, shape, name, whole):
    """The numbers as an array of the shape; whole ones stay whole where that is wanted."""
    whole = whole and all(hasattr(n, "__index__") for n in items)
    try:
        flat = array.array("q" if whole else "d", items)
    except OverflowError:
        if whole and (min(items) < 0 or max(items) >= 2 ** 64):
            raise OverflowError("%s: whole numbers of at most 64 bits are taken" % name) from None
        flat = array.array("Q", items)
    if not shape or not items:
        return flat
    return memoryview(flat).cast("B").cast(flat.typecode, [len(items) // math.prod(shape), *shape])


def numbers(value, name, columns=0, optional=False, whole=False):
    """An array of numbers. columns: elements a row; 1 = a flat one; 0 = any. whole: floats are refused."""
    if value is None and optional:
        return None
    found, letter = (None, "") if value is None else buffer(value, name)
    if found is None:
        items, shape = _flattened(_sequence(value, name), name)
        if whole and not all(hasattr(item, "__index__") for item in items):
            raise TypeError("%s: whole numbers (int) are needed" % name)
        found = _packed(_checked(items, name), shape, name, whole or columns == 1)
    elif letter == "?":
        raise TypeError("%s: numbers are needed, not truth values (bool)" % name)
    elif whole and letter not in WHOLE and memoryview(found).nbytes:
        raise TypeError("%s: whole numbers (int) are needed, not numbers of format '%s'" % (name, letter))
    if columns > 1:
        shape = memoryview(found).shape
        if shape[:1] != (0,) and (len(shape) != 2 or shape[1] != columns):
            raise ValueError("%s: the shape (N, %d) is needed, not %s" % (name, columns, shape))
    return found


def flat(value, name, like=None, optional=False, whole=False):
    """One number an item; a single number stands for as many as there are in like (an array that it stands beside), else one."""
    if value is None or not _is_scalar(value):
        return numbers(value, name, 1, optional, whole)
    count = len(like) if hasattr(like, "__len__") else 1
    return _packed([(integer if whole else number)(value, name)], (), name, True) * count


def _is_scalar(value):
    return not isinstance(value, str) and getattr(value, "ndim", 0) == 0 and (
        hasattr(value, "__float__") or hasattr(value, "__index__"))


def _chosen(mask, count, name):
    if len(mask) != count:
        raise ValueError("%s: a mask has one truth value a point, %d and not %d" % (name, count, len(mask)))
    return array.array("Q", itertools.compress(range(count), mask))


def indices(value, name, count, optional=False):
    """Indices of points, or a mask of them: one truth value for each of count points."""
    if value is None and optional:
        return None
    found, letter = (None, "") if value is None else buffer(value, name)
    if found is None:
        items = _sequence(value, name)
        if items and all(is_bool(item) for item in items):
            return _chosen(items, count, name)
        if any(is_bool(item) for item in items):
            raise TypeError("%s: indices (int) or a mask (bool) are needed, not both in one" % name)
        return numbers(items, name, 1, whole=True)
    if letter != "?":
        return numbers(found, name, 1, whole=True)
    view = memoryview(found)
    if view.ndim != 1:
        raise ValueError("%s: a mask has the shape (%d,), not %s" % (name, count, view.shape))
    if numpy is None or len(view) != count:
        return _chosen(view, count, name)
    return numpy.flatnonzero(found).astype(numpy.uint64, copy=False)


def values(data, name, count):
    """Values of a field, as they are; truth values as 0 and 1 (uint8); one number, or truth value, for all of count points."""
    if data is not None and _is_scalar(data) or is_bool(data):
        if numpy is not None and isinstance(data, (numpy.generic, numpy.ndarray)):
            return _as_numbers(numpy.full(count, data))
        kind = "B" if is_bool(data) else "d" if not hasattr(data, "__index__") else "q" if abs(int(data)) < 2 ** 63 else "Q"
        return array.array(kind, [data if hasattr(data, "__index__") else number(data, name)]) * count
    found, letter = (None, "") if data is None else buffer(data, name)
    if letter == "?":
        return _as_numbers(found)
    if found is None and data is not None:
        items = _sequence(data, name)
        if items and all(is_bool(item) for item in items):
            return array.array("B", map(bool, items))
        return numbers(items, name, 1)
    return numbers(data if found is None else found, name, 0)


def octets(value, name):
    """The bytes of an object: whatever has a buffer of them."""
    found, letter = buffer(value, name)
    if letter not in ("b", "B"):
        raise wrong_type(name, "bytes, or a buffer of them", value)
    return found


def _as_numbers(mask):
    if numpy is not None:
        made = numpy.asarray(mask)
        return made.view(numpy.uint8) if made.dtype == bool else made
    view = memoryview(mask)
    return view if view.format != "?" else array.array("B", view.tolist()) if not view.c_contiguous else view.cast("B")

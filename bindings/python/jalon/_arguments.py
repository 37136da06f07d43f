# SPDX-FileCopyrightText: 2026 The Jalon authors
# SPDX-License-Identifier: Apache-2.0
"""Single arguments on their way in: what is of the wrong type is a TypeError that names the argument and what was expected."""

import operator
import os

try:
    import numpy
except ImportError:  # everything works without; arrays are memoryviews then
    numpy = None  # type: ignore[assignment]


def wrong_type(name, expected, value):
    """The TypeError to raise."""
    told = repr(value)
    shown = " (%s)" % told if isinstance(value, (str, bytes, int, float, complex)) and len(told) < 40 else ""
    return TypeError("%s: %s is needed, not %s%s" % (name, expected, type(value).__name__, shown))


def is_bool(value):
    """Python's own or NumPy's."""
    return isinstance(value, bool) or (numpy is not None and isinstance(value, numpy.bool_))


def number(value, name, optional=False):
    """A float, of anything that is a real number: neither a text nor a truth value is."""
    if type(value) is float or (value is None and optional):
        return value
    convert = hasattr(value, "__float__") or hasattr(value, "__index__")
    if not convert or is_bool(value) or getattr(value, "ndim", 0) != 0:
        raise wrong_type(name, "a number", value)
    try:
        return float(value)
    except (TypeError, ValueError):
        raise wrong_type(name, "a number", value) from None


def integer(value, name, low=None, high=None, optional=False):
    """A whole number from low to high: 3.0 is none, nor is True."""
    if value is None and optional:
        return value
    if is_bool(value):
        raise wrong_type(name, "an int", value)
    try:
        whole = operator.index(value)
    except TypeError:
        raise wrong_type(name, "an int", value) from None
    if low is not None and whole < low:
        raise (ValueError if low == 0 else OverflowError)("%s: at least %d is needed, not %d" % (name, low, whole))
    if high is not None and whole > high:
        raise OverflowError("%s: at most %d is taken, not %d" % (name, high, whole))
    return whole


def flag(value, name):
    """True or False, nothing that is merely true or false when asked."""
    if not is_bool(value):
        raise wrong_type(name, "a bool", value)
    return bool(value)


def text(value, name, optional=False):
    """A str."""
    if isinstance(value, str) or (value is None and optional):
        return value
    raise wrong_type(name, "a str", value)


def crs(value, name, optional=False):
    """The text of a CRS: a str, or an object that tells its WKT, such as pyproj's CRS. None: it is not known."""
    if value is None:
        return None if optional else ""
    if not isinstance(value, str) and callable(getattr(value, "to_wkt", None)):
        return value.to_wkt()
    return text(value, name)


def path(value, name="path"):
    """The name of a file: str, bytes or a pathlib path."""
    try:
        return os.fsdecode(os.fspath(value))
    except TypeError:
        raise wrong_type(name, "a path (str, bytes or os.PathLike)", value) from None


def instance(value, name, kind, optional=False):
    """An object of that class of Jalon."""
    if isinstance(value, kind) or (value is None and optional):
        return value
    raise wrong_type(name, "a jalon." + kind.__name__, value)

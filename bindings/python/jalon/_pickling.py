# SPDX-FileCopyrightText: 2026 The Jalon authors
# SPDX-License-Identifier: Apache-2.0
"""Copies of objects, and pickles: their bytes (jalon/bytes.h), so that they cross to other processes, queues and caches."""

import pickle

from . import _native


COPY_OF_A_COLUMN = "Fields_copy"  # not of the table


def _native_name(handle):
    """The name by which native code knows the class, also of a class that a user derived from it."""
    return next(c.__name__ for c in type(handle).__mro__ if hasattr(_native, c.__name__ + "_close"))


def _refuse(handle, what):
    raise TypeError("%s objects cannot be %s: they belong to the calls of this process" % (type(handle).__name__, what))


def copied(handle):
    """An object of its own. Points, fields and results never change and are shared; what can be set is not."""
    name = _native_name(handle)
    if not hasattr(_native, name + "_to_bytes"):
        _refuse(handle, "copied")
    has_copy = hasattr(_native, name + "_copy") and name + "_copy" != COPY_OF_A_COLUMN
    made = getattr(_native, name + ("_copy" if has_copy else "_again"))(handle)
    if handle._manner() is not None:
        made.__setstate__(handle._manner())
    return made


def revived(name, data):
    """What a pickle of an object calls."""
    return getattr(_native, name + "_from_bytes")(data)


def reduced(handle, protocol):
    """For pickle. From protocol 5 on the bytes are handed over without a copy, out of band where the pickler takes them."""
    name = _native_name(handle)
    if not hasattr(_native, name + "_to_bytes"):
        _refuse(handle, "pickled")
    view = getattr(_native, name + "_to_bytes")(handle)
    return revived, (name, pickle.PickleBuffer(view) if protocol >= 5 else bytes(view)), handle._manner()

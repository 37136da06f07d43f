# SPDX-FileCopyrightText: 2026 The Jalon authors
# SPDX-License-Identifier: Apache-2.0
"""What all objects of the C library share: close, with-blocks, no attributes but their own, dictionaries, copies, a repr."""

import json
from typing import TYPE_CHECKING

from . import _pickling


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

    def _manner(self):
        """What Python knows of the object beyond its bytes, for __setstate__ of a copy; None: nothing."""
        return None

    if not TYPE_CHECKING:  # to which it would say that anything may be set
        def __setattr__(self, name, value):
            own = getattr(type(self), name, None)
            if name != "this" and not isinstance(own, property) and not (name.startswith("_") and hasattr(type(self), name)):
                raise AttributeError("%r object has no %s %r to set" % (type(self).__name__, self._settable, name))
            object.__setattr__(self, name, value)

    _settable = "attribute"

    def __init_subclass__(cls, **kwargs):
        super().__init_subclass__(**kwargs)
        if "_native_close" in cls.__dict__:  # functions of C are no methods by themselves
            close, closed = cls._native_close, cls._native_closed
            cls._native_close = lambda self: close(self)
            cls._native_closed = lambda self: closed(self)

    def _told(self):
        """(name, value) of what the object tells: not a value a point, nor other objects but tables."""
        for name in self._tables:
            if name not in ("points", "params", "cloud"):
                value = getattr(self, name)
                if not isinstance(value, Handle) or hasattr(value, "keys"):
                    yield name, value

    def to_dict(self):
        """What the object tells, as a dictionary of Python's own values: tables of results, texts, counts."""
        found = {}
        for name, value in self._told():
            if hasattr(value, "to_dict"):
                value = value.to_dict()
            elif name in ("parameters", "json") and isinstance(value, str) and value:
                value = json.loads(value)
            found[name] = value.tolist() if hasattr(value, "tolist") else value
        return found

    def _parts(self):
        """What the repr tells."""
        for name, value in self._told():
            if isinstance(value, (int, float)):
                yield "%s %r" % (name, value)
            elif hasattr(value, "_row_count"):
                yield "%d %s" % (value._row_count(), name.replace("_", " "))

    def __repr__(self):
        name = type(self).__name__
        if self.closed:
            return "<jalon.%s closed>" % name
        told = ", ".join(self._parts())
        return "<jalon.%s%s>" % (name, " of " + told if told else "")

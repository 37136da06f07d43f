# SPDX-FileCopyrightText: 2026 The Jalon authors
# SPDX-License-Identifier: Apache-2.0
"""One class a status of the C library; each is also the built-in exception that fits."""

from . import _native


class Error(Exception):
    """Base of all failures of Jalon. code: the status of the C library."""

    code = _native.ERROR_INTERNAL


class InvalidArgumentError(Error, ValueError):
    """Out of range, unknown name, wrong size or shape."""

    code = _native.ERROR_INVALID_ARGUMENT


class OutOfMemoryError(Error, MemoryError):
    """An allocation failed; nothing was changed."""

    code = _native.ERROR_OUT_OF_MEMORY


class CancelledError(Error):
    """Cancelled by Task.cancel, or by a progress callable that returned False."""

    code = _native.ERROR_CANCELLED


class NotFoundError(Error, LookupError):
    """No such field, parameter, station, method."""

    code = _native.ERROR_NOT_FOUND


class MissingFileError(NotFoundError, FileNotFoundError):
    """No such file or folder."""

    def __str__(self):
        return str(self.args[0]) if self.args else ""


class InsufficientDataError(Error, ValueError):
    """Too few points for the work."""

    code = _native.ERROR_INSUFFICIENT_DATA


class DegenerateError(Error, ValueError):
    """Collinear, all equal, no plane: geometry without a solution."""

    code = _native.ERROR_DEGENERATE


class IoError(Error, OSError):
    """The system refused to open, read, write or rename."""

    code = _native.ERROR_IO


class FormatError(Error, ValueError):
    """A file's content is malformed or truncated."""

    code = _native.ERROR_FORMAT


class UnsupportedError(Error, NotImplementedError):
    """Valid, but not handled by this build or method."""

    code = _native.ERROR_UNSUPPORTED


class CallbackError(Error, RuntimeError):
    """A callback failed without an exception of its own."""

    code = _native.ERROR_CALLBACK


class BusyError(Error, RuntimeError):
    """The task already runs a call, or the object is in use by one."""

    code = _native.ERROR_BUSY


class LimitError(Error, OverflowError):
    """More than the library can index or hold."""

    code = _native.ERROR_LIMIT


class InternalError(Error, RuntimeError):
    """A defect of Jalon; please report it."""

    code = _native.ERROR_INTERNAL


class ClosedError(Error, ValueError):
    """The object was closed."""

    code = -1000


__all__ = ["Error", "InvalidArgumentError", "OutOfMemoryError", "CancelledError", "NotFoundError", "MissingFileError",
           "InsufficientDataError", "DegenerateError", "IoError", "FormatError", "UnsupportedError", "CallbackError", "BusyError",
           "LimitError", "InternalError", "ClosedError"]

# A status without a class of its own is an Error (0 stands for those).
_native.set_errors({**{globals()[name].code: globals()[name] for name in __all__ if name not in ("Error", "MissingFileError")},
                    0: Error})

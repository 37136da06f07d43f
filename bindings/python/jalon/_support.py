# SPDX-FileCopyrightText: 2026 The Jalon authors
# SPDX-License-Identifier: Apache-2.0
"""What calls of the generated code share: clouds of arrays, options, tasks, missing files."""

import contextlib
import os

from . import _native
from ._arguments import instance, numpy, path as _path, wrong_type
from ._errors import MissingFileError, NotFoundError


def new_cloud(xyz, flags):
    """A cloud; of an array in column order it takes the columns, so that such an array is copied once too."""
    if (numpy is not None and isinstance(xyz, numpy.ndarray) and xyz.ndim == 2 and xyz.shape[1] == 3 and len(xyz) > 1
            and xyz.dtype == numpy.float64 and xyz.dtype.isnative and xyz.strides[0] == xyz.itemsize):
        return _native.Cloud_create_columns(xyz[:, 0], xyz[:, 1], xyz[:, 2], flags)
    return _native.Cloud_create(xyz, flags)


@contextlib.contextmanager
def files(path):
    """A file that is not there is a FileNotFoundError with its name."""
    try:
        yield
    except NotFoundError as error:
        if os.path.exists(path) and not isinstance(error, FileNotFoundError):
            raise
        missing = MissingFileError(str(error))
        missing.errno, missing.filename = 2, _path(path)
        raise missing from None


def options(operation, options, /, **given):
    """The parameter set of an operation; None when nothing differs from its defaults."""
    given = {name: value for name, value in given.items() if value is not None}
    if options is None and not given:
        return None
    from ._api import Params
    if options is not None and not isinstance(options, Params):
        if not hasattr(options, "keys"):
            raise wrong_type("options", "a mapping of names and values, or a jalon.Params,", options)
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


def task(progress, task):
    """The task, or the callable of a task for this call alone, or None."""
    from ._api import Task
    if task is None:
        if progress is not None and not callable(progress):
            raise wrong_type("progress", "a callable of (fraction, stage)", progress)
        return progress
    if progress is not None:
        raise TypeError("give progress= to the task, or no task=")
    return instance(task, "task", Task)

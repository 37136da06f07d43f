# SPDX-FileCopyrightText: 2026 The Jalon authors
# SPDX-License-Identifier: Apache-2.0
"""Which test called what: every function of the native module, and every method that the package adds, notes the first test in which a
call of it ended without an exception. What nothing called has no line, so the list cannot say more than what happened."""

import functools
import inspect
import types

import jalon
from jalon import _native, plots

# Of SWIG itself, or nothing that a test could call for its own sake.
NOT_CALLED = ("delete_", "SWIG_", "_swig", "set_errors")
NOT_NOTED = {"__init_subclass__", "__class_getitem__", "__setattr__"}


class Trace:
    def __init__(self):
        self.test = ""  # that is running
        self.called = {}  # {name: test}

    def noted(self, name, function):
        """The function, noting its calls."""
        @functools.wraps(function, assigned=("__module__", "__name__", "__qualname__", "__doc__"), updated=())
        def call(*arguments, **named):
            made = function(*arguments, **named)
            if name not in self.called and self.test:
                self.called[name] = self.test
            return made
        return call

    def watch(self):
        for name in dir(_native):
            function = getattr(_native, name)
            if isinstance(function, types.BuiltinFunctionType) and not any(part in name for part in NOT_CALLED):
                setattr(_native, name, self.noted(name, function))
        for name in dir(jalon):
            if inspect.isclass(getattr(jalon, name)):
                for base in getattr(jalon, name).__mro__:
                    if base.__module__.startswith("jalon.") and not base.__module__.endswith(("._api", "._errors")):
                        self.watch_class(base)
        for name, function in vars(plots).items():
            if inspect.isfunction(function) and not name.startswith("_"):
                setattr(plots, name, self.noted("plots." + name, function))

    def watch_class(self, watched):
        for name, member in list(vars(watched).items()):
            full = "%s.%s" % (watched.__name__, name)
            if name in NOT_NOTED or (name.startswith("_") and not name.endswith("__")) or hasattr(member, "noted"):
                continue
            if inspect.isfunction(member):
                made = self.noted(full, member)
            elif isinstance(member, property):
                made = property(self.noted(full, member.fget), member.fset, member.fdel, member.__doc__)
            else:
                continue
            if not isinstance(made, property):
                made.noted = True
            type.__setattr__(watched, name, made)

    def write(self, path):
        with open(path, "w", encoding="utf-8") as file:
            file.writelines("%s\t%s\n" % item for item in sorted(self.called.items()))

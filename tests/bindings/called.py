#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The Jalon authors
# SPDX-License-Identifier: Apache-2.0
"""Every public function of a binding is called with real data by a test: called.py LANGUAGE FILE

FILE is what the tests of that language wrote while they ran: a line a function, its name, a tab, the test in which a call of it ended
well. The names of what must be there come from the public headers, through bindings/generator, and for what a binding adds by hand from
its sources (OWN): a function that a test does not call fails here, however it is reached.
"""

import ast
import os
import sys

HERE = os.path.dirname(os.path.abspath(__file__))
ROOT = os.path.join(HERE, "..", "..")
sys.path[:0] = [os.path.join(HERE, "..", "style"), os.path.join(ROOT, "bindings", "generator")]
from shapes import LISTS, methods  # noqa: E402
from source import Tally  # noqa: E402

# Classes of bindings/swig/lists.h and what each has.
LIST_METHODS = {"Gauge": ("add_box", "add_sphere", "add_cylinder", "add_hull", "count"), "Targets": ("add", "count"), "CloudList": ("add",)}
# Of Python's own protocols, what no call of a user reaches by itself.
NOT_CALLED = {"__init_subclass__", "__setattr__", "__class_getitem__"}


def of_the_headers():
    """Cloud_knn, gauge_sweep ...: one name a function of C that the bindings wrap, and the lists that stand for arrays of structs."""
    names = {m.full_name for m in methods()}
    for name in sorted(set(LISTS.values())):
        names |= {"%s_%s" % (name, method) for method in LIST_METHODS[name]} | {"new_" + name}
    return names


def refuses(function):
    """Whether a function does nothing but raise."""
    return isinstance(function.body[-1], ast.Raise) and len(function.body) <= 2


def of_python():
    """What bindings/python adds by hand: Fields.to_pandas, Cloud.__getitem__, plots.histogram ..."""
    folder = os.path.join(ROOT, "bindings", "python", "jalon")
    for file in sorted(n for n in os.listdir(folder) if n.endswith(".py") and n != "_errors.py"):
        with open(os.path.join(folder, file), encoding="utf-8") as f:
            tree = ast.parse(f.read())
        for node in tree.body:
            if isinstance(node, ast.FunctionDef) and not file.startswith("_") and not node.name.startswith("_"):
                yield "%s.%s" % (file[:-3], node.name)
            if isinstance(node, ast.ClassDef) and node.name not in ("_CloudList", "FacesOf"):
                for member in (m for m in ast.walk(node) if isinstance(m, ast.FunctionDef)):
                    public = not member.name.startswith("_") or member.name.endswith("__")
                    if public and member.name not in NOT_CALLED and not refuses(member):
                        yield "%s.%s" % (node.name, member.name)


OWN = {"python": of_python, "java": set, "csharp": set}


def main():
    language, path = sys.argv[1:3]
    with open(path, encoding="utf-8") as file:
        called = dict(line.rstrip("\n").split("\t", 1) for line in file)
    tally = Tally()
    for kind, wanted in (("public", of_the_headers()), ("own", set(OWN[language]()))):
        tally.check("%s__every_%s_function_is_called_by_a_test" % (language, kind), sorted(wanted - set(called)))
        print("FIGURE %s: %d of %d %s functions are called by tests, as %s lists"
              % (language, len(wanted & set(called)), len(wanted), kind, path))
    tally.close()


if __name__ == "__main__":
    main()

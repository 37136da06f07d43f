# SPDX-FileCopyrightText: 2026 The Jalon authors
# SPDX-License-Identifier: Apache-2.0
"""Public members as the package's own stubs (_api.pyi) describe them, and values that no parameter of such a kind may take."""

import ast
import os
from collections import namedtuple

import numpy as np

import jalon

Parameter = namedtuple("Parameter", "name kind optional required")
Member = namedtuple("Member", "owner name parameters is_static manner")  # manner: "call", "get" or "set"

UNKNOWN = Parameter("no_such_keyword", "", False, True)
NUL, LONE = "a\0b", "a\ud800b"
NONE = (None,)
NUMBERS = ("3", [], {}, object(), 1j, b"1")
NO_NUMBERS = ("text", object(), [[1, 2], [3]], {"a": 1}, np.array(["a", "b"]), np.ones(3) * 1j, [None, 1], np.empty((2, 2), object))
NO_TEXTS = (3, b"bytes", [], NUL, LONE, object())
NO_OBJECTS = (7, "text", [], object(), jalon.Cloud, Ellipsis)
WRONG = {
    "int": (*NUMBERS, 2.5, float("nan"), 2 ** 70, -2 ** 70),
    "float": (*NUMBERS, [1.0, 2.0]),
    "str": NO_TEXTS,
    "choice": (*NO_TEXTS, "no such choice", ""),
    "Path": (3.5, [], object(), NUL, LONE),
    "ArrayLike": NO_NUMBERS,
    "ValuesLike": NO_NUMBERS,
    "Sequence[float]": NO_NUMBERS,
    "Indices": ("text", object(), [1.5], [2 ** 70], [-1], {"a": 1}, [[1, 2], [3]], np.array(["a"])),
    "Bytes": ("text", 3, object(), b"", b"wild", [1, 2], np.ones(3)),
    "Progress": (3, "text", object()),
    "options": (3, "text", {"no such parameter": 1}, {1: 2}, {"k": object()}, object()),
    "bool": ("yes", [], 2.5, object(), 1j),
    "CrsLike": (3, [], object(), NUL, LONE),
    "Gauge": NO_OBJECTS,
    "Union[ElementType, int]": (*NUMBERS, 0, -1, 99, 2 ** 70),
    "Union[Primitive, int]": (*NUMBERS, 0, -1, 99, 2 ** 70),
    "TargetsLike": (3, object(), [3], [("a",)], [("a", "text")], {"a": [1, 2]}, [(NUL, (1, 2, 3))]),
    "Iterable[Cloud]": (3, object(), [3], [None], ["text"], [object()]),
}
SHORT = {"Union[Params, Mapping[str, Any], None]": "options", "Callable[[int, str], Any]": "Progress"}


def parameter_of(name, annotation, default):
    text = ast.unparse(annotation)
    optional = text.startswith("Optional[") or "None" in text or text == "CrsLike"
    if text.startswith("Optional["):
        text = text[len("Optional["):-1]
    return Parameter(name, "choice" if text.startswith("Literal[") else SHORT.get(text, text), optional, default is None)


def member_of(owner, function):
    marks = [ast.unparse(mark) for mark in function.decorator_list]
    given = function.args
    positional = given.args[0 if owner is None or "staticmethod" in marks else 1:]
    defaults = [None] * (len(positional) - len(given.defaults)) + list(given.defaults)
    parameters = [parameter_of(a.arg, a.annotation, d) for a, d in zip(positional + given.kwonlyargs, defaults + list(given.kw_defaults))]
    return Member(owner, function.name, parameters, owner is None or "staticmethod" in marks or function.name == "__init__",
                  "get" if "property" in marks else "call")


def members():
    """All of the module's functions and of its classes' members, in the order of the stubs."""
    with open(os.path.join(os.path.dirname(jalon.__file__), "_api.pyi"), encoding="utf-8") as f:
        tree = ast.parse(f.read())
    out = []
    for node in tree.body:
        if isinstance(node, ast.FunctionDef):
            out.append(member_of(None, node))
        elif isinstance(node, ast.ClassDef) and hasattr(getattr(jalon, node.name, None), "close"):
            out += [member_of(node.name, f) for f in node.body
                    if isinstance(f, ast.FunctionDef) and not any(ast.unparse(mark).endswith(".setter") for mark in f.decorator_list)]
            out += [Member(node.name, part.target.id, [parameter_of("value", part.annotation, None)], False, "set") for part in node.body
                    if isinstance(part, ast.AnnAssign)]  # parameters of workers
    return out


def wrong_values(parameter, closed):
    """What this parameter must refuse; closed: {class: a closed object}."""
    nouns = [name for name in closed if name == parameter.kind]
    values = list(WRONG.get(parameter.kind, ()))
    if nouns:
        values = [*NO_OBJECTS, closed[nouns[0]], closed["Task" if nouns[0] != "Task" else "Cloud"]]
    elif parameter.kind == "options":
        values.append(closed["Params"])
    return values + ([] if parameter.optional or not values else [None])

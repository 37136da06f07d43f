# SPDX-FileCopyrightText: 2026 The Jalon authors
# SPDX-License-Identifier: Apache-2.0
"""The overloads of C#'s methods: masks of points, fields of flags, and inputs that optional arguments cannot leave out."""

import re

from csharp_inputs import camel, default_of, parameter_list, seen_by_caller, takes_task
from csharp_names import summary

# Inputs before those that a caller must give, with what stands for them.
LEFT_OUT = {"jalon_model_clearance": {"part": "Constants.WholeModel"},
            "jalon_model_clearance_to_model": {"part": "Constants.WholeModel", "other_part": "Constants.WholeModel"}}
# Methods that take their inputs in C's order too.
IN_ORDER = {"jalon_scanner_add_station"}
TASK = ["progress", "task", "cancel"]


def ordered(m):
    """The inputs as the full form takes them: those without a default first."""
    return sorted(seen_by_caller(m), key=lambda i: default_of(m, i) is not None)


def overload(m, name, result, parameters, arguments, about):
    arguments = arguments + (TASK if takes_task(m) else [])
    return summary(about, "") + ["public %s%s %s(%s) {" % ("static " if m.is_static else "", result, name, parameters),
                                 "  %s%s(%s);" % ("" if result == "void" else "return ", name, ", ".join(arguments)), "}", ""]


def replaced(m, name, result, i, parameter, argument, about):
    """With another type for one of the inputs, which becomes the first of that place."""
    parameters = re.sub(r"ArrayArgument %s( = default\(ArrayArgument\))?" % camel(i.name), parameter, parameter_list(m), count=1)
    return overload(m, name, result, parameters, [argument if j is i else camel(j.name) for j in ordered(m)], about)


def emit_overloads(m, name, result):
    """The lines beside the full form."""
    out = []
    for i in seen_by_caller(m):
        if m.noun == "jalon_cloud" and not m.is_static and i.kind == "packed" and i.name in ("indices", "seeds"):
            taken = "Masks.%s(mask, Count)" % ("Indices" if m.name == "select" else "Some")
            out += replaced(m, name, result, i, "bool[] mask", taken,
                            "The same of a mask: one a point of this cloud, true for those that are meant.")
        if i.name == "data":
            out += replaced(m, name, result, i, "bool[] data", "Masks.Flags(data)", "The same of flags, kept as 0 and 1.")
    left = LEFT_OUT.get(m.c.name)
    if left:
        parameters = re.sub("|".join(r"\blong %s, " % camel(n) for n in left), "", parameter_list(m))
        out += overload(m, name, result, parameters, [left.get(i.name) or camel(i.name) for i in ordered(m)],
                        "The same of all parts.")
    if m.c.name in IN_ORDER:
        parameters = ", ".join(re.search(r"\w+ %s\b" % camel(i.name), parameter_list(m)).group(0) for i in seen_by_caller(m))
        out += overload(m, name, result, parameters, [camel(i.name) for i in ordered(m)], "The same in the order of C.")
    return out

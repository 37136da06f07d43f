# SPDX-FileCopyrightText: 2026 The Jalon authors
# SPDX-License-Identifier: Apache-2.0
"""The parameter tables and the constants as C#: properties of workers, option classes, enums."""

from csharp_names import pascal, summary
from headers import constants
from texts import BOOL, DOUBLE, DOUBLES, INT64, row_text, worker_rows

TYPES = {DOUBLE: ("double", "Double"), INT64: ("long", "Int64"), BOOL: ("bool", "Bool"), DOUBLES: ("double[]", "Doubles")}
# Enums of their own; the first name of each, what its names begin with and what they are.
ENUMS = {"OK": ("Status", "", "Status of a call; messages say more."),
         "INT8": ("ElementType", "", "Types of array elements."),
         "LOG_DEBUG": ("LogLevel", "LOG_", "Levels of the log."),
         "PARAM_DOUBLE": ("ParamType", "PARAM_", "Types of parameters.")}
# What an option class has already.
TAKEN = {"Count", "Info", "Names", "Reset", "Set", "Get", "IsDisposed", "Parameters", "Run", "Truth", "AddStation"}


def property_of(row, target, about):
    type_, suffix = TYPES.get(row["type"], ("string", "String"))
    name = pascal(row["name"])
    name = name + "Value" if name in TAKEN else name
    read = "%sGet%s(\"%s\")" % (target, suffix, row["name"])
    change = "%sSet%s(\"%s\", value)" % (target, suffix, row["name"])
    return summary("Parameter " + about, "") + ["public %s %s {" % (type_, name), "  get { return %s; }" % read,
                                                "  set { %s; }" % change, "}", ""]


def worker_properties(tables, worker):
    out, all_methods = [], len(tables["workers"][worker])
    for row in worker_rows(tables, worker):
        of = "" if len(row["of"]) == all_methods else " Of: %s." % ", ".join(row["of"])
        out += property_of(row, "Parameters.", row_text(dict(row, methods="")) + of)
    return out


def emit_options(tables):
    out = []
    for operation, rows in sorted(tables["operations"].items()):
        name = pascal(operation) + "Options"
        out += summary("The parameters of operation \"%s\"; what is not set has its default." % operation, "")
        out += ["public sealed class %s : Params {" % name, "  /// <summary>All at their defaults.</summary>",
                "  public %s() : base(\"%s\") {}" % (name, operation), ""]
        for row in rows:
            out += ["  " + line if line else "" for line in property_of(row, "", row_text(row))]
        out += ["}", ""]
    return "\n".join(out)


def emit_constants():
    groups = {}
    for name, number, comment, group in constants():
        groups.setdefault(group, []).append((name, number, comment))
    out, rest = [], []
    for items in groups.values():
        enum = ENUMS.get(items[0][0])
        if enum is None:
            rest += items
            continue
        out += summary(enum[2], "") + ["public enum %s {" % enum[0]]
        for name, number, comment in items:
            out += summary(comment or name, "  ") + ["  %s = %d," % (pascal(name[len(enum[1]):]), number)]
        out += ["}", ""]
    out += summary("The values that columns of tables hold.", "") + ["public static class Constants {"]
    for name, number, comment in rest:
        type_ = "int" if number < 2 ** 31 else "long" if name == "WHOLE_MODEL" else "ulong"
        value = "-1" if type_ == "long" else "ulong.MaxValue" if type_ == "ulong" else str(number)
        out += summary(comment or name, "  ") + ["  public const %s %s = %s;" % (type_, pascal(name), value)]
    return out + ["}", ""]

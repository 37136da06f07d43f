# SPDX-FileCopyrightText: 2026 The Jalon authors
# SPDX-License-Identifier: Apache-2.0
"""The parameters of a Python function: how they are declared, what their types are, and how they are checked on their way in."""

from api_description import COUNTS, NOT_NULLABLE, ROWS, says
from emit_swig import inputs_seen
from python_names import ENUM_INPUTS
from shapes import class_of
from texts import BOOL, CHOICE, DOUBLE, DOUBLES, INT64, STRING

PYTHON_TYPES = {DOUBLE: "float", INT64: "int", BOOL: "bool", STRING: "str", DOUBLES: "Sequence[float]"}
# What an argument is when it is not given.
DEFAULTS = {"flags": "0", "level": "-1", "part": "WHOLE_MODEL", "other_part": "WHOLE_MODEL", "centred": "True", "components": "1"}
# Arrays of indices of the points of the cloud whose method it is: a mask does too.
INDICES = {"indices", "seeds"}
RANGES = {"uint64_t": (0, 2 ** 64 - 1), "uint32_t": (0, 2 ** 32 - 1), "int64_t": (-2 ** 63, 2 ** 63 - 1),
          "int32_t": (-2 ** 31, 2 ** 31 - 1), "jalon_status": (-2 ** 31, 2 ** 31 - 1)}
SMALL_CHECKS = {"jalon_vec3": "_point", "jalon_box": "_box", "jalon_transform": "_pose"}


def row_hint(row):
    """The type of a parameter of a table."""
    return literal(row["choices"].split("|")) if row["type"] == CHOICE else PYTHON_TYPES[row["type"]]


def literal(names):
    return "Literal[%s]" % ", ".join(repr(name) for name in names)


def is_optional(m, i):
    """Whether None may be given."""
    return i.nullable and not says(NOT_NULLABLE, m.c.name, i.name)


def hint_in(m, i):
    if i.name in INDICES and i.kind == "packed":
        base = "Indices"
    elif i.name in ENUM_INPUTS:
        base = "Union[%s, int]" % ENUM_INPUTS[i.name]
    elif i.name == "crs":
        base = "CrsLike"
    else:
        base = {"handle": lambda: class_of(i.type), "text": lambda: "Path" if i.name == "path" else "str", "flag": lambda: "bool",
                "number": lambda: "float" if i.type == "double" else "int", "list": lambda: list_hint(i), "bytes": lambda: "Bytes",
                "rows": lambda: "ValuesLike" if i.name == "data" else "ArrayLike",
                "packed": lambda: "ArrayLike" if i.name in ROWS else "ValuesLike"}.get(i.kind, lambda: "ArrayLike")()
    return "Optional[%s]" % base if is_optional(m, i) else base


def list_hint(i):
    return {"CloudList": "Iterable[Cloud]", "Targets": "TargetsLike"}.get(i.type, i.type)


class Signature:
    """The parameters of a Python function: [text for the code], [text for the stub], and the arguments of the native call."""

    def __init__(self, m, tables):
        self.m = m
        self.rows = tables["operations"][m.operation] if m.operation else []
        seen = inputs_seen(m)
        own = seen if m.is_static or not m.noun else seen[1:]
        plain = [i for i in own if i.kind not in ("options", "task")]
        required = [i for i in plain if not is_optional(m, i) and i.name not in DEFAULTS]
        optional = [i for i in plain if i not in required]
        self.code = [i.name for i in required] + ["%s=%s" % (i.name, DEFAULTS.get(i.name, "None")) for i in optional]
        self.stub = (["%s: %s" % (i.name, hint_in(m, i)) for i in required]
                     + ["%s: %s = ..." % (i.name, hint_in(m, i)) for i in optional])
        has_options, has_task = m.input("options") is not None, m.input("task") is not None
        if has_options or has_task:
            self.code.append("*")
            self.stub.append("*")
        if has_options:
            self.code += ["%s=None" % r["name"] for r in self.rows] + ["options=None"]
            self.stub += ["%s: Optional[%s] = ..." % (r["name"], row_hint(r)) for r in self.rows]
            self.stub.append("options: Union[Params, Mapping[str, Any], None] = ...")
        if has_task:
            self.code += ["progress=None", "task=None"]
            self.stub += ["progress: Optional[Progress] = ...", "task: Optional[Task] = ..."]
        self.arguments = [self.argument(i) for i in seen]

    def argument(self, i):
        m = self.m
        if m.noun and not m.is_static and i is m.inputs[0]:
            return "self"
        if i.kind == "options":
            return "_options(%r, options, %s)" % (m.operation, ", ".join("%s=%s" % (r["name"], r["name"]) for r in self.rows))
        if i.kind == "task":
            return "_task(progress, task)"
        return "%s(%s)" % (self.check(i)[0], ", ".join([i.name, repr(i.name)] + self.check(i)[1] +
                                                       (["optional=True"] if is_optional(m, i) else [])))

    def check(self, i):
        """(the function that checks an argument, what it needs to know beside value and name)."""
        if i.kind == "handle":
            return "_instance", [class_of(i.type)]
        if i.kind == "text":
            return {"path": "_path", "crs": "_crs"}.get(i.name, "_text"), []
        if i.kind == "flag":
            return "_flag", []
        if i.kind == "number":
            return ("_number", []) if i.type == "double" else ("_integer", [str(n) for n in RANGES[i.type]])
        if i.kind == "list":
            return {"CloudList": "_clouds", "Targets": "_targets", "Gauge": "_gauge"}[i.type], []
        if i.kind == "bytes":
            return "_octets", []
        if i.kind == "poses":
            return "_poses", []
        if i.kind == "small":
            return SMALL_CHECKS[i.type], []
        return self.array_check(i)

    def array_check(self, i):
        if i.name in INDICES:
            return "_indices", ["self.count"]
        if i.kind == "rows" and i.name == "data":
            return "_values", ["self.count" if self.m.class_name == "Cloud" else "1"]
        whole = [] if i.kind == "rows" or i.type == "const double*" else ["whole=True"]
        if i.name in ROWS:
            return "_numbers", [str(ROWS[i.name])] + whole
        beside = next(j for j in self.m.inputs if COUNTS.get(j.name) == COUNTS.get(i.name))
        return "_flat", ([] if beside is i else [beside.name]) + whole

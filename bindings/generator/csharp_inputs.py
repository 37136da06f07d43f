# SPDX-FileCopyrightText: 2026 The Jalon authors
# SPDX-License-Identifier: Apache-2.0
"""The inputs of C#'s methods: types, defaults, what holds them during a call."""

from api_description import NOT_NULLABLE, says
from csharp_names import CLASSES, camel
from emit_swig import inputs_seen
from shapes import class_of

UNSIGNED = ("uint32_t", "uint64_t")
SCALARS = {"uint32_t": "long", "uint64_t": "long", "int32_t": "int", "jalon_status": "int", "int64_t": "long", "double": "double",
           "std::string": "string"}
# Inputs that C wants and a caller seldom does, with what stands for them.
DEFAULTS = {("jalon_cloud_knn", "level"): "Constants.LevelAutomatic", "flags": "0",
            ("jalon_cloud_builder_declare_field", "components"): "1"}


def class_name(noun):
    name = class_of(noun)
    return CLASSES.get(name, name)


def input_type(i):
    if i.kind in ("rows", "packed", "bytes", "small", "poses"):
        return "ArrayArgument"
    if i.kind in ("handle", "options"):
        return class_name(i.type)
    if i.kind == "list":
        return "IEnumerable<Cloud>" if i.type == "CloudList" else i.type
    return {"text": "string", "flag": "bool"}.get(i.kind) or SCALARS[i.type]


def default_of(m, i):
    """The text of the default, or None where the caller must say."""
    if (m.c.name, i.name) in DEFAULTS or i.name in DEFAULTS:
        return DEFAULTS.get((m.c.name, i.name)) or DEFAULTS[i.name]
    if (not i.nullable or says(NOT_NULLABLE, m.c.name, i.name)) and i.kind != "options":
        return None
    if i.kind in ("number", "flag"):
        return None
    return "default(ArrayArgument)" if input_type(i) == "ArrayArgument" else "null"


def seen_by_caller(m):
    inputs = [i for i in inputs_seen(m) if i.kind != "task"]
    return inputs if m.is_static else inputs[1:]


def takes_task(m):
    return m.noun != "jalon_task" and m.input("task") is not None


def parameter_list(m):
    seen = seen_by_caller(m)
    texts = ["%s %s" % (input_type(i), camel(i.name)) for i in seen if default_of(m, i) is None]
    texts += ["%s %s = %s" % (input_type(i), camel(i.name), default_of(m, i)) for i in seen if default_of(m, i) is not None]
    if takes_task(m):
        texts += ["Progress progress = null", "JalonTask task = null", "CancellationToken cancel = default(CancellationToken)"]
    return ", ".join(texts)


def native_argument(m, i):
    name = camel(i.name)
    if not m.is_static and i is m.inputs[0]:
        return "self_.Pointer"
    if i.kind == "task":
        return "run_.Pointer" if takes_task(m) else name + "_.Pointer"
    if input_type(i) == "ArrayArgument":
        return name + "_.Pointer"
    if i.kind in ("handle", "options"):
        return name + "_.Pointer"
    if i.kind in ("list", "text"):
        return name + "_.Pointer"
    if i.type in UNSIGNED:
        return 'Number.%s(%s, "%s")' % ("UInt32" if i.type == "uint32_t" else "UInt64", name, name)
    return name


def usings(m):
    if not m.is_static:
        yield "using (var self_ = new Held(Live()))"
    for i in seen_by_caller(m):
        name = camel(i.name)
        if input_type(i) == "ArrayArgument":
            yield 'using (var %s_ = new Pinned(%s, "%s", %s))' % (name, name, name, "false" if default_of(m, i) else "true")
        elif i.kind == "list" and i.type == "CloudList":
            yield 'using (var %s_list = new CloudList(%s, "%s"))' % (name, name, name)
            yield "using (var %s_ = new Held(Of(%s_list)))" % (name, name)
        elif i.kind in ("list", "handle", "options"):
            yield "using (var %s_ = new Held(Of(%s)))" % (name, name)
        elif i.kind == "text":
            yield "using (var %s_ = new NativeText(%s))" % (name, name)
    if takes_task(m):
        yield "using (var run_ = new Run(progress, task, cancel))"

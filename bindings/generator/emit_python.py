# SPDX-FileCopyrightText: 2026 The Jalon authors
# SPDX-License-Identifier: Apache-2.0
"""jalon/_api.py and its stub: the classes of Python, with keyword arguments and texts from the headers and the tables."""

from api_description import ROWS
from emit_swig import has_result, inputs_seen, result_fields
from headers import Header, constants, header_names, nouns, read
from shapes import SMALL, class_nouns, class_of, methods
from texts import BOOL, CHOICE, DOUBLE, DOUBLES, INT64, STRING, row_text, translated, worker_rows, wrap

HEAD = '# Generated from the public headers by bindings/generator: do not edit.\n'
PYTHON_TYPES = {DOUBLE: "float", INT64: "int", BOOL: "bool", STRING: "str", CHOICE: "str", DOUBLES: "Sequence[float]"}
# What an argument is when it is not given.
DEFAULTS = {"flags": "0", "level": "-1", "part": "WHOLE_MODEL", "other_part": "WHOLE_MODEL", "centred": "True", "components": "1"}
# Makers in _support.py that choose among the functions of C.
MAKERS = {"Cloud": "_new_cloud"}
# Fields of named tuples that take the place of a method of tuples.
SHADOWS = {"count": "  # type: ignore[assignment]", "index": "  # type: ignore[assignment]"}
NO_PROPERTY = {"to_json", "seal", "copy", "to_bytes"}


def is_property(m):
    """Looks that need nothing but the object."""
    return bool(m.noun and not m.is_static and len(m.inputs) == 1 and m.outputs and not has_result(m)
                and m.name not in NO_PROPERTY)


def setters(noun, wrapped):
    """{"crs": method} of set_crs(value), where there is a crs to look at."""
    looks = {m.name for m in wrapped if m.noun == noun and is_property(m)}
    return {m.name[4:]: m for m in wrapped if m.noun == noun and m.name.startswith("set_") and m.name[4:] in looks
            and len(m.inputs) == 2}


def hint_in(i):
    base = {"handle": lambda: class_of(i.type), "text": lambda: "Path" if i.name == "path" else "str", "flag": lambda: "bool",
            "number": lambda: "float" if i.type == "double" else "int", "list": lambda: list_hint(i), "bytes": lambda: "Bytes"}.get(i.kind, lambda: "ArrayLike")()
    return "Optional[%s]" % base if i.nullable else base


def list_hint(i):
    return "Sequence[Cloud]" if i.type == "CloudList" else i.type


def hint_out(m):
    if has_result(m):
        return m.result_name[:-len("Result")]
    if not m.outputs:
        return "None"
    o = m.outputs[0]
    return field_hint(o)


def field_hint(o, c_type=None):
    if o is None:
        return {"std::string": "str", "double": "float"}.get(c_type, "int")
    return {"handle": lambda: class_of(o.type), "text": lambda: "str", "texts": lambda: "List[str]", "flag": lambda: "bool",
            "bytes": lambda: "bytes", "number": lambda: "float" if o.type == "double" else "int"}.get(o.kind, lambda: "Array")()


class Signature:
    """The parameters of a Python function: [(text for the stub, text for the code)], and the arguments of the native call."""

    def __init__(self, m, tables):
        self.m = m
        self.rows = tables["operations"][m.operation] if m.operation else []
        seen = inputs_seen(m)
        own = seen if m.is_static or not m.noun else seen[1:]
        plain = [i for i in own if i.kind not in ("options", "task")]
        required = [i for i in plain if not i.nullable and i.name not in DEFAULTS]
        optional = [i for i in plain if i not in required]
        self.code = [i.name for i in required] + ["%s=%s" % (i.name, DEFAULTS.get(i.name, "None")) for i in optional]
        self.stub = (["%s: %s" % (i.name, hint_in(i)) for i in required]
                     + ["%s: %s = ..." % (i.name, hint_in(i)) for i in optional])
        has_options, has_task = m.input("options") is not None, m.input("task") is not None
        if has_options or has_task:
            self.code.append("*")
            self.stub.append("*")
        if has_options:
            self.code += ["%s=None" % r["name"] for r in self.rows] + ["options=None"]
            self.stub += ["%s: Optional[%s] = ..." % (r["name"], PYTHON_TYPES[r["type"]]) for r in self.rows]
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
        if i.kind in ("rows", "packed"):
            return "_array(%s, %r, %s)" % (i.name, i.name, ROWS.get(i.name, 0 if i.kind == "rows" else 1))
        if i.kind in ("small", "poses"):
            return "_numbers(%s, %r)" % (i.name, i.name)
        if i.kind == "list":
            return "_clouds(%s)" % i.name if i.type == "CloudList" else i.name
        return "_path(path)" if i.name == "path" else i.name


def converted(o, call):
    """The native answer as Python hands it out."""
    if o is not None and o.kind == "small":
        return "_out(%s, %d, %d)" % ((call,) + (o.type if isinstance(o.type, tuple) else SMALL[o.type]))
    if o is not None and o.kind == "bytes":
        return "bytes(%s)" % call
    return "_out(%s)" % call if o is not None and o.kind in ("view", "filled", "copied", "doubles") else call


def doc_of(m, rows, known, null="None"):
    text = translated(m.doc, known, null)
    if rows:
        text += "\n\nKeyword arguments (None: the default):\n\n" + "\n".join("- " + row_text(r) for r in rows)
    return text


def docstring(text, indent):
    text = text.replace("\\", "\\\\").replace('"""', "'''")
    lines = wrap(text, 118, indent)
    if not lines:
        return []
    if len(lines) == 1 and not lines[0].rstrip().endswith('"'):
        return ['%s"""%s"""' % (indent, lines[0].strip())]
    return ['%s"""%s' % (indent, lines[0].strip())] + lines[1:] + [indent + '"""']


def call_lines(m, signature, indent):
    call = "_native.%s(%s)" % (m.full_name, ", ".join(signature.arguments))
    reads = any(i.name == "path" for i in m.inputs)
    lines = []
    if reads:
        lines += [indent + "with _files(path):"]
        indent += "    "
    if has_result(m):
        lines.append("%sresult = %s" % (indent, call))
        values = [converted(o, "_native.%s_%s(result)" % (m.result_name, name)) for name, o, _, _ in result_fields(m)]
        lines.append("%sreturn %s(%s)" % (indent, m.result_name[:-len("Result")], ", ".join(values)))
    else:
        lines.append("%s%s%s" % (indent, "return " if m.outputs else "", converted(m.outputs[0], call) if m.outputs else call))
    return lines


def emit_function(m, tables, known):
    """(code lines, stub lines), without indentation."""
    signature = Signature(m, tables)
    first = ["self"] if m.noun and not m.is_static else []
    code, stub = [], []
    if m.noun and m.is_static:
        code.append("@staticmethod")
        stub.append("@staticmethod")
    prop = is_property(m)
    if prop:
        code.append("@property")
        stub.append("@property")
    code.append("def %s(%s):" % (m.name, ", ".join(first + signature.code)))
    stub.append("def %s(%s) -> %s: ..." % (m.name, ", ".join(first + signature.stub), hint_out(m)))
    code += docstring(doc_of(m, signature.rows, known), "    ")
    code += call_lines(m, signature, "    ")
    return code + [""], stub


def emit_results(wrapped):
    code, stub = [], []
    for m in wrapped:
        if has_result(m):
            name = m.result_name[:-len("Result")]
            where = ("%s.%s" % (m.class_name, m.name)) if m.noun else m.name
            head = ["class %s(_ResultMixin, NamedTuple(%r, [%s])):" % (
                name, name, ", ".join("(%r, object)" % n for n, _, _, _ in result_fields(m)))]
            code += head + ['    """What %s gives."""' % where, "    __slots__ = ()", "", ""]
            code += ["class _%s:" % m.result_name, "    __swig_destroy__ = _native.delete_%s" % m.result_name, "", "",
                     "_native.%s_swigregister(_%s)" % (m.result_name, m.result_name), "", ""]
            stub += ["class %s(NamedTuple):" % name] + ["    %s: %s%s" % (n, field_hint(o, t), SHADOWS.get(n, "")) for n, o, t, _ in result_fields(m)]
            stub += ["    def to_dict(self) -> Dict[str, Any]: ...", ""]
    return code, stub


def class_doc(noun, known):
    """The comment of the header that declares the noun, the noun's sentence first."""
    for name in header_names():
        header = Header(name)
        if "typedef struct %s %s;" % (noun, noun) in header.text:
            return translated(header.doc, known)
    return ""


def base_in_stub(name, worker):
    mixins = read("bindings/python/jalon/_mixins.py")
    return name if "class %s(" % name in mixins else "_Worker" if worker else "Handle"


def emit_class(noun, wrapped, tables, known):
    name = class_of(noun)
    mine = [m for m in wrapped if m.noun == noun]
    worker = noun[len("jalon_"):]
    rows = worker_rows(tables, worker)
    create = next((m for m in mine if m.name == "create"), None)
    code = ["class %s(_mixins.base(%r, %r)):" % (name, name, bool(rows))]
    stub = ["class %s(_mixins.%s):" % (name, base_in_stub(name, bool(rows)))]
    body, body_stub = docstring(class_doc(noun, known), "    "), []
    body += ["    __swig_destroy__ = _native.delete_%s" % name, "    _native_close = _native.%s_close" % name,
             "    _native_closed = _native.%s_closed" % name,
             "    _tables = (%s)" % "".join("%r, " % m.name for m in mine if is_property(m)), ""]
    if create is not None and rows:
        given = ", ".join("%s=None" % r["name"] for r in rows)
        body += ["    def __init__(self, method=None, *, %s):" % given]
        body += docstring(doc_of(create, rows, known), "        ")
        body += ["        self._take(_native.%s_create(method))" % name,
                 "        self._set(%s)" % ", ".join("%s=%s" % (r["name"], r["name"]) for r in rows), ""]
        hints = ", ".join("%s: Optional[%s] = ..." % (r["name"], PYTHON_TYPES[r["type"]]) for r in rows)
        body_stub += ["    def __init__(self, method: Optional[str] = ..., *, %s) -> None: ..." % hints]
        for r in rows:
            help_text = (row_text(r) + ("" if len(r["of"]) == len(tables["workers"][worker]) else " Of: %s." % ", ".join(r["of"])))
            body += ["    %s = _mixins.parameter(%r, %r)" % (r["name"], r["name"], help_text)]
            body_stub += ["    %s: %s" % (r["name"], PYTHON_TYPES[r["type"]])]
        body.append("")
    elif create is not None and create.outputs:
        signature = Signature(create, tables)
        body += ["    def __init__(%s):" % ", ".join(["self"] + signature.code + _mixin_extra(name)[0])]
        body += docstring(doc_of(create, [], known), "        ")
        maker = MAKERS.get(name, "_native.%s_create" % name)
        body += ["        self._take(%s(%s))" % (maker, ", ".join(signature.arguments))]
        body += ["        " + line for line in _mixin_extra(name)[1]] + [""]
        body_stub += ["    def __init__(%s) -> None: ..." % ", ".join(["self"] + signature.stub + _mixin_extra(name)[2])]
    change = setters(noun, wrapped)
    for m in mine:
        if m is create or m in change.values():
            continue
        lines, stubs = emit_function(m, tables, known)
        body += ["    " + line if line else "" for line in lines]
        body_stub += ["    " + line for line in stubs]
        if is_property(m) and m.name in change:
            body += ["    @%s.setter" % m.name, "    def %s(self, value):" % m.name,
                     "        _native.%s_set_%s(self, value)" % (name, m.name), ""]
            body_stub += ["    @%s.setter" % m.name, "    def %s(self, value: %s) -> None: ..." % (m.name, hint_out(m))]
    register = ["_native.%s_swigregister(%s)" % (name, name), "", ""]
    return code + body + [""] + register, stub + (body_stub or ["    ..."]) + [""]


def _mixin_extra(name):
    """Arguments that a class takes beside those of C: (code, lines, stub)."""
    if name == "Task":
        return (["threads=0", "progress=None", "log=None"], ["self._begin(threads, progress, log)"],
                ["threads: int = ...", "progress: Optional[Progress] = ...", "log: Optional[Callable[[int, str], Any]] = ..."])
    return [], [], []


def module(tables):
    """(text of _api.py, text of _api.pyi)."""
    wrapped, known = methods(), nouns()
    code = [HEAD + '"""The classes and functions of Jalon; the package jalon hands them on."""', "",
            "from typing import NamedTuple", "", "from . import _mixins, _native",
            "from ._support import _array, _clouds, _files, _new_cloud, _numbers, _options, _out, _path, _task", "from ._mixins import _ResultMixin", ""]
    stub = [HEAD, "import os", "from typing import Any, Callable, Dict, List, Mapping, NamedTuple, Optional, Sequence, Union", "",
            "from . import _mixins", "from ._mixins import Gauge, Targets", "", "Array = Any  # numpy.ndarray, or memoryview without NumPy", "ArrayLike = Any",
            "Bytes = Union[bytes, bytearray, memoryview]", "Path = Union[str, bytes, os.PathLike]", "Progress = Callable[[float, str], Optional[bool]]", ""]
    names = []
    for name, value, comment, _ in constants():
        code.append("%s = %d%s" % (name, value, "  # " + comment if comment else ""))
        stub.append("%s: int" % name)
        names.append(name)
    code += ["", ""]
    results, result_stubs = emit_results(wrapped)
    code, stub = code + results, stub + [""] + result_stubs
    for noun in sorted(class_nouns()):
        lines, stubs = emit_class(noun, wrapped, tables, known)
        code, stub = code + lines, stub + stubs
        names.append(class_of(noun))
    for m in wrapped:
        if m.noun is None:
            lines, stubs = emit_function(m, tables, known)
            code, stub = code + lines + [""], stub + stubs
            names.append(m.name)
    names += [m.result_name[:-len("Result")] for m in wrapped if has_result(m)]
    code += ["__all__ = [%s]" % ", ".join(repr(n) for n in names), ""]
    stub += ["", "__all__ = [%s]" % ", ".join(repr(n) for n in names), ""]
    return "\n".join(code), "\n".join(stub)

# SPDX-FileCopyrightText: 2026 The Jalon authors
# SPDX-License-Identifier: Apache-2.0
"""jalon/_api.py and its stub: the classes of Python, with keyword arguments and texts from the headers and the tables."""

import functools

from emit_swig import has_result, result_fields
from headers import Header, header_names, nouns, read
from python_columns import stub_classes, table_hint, table_of
from python_names import ENUM_FIELDS, dtype_of, enums, is_pose, is_table, shape_of
from python_signature import PYTHON_TYPES, Signature, literal, row_hint
from shapes import class_nouns, class_of, methods
from texts import CHOICE, row_text, translated, worker_rows, wrap

HEAD = '# Generated from the public headers by bindings/generator: do not edit.\n'
# Makers in _support.py that choose among the functions of C.
MAKERS = {"Cloud": "_new_cloud"}
# Fields of named tuples that take the place of a method of tuples.
SHADOWS = {"count": "  # type: ignore[assignment]", "index": "  # type: ignore[assignment]"}
NO_PROPERTY = {"to_json", "seal", "copy", "to_bytes"}
# Files of the package with classes that a generated class extends.
MIXINS = ("_mixins", "_clouds", "_tables")


@functools.lru_cache(None)
def functions():
    """{full name: method} of all."""
    return {m.full_name: m for m in methods()}


def is_property(m):
    """Looks that need nothing but the object."""
    return bool(m.noun and not m.is_static and len(m.inputs) == 1 and m.outputs and not has_result(m)
                and m.name not in NO_PROPERTY)


def setters(noun, wrapped):
    """{"crs": method} of set_crs(value), where there is a crs to look at."""
    looks = {m.name for m in wrapped if m.noun == noun and is_property(m)}
    return {m.name[4:]: m for m in wrapped if m.noun == noun and m.name.startswith("set_") and m.name[4:] in looks
            and len(m.inputs) == 2}


def hint_out(m):
    if has_result(m):
        return m.result_name[:-len("Result")]
    return field_hint(m, m.outputs[0]) if m.outputs else "None"


def field_hint(m, o, c_type=None, name=None):
    if o is None:
        return ENUM_FIELDS.get((m.result_name, name)) or {"std::string": "str", "double": "float"}.get(c_type, "int")
    if is_table(o):
        return table_hint(m, o, functions())
    return {"handle": lambda: class_of(o.type), "text": lambda: "str", "texts": lambda: "List[str]", "flag": lambda: "bool",
            "bytes": lambda: "bytes", "number": lambda: "float" if o.type == "double" else "int"}.get(o.kind, lambda: array_hint(m, o))()


def array_hint(m, o):
    dtype = dtype_of(m, o)
    return "NDArray[numpy.%s]" % dtype if dtype else "Array"


def converted(m, o, call, name=None):
    """The native answer as Python hands it out."""
    if o is None:
        enum = ENUM_FIELDS.get((m.result_name, name))
        return "_known(%s, %s)" % (enum, call) if enum else call
    if is_table(o):
        kind, record, columns = table_of(m, o, functions())
        known = "{%s}" % ", ".join("%r: %s" % item for item in sorted(columns.items()))
        more = [record, known] + (["_mixins.FacesOf(self)"] if record == "Face" else []) if record else [known] * bool(columns)
        if kind == "table" and columns and not record:
            more = ["None", known]
        return "_%s(%s)" % (kind, ", ".join([call] + more))
    if is_pose(o):
        return "_pose_out(%s)" % call
    if o.kind == "bytes":
        return "bytes(%s)" % call
    if o.kind == "small":
        return "_out(%s, %d, %d)" % ((call,) + shape_of(o))
    return "_out(%s)" % call if o.kind in ("view", "filled", "copied", "doubles") else call


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
        values = [converted(m, o, "_native.%s_%s(result)" % (m.result_name, name), name) for name, o, _, _ in result_fields(m)]
        lines.append("%sreturn %s(%s)" % (indent, m.result_name[:-len("Result")], ", ".join(values)))
    else:
        lines.append("%s%s%s" % (indent, "return " if m.outputs else "", converted(m, m.outputs[0], call) if m.outputs else call))
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
            head = ["class %s(_mixins.ResultMixin, NamedTuple(%r, [%s])):" % (
                name, name, ", ".join("(%r, object)" % n for n, _, _, _ in result_fields(m)))]
            code += head + ['    """What %s gives."""' % where, "    __slots__ = ()", "", ""]
            code += ["class _%s:" % m.result_name, "    __swig_destroy__ = _native.delete_%s" % m.result_name, "", "",
                     "_native.%s_swigregister(_%s)" % (m.result_name, m.result_name), "", ""]
            stub += ["class %s(NamedTuple):" % name] + ["    %s: %s%s" % (n, field_hint(m, o, t, n), SHADOWS.get(n, "")) for n, o, t, _ in result_fields(m)]
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
    if name == "Fields":
        return "_tables.Fields[R]"
    file = next((f for f in MIXINS if "\nclass %s(" % name in read("bindings/python/jalon/%s.py" % f)), None)
    return "%s.%s" % (file, name) if file else "_mixins._Worker" if worker else "_handles.Handle"


def emit_class(noun, wrapped, tables, known):
    name = class_of(noun)
    mine = [m for m in wrapped if m.noun == noun]
    worker = noun[len("jalon_"):]
    rows = worker_rows(tables, worker)
    create = next((m for m in mine if m.name == "create"), None)
    code = ["class %s(_mixins.base(%r, %r)):" % (name, name, bool(rows))]
    stub = ["class %s(%s):" % (name, base_in_stub(name, bool(rows)))]
    body, body_stub = docstring(class_doc(noun, known), "    "), []
    body += ["    __swig_destroy__ = _native.delete_%s" % name, "    _native_close = _native.%s_close" % name,
             "    _native_closed = _native.%s_closed" % name,
             "    _tables = (%s)" % "".join("%r, " % m.name for m in mine if is_property(m)), ""]
    if create is not None and rows:
        given = ", ".join("%s=None" % r["name"] for r in rows)
        body += ["    def __init__(self, method=None, *, %s):" % given]
        body += docstring(doc_of(create, rows, known), "        ")
        body += ["        self._take(_native.%s_create(_text(method, 'method', optional=True)))" % name,
                 "        self._set(%s)" % ", ".join("%s=%s" % (r["name"], r["name"]) for r in rows), ""]
        hints = ", ".join("%s: Optional[%s] = ..." % (r["name"], row_hint(r)) for r in rows)
        names = literal(tables["workers"][worker])
        body_stub += ["    def __init__(self, method: Optional[%s] = ..., *, %s) -> None: ..." % (names, hints)]
        for r in rows:
            help_text = (row_text(r) + ("" if len(r["of"]) == len(tables["workers"][worker]) else " Of: %s." % ", ".join(r["of"])))
            body += ["    %s = _mixins.parameter(%r, %r)" % (r["name"], r["name"], help_text)]
            body_stub += ["    %s: %s" % (r["name"], row_hint(r))]
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
            put = change[m.name]
            body += ["    @%s.setter" % m.name, "    def %s(self, %s):" % (m.name, put.inputs[1].name),
                     "        _native.%s_set_%s(%s)" % (name, m.name, ", ".join(Signature(put, tables).arguments)), ""]
            body_stub += ["    @%s.setter" % m.name, "    def %s(self, %s) -> None: ..." % (m.name, Signature(put, tables).stub[0])]
    register = ["_native.%s_swigregister(%s)" % (name, name), "", ""]
    return code + body + [""] + register, stub + (body_stub or ["    ..."]) + [""]


def _mixin_extra(name):
    """Arguments that a class takes beside those of C: (code, lines, stub)."""
    if name == "Task":
        return (["threads=0", "progress=None", "log=None", "memory_limit=0"], ["self._begin(threads, progress, log, memory_limit)"],
                ["threads: int = ...", "progress: Optional[Progress] = ...", "log: Optional[Callable[[int, str], Any]] = ...",
                 "memory_limit: int = ..."])
    return [], [], []


def emit_constants():
    """(code, stub, names): enums, each member also a constant by the name that it has in C, and numbers that stand alone."""
    code, stub, names = [], [], []
    classes, alone = enums()
    for name, members in classes.items():
        code += ["", "", "class %s(enum.IntEnum):" % name,
                 '    """%s"""' % "; ".join("%s%s" % (member, ": " + comment if comment else "") for member, _, _, comment in members), ""]
        code += ["    %s = %d" % (member, value) for member, _, value, _ in members]
        stub += ["class %s(enum.IntEnum):" % name] + ["    %s = %d" % (member, value) for member, _, value, _ in members] + [""]
        names.append(name)
    code += ["", ""]
    for name, members in classes.items():
        code += ["%s = %s.%s" % (constant, name, member) for member, constant, _, _ in members]
        stub += ["%s: %s" % (constant, name) for _, constant, _, _ in members]
        names += [constant for _, constant, _, _ in members]
    for name, value, comment in alone:
        code.append("%s = %d%s" % (name, value, "  # " + comment if comment else ""))
        stub.append("%s: int" % name)
        names.append(name)
    return code + ["", ""], stub + [""], names


IMPORTS = """
import enum
from typing import NamedTuple

from . import _mixins, _native
from ._arguments import crs as _crs, flag as _flag, instance as _instance, integer as _integer, number as _number
from ._arguments import path as _path, text as _text
from ._arrays import flat as _flat, indices as _indices, numbers as _numbers, octets as _octets, values as _values
from ._lists import clouds as _clouds, gauge as _gauge, targets as _targets
from ._records import Face, Region, Segment, Part, known as _known
from ._shapes import box as _box, out as _out, point as _point, pose as _pose, pose_out as _pose_out, poses as _poses
from ._support import files as _files, new_cloud as _new_cloud, options as _options, task as _task
from ._tables import summary as _summary, table as _table
"""
STUB_IMPORTS = """
import enum
import os
from typing import Any, Callable, Dict, Iterable, List, Literal, Mapping, NamedTuple, Optional, Protocol, Sequence, Tuple, TypeVar, Union

import numpy
import numpy.typing
from numpy.typing import ArrayLike, NDArray

from . import _clouds, _handles, _mixins, _tables
from ._lists import Gauge, Targets
from ._records import Face, Part, Point, Record, Region, Segment, Summary

R = TypeVar("R", bound=Record)
Array = NDArray[Any]  # a memoryview without NumPy
ValuesLike = Union[ArrayLike, float]  # one number stands for all
Indices = Union[NDArray[numpy.integer[Any]], NDArray[numpy.bool_], Sequence[int], Sequence[bool]]  # or a mask
Bytes = Union[bytes, bytearray, memoryview, NDArray[numpy.uint8], NDArray[numpy.int8]]
Path = Union[str, bytes, os.PathLike[str], os.PathLike[bytes]]
Progress = Callable[[float, str], Optional[bool]]
TargetsLike = Union[Targets, Mapping[str, ArrayLike], Iterable[Tuple[Any, ...]]]

class HasWkt(Protocol):
    def to_wkt(self) -> str: ...

CrsLike = Union[str, HasWkt, None]
"""

def module(tables):
    """(text of _api.py, text of _api.pyi)."""
    wrapped, known = list(functions().values()), nouns()
    code = [HEAD + '"""The classes and functions of Jalon; the package jalon hands them on."""', IMPORTS]
    stub = [HEAD + STUB_IMPORTS]
    constants, constant_stubs, names = emit_constants()
    results, result_stubs = emit_results(wrapped)
    code, stub = code + constants + results, stub + constant_stubs + stub_classes(functions()) + result_stubs
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

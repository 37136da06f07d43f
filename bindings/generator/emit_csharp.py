#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The Jalon authors
# SPDX-License-Identifier: Apache-2.0
"""The public classes of C# over SWIG's P/Invoke class: emit_csharp.py OUT_FOLDER PARAMETERS_JSON writes Api.cs and Options.cs."""

import json
import os
import re
import sys

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
from csharp_inputs import (SCALARS, class_name, default_of, input_type, native_argument, parameter_list,  # noqa: E402
                           seen_by_caller, takes_task, usings)
from csharp_names import FACTORS, KEYWORDS, camel, documentation, pascal, summary  # noqa: E402
from csharp_overloads import emit_overloads  # noqa: E402
from csharp_params import emit_constants, emit_options, worker_properties  # noqa: E402
from emit_swig import has_result, inputs_seen, result_fields  # noqa: E402
from headers import Header, header_names, nouns  # noqa: E402
from shapes import SMALL, class_nouns, class_of, methods  # noqa: E402

HEAD = "// Generated from the public headers by bindings/generator.\nusing System;\nusing System.Collections.Generic;\n" \
       "using System.Runtime.InteropServices;\nusing System.Threading;\n\nnamespace Jalon {\n"
NO_INLINING = "[System.Runtime.CompilerServices.MethodImpl(System.Runtime.CompilerServices.MethodImplOptions.NoInlining)]"
VERBS = {"seal", "copy"}


def rows_and_columns(o):
    return o.type if isinstance(o.type, tuple) else SMALL[o.type]


# ---- outputs --------------------------------------------------------------------------------------------------------

def output_type(o):
    if o.kind == "handle":
        return class_name(o.type)
    if o.kind == "small":
        return "double[]" if rows_and_columns(o)[0] == 1 else "double[,]"
    if o.kind == "doubles":
        return "double[]"
    if o.kind in ("view", "filled", "copied"):
        return "ArrayView"
    return {"text": "string", "texts": "string[]", "flag": "bool", "bytes": "byte[]"}.get(o.kind) or SCALARS[o.type]


def managed(o, type_, native):
    """What the native answer becomes."""
    kind = o.kind if o is not None else "text" if type_ == "std::string" else "number"
    if kind == "handle":
        return "%s.Wrap(%s)" % ("global::Jalon." + class_name(o.type), native)
    if kind == "small":
        return "Small.%s(%s)" % ("Row" if rows_and_columns(o)[0] == 1 else "Rows", native)
    if kind == "doubles":
        return "Small.Row(%s)" % native
    if kind == "bytes":
        return "Small.Octets(%s)" % native
    if kind in ("view", "filled", "copied"):
        return "ArrayView.Wrap(%s)" % native
    if kind == "text":
        return "Text.Of(%s)" % native
    if kind == "texts":
        return "Text.ListOf(%s)" % native
    return "Number.Of(%s)" % native if (o.type if o is not None else type_) == "uint64_t" else native


def return_type(m):
    if has_result(m):
        return m.result_name
    return output_type(m.outputs[0]) if m.outputs else "void"


def emit_result(m):
    """The class of several outputs."""
    fields = [(pascal(name), SCALARS.get(type_) if o is None else output_type(o), o, type_, name)
              for name, o, type_, _ in result_fields(m)]
    owned = [f for f in fields if f[2] is not None and f[2].kind in ("handle", "view", "filled", "copied")]
    where = "%s.%s" % (class_name(m.noun), member_name(m)) if m.noun else "Library." + pascal(m.name)
    out = summary("What %s gives." % where, "") + [
        "public sealed class %s%s {" % (m.result_name, " : IDisposable" if owned else ""),
        '  [DllImport(Loader.Name, EntryPoint = "CSharp_Jalon_delete_%s")]' % m.result_name,
        "  private static extern void DeleteResult(IntPtr result);", "",
        "  private sealed class NativeBox : Box {", "    internal NativeBox(IntPtr result) : base(result, 0) {}",
        "    protected override void Delete(IntPtr result) {", "      DeleteResult(result);", "    }", "  }", "",
        "  internal %s(IntPtr result) {" % m.result_name, "    using (new NativeBox(result)) {"]
    for name, _, o, type_, native in fields:
        call = "LibraryPINVOKE.%s_%s(result)" % (m.result_name, native)
        out.append("      %s = %s;" % (name, managed(o, type_, call)))
    out += ["    }", "  }", ""]
    for name, type_, o, _, native in fields:
        about = "Output %s of the call." % native if o is not None else field_comment(m, native)
        out += summary(about, "  ") + ["  public %s %s { get; private set; }" % (type_, name), ""]
    if len(fields) > 1:
        out += summary("For var (%s) = ..." % ", ".join(camel(f[4]) for f in fields), "  ")
        out += ["  public void Deconstruct(%s) {" % ", ".join("out %s %s" % (f[1], camel(f[4])) for f in fields)]
        out += ["    %s = %s;" % (camel(f[4]), f[0]) for f in fields] + ["  }", ""]
    out += summary("The values of all outputs.", "  ") + ["  public override string ToString() {"]
    out += ['    return Described.Result("%s", %s);' % (m.result_name, ", ".join('"%s", %s' % (f[0], f[0]) for f in fields)), "  }"]
    if owned:
        out += [""] + summary("Disposes of all of them.", "  ") + ["  public void Dispose() {"]
        out += ["    if (%s != null) %s.Dispose();" % (f[0], f[0]) for f in owned] + ["  }"]
    return out + ["}", ""]


def field_comment(m, native):
    from headers import structs
    struct = next(o.type for o in m.outputs if o.kind == "struct")
    comment = next((c for _, field, _, c in structs()[struct] if field == native), "")
    return comment or pascal(native) + "."


# ---- members --------------------------------------------------------------------------------------------------------

def member_name(m):
    """Values are properties; what makes an object is a method: GetFields()."""
    makes = m.outputs and not seen_by_caller(m) and not takes_task(m) and not is_property(m) and not m.is_static
    plain = m.name not in VERBS and not m.name.startswith("to_") and not has_result(m)
    return ("Get" if makes and plain else "") + pascal(m.name)


def is_property(m):
    return (not m.is_static and not seen_by_caller(m) and not takes_task(m) and len(m.outputs) == 1 and not has_result(m)
            and m.outputs[0].kind in ("number", "text", "flag") and not m.name.startswith("to_"))


def native_name(m):
    """SWIG's name of the function: a keyword of C# gets an underscore."""
    name = m.name + "_" if m.name in KEYWORDS else m.name
    return "%s_%s" % (m.class_name, name) if m.noun else name


def body(m, wrap):
    """The lines that call and hand out; wrap: makes the answer from the native one."""
    call = "LibraryPINVOKE.%s(%s)" % (native_name(m), ", ".join(native_argument(m, i) for i in inputs_seen(m)))
    check = "run_.Check();" if takes_task(m) else "Failure.Check();"
    lines = [call + ";", check] if wrap is None else ["var native_ = %s;" % call, check, "return %s;" % wrap]
    opened = list(usings(m))
    if not opened:
        return lines
    return opened[:-1] + [opened[-1] + " {"] + ["  " + line for line in lines] + ["}"]


def wrapped_answer(m):
    if has_result(m):
        return "new %s(native_)" % m.result_name
    return managed(m.outputs[0], m.outputs[0].type, "native_") if m.outputs else None


def setter_of(m, mine):
    """The method set_x of the property x."""
    return next((s for s in mine if s.name == "set_" + m.name and len(seen_by_caller(s)) == 1), None)


def emit_method(m, known):
    """A static one in two, because Mono looks for the native library when it compiles what calls it: after Loader then."""
    name, lines = member_name(m), ["  " + line for line in body(m, wrapped_answer(m))]
    out = documentation(m, known, takes_task(m))
    head = "%s %s(%s) {" % (return_type(m), name, parameter_list(m))
    if not m.is_static:
        return out + ["public " + head] + lines + ["}", ""]
    arguments = [camel(i.name) for i in sorted(seen_by_caller(m), key=lambda i: default_of(m, i) is not None)]
    arguments += ["progress", "task", "cancel"] if takes_task(m) else []
    call = "  %s%sLoaded(%s);" % ("return " if m.outputs else "", name, ", ".join(arguments))
    plain = re.sub(r" = (default\(\w+\)|[\w.]+)", "", parameter_list(m))
    return out + ["public static " + head, "  Loader.Load();", call, "}", "", NO_INLINING,
                  "private static %s %sLoaded(%s) {" % (return_type(m), name, plain)] + lines + ["}", ""]


def emit_property(m, mine, known):
    out = documentation(m, known, False) + ["public %s %s {" % (return_type(m), member_name(m)), "  get {"]
    out += ["    " + line for line in body(m, wrapped_answer(m))] + ["  }"]
    change = setter_of(m, mine)
    if change is not None:
        change.inputs[1].name = "value"
        out += ["  set {"] + ["    " + line for line in body(change, None)] + ["  }"]
    return out + ["}", ""]


def emit_constructor(m, name, known):
    """From _create: the native handle is made before the base class is."""
    arguments = ", ".join(camel(i.name) for i in seen_by_caller(m))
    out = documentation(m, known, False)
    out += ["public %s(%s) : this(Loader.Load() ? Made(%s) : IntPtr.Zero) {}" % (name, parameter_list(m), arguments), "",
            NO_INLINING, "private static IntPtr Made(%s) {" % ", ".join("%s %s" % (input_type(i), camel(i.name)) for i in seen_by_caller(m))]
    return out + ["  " + line for line in body(m, "native_")] + ["}", ""]


def class_summary(noun):
    for name in header_names():
        if any("typedef struct %s %s;" % (noun, noun) in line for line in open_header(name)):
            return Header(name).doc
    return ""


def open_header(name):
    from headers import read
    return read("include/jalon/" + name).split("\n")


def box_lines(noun, name, base):
    native = class_of(noun)
    return ['[DllImport(Loader.Name, EntryPoint = "CSharp_Jalon_delete_%s")]' % native,
            "private static extern void DeleteBox(IntPtr box);", "",
            "private sealed class NativeBox : Box {",
            "  internal NativeBox(IntPtr box) : base(box, %s) {}" % FACTORS.get(name, "0"),
            "  protected override void Delete(IntPtr box) {", "    DeleteBox(box);", "  }", "}", "",
            "internal %s(IntPtr box) : base(new NativeBox(box)) {}" % name, "",
            "internal static %s Wrap(IntPtr box) {" % name, "  return box == IntPtr.Zero ? null : new %s(box);" % name, "}", "",
            "internal override void Close(Box box) {",
            "  using (var self_ = new Held(box)) LibraryPINVOKE.%s_close(self_.Pointer);" % native, "  Failure.Check();", "}", ""]


def emit_class(noun, wrapped, tables, known):
    name, mine = class_name(noun), [m for m in wrapped if m.noun == noun]
    works = noun[len("jalon_"):] in tables["workers"]
    kind = "partial" if name == "Params" else "sealed partial"
    out = summary(class_summary(noun), "", known) + ["public %s class %s : %s {" % (kind, name, "Worker" if works else "Noun")]
    inner = box_lines(noun, name, works)
    setters = [setter_of(m, mine) for m in mine if is_property(m)]
    for m in mine:
        if m.name == "create" and noun == "jalon_task" or m in setters:
            continue
        if m.name == "create":
            inner += emit_constructor(m, name, known)
        elif works and m.name == "params":
            inner += ["internal override Params MakeParams() {"] + ["  " + line for line in body(m, wrapped_answer(m))] + ["}", ""]
        elif is_property(m):
            inner += emit_property(m, mine, known)
        else:
            inner += emit_method(m, known) + emit_overloads(m, member_name(m), return_type(m))
    inner += ["internal override string About() {", "  return Described.About(this);", "}", ""]
    if works:
        inner += worker_properties(tables, noun[len("jalon_"):])
    return out + ["  " + line if line else "" for line in inner] + ["}", ""]


def api(tables):
    known, wrapped = nouns(), methods()
    out = [HEAD] + emit_constants()
    for m in wrapped:
        out += emit_result(m) if has_result(m) else []
    for noun in sorted(class_nouns()):
        out += emit_class(noun, wrapped, tables, known)
    out += summary("The functions that belong to no object.", "") + ["public static class Library {"]
    out += ["  private static Box Of(Noun noun) {", "    return Noun.Of(noun);", "  }", ""]
    out += summary("Handles that the objects of this process hold; 0 when all are disposed of or collected.", "  ")
    out += ["  public static long LiveHandleCount {", "    get { return Loader.Load() ? LiveHandles() : 0; }", "  }", "", "  " + NO_INLINING, "  private static long LiveHandles() {",
            "    return LibraryPINVOKE.live_handle_count();", "  }", ""]
    for m in wrapped:
        if m.noun is None:
            out += ["  " + line if line else "" for line in emit_method(m, known)]
    return "\n".join(out + ["}", "", "}", ""])


def main():
    folder = sys.argv[1]
    os.makedirs(folder, exist_ok=True)
    with open(sys.argv[2], encoding="utf-8") as f:
        tables = json.load(f)
    for name, text in (("Api.cs", api(tables)), ("Options.cs", HEAD + emit_options(tables) + "}\n")):
        with open(os.path.join(folder, name), "w", encoding="utf-8") as f:
            f.write(text)


if __name__ == "__main__":
    main()

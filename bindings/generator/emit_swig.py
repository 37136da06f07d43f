# SPDX-FileCopyrightText: 2026 The Jalon authors
# SPDX-License-Identifier: Apache-2.0
"""jalon_calls.h, one C++ function a wrapped C function, and jalon_api.i, the classes that SWIG sees. The same for all languages."""

from api_description import BY_RINGS, COUNTS, ROWS
from headers import constants, nouns, structs
from shapes import SMALL, class_nouns, class_of, methods

LICENSE = "/* Generated from the public headers by bindings/generator. */\n"
ELEMENT = {"const double*": "double", "const uint64_t*": "std::uint64_t", "const uint32_t*": "std::uint32_t"}
SCALARS = {"jalon_status": "int32_t"}


def input_type(i):
    """How the C++ function and SWIG see an input."""
    if i.kind in ("handle", "options", "task"):
        return class_of(i.type) + "*"
    return {"text": "const char*", "flag": "bool", "list": i.type + "*", "rows": "const ArrayIn*", "packed": "const ArrayIn*",
            "bytes": "const ArrayIn*", "small": "const ArrayIn*", "poses": "const ArrayIn*"}.get(i.kind) or SCALARS.get(i.type, i.type)


def output_type(o):
    if o.kind == "handle":
        return class_of(o.type) + "*"
    if o.kind in ("small", "doubles"):
        return "Numbers*"
    if o.kind in ("view", "filled", "copied"):
        return "Array*"
    if o.kind == "bytes":
        return "Octets*"
    return {"text": "std::string", "texts": "Texts", "flag": "bool"}.get(o.kind) or SCALARS.get(o.type, o.type)


def inputs_seen(m):
    """What a caller gives: without what another input brings along."""
    return [i for i in m.inputs if i.kind != "merged"]


def signature(m):
    return ", ".join("%s %s%s" % (input_type(i), i.name, " = nullptr" if i.kind in ("options", "task") else "")
                     for i in inputs_seen(m))


def declarations(m):
    """The C++ lines that open the inputs: boxes, packed arrays."""
    shared_rows = [i.name for i in m.inputs if i.kind == "rows"]
    for i in inputs_seen(m):
        if i.kind in ("handle", "options", "task"):
            yield "const Use<%s> %s_(%s);" % (i.type, i.name, i.name)
        elif i.kind == "rows" and len(shared_rows) > 1:
            yield 'const Packed<double> %s_(%s, 1, "%s");' % (i.name, i.name, i.name)
        elif i.kind == "rows":
            rows = ROWS.get(i.name)
            yield 'const ArrayIn %s_ = rows_of(%s, %s, "%s");' % (
                i.name, i.name, rows or "%s == nullptr ? 1 : %s->components" % (i.name, i.name), i.name)
        elif i.kind == "packed":
            if i.name == "indices" and i.nullable:
                yield 'refuse_none(%s, "%s");' % (i.name, i.name)
            yield 'const Packed<%s> %s_(%s, %d, "%s");' % (ELEMENT[i.c.type], i.name, i.name, ROWS.get(i.name, 1), i.name)
        elif i.kind == "bytes":
            yield 'const OctetsIn %s_(%s, "%s");' % (i.name, i.name, i.name)
        elif i.kind == "poses":
            yield 'const Poses %s_(%s, "%s");' % (i.name, i.name, i.name)
        elif i.kind == "small":
            yield 'const Numbers12 %s_(%s, %d, %d, "%s");' % ((i.name, i.name) + SMALL[i.type] + (i.name,))
        elif i.kind == "list":
            yield 'if (%s == nullptr) throw Failure{JALON_ERROR_INVALID_ARGUMENT, "%s must be given"};' % (i.name, i.name)


def slots(m):
    for o in m.outputs:
        if o.kind in ("handle", "bytes"):
            yield "Owned<%s> %s_out;" % (o.type, o.name)
        elif o.kind == "text" and o.c is not None:
            yield "const char* %s_out = nullptr;" % o.name
        elif o.kind in ("number", "flag") and o.c is not None:
            yield "%s %s_out = 0;" % (o.type, o.name)
        elif o.kind == "struct":
            yield "%s %s_out = {};" % (o.type, o.name)
            if structs()[o.type][0][1] == "struct_size":
                yield "%s_out.struct_size = sizeof %s_out;" % (o.name, o.name)
        elif o.kind == "small":
            rows, columns = o.type if isinstance(o.type, tuple) else SMALL[o.type]
            yield "double %s_out[%d] = {};" % (o.name, rows * columns)
        elif o.kind == "view":
            yield "jalon_array_view %s_out = {};" % o.name
        elif o.kind == "doubles":
            yield "const double* %s_out = nullptr;" % o.name
            yield "std::uint64_t %s_count = 0;" % o.name
        elif o.kind == "texts":
            yield "const char* const* %s_out = nullptr;" % o.name
            yield "std::uint64_t %s_count = 0;" % o.name
        elif o.kind == "filled":
            element, rows, columns = o.type
            yield "%s* %s_data = nullptr;" % (element, o.name)
            yield "std::unique_ptr<Array> %s_out(Array::made(%s, %s, &%s_data));" % (o.name, rows, columns, o.name)
        elif o.kind == "copied":
            first = m.inputs[0].name
            yield "jalon_array_view look = {};"
            yield "check(jalon_fields_view(%s_, name, &look));" % first
            yield "std::unique_ptr<Array> %s_out(Array::made_as(type, look.count, look.components));" % o.name


def count_argument(m, p):
    """The argument for a count, from the array or list it counts."""
    for i in m.inputs:
        if COUNTS.get(i.name) == p.name and i.kind not in ("merged",):
            if i.name in BY_RINGS:
                continue
            if i.kind == "list":
                return i.name + "->count()"
            return i.name + ("_.count" if i.kind == "rows" and len([r for r in m.inputs if r.kind == "rows"]) == 1 else "_.count()")
    return "%s->hull_count()" % next(i.name for i in m.inputs if i.kind == "list")


def first_of_group(m, i):
    """The name of the array whose count the others share."""
    return next(j for j in m.inputs if COUNTS.get(j.name) == COUNTS.get(i.name) and j.name not in BY_RINGS)


def argument(m, p):
    i = next((i for i in m.inputs if i.c is p), None)
    o = next((o for o in m.outputs if o.c is p), None)
    rows = [r for r in m.inputs if r.kind == "rows"]
    if i is not None:
        if i.kind in ("handle", "options", "task"):
            return i.name + "_"
        if i.kind == "merged":
            return "%s->hull()" % next(j.name for j in m.inputs if j.kind == "list")
        if i.kind == "list":
            return i.name + ("->pieces()" if i.type == "Gauge" else "->data()")
        if i.kind == "small":
            return "%s_.as<%s>()" % (i.name, i.type)
        if i.kind == "poses":
            return i.name + "_.data()"
        if i.kind == "rows" and len(rows) == 1:
            return i.name + "_.data"
        if i.kind == "bytes":
            return i.name + "_.data()"
        if i.kind in ("packed", "rows"):
            if i.name in BY_RINGS:
                return "%s_.data_like(sum_of(%s_))" % (i.name, BY_RINGS[i.name])
            first = first_of_group(m, i)
            if first is i:
                return i.name + "_.data()"
            return "%s_.data_like(%s)" % (i.name, count_argument(m, next(q for q in m.c.parameters if q.name == COUNTS[i.name])))
        return i.name + (" ? 1 : 0" if i.kind == "flag" else "")
    if o is not None:
        return {"handle": "%s_out.slot()", "bytes": "%s_out.slot()", "small": "reinterpret_cast<" + p.type + ">(%s_out)" if not p.extent else "%s_out",
                "filled": "%s_data", "copied": "const_cast<void*>(%s_out->data())"}.get(o.kind, "&%s_out") % o.name
    if p.name in ("type", "stride_bytes", "components") and rows:
        if len(rows) > 1:
            return {"type": "JALON_FLOAT64", "stride_bytes": "0"}[p.name]
        return rows[0].name + "_." + p.name
    if p.name == "capacity_elements":
        return "look.count * look.components"
    counted = next((o for o in m.outputs if o.kind in ("doubles", "texts")), None)
    if p.name == "count" and counted is not None:
        return "&%s_count" % counted.name
    return count_argument(m, p)


def value(m, o):
    """The output as the C++ function returns it."""
    return {
        "handle": "boxed(%s_out)", "text": "text_of(%s_out)", "flag": "%s_out != 0", "number": "%s_out",
        "doubles": "Array::of(%s_out, %s_count, 1)", "texts": "texts_of(%s_out, %s_count)",
        "filled": "%s_out.release()", "copied": "%s_out.release()",
        "bytes": "octets_of(%s_out)",
        "view": "view_of<" + (m.noun or "") + ">(%s_out, " + (m.inputs[0].name if m.inputs else "") + "_)",
        "small": "Array::of(%s_out, {}, {})".format(*(o.type if isinstance(o.type, tuple) else SMALL.get(o.type, (0, 0)))),
    }[o.kind].replace("%s", o.name)


def result_fields(m):
    """[(name, output or None, C++ type, how to fill it)] of the struct that several outputs make."""
    fields = []
    for o in m.outputs:
        name = o.name[4:] if o.name.startswith("out_") else o.name
        if o.kind == "struct":
            prefix = "" if len(m.outputs) == 1 else ""
            for type_, field, _, _ in structs()[o.type]:
                if field in ("struct_size", "reserved"):
                    continue
                text = type_ == "const char*"
                fields.append((prefix + field, None, "std::string" if text else type_,
                               ("text_of(%s_out.%s)" if text else "%s_out.%s") % (o.name, field)))
        else:
            if name == "out":
                name = o.type[len("jalon_"):] if o.kind == "handle" else "value"
            fields.append((name, o, output_type(o), None))
    return fields


def has_result(m):
    return len(m.outputs) > 1 or any(o.kind == "struct" for o in m.outputs)


def return_type(m):
    if has_result(m):
        return m.result_name + "*"
    return output_type(m.outputs[0]) if m.outputs else "void"


def emit_result(m):
    lines = ["struct %s {" % m.result_name]
    for name, o, type_, _ in result_fields(m):
        if o is not None and o.kind == "handle":
            lines += ["  Owned<%s> %s_;" % (o.type, name),
                      "  %s %s() const { return boxed_copy(%s_); }" % (type_, name, name)]
        elif type_ in ("Numbers*", "Array*"):
            lines += ["  std::unique_ptr<Array> %s_;" % name,
                      "  %s %s() const { return new Array(*%s_); }" % (type_, name, name)]
        else:
            lines += ["  %s %s_ = {};" % (type_, name), "  %s %s() const { return %s_; }" % (type_, name, name)]
    return lines + ["};"]


def emit_call(m):
    lines = ["inline %s %s(%s) {" % (return_type(m), m.full_name, signature(m))]
    lines += ["  " + line for line in list(declarations(m)) + list(slots(m))]
    call = "%s(%s)" % (m.c.name, ", ".join(argument(m, p) for p in m.c.parameters))
    direct = m.outputs and m.outputs[0].c is None
    if direct:
        lines.append("  return %s;" % (("text_of(%s)" if m.outputs[0].kind == "text" else "%s") % call))
        return lines + ["}"]
    lines.append("  check(%s);" % call)
    if has_result(m):
        lines.append("  std::unique_ptr<%s> result(new %s);" % (m.result_name, m.result_name))
        for name, o, type_, fill in result_fields(m):
            if o is not None and o.kind == "handle":
                lines.append("  move_into(result->%s_, %s_out);" % (name, o.name))
            elif type_ in ("Numbers*", "Array*"):
                lines.append("  result->%s_.reset(%s);" % (name, value(m, o)))
            else:
                lines.append("  result->%s_ = %s;" % (name, fill or value(m, o)))
        lines.append("  return result.release();")
    elif m.outputs:
        lines.append("  return %s;" % value(m, m.outputs[0]))
    return lines + ["}"]


def calls_header():
    out = [LICENSE + "#ifndef JALON_CALLS_H", "#define JALON_CALLS_H", '#include "lists.h"', "namespace jalon_binding {"]
    for noun in nouns():
        out.append('JALON_OWNERSHIP(%s, "the %s")' % (noun, noun[len("jalon_"):].replace("_", " ")))
        if noun in class_nouns():
            out.append("typedef Handle<%s> %s;" % (noun, class_of(noun)))
    out.append('#include "calls_support.h"')
    wrapped = methods()
    for m in wrapped:
        out += emit_result(m) if has_result(m) else []
    out.append("namespace calls {")
    for m in wrapped:
        out += emit_call(m)
    return "\n".join(out + ["}  // namespace calls", "}  // namespace jalon_binding", "#endif", ""])


def interface():
    out = [LICENSE]
    wrapped = methods()
    for name, number, _, _ in constants():
        out.append("%%constant %s %s = %s;" % ("int32_t" if abs(number) < 2 ** 31 else "uint64_t", name,
                                               number if number < 2 ** 31 else "UINT64_MAX"))
    for m in wrapped:
        if has_result(m):
            for name, _, type_, _ in result_fields(m):
                if type_.endswith("*"):
                    out.append("%%newobject %s::%s;" % (m.result_name, name))
            out.append("%%nodefaultctor %s;" % m.result_name)
            out += ["class %s {" % m.result_name, " public:", "  ~%s();" % m.result_name]
            out += ["  %s %s() const;" % (type_, name) for name, _, type_, _ in result_fields(m)] + ["};"]
    for noun in sorted(class_nouns()):
        name = class_of(noun)
        mine = [m for m in wrapped if m.noun == noun]
        out += ["%%newobject %s::%s;" % (name, m.name) for m in mine if return_type(m).endswith("*")]
        out += ["%%newobject %s::again;" % name, "%%nodefaultctor %s;" % name, "class %s {" % name, " public:", "  ~%s();" % name, "  void close();",
                "  bool closed() const;", "};", "%%extend %s {" % name]
        for m in mine:
            seen = inputs_seen(m)
            rest = seen if m.is_static else seen[1:]
            parameters = ", ".join("%s %s%s" % (input_type(i), i.name, " = NULL" if i.kind in ("options", "task") else "") for i in rest)
            arguments = ", ".join((["$self"] if not m.is_static else []) + [i.name for i in rest])
            returns = "" if return_type(m) == "void" else "return "
            out.append("  %s%s %s(%s) { %s%s(%s); }" % ("static " if m.is_static else "", return_type(m), m.name, parameters,
                                                        returns, "jalon_binding::calls::" + m.full_name, arguments))
        out += ["#ifdef SWIGPYTHON", "  %s* again() { return jalon_binding::again($self); }" % name, "#endif", "}"]
    for m in wrapped:
        if m.noun is None:
            parameters = ", ".join("%s %s%s" % (input_type(i), i.name, " = NULL" if i.kind in ("options", "task") else "")
                                   for i in inputs_seen(m))
            if return_type(m).endswith("*"):
                out.append("%%newobject %s;" % m.name)
            out += ["%%{ using jalon_binding::calls::%s; %%}" % m.name, "%s %s(%s);" % (return_type(m), m.name, parameters)]
    return "\n".join(out + [""])

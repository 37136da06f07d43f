# SPDX-FileCopyrightText: 2026 The Jalon authors
# SPDX-License-Identifier: Apache-2.0
"""The overloads of Java's methods: one a kind of array, and without what a caller seldom says.

SWIG writes the full form, whose arrays are Rows; what stands here calls it. Small arrays (points, boxes, poses) are double[].
"""

from api_description import NOT_NULLABLE, ROWS, says
from emit_swig import has_result, inputs_seen
from shapes import class_of

SCALARS = {"std::string": "String", "bool": "boolean", "double": "double", "int32_t": "int", "uint32_t": "long",
           "uint64_t": "long", "int64_t": "long", "jalon_status": "int"}
NIO = "java.nio.%sBuffer"
ARRAY, ROWS_CLASS, MASK = "Array", "Rows", "boolean[]"
# What one array of a call may be: of coordinates or values, of indices, of a field's data.
NUMBERS = ["double[]", "float[]", NIO % "Double", NIO % "Float", ARRAY]
INDICES = ["long[]", "int[]", NIO % "Long", NIO % "Int", ARRAY]
DATA = ["double[]", "float[]", "long[]", "int[]", "short[]", "byte[]", MASK, "double[][]"]
DATA += [NIO % name for name in ("Double", "Float", "Long", "Int", "Short", "Byte")] + [ARRAY]
OCTETS = ["byte[]", NIO % "Byte", ARRAY]  # an object's bytes
USUAL = 3  # kinds of arrays that every form of a method takes
# What the arrays of a call with several of them are together: numbers, uint64 indices, uint32 indices.
FAMILIES = [("double[]", "long[]", "int[]"), ("float[]", "long[]", "int[]"), (NIO % "Double", NIO % "Long", NIO % "Int"),
            (NIO % "Float", NIO % "Long", NIO % "Int"), (ARRAY, ARRAY, ARRAY)]
# Inputs that C wants and a caller seldom says, with what stands for them.
DEFAULTS = {"flags": "0", "jalon_cloud_knn.level": "Jalon.LEVEL_AUTOMATIC", "jalon_cloud_builder_declare_field.components": "1",
            "jalon_model_clearance.part": "Jalon.WHOLE_MODEL", "jalon_model_clearance_to_model.part": "Jalon.WHOLE_MODEL",
            "jalon_model_clearance_to_model.other_part": "Jalon.WHOLE_MODEL"}
# Calls of which one of several inputs must be given, or some together: the sets that make sense beside all of them.
ALTERNATIVES = {"jalon_gauge_sweep": [["cloud"], ["model"]], "jalon_gauge_sweep_model": [["cloud"], ["model"]],
                "jalon_comparison_outlines": [["reverse", "reverse_points"], []]}


def camel(name):
    first, *rest = name.split("_")
    return first + "".join(part.capitalize() for part in rest)


def is_mask(m, i):
    """Whether those indices are of the points of the cloud that the method is of, so that a mask can say them."""
    return m.noun == "jalon_cloud" and not m.is_static and i.kind == "packed" and i.name in ("indices", "seeds")


def is_array(i):
    return i.kind in ("rows", "packed", "poses", "bytes")


def full_type(i):
    """As SWIG declares it."""
    if is_array(i):
        return ROWS_CLASS
    if i.kind == "list":
        return "java.util.List<Cloud>" if i.type == "CloudList" else i.type
    if i.kind in ("handle", "options", "task"):
        return class_of(i.type)
    return {"small": "double[]", "text": "String", "flag": "boolean"}.get(i.kind) or SCALARS[i.type]


def default_of(m, i):
    """What stands for an input that is left out; None where it cannot be."""
    text = DEFAULTS.get(m.c.name + "." + i.name) or DEFAULTS.get(i.name)
    if text is not None or says(NOT_NULLABLE, m.c.name, i.name):
        return text
    if i.kind in ("options", "task") or (i.nullable and i.kind not in ("number", "flag")):
        return "null"
    return None


def return_type(m):
    if has_result(m):
        return m.result_name
    if not m.outputs:
        return "void"
    o = m.outputs[0]
    if o.kind == "handle":
        return class_of(o.type)
    return {"small": "double[]", "doubles": "double[]", "view": ARRAY, "filled": ARRAY, "copied": ARRAY, "text": "String",
            "texts": "java.util.List<String>", "flag": "boolean", "bytes": "byte[]"}.get(o.kind) or SCALARS[o.type]


def given(m, seen):
    """The sets of inputs that overloads take, in C's order: the optional ones left out from the end, then options and task."""
    last = [i for i in seen if i.kind in ("options", "task")]
    free = [i for i in seen if i not in last and default_of(m, i) is not None]
    kept = [free[:n] for n in range(len(free), -1, -1)]
    if m.c.name in ALTERNATIVES:
        kept = [free] + [[i for i in free if i.name in names] for names in ALTERNATIVES[m.c.name]]
    tails = [[i for i, keep in zip(last, flags) if keep] for flags in ((1, 1), (1, 0), (0, 1), (0, 0))]
    for some in kept:
        for tail in tails:
            yield [i for i in seen if i in some or i in tail or (i not in free and i not in last)]


def kinds(m, inputs):
    """[{name: type of the array}] that those inputs may be, what most programs have first."""
    arrays = [i for i in inputs if is_array(i)]
    if not arrays:
        return [{}]
    rows = [{i.name: ROWS_CLASS for i in arrays}]
    if len(arrays) > 1:
        families = [{i.name: family[column_of(i)] for i in arrays} for family in FAMILIES]
        return families[:1] + rows + families[1:]
    i = arrays[0]
    types = (NUMBERS, INDICES, INDICES)[column_of(i)]
    if i.name == "data":
        types = DATA
    elif i.kind == "bytes":
        types = OCTETS
    elif i.kind == "poses":
        types = ["double[]", "double[][]"]
    elif is_mask(m, i):
        types = types[:1] + [MASK] + types[1:]
    elif column_of(i) == 0 and ROWS.get(i.name, 1) > 1:
        types = types[:1] + ["double[][]"] + types[1:]
    kinds_ = [{i.name: t} for t in types]
    return kinds_[:1] + rows + kinds_[1:]


def column_of(i):
    return {"const uint64_t*": 1, "const uint32_t*": 2}.get(i.c.type, 0)


def argument(m, i, taken):
    """What the full form gets for it."""
    if i.name not in [j.name for j in taken]:
        return "(%s) null" % full_type(i) if default_of(m, i) == "null" else default_of(m, i)
    type_ = taken_type(i, taken)
    if not is_array(i) or type_ == ROWS_CLASS:
        return i.name
    if type_ == MASK:
        if not is_mask(m, i):
            return "Rows.flags(%s)" % i.name
        return "Masks.%s(mask, count())" % ("indices" if m.name == "select" else "some")
    return "Rows.of(%s)" % i.name


def taken_type(i, taken):
    return next(j.java for j in taken if j.name == i.name)


class Taken:
    """One parameter of an overload."""

    def __init__(self, m, i, type_):
        self.name, self.java = i.name, type_
        self.shown = "mask" if type_ == MASK and is_mask(m, i) else i.name


def comment(m, seen, taken):
    link = "{@link #%s(%s)}" % (camel(m.name), ", ".join(full_type(i).split("<")[0] for i in seen))
    left = [i.name for i in seen if i.name not in [t.name for t in taken]]
    text = "As " + link + (", without %s." % ", ".join(left) if left else ".")
    if any(t.shown == "mask" for t in taken):
        text = text[:-1] + "; mask: one a point of this cloud, true for those that are meant."
    return "  /** %s */" % text


def overloads(m):
    """The Java lines beside SWIG's full form."""
    seen = inputs_seen(m)
    seen = seen if m.is_static else seen[1:]
    done, out = {tuple(full_type(i) for i in seen)}, []
    forms = list(given(m, seen))
    with_arrays = [inputs for inputs in forms if any(is_array(i) for i in inputs)]
    for inputs in forms:
        # Every form with the usual types; with the others the longest and the shortest.
        every = inputs in with_arrays[:1] + with_arrays[-1:] or any(i.name == "data" for i in inputs)
        for types in kinds(m, inputs)[:None if every else USUAL]:
            taken = [Taken(m, i, types.get(i.name) or full_type(i)) for i in inputs]
            key = tuple(t.java for t in taken)
            if key in done:
                continue
            done.add(key)
            name, result = camel(m.name), return_type(m)
            out += [comment(m, seen, taken),
                    "  public %s%s %s(%s) {" % ("static " if m.is_static else "", result, name,
                                                ", ".join("%s %s" % (t.java, t.shown) for t in taken)),
                    "    %s%s(%s);" % ("" if result == "void" else "return ", name,
                                       ", ".join(argument(m, i, taken) for i in seen)), "  }", ""]
    return out


def small_names(wrapped):
    """The parameters that are points, boxes and poses wherever they occur."""
    names = {i.name for m in wrapped for i in m.inputs if i.kind == "small"}
    clash = {i.name for m in wrapped for i in m.inputs if is_array(i) and i.name in names}
    if clash:
        raise SystemExit("small arrays and large ones of one name: " + ", ".join(sorted(clash)))
    return sorted(names)


def typemaps(wrapped):
    """What SWIG must know: which arrays are double[]."""
    for name in small_names(wrapped):
        yield '%%typemap(jstype) const ArrayIn* %s "double[]"' % name
        yield '%%typemap(javain) const ArrayIn* %s "Rows.of($javainput)"' % name


def proxy_code(noun, lines):
    """Lines inside the class of a noun."""
    return "%%extend %s {\n%%proxycode %%{\n%s\n%%}\n}" % (class_of(noun), "\n".join(lines))


def code(wrapped, nouns):
    """The overloads of all classes and of the functions that belong to none."""
    yield from typemaps(wrapped)
    for noun in nouns:
        yield proxy_code(noun, [line for m in wrapped if m.noun == noun for line in overloads(m)])
    lines = ["  private Jalon() {}", ""] + [line for m in wrapped if m.noun is None for line in overloads(m)]
    yield "%%pragma(java) modulecode=%%{\n%s\n%%}" % "\n".join(lines)

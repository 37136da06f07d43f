# SPDX-FileCopyrightText: 2026 The Jalon authors
# SPDX-License-Identifier: Apache-2.0
"""How each C function looks in a language: the class it belongs to, its inputs and its outputs.

The C grammar is regular - jalon_noun_verb(handle, inputs, options, task, outputs) - so the shape follows from the parameters.
A parameter of a kind that no rule here knows ends the generation with its name.
"""

from api_description import BY_RINGS, COUNTS, MAY_BE_LEFT_OUT, NULLABLE, OPERATION, says
from headers import Header, header_names, nouns, public_functions, structs

# What each language has its own form of, and which.
REPLACED = {
    "_retain": "objects share handles by themselves",
    "_release": "close() and the end of the object",
    "jalon_last_error_message": "the message of the exception",
    "jalon_bytes_view": "the bytes that to_bytes gives, in the language's own form",
    "jalon_task_set_progress": "the progress callback of the language",
    "jalon_task_set_log": "the log callback of the language",
}
# Handles that are no class: what looks at them is made from them (REPLACED says how).
NO_CLASS = {"jalon_bytes"}
# Memory that the caller gives in C: rows and columns, as expressions of the other parameters.
FILLED = {
    ("jalon_cloud_knn", "indices"): ("uint64_t", "queries_.count", "k"),
    ("jalon_cloud_knn", "squared_distances"): ("double", "queries_.count", "k"),
    ("jalon_cloud_knn_all", "indices"): ("uint32_t", "count_of(cloud_)", "k"),
    ("jalon_cloud_knn_all", "squared_distances"): ("float", "count_of(cloud_)", "k"),
    ("jalon_noise_law_evaluate", "density"): ("double", "values_.count()", "1"),
    ("jalon_noise_law_evaluate", "cumulative"): ("double", "values_.count()", "1"),
    ("jalon_noise_law_quantiles", "out"): ("double", "probabilities_.count()", "1"),
}
NUMBERS = {"jalon_status", "uint64_t", "int64_t", "uint32_t", "int32_t", "double"}
SMALL = {"jalon_vec3": (1, 3), "jalon_box": (2, 3), "jalon_transform": (3, 4)}
LISTS = {"jalon_gauge_piece": "Gauge", "jalon_target": "Targets", "jalon_cloud": "CloudList"}


def class_nouns():
    return [noun for noun in nouns() if noun not in NO_CLASS]


def class_of(noun):
    return "".join(part.capitalize() for part in noun[len("jalon_"):].split("_"))


class Input:
    """kind: handle, text, number, flag, rows (strided), packed, bytes, small, list, options, task."""

    def __init__(self, kind, name, type_, nullable, c=None):
        self.kind, self.name, self.type, self.nullable, self.c = kind, name, type_, nullable, c


class Output:
    """kind: handle, text, texts, number, flag, small, view, filled, doubles, bytes; type: noun, C type or struct."""

    def __init__(self, kind, name, type_, c):
        self.kind, self.name, self.type, self.c = kind, name, type_, c


class Method:
    def __init__(self, function, noun, doc):
        self.c, self.noun, self.doc = function, noun, doc
        self.class_name = class_of(noun) if noun else None
        self.name = function.name[len(noun or "jalon") + 1:]
        self.inputs, self.outputs = [], []
        self.is_static = False
        self.operation = OPERATION.get(function.name)

    @property
    def full_name(self):
        return (self.class_name + "_" if self.noun else "") + self.name

    @property
    def result_name(self):
        words = self.c.name[len("jalon_"):].split("_")
        return "".join(w.capitalize() for w in words) + "Result"

    def input(self, kind):
        return next((i for i in self.inputs if i.kind == kind), None)


def handle_noun(type_, known):
    bare = type_.replace("const ", "").rstrip("*")
    return bare if bare in known and type_.count("*") == 1 else None


class Reader:
    """Walks over the parameters of one function."""

    def __init__(self, function, noun, doc, known, all_structs):
        self.f, self.known, self.structs = function, known, all_structs
        self.m = Method(function, noun, doc)
        self.all_names = [p.name for p in function.parameters]

    def unknown(self, p):
        raise SystemExit("%s: no shape for the parameter %s %s: add a rule to bindings/generator/shapes.py"
                         % (self.f.name, p.type, p.name))

    def read(self):
        for i, p in enumerate(self.f.parameters):
            if not (self.consumed(p) or self.take_input(i, p) or self.take_output(p)):
                self.unknown(p)
        if self.f.result == "const char*":
            self.m.outputs.append(Output("text", "return", "std::string", None))
        elif self.f.result != "jalon_status":
            self.m.outputs.append(Output("number", "return", self.f.result, None))
        self.m.is_static = not (self.m.noun and self.m.inputs and self.m.inputs[0].type == self.m.noun
                                and self.f.parameters[0].type.rstrip("*").replace("const ", "") == self.m.noun)
        return self.m

    def consumed(self, p):
        """Counts, types and strides that an array brings along."""
        if p.name == "capacity_elements":
            return True
        has_rows = any(q.type == "const void*" for q in self.f.parameters)
        if p.name in ("type", "stride_bytes", "components") and has_rows:
            return True
        arrays = [q.name for q in self.f.parameters if COUNTS.get(q.name) == p.name and q.type.startswith(("const ", "jalon_cloud*"))]
        return p.type == "uint64_t" and bool(arrays)

    def add(self, kind, p, type_=None):
        may_be_null = says(NULLABLE | MAY_BE_LEFT_OUT, self.f.name, p.name)
        may_be_null |= p.name == "indices" and kind == "packed" and self.m.name != "select"
        self.m.inputs.append(Input(kind, p.name, type_ or p.type, may_be_null, p))
        return True

    def take_input(self, i, p):
        bare = p.type.replace("const ", "").rstrip("*")
        if bare.replace("const", "").rstrip("* ") in LISTS and COUNTS.get(p.name) in self.all_names:
            return self.add("list", p, LISTS[bare.replace("const", "").rstrip("* ")])
        if p.name == "options":
            return self.add("options", p, "jalon_params")
        if p.name == "task" and i > 0:
            return self.add("task", p, "jalon_task")
        noun = handle_noun(p.type, self.known)
        if noun:
            return self.add("handle", p, noun)
        if p.type == "const char*":
            return self.add("text", p)
        if p.type == "const void*":
            return self.add("rows", p)
        if p.type == "const uint8_t*":
            return self.add("bytes", p)
        if p.name in BY_RINGS or p.name == "hull_points" or p.type in ("const double*", "const uint64_t*", "const uint32_t*"):
            return self.add("merged" if p.name == "hull_points" else "packed", p)
        if p.type.startswith("const ") and bare in SMALL:
            return self.add("poses" if p.name in COUNTS else "small", p, bare)
        if p.type in NUMBERS:
            flag = p.type == "int32_t" and (p.name == "centred" or self.f.name.endswith("set_bool"))
            return self.add("flag" if flag else "number", p)
        return False

    def take_output(self, p):
        out = lambda kind, type_: self.m.outputs.append(Output(kind, p.name, type_, p)) or True  # noqa: E731
        bare = p.type.rstrip("*").replace("const ", "")
        if (self.f.name, p.name) in FILLED:
            return out("filled", FILLED[(self.f.name, p.name)])
        if p.type.endswith("**") and bare in self.known:
            return out("bytes" if bare in NO_CLASS else "handle", bare)
        if p.type == "const char**":
            return out("text", "std::string")
        if p.type == "const char*const**":
            return out("texts", None)
        if p.type == "const double**":
            return out("doubles", None)
        if p.type == "jalon_array_view*":
            return out("view", bare)
        if p.extent == 9 or (p.type.endswith("*") and bare in SMALL):
            return out("small", (3, 3) if p.extent else bare)
        if p.type.endswith("*") and bare in self.structs:
            return out("struct", bare)
        if p.type == "uint64_t*" and p.name == "count" and any(o.kind in ("doubles", "texts") for o in self.m.outputs):
            return True
        if p.type.endswith("*") and p.type.count("*") == 1 and bare in NUMBERS:
            flag = bare == "int32_t" and (p.name.startswith("has_") or "_is_" in self.f.name or self.f.name.endswith("get_bool"))
            return out("flag" if flag else "number", bare)
        if p.type == "void*":
            return out("copied", None)
        return False


def replaced(name):
    return REPLACED.get(name) or next((why for end, why in REPLACED.items() if end[0] == "_" and name.endswith(end)), None)


def methods():
    """All functions that are wrapped, in the order of the headers."""
    known, all_structs = nouns(), structs()
    docs = {}
    for name in header_names():
        docs.update(Header(name).docs)
    found = []
    for function in public_functions():
        if replaced(function.name):
            continue
        noun = next((n for n in known if function.name.startswith(n + "_")), None)
        found.append(Reader(function, noun, docs.get(function.name, ""), known, all_structs).read())
    return found


if __name__ == "__main__":
    for m in methods():
        print(("static " if m.is_static else "") + m.full_name, [(i.kind, i.name) for i in m.inputs],
              "->", [(o.kind, o.name) for o in m.outputs])

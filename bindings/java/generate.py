#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The Jalon authors
# SPDX-License-Identifier: Apache-2.0
"""What only Java has, from the headers and the parameter tables: generate.py OUT_I OUT_FOLDER PARAMETERS_JSON

OUT_I, java_api.i: Javadoc, results as values, typed setters of the workers. OUT_FOLDER: one class of parameters an operation.
"""

import json
import os
import re
import sys

HERE = os.path.dirname(os.path.abspath(__file__))
sys.path[:0] = [HERE, os.path.join(HERE, "..", "generator")]
import overloads  # noqa: E402
from api_description import ROWS  # noqa: E402
from emit_swig import has_result, inputs_seen, result_fields  # noqa: E402
from headers import Header, header_names, read  # noqa: E402
from overloads import camel, proxy_code  # noqa: E402
from shapes import SMALL, class_nouns, class_of, methods  # noqa: E402
from texts import parts  # noqa: E402

LICENSE = "/* Generated from the public headers by bindings/java/generate.py. */\n"
TYPES = {"std::string": "String", "bool": "boolean", "double": "double", "int32_t": "int", "uint32_t": "long",
         "uint64_t": "long", "int64_t": "long", "Numbers*": "double[]"}
DOUBLE, INT64, BOOL, STRING, CHOICE, DOUBLES = range(1, 7)
PARAM_TYPES = {DOUBLE: "double", INT64: "long", BOOL: "boolean", STRING: "String", CHOICE: "String", DOUBLES: "double[]"}


def title(name):
    return "".join(part.capitalize() for part in name.split("_"))


def java_type(c_type):
    return TYPES.get(c_type) or c_type.rstrip("*")


class Documents:
    """Comments of the headers as Javadoc."""

    def __init__(self, wrapped):
        self.links = {m.c.name: "%s.%s" % (m.class_name or "Jalon", camel(m.name)) for m in wrapped}

    def html(self, text):
        text = text.replace("&", "&amp;").replace("<", "&lt;").replace(">", "&gt;").replace("*/", "* /").replace("@", "&#64;")
        text = re.sub(r"\bjalon_\w+", lambda n: "{@code %s}" % self.links.get(n.group(0), n.group(0)), text)
        text = re.sub(r"\bJALON_(\w+)", r"\1", text)
        return re.sub(r"\bNULL\b", "null", text)

    def paragraphs(self, text):
        """Those of a comment; tables keep their lines."""
        return ["<pre>\n%s\n</pre>" % self.html(part) if is_table else self.html(part) for is_table, part in parts(text)]

    def comment(self, paragraphs, indent=""):
        lines = []
        for i, text in enumerate(t for t in paragraphs if t):
            break_ = "<p>" if i and not text.startswith("<pre>") else ""
            lines += ([""] if i else []) + (break_ + text).split("\n")
        return "\n".join([indent + "/**"] + [(indent + " * " + line).rstrip() for line in lines] + [indent + " */"])


def notes(m):
    """What the Java form of the inputs takes."""
    for i in inputs_seen(m)[0 if m.is_static else 1:]:
        if i.kind in ("rows", "packed", "poses", "small"):
            columns = "12 or 16" if i.kind == "poses" else ROWS.get(i.name)
            shape = "%s: rows of %s" % (i.name, columns) if columns else i.name + ": numbers"
            if i.kind == "small":
                count = SMALL[i.type][0] * SMALL[i.type][1]
                shape = "%s: %s numbers" % (i.name, "12 or 16" if count == 12 else count)
            yield shape + ("; may be null" if overloads.default_of(m, i) == "null" else "")
        elif i.kind == "bytes":
            yield "%s: what toBytes gave" % i.name
        elif i.kind == "options":
            operation = m.operation
            link = "{@link %sParams}, " % title(operation) if operation else ""
            yield "options: %snull = the defaults" % link
        elif i.kind == "task":
            yield "task: threads, progress and cancel, null = none"
    if has_result(m):
        yield "Returns " + ", ".join(camel(name) + "()" for name, *_ in result_fields(m))


def method_comments(wrapped, documents):
    for m in wrapped:
        own = list(notes(m))
        text = documents.paragraphs(m.doc or m.c.name + " of the C library.")
        text += [";\n".join(own) + "."] if own else []
        yield "%%javamethodmodifiers %s%s %%{%s\n  public%%}" % (
            m.class_name + "::" if m.noun else "", m.name, documents.comment(text, "  ").lstrip())


def class_comments(documents):
    for noun in class_nouns():
        for name in header_names():
            if "typedef struct %s %s;" % (noun, noun) not in read("include/jalon/" + name):
                continue
            header = Header(name)
            own = "jalon_" + name[:-2] == noun
            text = header.doc if own else header.docs.get(noun + "_create") or "%s, see %s.h." % (class_of(noun), name[:-2])
            yield "%%typemap(javaimports) %s %%{\n%s\n%%}" % (
                class_of(noun), documents.comment(documents.paragraphs(text)))


def result_class(m):
    """The result of a call with several outputs: read once, held as plain values, so that nothing native stays behind it."""
    name, fields = m.result_name, [(n, java_type(t), t) for n, _, t, _ in result_fields(m)]
    closed = [n for n, java, c in fields if c.endswith("*") and java != "double[]"]
    lines = ["%%typemap(javabase) %s \"\"" % name, "%%typemap(javainterfaces) %s \"%s\"" % (name, "AutoCloseable" if closed else "")]
    for n, _, _ in fields:
        lines += ["%%rename(%s) %s::%s;" % (camel("native_" + n), name, n), "%%javamethodmodifiers %s::%s \"private\"" % (name, n)]
    lines += ["%%typemap(javaimports) %s %%{" % name,
              "/** What {@code %s.%s} gives.%s */" % (m.class_name or "Jalon", camel(m.name), " close() closes its parts." if closed else ""),
              "%}", "%%typemap(javabody) %s %%{" % name]
    lines += ["  private final long swigCPtr;"] + ["  private final %s %s;" % (java, camel(n)) for n, java, _ in fields]
    lines += ["", "  %s(long pointer, boolean owned) {" % name, "    swigCPtr = pointer;", "    try {"]
    lines += ["      %s = %s();" % (camel(n), camel("native_" + n)) for n, _, _ in fields]
    lines += ["    } finally {", "      $imclassname.delete_%s(pointer);" % name, "    }", "  }"]
    for n, java, _ in fields:
        lines += ["", "  /** %s. */" % n.replace("_", " ").capitalize(),
                  "  public %s %s() {" % (java, camel(n)), "    return %s;" % camel(n), "  }"]
    if closed:
        lines += ["", "  @Override", "  public void close() {"]
        lines += ["    if (%s != null) {\n      %s.close();\n    }" % (camel(n), camel(n)) for n in closed] + ["  }"]
    values = ['"%s"' % camel(n) + (", java.util.Arrays.toString(%s)" if java == "double[]" else ", %s") % camel(n) for n, java, _ in fields]
    lines += ["", "  /** The values of all parts. */", "  @Override", "  public String toString() {",
              '    return Described.result("%s", %s);' % (name, ", ".join(values)), "  }"]
    return "\n".join(lines + ["%}"])


def row_comment(row, documents, more=""):
    limits = ""
    if row["type"] in (DOUBLE, INT64, DOUBLES) and (row["minimum"] is not None or row["maximum"] is not None):
        limits = "; from %s to %s" % tuple("any" if v is None else "%.15g" % v for v in (row["minimum"], row["maximum"]))
    unit = " (%s)" % row["unit"] if row["unit"] else ""
    choices = "; one of " + row["choices"].replace("|", ", ") if row["choices"] else ""
    text = "%s%s. Default %s%s%s.%s" % (row["help"], unit, row["default_text"], limits, choices, more)
    return documents.comment([documents.html(text)], "  ")


def setters(owner, rows, documents, body):
    """Typed setters of rows [(row, note)]; body(row) is what one does."""
    out = []
    for row, more in rows:
        out += [row_comment(row, documents, more),
                "  public %s set%s(%s value) {" % (owner, title(row["name"]), PARAM_TYPES[row["type"]])]
        out += ["    " + line for line in body(row)] + ["    return this;", "  }", ""]
    return out


def worker_code(noun, tables, documents):
    """set(name, value) and the typed setters of a worker: of all its methods."""
    owner, rows, seen = class_of("jalon_" + noun), [], {}
    for method, table in tables.items():
        for row in table:
            if row["name"] in seen:
                if seen[row["name"]]["type"] != row["type"]:
                    raise SystemExit("%s: the parameter %s has two types" % (noun, row["name"]))
                continue
            seen[row["name"]] = row
            with_it = [m for m, t in tables.items() if any(r["name"] == row["name"] for r in t)]
            rows.append((row, "" if len(with_it) == len(tables) else " Of " + ", ".join(with_it) + "."))
    use = lambda what: ["try (Params params = params()) {", "  params.%s;" % what, "}"]  # noqa: E731
    out = []
    used = {PARAM_TYPES[row["type"]] for row, _ in rows} | {"long"}  # whole numbers where a double is wanted too
    for java in (t for t in ("double", "long", "boolean", "String", "double[]") if t in used):
        out += ["  /** Sets a parameter of this worker by its name; see {@link Params}. */",
                "  public %s set(String name, %s value) {" % (owner, java)]
        out += ["    " + line for line in use("set(name, value)")] + ["    return this;", "  }", ""]
    out += setters(owner, rows, documents, lambda row: use('set("%s", value)' % row["name"]))
    return proxy_code("jalon_" + noun, out)


def texts_of_objects():
    """toString of each noun, by class Described."""
    for noun in class_nouns():
        yield proxy_code(noun, ["  /** One line: what it is and how much of it there is; never an exception. */", "  @Override",
                                "  public String toString() {", "    return Described.of(this);", "  }"])


def params_class(operation, rows, documents):
    owner = title(operation) + "Params"
    out = [LICENSE + "package org.jalon;", "",
           "/** The parameters of \"%s\", at their defaults until set. */" % operation, "public final class %s extends Params {" % owner,
           "  /** All at their defaults. */", "  public %s() {" % owner,
           '    super(JalonJNI.Params_create(Text.utf8("%s")), true);' % operation, "  }", ""]
    out += setters(owner, [(row, "") for row in rows], documents, lambda row: ['set("%s", value);' % row["name"]])
    return "\n".join(out + ["}", ""])


def write(path, text):
    if not os.path.exists(path) or open(path, encoding="utf-8").read() != text:
        with open(path, "w", encoding="utf-8") as f:
            f.write(text)


def main():
    interface, folder = sys.argv[1:3]
    tables = json.load(open(sys.argv[3], encoding="utf-8"))
    wrapped = methods()
    documents = Documents(wrapped)
    parts = [LICENSE] + list(class_comments(documents)) + list(method_comments(wrapped, documents))
    parts += list(texts_of_objects()) + list(overloads.code(wrapped, class_nouns()))
    parts += [result_class(m) for m in wrapped if has_result(m)]
    parts += [worker_code(noun, methods_, documents) for noun, methods_ in tables["workers"].items()]
    write(interface, "\n".join(parts + [""]))
    os.makedirs(folder, exist_ok=True)
    wanted = {title(operation) + "Params.java": rows for operation, rows in tables["operations"].items()}
    for stale in set(os.listdir(folder)) - set(wanted):
        os.remove(os.path.join(folder, stale))
    for operation, rows in tables["operations"].items():
        write(os.path.join(folder, title(operation) + "Params.java"), params_class(operation, rows, documents))


if __name__ == "__main__":
    main()

# SPDX-FileCopyrightText: 2026 The Jalon authors
# SPDX-License-Identifier: Apache-2.0
"""Comments of the C headers as documentation of another language, and parameter rows as text."""

import json
import re

DOUBLE, INT64, BOOL, STRING, CHOICE, DOUBLES = range(1, 7)


def words(name):
    return "".join(part.capitalize() for part in name.lower().split("_"))


def error_class(constant):
    """ERROR_NOT_FOUND -> NotFoundError."""
    return words(constant[len("ERROR_"):]) + "Error"


def translated(text, nouns, null="None", separator=".", member=lambda name: name):
    """The comment with the names that the language has."""
    def function(match):
        name = match.group(0)
        noun = next((n for n in nouns if name.startswith(n + "_")), None)
        if name in nouns:
            return words(name[len("jalon_"):])
        if noun is None:
            return member(name[len("jalon_"):])
        return words(noun[len("jalon_"):]) + separator + member(name[len(noun) + 1:])

    text = re.sub(r"\bjalon_[a-z0-9_]+", function, text)
    text = re.sub(r"\bJALON_(ERROR_[A-Z_]+)", lambda m: error_class(m.group(1)), text)
    text = re.sub(r"\bJALON_", "", text)
    text = re.sub(r"\bNULL\b", null, text)
    text = re.sub(r"\s*The caller releases (it|them)\.", "", text)
    text = re.sub(r"\*(out(?:_\w+)?)\b", lambda m: m.group(1), text)
    return re.sub(r"\*([a-z]\w*)\b", r"\1", text)


def parts(text):
    """[(is a table, text)]: the paragraphs of a comment and, apart from them, its tables of columns, whose lines stay."""
    found = []
    for paragraph in re.split(r"\n\s*\n", text):
        table = re.search(r"^ +column +type +unit +meaning$.*", paragraph, re.S | re.M)
        before = paragraph[:table.start()] if table else paragraph
        found += [(False, before.rstrip())] if before.strip() else []
        found += [(True, table.group(0))] if table else []
    return found


def wrap(text, width, indent=""):
    """The paragraphs broken anew; lines that begin with "- " stay apart, tables as they are."""
    out = []
    for is_table, part in parts(text):
        out += [""] if out else []
        out += [indent + line for line in part.split("\n")] if is_table else wrap_prose(part, width, indent)
    return out


def wrap_prose(text, width, indent):
    out, current = [], ""
    for line in text.split("\n") + [""]:
        starts = line.strip() == "" or re.match(r"\s*- ", line)
        if starts and current:
            out += fill(current, width, indent)
            current = ""
        if line.strip() == "":
            if out and out[-1] != "":
                out.append("")
        else:
            current = line.rstrip() if not current else current + " " + line.strip()
    while out and out[-1] == "":
        out.pop()
    return out


def fill(text, width, indent):
    hanging = "  " if text.lstrip().startswith("- ") else ""
    lines, current = [], indent
    for word in text.split():
        if len(current) + 1 + len(word) > width and current.strip():
            lines.append(current.rstrip())
            current = indent + hanging
        current += ("" if current.endswith(" ") or current == indent else " ") + word
    return lines + [current.rstrip()]


def default_of(row):
    return json.loads(row["default_text"])


def row_text(row):
    """One line: unit, choices or range, default, help."""
    facts = []
    if row["unit"]:
        facts.append(row["unit"])
    if row["choices"]:
        facts.append(row["choices"].replace("|", " | "))
    low, high = row["minimum"], row["maximum"]
    if row["type"] in (DOUBLE, INT64, DOUBLES) and (low is not None or high is not None):
        facts.append("%s to %s" % ("-inf" if low is None else "%g" % low, "inf" if high is None else "%g" % high))
    facts.append("default " + row["default_text"])
    text = "%s (%s): %s" % (row["name"], ", ".join(facts), row["help"])
    return text + (" Methods: %s." % row["methods"].replace(",", ", ") if row["methods"] else "")


def worker_rows(tables, worker):
    """The rows of all methods of a worker, each name once, in order of appearance; {"of": methods that have it}."""
    rows = {}
    for method, table in tables["workers"].get(worker, {}).items():
        for row in table:
            rows.setdefault(row["name"], dict(row, of=[]))["of"].append(method)
    return list(rows.values())

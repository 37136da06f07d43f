# SPDX-FileCopyrightText: 2026 The Jalon authors
# SPDX-License-Identifier: Apache-2.0
"""What rows of tables hold, for Python: from the tables of columns in the comments of the headers."""

import keyword
import re

from python_names import RECORDS, columns_of_enums, is_single, is_table

TABLE = re.compile(r"^( +)column +type +unit +meaning$\n((?:\1 *\S.*(?:\n|$))*)", re.M)
COLUMN = r"^ {%d}([a-z]\w*) +(u?int|float)\d+(?: x (\w+))? "
# Tables whose comment says that they have the columns of another's.
COLUMNS_OF = {"Cloud_fit_sphere": "Segmentation_segments", "Cloud_fit_cylinder": "Segmentation_segments",
              "gauge_sweep_model": "gauge_sweep", "Model_volume": "Cloud_volume"}
# What a record or a summary has already; a column of such a name is had by row["values"] alone.
TAKEN = {"get", "items", "keys", "table", "to_dict", "values"}
MANY = 1000  # stands for as many numbers a row as there are classes, "x n"
SHORT = 4  # vectors of up to so many numbers are typed number by number


def output_name(o):
    return o.name[4:] if o.name.startswith("out_") else o.name


def tables(m):
    """[(last paragraph before the table, {column: ("int" or "float", numbers a row)})] of a function's comment."""
    found, at = [], 0
    for table in TABLE.finditer(m.doc):
        before = re.split(r"\n\s*\n", m.doc[at:table.start()].rstrip())[-1]
        rows = re.findall(COLUMN % len(table.group(1)), table.group(2), re.M)
        found.append((before, {name: (kind.lstrip("u"), int(count or 1) if (count or "1").isdigit() else MANY) for name, kind, count in rows}))
        at = table.end()
    return found


def is_of(m, o, before):
    """Whether the paragraph before a table of columns says that it is of this output."""
    outputs = [other for other in m.outputs if is_table(other)]
    named = [other for other in outputs if re.search(r"\b%s\b" % re.escape(other.name), before)]
    return o in named if named else len(outputs) == 1 and before != "Fields:"  # those go into the cloud


def either(one, other):
    """The kind of a column that two methods give; None: any. A whole number does where a number is wanted."""
    if one is None or one[1] != other[1]:
        return None
    return one if one == other else ("float", one[1])


def columns(m, o, functions):
    """({column: ("int" or "float", numbers a row), or None where it depends}, {column: enum}) of an output that is a table."""
    found, enums = {}, {}
    like = functions.get(COLUMNS_OF.get(m.full_name))
    if like is not None:
        same = next((other for other in like.outputs if output_name(other) == output_name(o)), None)
        found, enums = columns(like, same, functions) if same is not None else ({}, {})
    for before, rows in tables(m):
        if is_of(m, o, before):
            for name, kind in rows.items():
                found[name] = either(found.get(name, kind), kind)
    enums = dict(enums, **columns_of_enums(m.doc))
    return found, {name: enum for name, enum in enums.items() if name in found}


def record_of(m, o):
    """The public class of the rows of a table, or None."""
    return RECORDS.get(m.full_name if o.name == "out" else "%s.%s" % (m.full_name, output_name(o)))


def table_of(m, o, functions):
    """(function of _tables.py, class of the records or None, {column: enum}) of an output that is a table."""
    return "summary" if is_single(m, o) else "table", record_of(m, o), columns(m, o, functions)[1]


def hint(kind, enum, single):
    """The type of one value."""
    if kind is None:
        return "Any"
    base, count = kind
    if count == 1:
        return enum or base
    if single:
        return "NDArray[numpy.%s64]" % base
    return "Tuple[%s]" % (", ".join([base] * count) if count <= SHORT else base + ", ...")


def attributes(found, enums, single=False):
    """The lines that declare them, without indentation."""
    usual = [name for name in found if name not in TAKEN]
    return ["%s: %s" % (name + "_" * keyword.iskeyword(name), hint(found[name], enums.get(name), single)) for name in usual]


def row_class(m, o):
    """The name in the stub of the rows of a table without a public class, or of a summary."""
    name = "".join(word.capitalize() for word in m.c.name.split("_")[1:])
    return "_%s%s" % (name, "" if o.name == "out" else "".join(word.capitalize() for word in output_name(o).split("_")))


def of_records(functions):
    """{public class: the lines that declare its attributes}."""
    return {record_of(m, o): attributes(*columns(m, o, functions)) for m in functions.values() for o in m.outputs
            if is_table(o) and record_of(m, o)}


def own(m, o, functions):
    """(class that it extends, attributes of its own) of the rows of a table, or of a summary."""
    kind, record, enums = table_of(m, o, functions)
    if record:
        return record, []
    return "Summary" if kind == "summary" else "Record", attributes(columns(m, o, functions)[0], enums, kind == "summary")


def table_hint(m, o, functions):
    """The type of an output that is a table, in the stub."""
    base, lines = own(m, o, functions)
    name = row_class(m, o) if lines else base
    return name if base == "Summary" else "Fields[%s]" % name


def stub_classes(functions):
    """The lines of the classes that table_hint names."""
    out = []
    for m in functions.values():
        for o in (o for o in m.outputs if is_table(o)):
            base, lines = own(m, o, functions)
            out += ["class %s(%s):" % (row_class(m, o), base)] + ["    " + line for line in lines] + [""] if lines else []
    return out


COLUMNS_HEAD = '''# Generated from the public headers by bindings/generator: do not edit.
"""What the records of the package hold, for type checkers and help()."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any, Tuple

if TYPE_CHECKING:
    from ._api import %s
'''


def module(functions):
    """The text of _columns.py."""
    found = of_records(functions)
    enums = sorted({word for lines in found.values() for line in lines for word in re.findall(r": ([A-Z]\w+)$", line)} - {"Any"})
    out = [COLUMNS_HEAD % ", ".join(enums)]
    for name, lines in sorted(found.items()):
        out += ["", "class %sColumns:" % name, "    __slots__ = ()"] + ["    " + line for line in lines] + [""]
    return "\n".join(out)

#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The Jalon authors
# SPDX-License-Identifier: Apache-2.0
"""The parameter tables against what is committed: parameters.py BUILD_FOLDER [--update]

parameters.txt has a line a parameter: owner, name, type, default, range or choices, unit, methods, help. Whoever sets a parameter by
name relies on it; a wanted change is written anew by tests/abi/update.sh, with its line in CHANGELOG.md.
"""

import os
import sys

HERE = os.path.dirname(os.path.abspath(__file__))
sys.path[:0] = [os.path.join(HERE, "..", "style"), os.path.join(HERE, "..", "..", "bindings", "generator")]
from dump_params import Library, workers  # noqa: E402
from source import Tally  # noqa: E402

COMMITTED = os.path.join(HERE, "parameters.txt")
TYPES = ("", "double", "int64", "bool", "string", "choice", "doubles")


def limits(row):
    if row["choices"]:
        return row["choices"]
    low, high = row["minimum"], row["maximum"]
    return "" if low is None and high is None else "%s ... %s" % (low, high)


def lines_of(library):
    tables = {"operation " + name: rows for name, rows in library.operations().items()}
    for noun in workers():
        for method, rows in library.methods(noun).items():
            tables["%s %s" % (noun[len("jalon_"):], method)] = rows
    for owner, rows in tables.items():
        for row in rows:
            yield "; ".join([owner, row["name"], TYPES[row["type"]], row["default_text"], limits(row), row["unit"], row["methods"],
                             row["help"]])


def main():
    library = Library(os.path.join(os.path.abspath(sys.argv[1]), "src", "libjalon.so"))
    found = list(lines_of(library))
    if "--update" in sys.argv[2:]:
        with open(COMMITTED, "w", encoding="utf-8") as f:
            f.write("# The parameters of all operations and workers, by tests/abi/update.sh.\n" + "\n".join(found) + "\n")
    with open(COMMITTED, encoding="utf-8") as f:
        committed = [line.rstrip("\n") for line in f if not line.startswith("#")]
    tally = Tally()
    tally.check("abi: parameters, their order, defaults, ranges, units and help equal the committed tables",
                ["+ " + line for line in found if line not in committed] + ["- " + line for line in committed if line not in found] +
                (["the order"] if sorted(found) == sorted(committed) and found != committed else []))
    owners = [tuple(line.split("; ")[:2]) for line in found]
    tally.check("abi: no set has two parameters of one name", ["%s: %s" % o for o in sorted(set(owners)) if owners.count(o) > 1])
    tally.close()


if __name__ == "__main__":
    main()

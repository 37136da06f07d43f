# SPDX-FileCopyrightText: 2026 The Jalon authors
# SPDX-License-Identifier: Apache-2.0
"""One type a name. Two classes of one name in one namespace are two definitions of one class to the linker: where their members
are not inlined it keeps those of either, and copies one as if it were the other. No compiler tells."""

import collections
import re

from source import read

TYPE = re.compile(r"(?:template\s*<.*>\s*)?(?:struct|class|enum(?:\s+class)?|union)\s+(?:alignas\([^)]*\)\s*)?(\w+)(?!\w|::|\s*;|\s*<)")
NAMESPACE = re.compile(r"(?:inline )?namespace\b\s*([\w:]*)\s*\{")


def types_of(path):
    """(namespace, name) of each class, struct and enumeration at the margin; what is unnamed is the file's own."""
    spaces = []
    for line in read(path).splitlines():
        opened = NAMESPACE.match(line)
        if opened and not line.rstrip().endswith("}"):
            spaces.append(opened.group(1))
        elif re.match(r"\}\s*// namespace", line) and spaces:
            spaces.pop()
        found = TYPE.match(line)
        if found and "" not in spaces:
            yield "::".join(spaces + [found.group(1)])


def one_definition(files):
    places = collections.defaultdict(set)
    for path in files:
        if re.match(r"src/.*\.(h|cpp)$", path):
            for name in types_of(path):
                places[name].add(path)
    for name, paths in sorted(places.items()):
        if len(paths) > 1:
            yield "%s: %s" % (name, ", ".join(sorted(paths)))

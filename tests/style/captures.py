# SPDX-FileCopyrightText: 2026 The Jalon authors
# SPDX-License-Identifier: Apache-2.0
"""Names of a structured binding are not captured as such: Clang before 16 refuses what GCC takes."""

import re

from source import read, without_comments

BINDING = re.compile(r"\bauto\s*(?:const\s*)?&{0,2}\s*\[([\w\s,]+)\]")
LAMBDA = re.compile(r"\[([&=][^\[\]]*)\]\s*(?:\(([^()]*(?:\([^()]*\)[^()]*)*)\))?[^(){};]*\{")
MACRO = re.compile(r"\b(?:CAPTURE|INFO)\(([^;]*)\);")  # doctest makes a lambda of these
PAIRS = {"{": "}", "(": ")"}


def closing(text, start):
    """Where the bracket that opens at start is closed."""
    opened, depth = text[start], 0
    for i in range(start, len(text)):
        depth += (text[i] == opened) - (text[i] == PAIRS[opened])
        if depth == 0:
            return i
    return len(text)


def end_of_statement(text, start):
    """The end of a statement: the block of its last loop or branch, or the semicolon outside all brackets."""
    i = start
    while i < len(text) and text[i] != ";":
        if text[i] in PAIRS:
            is_block = text[i] == "{" and (i == start or text[start - 1:i].rstrip().endswith(")"))
            i = closing(text, i)
            if is_block:
                break
        i += 1
    return i


def scope_of(text, at):
    """From the declaration at this place to the end of where its names are seen."""
    depth, head = 0, None
    for i in range(at, -1, -1):  # within the brackets of a for, or of an if with an initialiser?
        depth += (text[i] == ")") - (text[i] == "(")
        if depth < 0:
            head = i
            break
        if text[i] in "{}":
            break
    if head is not None:
        body = closing(text, head) + 1
        return text[at:end_of_statement(text, body)]
    depth = 0
    for i in range(at, len(text)):
        depth += (text[i] == "{") - (text[i] == "}")
        if depth < 0:
            return text[at:i]
    return text[at:]


def captured_bindings(files):
    for path in files:
        if not path.endswith((".cpp", ".h")) or not path.startswith(("src/", "tests/")):
            continue
        text = without_comments(read(path))
        for declared in BINDING.finditer(text):
            names = re.findall(r"\w+", declared.group(1))
            scope = scope_of(text, declared.start())
            for found in MACRO.finditer(scope):
                for name in names:
                    if re.search(r"(?<![\w.>:])%s\b" % name, found.group(1)):
                        yield "%s: %s captures %s of auto [%s]" % (path, found.group(0), name, ", ".join(names))
            for found in LAMBDA.finditer(scope):
                own = found.group(1) + "," + (found.group(2) or "")
                body = scope[found.end() - 1:closing(scope, found.end() - 1)]
                for name in names:
                    used = re.search(r"(?<![\w.>:])%s\b" % name, body)
                    if used and not re.search(r"\b%s\b" % name, own):
                        yield "%s: a lambda captures %s of auto [%s]" % (path, name, ", ".join(names))

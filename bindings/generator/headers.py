# SPDX-FileCopyrightText: 2026 The Jalon authors
# SPDX-License-Identifier: Apache-2.0
"""What the public headers say: functions with their comments, nouns (opaque handles), structs and constants."""

import os
import re

ROOT = os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__))))
FOLDER = os.path.join(ROOT, "include", "jalon")


def read(path):
    with open(os.path.join(ROOT, path), encoding="utf-8", errors="replace") as f:
        return f.read()


# What a reader of C must not take for code: comments and literals.
TOKENS = re.compile(r'R"([^(\s]*)\(.*?\)\1"|//[^\n]*|/\*.*?\*/|"(?:\\.|[^"\\\n])*"|\'(?:\\.|[^\'\\\n])+\'', re.S)


def without_comments(text, keep_strings=False):
    """C or C++ with comments (and string contents) blanked; line numbers stay."""
    def blank(match):
        token = match.group(0)
        if token.startswith("/"):
            return re.sub(r"[^\n]", " ", token)
        if keep_strings or token.startswith("'"):
            return token
        return '"' + re.sub(r"[^\n]", " ", token[1:-1]) + '"'
    return TOKENS.sub(blank, text)


def header_names():
    return sorted(n for n in os.listdir(FOLDER) if n.endswith(".h"))


def plain(comment):
    """The text of a /** comment */ without its stars, paragraphs kept."""
    lines = [re.sub(r"^\s*\* ?", "", line).rstrip() for line in comment.strip().split("\n")]
    text = "\n".join(lines).strip()
    return re.sub(r"^@file \S+\n", "", text)


class Header:
    """One header: its comment, the comment of each of its functions."""

    def __init__(self, name):
        self.name = name
        self.text = text = read("include/jalon/" + name)
        about = re.search(r"/\*\*\s*\n \* @file.*?\*/", text, re.S)
        self.doc = plain(about.group(0)[3:-2]) if about else ""
        self.docs = {}
        pattern = r"(?:/\*\*((?:(?!\*/).)*)\*/\s*)?JALON_API\s+(?:JALON_CHECK\s+)?[\w\s]+?[\s*]+(jalon_\w+)\s*\("
        for match in re.finditer(pattern, text, re.S):
            self.docs[match.group(2)] = plain(match.group(1) or "")


class Parameter:
    def __init__(self, text):
        text = " ".join(text.split())
        array = re.match(r"(.*?)(\w+)\[(\d+)\]$", text)
        match = array or re.match(r"(.*?)(\w+)$", text)
        self.type = re.sub(r"\s*\*\s*", "*", match.group(1).strip())
        self.name = match.group(2)
        self.extent = int(array.group(3)) if array else 0
        if array:
            self.type += "*"


class Function:
    def __init__(self, header, result, name, parameters):
        self.header, self.result, self.name = header, result, name
        self.parameters = [Parameter(p) for p in parameters.split(",") if p.strip() != "void"]


def public_functions():
    """Every JALON_API function, in the order of the headers (by name of the header)."""
    functions = []
    for header in header_names():
        text = without_comments(read("include/jalon/" + header))
        text = re.sub(r"^\s*#[^\n]*(\\\n[^\n]*)*", "", text, flags=re.M)
        for match in re.finditer(r"JALON_API\s+(?:JALON_CHECK\s+)?([\w\s]+?[\s*]+)(jalon_\w+)\s*\(([^)]*)\)\s*;", text):
            functions.append(Function(header, " ".join(match.group(1).split()), match.group(2), match.group(3)))
    return functions


def nouns():
    """Opaque handles, the longest names first: ["jalon_model_evaluation", ...]."""
    found = set()
    for name in header_names():
        found |= set(re.findall(r"typedef struct (jalon_\w+) \1;", read("include/jalon/" + name)))
    return sorted(found, key=lambda n: (-len(n), n))


def structs():
    """Public structs by name: [(type, field, extent or 0, comment)]."""
    found = {}
    for name in header_names():
        for match in re.finditer(r"typedef struct (jalon_\w+) \{(.*?)\} \1;", read("include/jalon/" + name), re.S):
            fields = []
            for token in re.findall(r"/\*.*?\*/|[^;/]+;", match.group(2), re.S):
                if token.startswith("/*"):
                    if fields:  # the comment behind the field before
                        fields[-1] = fields[-1][:3] + (" ".join(token.strip("/*<").split()),)
                    continue
                parts = re.match(r"\s*(.+?[\s*])(\w+(?:, *\w+)*)(?:\[(\d+)\])?;$", " ".join(token.split()))
                for field in parts.group(2).split(","):
                    fields.append((parts.group(1).replace(" *", "*").strip(), field.strip(), int(parts.group(3) or 0), ""))
            found[match.group(1)] = fields
    return found


def constants():
    """[(name without JALON_, value, comment, group)] of enums and plain numeric macros; group: running number of the enum."""
    found, group = [], 0
    for name in header_names():
        text = read("include/jalon/" + name)
        for match in re.finditer(r"(?:/\*\*((?:(?!\*/).)*)\*/\s*)?\benum \{(.*?)\};", text, re.S):
            group += 1
            for item in re.finditer(r"JALON_(\w+)\s*=\s*(-?\d+),?(?:\s*/\*\*<(.*?)\*/)?", match.group(2), re.S):
                found.append((item.group(1), int(item.group(2)), " ".join((item.group(3) or "").split()), group))
        group += 1
        for item in re.finditer(r"#define JALON_(\w+)[\s\\]+(\d+|UINT64_MAX)\b[^\n]*?(?:/\*\*<(.*?)\*/)?\n", text):
            value = 2 ** 64 - 1 if item.group(2) == "UINT64_MAX" else int(item.group(2))
            if not item.group(1).startswith("VERSION"):
                found.append((item.group(1), value, (item.group(3) or "").strip(), group))
    return found

# SPDX-FileCopyrightText: 2026 The Jalon authors
# SPDX-License-Identifier: Apache-2.0
"""What the checks share: the files of the tree, C without comments, the public functions, and the tally."""

import os
import re
import subprocess
import sys

ROOT = os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__))))


class Tally:
    """Named behaviours, one line each, and the closing count that tests/run.sh adds up."""

    def __init__(self):
        self.passed = self.failed = self.skipped = 0

    def check(self, name, problems):
        """Passes when problems (lines of text) is empty; shows the first twenty otherwise."""
        problems = list(problems)
        if not problems:
            self.passed += 1
            print("ok - " + name)
            return
        self.failed += 1
        print("not ok - %s (%d)" % (name, len(problems)))
        for line in problems[:20]:
            print("    " + line)

    def skip(self, name, why):
        self.skipped += 1
        print("skipped - %s: %s" % (name, why))

    def close(self):
        print("%d passed, %d failed, %d skipped" % (self.passed, self.failed, self.skipped))
        sys.exit(1 if self.failed else 0)


def tree_files():
    """Paths (relative to the root) of the files that git tracks or would track; without git, all but build folders."""
    try:
        out = subprocess.run(["git", "-C", ROOT, "ls-files", "-zco", "--exclude-standard"], check=True,
                             capture_output=True, text=True).stdout
        files = out.split("\0")[:-1]
    except (OSError, subprocess.CalledProcessError):
        files = []
        for folder, folders, names in os.walk(ROOT):
            folders[:] = [f for f in folders if f not in (".git", "build", "out", ".venv", "__pycache__")]
            files += [os.path.relpath(os.path.join(folder, n), ROOT) for n in names]
    return sorted(f for f in files if os.path.isfile(os.path.join(ROOT, f)))


def read(path):
    with open(os.path.join(ROOT, path), encoding="utf-8", errors="replace") as f:
        return f.read()


_TOKENS = re.compile(r'R"([^(\s]*)\(.*?\)\1"|//[^\n]*|/\*.*?\*/|"(?:\\.|[^"\\\n])*"|\'(?:\\.|[^\'\\\n])+\'', re.S)


def without_comments(text, keep_strings=False):
    """C or C++ with comments (and string contents) blanked; line numbers stay."""
    def blank(match):
        token = match.group(0)
        if token.startswith("/"):
            return re.sub(r"[^\n]", " ", token)
        if keep_strings or token.startswith("'"):
            return token
        return '"' + re.sub(r"[^\n]", " ", token[1:-1]) + '"'
    return _TOKENS.sub(blank, text)


def strings_of(text):
    """(line number, literal) of every string literal."""
    for match in _TOKENS.finditer(text):
        token = match.group(0)
        if token[0] in '"R':
            yield text.count("\n", 0, match.start()) + 1, token


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
    folder = os.path.join(ROOT, "include", "jalon")
    for header in sorted(os.listdir(folder)):
        text = without_comments(read("include/jalon/" + header))
        text = re.sub(r"^\s*#[^\n]*(\\\n[^\n]*)*", "", text, flags=re.M)
        for match in re.finditer(r"JALON_API\s+(?:JALON_CHECK\s+)?([\w\s]+?[\s*]+)(jalon_\w+)\s*\(([^)]*)\)\s*;", text):
            functions.append(Function(header, " ".join(match.group(1).split()), match.group(2), match.group(3)))
    return functions

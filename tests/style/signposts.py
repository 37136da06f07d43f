# SPDX-FileCopyrightText: 2026 The Jalon authors
# SPDX-License-Identifier: Apache-2.0
"""What points a reader somewhere and can be checked: jalon.h names all headers, comments cite what a reader can find."""

import os
import re

from source import ROOT, read


def umbrella():
    """jalon.h includes every public header, and its comment names every noun that has a method to choose."""
    text = read("include/jalon/jalon.h")
    for header in sorted(os.listdir(os.path.join(ROOT, "include", "jalon"))):
        if header != "jalon.h" and "#include <jalon/%s>" % header not in text:
            yield "jalon.h does not include %s" % header
        for noun in re.findall(r"\bjalon_(\w+)_create\(const char\* method,", read("include/jalon/" + header)):
            if not re.search(r"\b%s\b" % noun, text[:text.index("*/\n#ifndef")]):
                yield "the comment of jalon.h forgets the %s" % noun


def cycled_handles():
    """Each kind of handle is made and given back over and over by the test of what handles keep, and no other is."""
    headers = "\n".join(read("include/jalon/" + h) for h in sorted(os.listdir(os.path.join(ROOT, "include", "jalon"))))
    kinds = set(re.findall(r"\bvoid (jalon_\w+)_release\(", headers))
    cycled = set(re.findall(r'\{"(jalon_\w+)", \w+_cycle\}', read("tests/reliability/handles_test.c")))
    for kind in sorted(kinds ^ cycled):
        yield "%s is %s" % (kind, "in no cycle of tests/reliability/handles_test.c" if kind in kinds else "no kind of handle")


# Notes that only some of us ever had, and the numbers of their steps, tables and scenes: a comment names author, year and
# section of the source, or the plain reason.
NOTES = r"(?:facade|feature|plane|joint)-(?:modelling|segmentation|codes|extraction|registration)\b" \
        r"|\bdistances-and-change\b|\boctree-and-applications\b|\bapi-abi-bindings\b|\bpeers-measured\b"
LABELS = r"\banchor [A-Z]\d|\b(?:spec|notes|[Ss]pecification)\)?,? [A-Z]\d|\b[A-Z]{1,2}\d+b? of the (?:notes|spec)|[(/ ]A\d{1,2}(?:-A?\d+)?[):;,.]"
PAPER = re.compile(r"\bpaper\b|\bupright\b|largest usual scale|\"A\d")  # sheets of paper are called A3 too


def citations(files):
    """Comments of code and pages that cite a document that is not in the repository."""
    for path in files:
        if not path.startswith(("src/", "include/", "tests/", "bindings/", "examples/")) or path == "tests/style/signposts.py":
            continue
        if not path.endswith((".h", ".cpp", ".c", ".i", ".py", ".sh", ".cmake", ".java", ".cs", ".md", ".txt")):
            continue
        for number, line in enumerate(read(path).splitlines(), 1):
            comment = re.search(r"//.*|^\s*/?\*.*|^\s*#.*", line) or (re.search(".*", line) if path.endswith(".md") else None)
            labelled = comment and re.search(LABELS, comment.group(0)) and not PAPER.search(line)
            if re.search(NOTES, line) or labelled:
                yield "%s:%d: %s" % (path, number, line.strip()[:90])

# SPDX-FileCopyrightText: 2026 The Jalon authors
# SPDX-License-Identifier: Apache-2.0
"""The page of the Python binding taken apart: its sentences, its blocks of code, its tables; and which tests say which sentence."""

import os
import re

ROOT = os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "..", "..")
PATH = os.path.join(ROOT, "bindings", "python", "README.md")
said = {}  # {sentence: test}


def says(*sentences):
    """Marks a test that fails when one of these sentences of the page is not true."""
    def mark(test):
        said.update((" ".join(sentence.split()), test.__qualname__) for sentence in sentences)
        return test
    return mark


def text():
    with open(PATH, encoding="utf-8") as file:
        return file.read()


def sentences():
    """What the page claims: its prose, without headings, code and tables, and without the lines that only lead to code."""
    prose = re.sub(r"^(#| {4}|\|).*$", "", text(), flags=re.M)
    found = []
    for paragraph in re.split(r"\n\s*\n|^- ", prose, flags=re.M):
        whole = " ".join(paragraph.split())
        found += re.split(r"(?<=\.)\s+(?=[A-Z`])", whole) if whole else []
    return found


def blocks():
    """The indented blocks of code."""
    return [re.sub(r"^ {4}", "", block, flags=re.M).strip("\n") for block in re.findall(r"(?:^ {4}.*\n|^\n(?= {4}))+", text(), re.M)]


def table():
    """[(class, built-in or "")] of the table of exceptions, a pair of each class and its own built-in."""
    rows = []
    for line in re.findall(r"^\| (`.*) \|$", text(), re.M):
        names, also = (re.findall(r"`(\w+)`", cell) for cell in line.split("|")[:2])
        rows += [(name, also[min(i, len(also) - 1)] if also else "") for i, name in enumerate(names)]
    return rows

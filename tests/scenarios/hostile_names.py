# SPDX-FileCopyrightText: 2026 The Jalon authors
# SPDX-License-Identifier: Apache-2.0
"""Names that mean something to what reads our files: no table, page, picture, drawing or model of the command line changes its
structure by them, and a file is written where it was asked for. Other programs' parsers judge: those of Python.
Usage: hostile_names.py JALON"""

import csv
import json
import math
import os
import re
import subprocess
import sys
import tempfile
from html.parser import HTMLParser
from xml.etree import ElementTree

JALON = os.path.realpath(sys.argv[1])

# Script for pages and pictures, formulas for spreadsheets, groups and layers for drawings, quotes for JSON, paths, bytes that
# control a terminal, texts that look like numbers or like nothing.
NAMES = [
    "<script>alert(1)</script>", "</script><script>alert(1)//", "<img src=x onerror=alert(1)>", "\"><svg onload=alert(1)>", "</text></svg>",
    "<!--", "-->", "]]>", "<![CDATA[", "&lt;script&gt;", "&amp;", "&#60;b&#62;", "<?xml?>", "</style>", "</title>", "javascript:alert(1)",
    "=1+1", "=HYPERLINK(\"http://x\")", "+cmd|'/C calc'!A0", "-2+3+cmd|' /C calc'!A0", "@SUM(1+9)", "=\"a\"", "'=1", "\"quoted\"", "a\"b\"c", "'", "\"",
    "`id`", "$(id)", "${x}", "%s%n", "{0}", "\\\"", "\\u0000", "\\", "a\\nEOF", "EOF", "SECTION", "0", "*Model_Space", "A|B", "<>/\\:*?=",
    "../../etc/passwd", "/etc/passwd", "..", "C:\\x", "nul", "\x01\x1b[31m", "\x7f", "\u202eabc", "\u00e9\u4e2d", "\U0001f600", "x" * 300,
    "null", "true", "NaN", "1e400", "__proto__", "constructor",
]
PLAIN = "abc"
passed = failed = 0


def judge(name, test):
    global passed, failed
    try:
        test()
        passed += 1
        print("ok -", name)
    except Exception as trouble:
        failed += 1
        print("not ok - %s: %s" % (name, str(trouble)[:300]))


def run(*arguments):
    done = subprocess.run([JALON, *arguments], capture_output=True, timeout=300)
    assert done.returncode == 0, done.stderr.decode(errors="replace")
    return done.stdout


def is_number(text):
    try:
        float(text)
        return True
    except ValueError:
        return False


def same_table(path, plain):
    """As many cells in as many lines, and none that a spreadsheet computes."""
    rows, others = (list(csv.reader(open(p, newline="", encoding="utf-8"), strict=True)) for p in (path, plain))
    assert [len(r) for r in rows] == [len(r) for r in others], "cells"
    for cell in (c for r in rows for c in r):
        assert cell[:1] not in ("=", "+", "-", "@", "\t", "\r") or is_number(cell), "a formula: %r" % cell


class Tags(HTMLParser):
    """The elements of a page with the names of their attributes: what a name must not add to."""

    def __init__(self, path):
        super().__init__()
        self.seen = []
        self.feed(open(path, encoding="utf-8").read())
        self.close()

    def handle_starttag(self, tag, attributes):
        self.seen.append((tag, sorted(a for a, _ in attributes)))

    def handle_endtag(self, tag):
        self.seen.append(("/", tag))

    def handle_comment(self, data):
        self.seen.append(("!", len(data) > 0))


def same_elements(seen, plain):
    """The same, one after another; of the labels of drawings, for which there is room or not, the same kinds."""
    is_label = lambda e: e[0].endswith("text") or e == ("/", "text")
    assert [e for e in seen if not is_label(e)] == [e for e in plain if not is_label(e)], "elements"
    unknown = [e for e in seen if is_label(e) and e not in plain]
    assert not unknown, "labels of other kinds: %s" % unknown[:3]


def same_page(path, plain):
    same_elements(Tags(path).seen, Tags(plain).seen)


def same_picture(path, plain):
    shape = lambda p: [(e.tag, sorted(e.attrib)) for e in ElementTree.parse(p).iter()]
    same_elements(shape(path), shape(plain))


def shape_of(value):
    if isinstance(value, dict):
        return {name: shape_of(member) for name, member in value.items()}
    return [shape_of(v) for v in value] if isinstance(value, list) else type(value).__name__


def same_json(path, plain):
    a, b = (shape_of(json.load(open(p, encoding="utf-8"))) for p in (path, plain))
    assert a == b, "members"


def same_drawing(path, plain):
    """Pairs of a code and a value (DXF): the same codes, one end."""
    codes = []
    for p in (path, plain):
        lines = open(p, encoding="ascii").read().splitlines()
        assert len(lines) % 2 == 0 and lines[1::2].count("EOF") == 1 and lines[-1] == "EOF", "pairs"
        codes.append([int(c) for c in lines[0::2]])
    assert codes[0] == codes[1], "groups"


JUDGES = {".csv": same_table, ".html": same_page, ".svg": same_picture, ".json": same_json, ".geojson": same_json, ".dxf": same_drawing}


def same_files(folder, plain):
    assert sorted(os.listdir(folder)) == sorted(os.listdir(plain)), "files"
    for name in sorted(os.listdir(folder)):
        if how := JUDGES.get(os.path.splitext(name)[1]):
            how(os.path.join(folder, name), os.path.join(plain, name))


def without_separators(name):
    return re.sub(r"[;,\s]", "_", name)


def network(names, folder):
    """A survey whose points have these names, each sighted twice."""
    with open(folder + ".txt", "w", encoding="utf-8") as out:
        out.write("from;to;direction;zenith;distance;code\n")
        for start, north in (("A", 0), ("B", 50)):
            out.write("%s;%s;%d;100;50;\n" % (start, "BA"[north > 0], 200 if north else 0))
            for k, name in enumerate(names):
                east, up = 20 + k, 10 + 7 * k - north
                out.write("%s;%s;%.5f;100;%.4f;350\n" % (start, name, math.atan2(east, up) * 200 / math.pi % 400, math.hypot(east, up)))
    run("network", folder + ".txt", "--points", "nails.txt", "-o", folder, "--quiet")


def code(names, folder):
    """A list of codes in which these are the surveyed points of a window and points of a code that nobody knows."""
    with open(folder + ".txt", "w", encoding="utf-8") as out:
        for k, name in enumerate(names):
            out.write("%s;%s;360\n" % (name, ["5;0;1", "9;0;3"][k % 2]) if k < 2 else "%s;0;0;%d;777\n" % (name, k))
    run("code", "sample.las", folder + ".txt", "-o", folder, "--method", "survey", "--quiet")


def unlike(kind, names):
    """Names of the same number that mean nothing: what they make is the structure to be kept."""
    return ["%s%d" % (kind, k) for k in range(len(names))]


def check_tool(tool, names):
    title = tool.__name__
    tool(unlike("n", names), title + "_plain")
    tool(names, title + "_hostile")
    for name in sorted(os.listdir(title + "_plain")):
        if how := JUDGES.get(os.path.splitext(name)[1]):
            judge("%s of %s keeps its structure" % (name, title), lambda: how(title + "_hostile/" + name, title + "_plain/" + name))
    judge("%s writes the same files" % title, lambda: same_files(title + "_hostile", title + "_plain"))


def check_file_names():
    os.mkdir("files")
    wanted = set()
    for k, name in enumerate(NAMES):
        if "/" in name or len(name.encode()) > 200 or name in (".", ".."):
            continue
        path = os.path.join("files", name + ".csv")
        run("convert", "--quiet", "few.xyz", path)
        wanted.add(name + ".csv")
    assert set(os.listdir("files")) == wanted, set(os.listdir("files")) ^ wanted


def main():
    assert len(NAMES) >= 40
    with tempfile.TemporaryDirectory() as work:
        os.chdir(work)
        open("nails.txt", "w").write("id x y z sx sy sz\nA 0 0 0 0 0 0\nB 0 50 0 0 0 0\n")
        open("few.xyz", "w").write("1 2 3\n4 5 6\n7 8 9.5\n")
        run("scan", "-o", "sample.las", "--quiet", "--set", "horizontal_step_rad=0.004", "--set", "vertical_step_rad=0.004")
        check_tool(network, list(dict.fromkeys(without_separators(n) for n in NAMES)))
        check_tool(code, [n.replace(";", "_") for n in NAMES])
        judge("%d names of files are the files' names" % len(NAMES), check_file_names)
        os.chdir("/")
    print("FIGURE hostile names: %d through tables, pages, pictures, drawings, models and as names of files" % len(NAMES))
    print("%d passed, %d failed" % (passed, failed))
    return 1 if failed else 0


sys.exit(main())

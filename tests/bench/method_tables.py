# SPDX-FileCopyrightText: 2026 The Jalon authors
# SPDX-License-Identifier: Apache-2.0
"""The table of tests/bench/METHODS.md: every method for planes with its defaults on the scenes of the literature and on scanned streets.

    python3 tests/bench/method_tables.py JALON [--data FOLDER] [--write]    # some processor minutes

JALON is the command line tool. --write renews the table of the page; else it is printed. Scenes of FOLDER (facades/street_1.txt,
street_3.txt) are left out where they are absent."""

import argparse
import json
import os
import re
import subprocess
import tempfile

PAGE = os.path.join(os.path.dirname(os.path.abspath(__file__)), "METHODS.md")
BEGIN, END = "<!-- table -->\n", "<!-- end of the table -->\n"
SAMPLE = ["--method", "sample"]
STATIC = ["--method", "static", "--set", "horizontal_step_rad=0.004", "--set", "vertical_step_rad=0.004"]
# Name, what it is, scene and how it is scanned: small clouds, 20 000 to 400 000 points.
SCENES = [
    ("S1", "posts, bands, mullions, windows", "insa", SAMPLE + ["--set", "spacing_m=0.15", "--set", "noise_m=0.0075"]),
    ("S2", "wall, window surrounds, joinery", "surrounds", SAMPLE + ["--set", "spacing_m=0.04", "--set", "noise_m=0.006"]),
    ("S3", "S2 behind trees, cars, pedestrians", "unwanted", STATIC),
    ("S5", "ten planes of mixed sizes", "std", SAMPLE + ["--set", "points=50000", "--set", "noise_m=0.0075"]),
    ("S6", "one plane", "normal", SAMPLE + ["--set", "points=100000", "--set", "noise_m=0.0025"]),
    ("S7", "six strips, each 0.1 m behind the last", "strips", SAMPLE + ["--set", "points=20000", "--set", "noise_m=0.005"]),
    ("S8", "two rectangles of one plane", "patches", SAMPLE + ["--set", "points=20000"]),
    ("S9", "two sills on a wall", "sills", SAMPLE + ["--set", "points=20000"]),
    ("S9b", "a shelf along a wall", "robbery", SAMPLE + ["--set", "points=20000"]),
    ("S11", "facade in rows of constant angles", "facade", STATIC),
    ("street", "six facades, ground, columns, boxes", "street", [o.replace("0.004", "0.008") for o in STATIC]),
]
REAL = [("street_1", "a street, scanned", "facades/street_1.txt"), ("street_3", "another", "facades/street_3.txt")]


def run(*command):
    subprocess.run(command, check=True, stdout=subprocess.DEVNULL)


def compared(jalon, scan, folder, reference, more=()):
    labels = ["--reference-labels", reference] if reference else []
    run(jalon, "segment", scan, "-o", folder, "--compare-methods", "--quiet", "--threads", "1", *labels, *more)
    with open(os.path.join(folder, "methods.json"), encoding="utf-8") as file:
        return json.load(file)


def cell(row):
    if row["unsupported"]:
        return "-"
    number = lambda value: "-" if value is None else "%.2f" % value
    sigma = "-" if row["sigma"] is None else "%.1f" % (1000 * row["sigma"])
    return "%d; %.2f; %s" % (row["planes"], row["share"], sigma) + (
        "; %s, %s" % (number(row["tdr"]), number(row["tda"])) if row["tdr"] is not None else "")


def results(jalon, data, folder):
    for name, what, scene, how in SCENES:
        scan = os.path.join(folder, name + ".ply")
        run(jalon, "scan", "--scene", scene, "-o", scan, "--quiet", *how)
        yield name, what, compared(jalon, scan, os.path.join(folder, name), "face")
    for name, what, path in REAL:
        scan = os.path.join(data, path)
        if os.path.exists(scan):
            yield name, what, compared(jalon, scan, os.path.join(folder, name), None)


def table(rows):
    methods = [row["method"] for row in rows[0][2]["methods"]]
    lines = ["| scene | points | " + " | ".join(methods) + " |", "|---" * (len(methods) + 2) + "|"]
    for name, what, result in rows:
        found = {row["method"]: row for row in result["methods"]}
        lines.append("| %s: %s | %d | " % (name, what, result["points"]) + " | ".join(cell(found[m]) for m in methods) + " |")
    return "\n".join(lines) + "\n"


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("jalon")
    parser.add_argument("--data", default="")
    parser.add_argument("--write", action="store_true")
    arguments = parser.parse_args()
    with tempfile.TemporaryDirectory() as folder:
        rows = list(results(os.path.abspath(arguments.jalon), arguments.data, folder))
    text = table(rows)
    if not arguments.write:
        print(text, end="")
        return
    with open(PAGE, encoding="utf-8") as file:
        page = file.read()
    pattern = re.escape(BEGIN) + ".*" + re.escape(END)
    page = re.sub(pattern, lambda _: BEGIN + text + END, page, flags=re.S)
    with open(PAGE, "w", encoding="utf-8") as file:
        file.write(page)


if __name__ == "__main__":
    main()

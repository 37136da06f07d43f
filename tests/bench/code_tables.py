# SPDX-FileCopyrightText: 2026 The Jalon authors
# SPDX-License-Identifier: Apache-2.0
"""The tables of tests/bench/CODES.md: classes, methods and forms of the segmentation by feature codes beside the figures of their source.

    python3 tests/bench/code_tables.py BUILD [--seeds 82-91] [--write]    # 30 processor seconds a seed

BUILD has tests/accuracy/accuracy, src/jalon and, for the second table, tests/bench/code_methods. --write renews the page; else both are printed."""

import argparse
import os
import re
import subprocess
import tempfile

PAGE = os.path.join(os.path.dirname(os.path.abspath(__file__)), "CODES.md")
CLASSES = ["rest", "walls", "doors", "windows", "gutters"]
SHOWN = CLASSES + ["mean F1"]
# F1 of the source (master's thesis, University of Liege 2021), tables 5, 7 and 10: of one complete building, which has no gutter, and of facades.
SOURCE = {("complete building", "targets"): [0.982, 0.974, 0.876, 0.794, None, 0.907], ("complete building", "survey"): [0.993, 0.990, 0.904, 0.841, None, 0.932],
          ("facades", "targets"): [0.991, 0.965, 0.770, 0.728, 0.654, 0.822], ("facades", "survey"): [0.997, 0.984, 0.879, 0.799, 0.799, 0.892]}
DENSE = " as dense as the source"
FIGURE = re.compile(r"FIGURE codes, (complete building|facades)(%s)?, seed (\d+), (survey|targets), (source|improved)[^:]*: ([^;]*);" % DENSE)
SCAN = ["--scene", "yard", "--scene-set", "zone=facades", "--method", "sample", "--set", "spacing_m=0.0115", "--set", "noise_m=0.002",
        "--set", "densities=ground=0.3,target=8,gutter=1.3"]


def figures_of(text):
    """F1 by class and the mean, by (zone, density, method, form), a list of the seeds."""
    found = {}
    for zone, density, _, method, form, figures in FIGURE.findall(text):
        row = {"mean F1": float(re.search(r"mean F1 ([\d.]+)", figures)[1])}
        for name in CLASSES:
            match = re.search(r"%s [\d.]+ [\d.]+ ([\d.]+)" % name, figures)
            if match:
                row[name] = float(match[1])
        found.setdefault((zone, density, method, form), []).append(row)
    return found


def cell(rows, name, least_of_source):
    values = [row[name] for row in rows if name in row]
    if not values:
        return "-"
    below = least_of_source is not None and min(values) < least_of_source
    return "%.3f (%.3f)%s" % (sum(values) / len(values), min(values), " *" if below else "")


def class_table(found):
    lines = ["| scene, method, form | " + " | ".join(SHOWN) + " |", "|---" * (len(SHOWN) + 1) + "|"]
    for (zone, method), figures in SOURCE.items():
        lines.append("| %s, %s: the source's own | " % (zone, method) + " | ".join("-" if f is None else "%.3f" % f for f in figures) + " |")
        for density in (DENSE, ""):
            for form in ("source", "improved"):
                rows = found.get((zone, density, method, form), [])
                cells = [cell(rows, name, least) for name, least in zip(SHOWN, figures)]
                lines.append("| %s%s, %s, %s | " % (zone, density or " at an even density", method, form) + " | ".join(cells) + " |")
    return "\n".join(lines) + "\n"


def rate_table(text):
    lines = ["| method, form | M points a processor second | peak, B a point |", "|---|---|---|"]
    for method, form, rate, peak in re.findall(r"(\w+)_codes +(\w+) .*?([\d.]+) M points a processor second, peak +([\d.]+) B", text):
        lines.append("| %s, %s | %s | %s |" % (method, form, rate, peak))
    return "\n".join(lines) + "\n"


def measured(build, seeds):
    found, last = {}, int(seeds.split("-")[-1])
    for seed in range(int(seeds.split("-")[0]), last + 1):
        environment = dict(os.environ, JALON_FULL="1", JALON_YARD_SEEDS=str(seed))
        run = subprocess.run([os.path.join(build, "tests/accuracy/accuracy"), "-tc=coded_yard__both_methods*"], env=environment, capture_output=True, text=True)
        if run.returncode:
            print("seed %d: a check of the test failed" % seed)
        for key, rows in figures_of(run.stdout).items():
            found.setdefault(key, []).extend(rows)
    return found


def rates(build):
    program = os.path.join(build, "tests/bench/code_methods")
    if not os.path.exists(program):
        return None
    with tempfile.TemporaryDirectory() as folder:
        scan = os.path.join(folder, "yard.las")
        subprocess.run([os.path.join(build, "src/jalon"), "scan", *SCAN, "-o", scan, "--quiet"], check=True)
        lists = [os.path.join(folder, "yard.%s.txt" % name) for name in ("survey", "targets")]
        return subprocess.run([program, scan, *lists, "2"], check=True, capture_output=True, text=True).stdout


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("build")
    parser.add_argument("--seeds", default="42-51")
    parser.add_argument("--write", action="store_true")
    arguments = parser.parse_args()
    tables = {"classes of the seeds": class_table(measured(arguments.build, arguments.seeds))}
    if (text := rates(arguments.build)) is not None:
        tables["rates"] = rate_table(text)
    for name, table in tables.items():
        if not arguments.write:
            print(table)
            continue
        with open(PAGE, encoding="utf-8") as file:
            page = file.read()
        pattern = r"(<!-- %s[^\n]*-->\n).*?(<!-- end -->\n)" % name
        begin = "<!-- %s%s -->\n" % (name, " " + arguments.seeds if name.endswith("seeds") else "")
        page = re.sub(pattern, lambda m: begin + table + m[2], page, flags=re.S)
        with open(PAGE, "w", encoding="utf-8") as file:
            file.write(page)


if __name__ == "__main__":
    main()

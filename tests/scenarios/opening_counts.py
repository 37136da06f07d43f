# SPDX-FileCopyrightText: 2026 The Jalon authors
# SPDX-License-Identifier: Apache-2.0
"""How many openings of each class every file of `jalon facade` has: one table, and an error where two differ.

Usage: opening_counts.py FOLDER SAID, with what the tool said on its standard output.
"""

import collections
import json
import pathlib
import re
import sys

CLASSES = ["window", "door", "gateway", "shop_front", "vent", "recess", "opening"]


def count(words):
    return {c: n for c, n in collections.Counter(words).items() if c in CLASSES}


def of_said(text):
    summary = next(line for line in text.splitlines() if re.match(r"\d+ faces; ", line))
    return {c: int(n) for n, c in re.findall(r"(\d+) (\w+)", summary.split("; ")[1]) if c in CLASSES}


def of_report(report, member):
    return count(row["class"] for row in report[member])


def of_types(report):
    sums = collections.Counter()
    for row in report["opening_types"]:
        sums[row["class"]] += row["count"]
    return dict(sums)


def of_page(page):
    words = {"other opening": "opening", "shop front": "shop_front", "recesse": "recess"}
    lead = re.search(r"The model has (.*?)\.<", page).group(1)
    counts = {}
    for n, word in re.findall(r"(\d+) ([a-z ]+?)s?(?=,| and |$)", lead):
        word = words.get(word, word)
        if word in CLASSES and int(n) > 0:
            counts[word] = int(n)
    return counts


def of_drawings(drawings):
    return count(word for text in drawings for word in re.findall(r'data-class="(\w+)"', text))


def of_city(city):
    parts = {}
    for thing in city["CityObjects"].values():
        rows = list(thing["attributes"].get("groups", []))
        for geometry in thing["geometry"]:
            rows += geometry.get("semantics", {}).get("surfaces", [])
        for row in rows:
            parts[row["part"]] = row["class"]
    return count(parts.values())


def of_geojson(features):
    named = {}
    for feature in features["features"]:
        told = feature["properties"]
        if told.get("class") in CLASSES:
            named[told["name"], told["part_of"]] = told["class"]
    return count(named.values())


def of_dxf(text):
    """Parts by their layers, which carry the class, and by the application data."""
    lines = [line.strip() for line in text.splitlines()]
    pairs = list(zip(lines[::2], lines[1::2]))
    layers, data = {}, {}
    layer = part = None
    for code, value in pairs:
        if code == "0":
            layer = part = None
        elif code == "8":
            layer = value
        elif code == "1000" and value.startswith("number="):
            part = value[7:]
        elif code == "1000" and value.startswith("class=") and value[6:] in CLASSES:
            data[part] = value[6:]
            layers[part] = layer.removesuffix("-COPIED").lower()
    return count(layers.values()), count(data.values())


def of_obj(text):
    return count(re.findall(r"^#: part \d+(?: of \d+)? class (\S+)", text, re.M))


def main():
    folder = pathlib.Path(sys.argv[1])
    read = lambda name: (folder / name).read_text(encoding="utf-8")
    report = json.loads(read("report.json"))
    # Of several facades each has its own drawing.
    drawings = sorted(folder.glob("elevation_*.svg")) or [folder / "elevation.svg"]
    counts = {
        "said": of_said(pathlib.Path(sys.argv[2]).read_text(encoding="utf-8")),
        "report.json openings": of_report(report, "openings"),
        "report.json parts": of_report(report, "parts"),
        "report.json types": of_types(report),
        "report.html": of_page(read("report.html")),
        "elevation*.svg": of_drawings([path.read_text(encoding="utf-8") for path in drawings]),
        "model.city.json": of_city(json.loads(read("model.city.json"))),
        "model.geojson": of_geojson(json.loads(read("model.geojson"))),
        "model.obj": of_obj(read("model.obj")),
    }
    counts["model.dxf layers"], counts["model.dxf data"] = of_dxf(read("model.dxf"))
    for name, told in counts.items():
        print(f"{name:22}", "  ".join(f"{told.get(c, 0):4} {c}" for c in CLASSES))
    wanted = counts["said"]
    wrong = [name for name, told in counts.items() if told != wanted]
    if wrong or sum(wanted.values()) == 0:
        sys.exit(f"other counts than said: {', '.join(wrong) or 'no opening at all'}")


main()

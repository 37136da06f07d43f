# SPDX-FileCopyrightText: 2026 The Jalon authors
# SPDX-License-Identifier: Apache-2.0
"""A table by room and the least covered files of gcovr's summary: coverage_rooms.py SUMMARY.json"""

import json
import sys
from collections import defaultdict

SHOWN = 25  # files

with open(sys.argv[1], encoding="utf-8") as f:
    files = json.load(f)["files"]
KEYS = ("line_covered", "line_total", "branch_covered", "branch_total")
rooms = defaultdict(lambda: [0, 0, 0, 0])
for file in files:
    for room in (file["filename"].split("/")[1], "all"):
        for i, key in enumerate(KEYS):
            rooms[room][i] += file[key]


def percent(part, whole):
    return 100 * part / whole if whole else 100


for room, (lines, all_lines, branches, all_branches) in sorted(rooms.items()):
    print("%s%-13s %6d lines %5.1f %%, %6d branches %5.1f %%" % (
        "FIGURE coverage of " if room == "all" else "  ", room, all_lines, percent(lines, all_lines), all_branches, percent(branches, all_branches)))
print("the files with most lines that no test runs:")
for file in sorted(files, key=lambda f: f["line_covered"] - f["line_total"])[:SHOWN]:
    print("  %4d of %4d  %s" % (file["line_total"] - file["line_covered"], file["line_total"], file["filename"]))

#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The Jalon authors
# SPDX-License-Identifier: Apache-2.0
"""PTX files read by Jalon and by CloudCompare, point by point: check_cloudcompare.py BUILD_FOLDER

Drawn files of one to three scans with poses, cells without return, with and without colours. CloudCompare keeps coordinates
in floats beside a shift, so that places agree to a tenth of a millimetre. Where it is missing: skipped (77), visibly."""

import math
import os
import pathlib
import random
import shutil
import subprocess
import sys
import tempfile

SEEDS = range(1, 13)
PLACE_M = 1e-4


def rotation(draw):
    """Rows of a turn about a drawn axis, from a unit quaternion."""
    q = [draw.gauss(0, 1) for _ in range(4)]
    w, x, y, z = (value / math.hypot(*q) for value in q)
    return [[1 - 2 * (y * y + z * z), 2 * (x * y - w * z), 2 * (x * z + w * y)],
            [2 * (x * y + w * z), 1 - 2 * (x * x + z * z), 2 * (y * z - w * x)],
            [2 * (x * z - w * y), 2 * (y * z + w * x), 1 - 2 * (x * x + y * y)]]


def scan(draw, with_colours):
    """The text of a scan, and its points in the world."""
    columns, rows = draw.randint(1, 12), draw.randint(1, 9)
    turn, move = rotation(draw), [draw.uniform(-80, 80) for _ in range(3)]
    lines = ["%d" % columns, "%d" % rows, "%.6f %.6f %.6f" % tuple(move)]
    lines += ["%.9f %.9f %.9f" % tuple(turn[i][k] for i in range(3)) for k in range(3)]
    lines += ["%.9f %.9f %.9f 0" % tuple(turn[i][k] for i in range(3)) for k in range(3)]  # a row of the file is a column
    lines.append("%.6f %.6f %.6f 1" % tuple(move))
    places = []
    for _ in range(columns * rows):
        empty = bool(places) and draw.random() < 0.3
        local = [0.0] * 3 if empty else [round(draw.uniform(-30, 30), 4) for _ in range(3)]
        line = "%.4f %.4f %.4f %.3f" % (*local, 0.5 if empty else draw.random())
        lines.append(line + (" %d %d %d" % tuple(draw.randrange(256) for _ in range(3)) if with_colours else ""))
        if not empty:
            places.append(tuple(sum(turn[i][k] * local[k] for k in range(3)) + move[i] for i in range(3)))
    return lines, places


def rows_of(path):
    out = []
    for line in path.read_text().replace(",", " ").splitlines():
        try:
            out.append(tuple(float(word) for word in line.split()[:3]))
        except ValueError:  # names of columns
            continue
    return out


def by_cloudcompare(program, path):
    """The points of all scans, as CloudCompare saves them in text."""
    home = path.parent / (path.stem + "_saved")
    home.mkdir()
    shutil.copy(path, home / path.name)
    environment = dict(os.environ, QT_QPA_PLATFORM="offscreen", HOME=str(home), XDG_RUNTIME_DIR=str(home), LC_ALL="C")
    subprocess.run([program, "-SILENT", "-AUTO_SAVE", "OFF", "-C_EXPORT_FMT", "ASC", "-PREC", "8", "-SEP", "SPACE", "-NO_TIMESTAMP",
                    "-O", str(home / path.name), "-SAVE_CLOUDS"], check=True, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL,
                   env=environment, timeout=300)
    return [row for file in sorted(home.glob("*.asc")) for row in rows_of(file)]


def farthest(ours, theirs):
    """Of points in order: how far from each other at most, none where they are not as many."""
    if len(ours) != len(theirs):
        return None
    return max((max(abs(a - b) for a, b in zip(p, q)) for p, q in zip(sorted(ours), sorted(theirs))), default=0.0)


def main():
    program = shutil.which("CloudCompare") or shutil.which("cloudcompare.CloudCompare")
    if program is None:
        print("skipped: CloudCompare is missing (Debian 12: apt install cloudcompare)")
        print("0 passed, 0 failed, 1 skipped")
        return 77
    tool = os.path.join(sys.argv[1], "src", "jalon")
    passed = failed = 0
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        for seed in SEEDS:
            draw = random.Random(seed)
            lines, places = [], []
            for _ in range(draw.randint(1, 3)):
                more, at = scan(draw, seed % 2 == 1)
                lines, places = lines + more, places + at
            path, text = folder / ("drawn_%d.ptx" % seed), folder / ("jalon_%d.txt" % seed)
            path.write_text("\n".join(lines) + "\n")
            subprocess.run([tool, "convert", "--quiet", str(path), str(text)], check=True)
            ours, theirs = rows_of(text), by_cloudcompare(program, path)
            apart = [farthest(ours, places), farthest(ours, theirs)]
            good = all(far is not None and far <= PLACE_M for far in apart)
            passed, failed = passed + good, failed + (not good)
            print("%s - %d points of PTX %d: as drawn and as by CloudCompare%s" %
                  ("ok" if good else "not ok", len(ours), seed, "" if good else " (%d, %s)" % (len(theirs), apart)))
    print("%d passed, %d failed, 0 skipped" % (passed, failed))
    return 1 if failed else 0


if __name__ == "__main__":
    sys.exit(main())

#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The Jalon authors
# SPDX-License-Identifier: Apache-2.0
"""The verdict of hostile.sh: hostile_counts.py [--dear] FOLDER ..., each folder of a number of points and named so, the larger first.

An operation holds when on no cloud it takes more than 20 times the instructions that it takes on an ordinary one (the dearer of points
drawn in a cube and on the faces of a box); where the length of the answer depends on the cloud, than 20 times those for each row of it.
--dear prints the names of those that do not."""

import pathlib
import sys

MOST_TIMES = 20
ORDINARY = 2  # the first clouds: the box, the random cloud


def calls_of(folder):
    """Lines of (cloud, rows, instructions); raises where a call is missing."""
    rows = [line.split("\t") for line in (folder / "calls").read_text().splitlines()]
    counts = [int(word) for word in (folder / "counts").read_text().split()]
    code = int((folder / "code").read_text())
    if code != 0 or len(rows) != len(counts) or len(rows) <= ORDINARY:
        last = (folder / "error").read_text().strip().splitlines()[-1:]
        raise ValueError(f"exit {code}, {len(rows)} calls, {len(counts)} counts {' '.join(last)}")
    return [(cloud, max(1, int(answered)), count) for (_, cloud, _, answered), count in zip(rows, counts)]


def worst_of(folder):
    """(times, cloud, whole): the dearest beside the ordinary ones, all of it or each row of the answer, and all of it."""
    calls = calls_of(folder)
    whole = max(count for _, _, count in calls[:ORDINARY])
    row = max(count / rows for _, rows, count in calls[:ORDINARY])
    return max((min(count / whole, count / rows / row), cloud, count / whole) for cloud, rows, count in calls[ORDINARY:])


def name_of(folder):
    return folder.name.replace("_", " ")


def folders_in(folder):
    return sorted(path for path in folder.iterdir() if path.is_dir()) if folder.is_dir() else []


def dear_in(folder):
    for operation in folders_in(folder):
        try:
            if worst_of(operation)[0] > MOST_TIMES:
                print(name_of(operation))
        except ValueError:
            pass  # the verdict tells of it


def verdict(folders):
    chosen = {}
    for folder in folders:
        for operation in folders_in(folder):
            chosen.setdefault(name_of(operation), operation)
    passed, failed, worst = 0, 0, (0, "", "")
    for name, operation in sorted(chosen.items()):
        points = operation.parent.name
        try:
            times, cloud, whole = worst_of(operation)
        except ValueError as error:
            print(f"not ok - hostile: {name}: {error}")
            failed += 1
            continue
        worst = max(worst, (times, name, cloud))
        good = times <= MOST_TIMES
        passed, failed = passed + good, failed + (not good)
        rows = f", by rows of the answer; as a whole {whole:.1f}" if whole > times else ""
        print(f"{'ok' if good else 'not ok'} - hostile: {name}, {points} points: {times:.1f} times an ordinary cloud ({cloud}){rows}")
    print(f"FIGURE counted work: {len(chosen)} operations on sixteen hostile clouds, at most {worst[0]:.1f} times the instructions "
          f"of an ordinary one ({worst[1]}, {worst[2]})")
    print(f"{passed} passed, {failed} failed")
    return 1 if failed or not chosen else 0


if __name__ == "__main__":
    if sys.argv[1] == "--dear":
        dear_in(pathlib.Path(sys.argv[2]))
        sys.exit(0)
    sys.exit(verdict([pathlib.Path(path) for path in sys.argv[1:]]))

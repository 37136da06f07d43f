#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The Jalon authors
# SPDX-License-Identifier: Apache-2.0
"""Times that the project promises without a peer, measured alone: promised.py BUILD.

Tests print such figures and assert none of them; here the printed lines are held against what was promised."""

import dataclasses
import os
import re
import subprocess
import sys

THIRTY = 30  # the machine of 2006 against one thread of today's: what the octree's specification asks for


@dataclasses.dataclass
class Promise:
    program: str  # in BUILD/tests
    arguments: list
    pattern: str  # of the lines that tell it, the figure as its group
    at_least: float = 0
    at_most: float = float("inf")


PROMISES = [
    Promise("bench/thesis_clouds", [], r"in all: ([\d.]+) x faster", at_least=THIRTY),
    Promise("bench/thesis_mesh", [], r"in all: ([\d.]+) x faster", at_least=THIRTY),
    Promise("bench/thesis_mesh", [], r"triangles: .* ([\d.]+) x faster", at_least=10),  # each row by itself
    Promise("bench/thesis_fields", [], r"T[67], .* ([\d.]+) x faster", at_least=THIRTY),
    Promise("capi_cancel_test", [], r"cancel latency.* p99 ([\d.]+) ms", at_most=100),  # task.h says so
    Promise("bench/georeference_jalon", [], r"with covariances: ([\d.]+) M points a second on 2 threads", at_least=5),
    Promise("bench/reading_jalon", [], r"laz of .* ([\d.]+) s on", at_most=0.7),
    Promise("bench/reading_jalon", [], r"e57 of .* ([\d.]+) s on", at_most=1.5),
    Promise("bench/reading_jalon", [], r"COPC file .* ([\d.]+) s,", at_most=0.3),
    Promise("bench/reading_jalon", [], r"COPC file .* ([\d.]+) MB", at_most=200),
    Promise("accuracy/accuracy", ["-tc=chain_street__columns*"], r"([\d.]+) x the time of planes alone", at_most=2),
]


def judged(promise, text):
    """(kept or not, line) of each line that tells the figure; one that does not come is a promise not kept."""
    out = []
    for line in text.splitlines():
        if "FIGURE" in line and (match := re.search(promise.pattern, line)):
            out.append((promise.at_least <= float(match.group(1)) <= promise.at_most, line[line.index("FIGURE"):]))
    return out or [(False, "%s does not tell %s" % (promise.program, promise.pattern))]


def main():
    build = sys.argv[1]
    said, bad = {}, 0
    for promise in PROMISES:
        command = [os.path.join(build, "tests", promise.program)] + promise.arguments
        if tuple(command) not in said:
            run = subprocess.run(command, capture_output=True, text=True)
            said[tuple(command)] = run.stdout
            if run.returncode:
                bad += 1
                print("%s ended with %d\n%s" % (promise.program, run.returncode, run.stdout[-2000:]))
        for good, line in judged(promise, said[tuple(command)]):
            bad += not good
            print("%s %s" % ("kept  " if good else "BROKEN", line), flush=True)
    print("%d promises of time are not kept" % bad)
    return 1 if bad else 0


if __name__ == "__main__":
    sys.exit(main())

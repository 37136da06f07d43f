#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The Jalon authors
# SPDX-License-Identifier: Apache-2.0
"""`jalon compare` whole, all its files written: compare_whole.py BUILD [STEP_RAD [THREADS [SEED]]].

The street's two epochs in LAS, with all that the scanner tells of a point: by the clock, in processor seconds, the peak
of the process in bytes a point of both, what was found, and beside it what copying the files that it wrote takes here:
two thirds of a gigabyte for 5 million points. Steps: 0.003 rad for 2.4 + 2.4 million points, 0.00146 for 10 + 10."""

import json
import os
import pathlib
import resource
import shutil
import subprocess
import sys
import tempfile
import time

from facade_whole import measured

LIMIT_B = 120  # a point of both epochs


def copying_s(folder, to):
    start = time.monotonic()
    shutil.copytree(folder, to)
    return time.monotonic() - start


def main():
    build = pathlib.Path(sys.argv[1]).resolve()
    step = sys.argv[2] if len(sys.argv) > 2 else "0.003"
    threads = sys.argv[3] if len(sys.argv) > 3 else "2"
    seed = int(sys.argv[4]) if len(sys.argv) > 4 else 1
    jalon = str(build / "src/jalon")
    with tempfile.TemporaryDirectory() as work:
        os.chdir(work)
        scans = []
        for epoch in (1, 2):
            scans.append(f"epoch{epoch}.las")
            command = [jalon, "scan", "--scene", "street", "--scene-set", f"epoch={epoch}", "--set", f"seed={2 * seed + epoch}",
                       "--set", f"horizontal_step_rad={step}", "--set", f"vertical_step_rad={step}", "-o", scans[-1], "-q"]
            subprocess.run(command, check=True)
        scanning_kib = resource.getrusage(resource.RUSAGE_CHILDREN).ru_maxrss
        wall, cpu, out = measured([jalon, "compare", *scans, "-o", "out", "--json", "--threads", threads])
        peak_kib = resource.getrusage(resource.RUSAGE_CHILDREN).ru_maxrss
        copying = copying_s("out", "copy")
        told = json.loads(out)
    points = told["summary"]["points"] + told["reverse_summary"]["points"]
    peak = peak_kib * 1024 / points
    assert peak_kib > scanning_kib, "a peak is that of all children so far, and the scanner took more"
    found = ", ".join(f"{change['class']} {change['confidence']:.2f}" for change in told["changes"])
    times = told["times"]
    print(f"FIGURE compare whole, {points} points, {threads} threads: {wall:.2f} s, {cpu:.2f} processor seconds (reading "
          f"{times['read']:.2f} s, comparing {times['compare']:.2f}, changes {times['changes']:.2f}, writing "
          f"{wall - sum(times.values()):.2f}; copying its files {copying:.2f}), {peak:.0f} B a point at the peak (limit {LIMIT_B})")
    print(f"found {len(told['changes'])}: {found}")
    return 1 if peak > LIMIT_B else 0


if __name__ == "__main__":
    sys.exit(main())

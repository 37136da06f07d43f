#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The Jalon authors
# SPDX-License-Identifier: Apache-2.0
"""`jalon facade` whole, all its files written: facade_whole.py BUILD [POINTS [THREADS [ARGUMENT ...]]].

Times by the clock and in processor seconds, and the peak of the process in bytes a point, of the street in LAS without
and with time and colour (point formats 0 and 3) and of the sample. Arguments go to `jalon facade`."""

import json
import os
import pathlib
import resource
import subprocess
import sys
import tempfile
import time

LIMIT_B = 130  # a point, at the peak, from so many points on: below, the program itself counts
FROM_POINTS = 5_000_000


def measured(command):
    """(seconds by the clock, processor seconds, output) of a command, whose peak lies in RUSAGE_CHILDREN of this process."""
    before, start = resource.getrusage(resource.RUSAGE_CHILDREN), time.monotonic()
    out = subprocess.run(command, check=True, capture_output=True, text=True).stdout
    after = resource.getrusage(resource.RUSAGE_CHILDREN)
    return time.monotonic() - start, after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime, out


def tell(name, scan, folder, jalon, threads, arguments):
    """One line for a scan, in a process of its own: a peak is that of all children so far."""
    reader, writer = os.pipe()
    if os.fork() == 0:
        wall, cpu, out = measured([jalon, "facade", scan, "-o", folder, "--json", "--threads", str(threads), *arguments])
        points = json.loads(out)["points"]
        peak = resource.getrusage(resource.RUSAGE_CHILDREN).ru_maxrss * 1024 / points
        bad = points >= FROM_POINTS and peak > LIMIT_B
        print(f"FIGURE facade whole, {name}, {points} points, {threads} threads: {wall:.2f} s, "
              f"{cpu:.2f} processor seconds, {peak:.0f} B a point at the peak{' (limit %d)' % LIMIT_B if bad else ''}")
        sys.stdout.flush()
        os.write(writer, b"1" if bad else b"0")
        os._exit(0)
    os.close(writer)
    os.wait()
    return os.read(reader, 1) != b"0"


def main():
    build = pathlib.Path(sys.argv[1]).resolve()
    points = sys.argv[2] if len(sys.argv) > 2 else "10000000"
    threads = int(sys.argv[3]) if len(sys.argv) > 3 else 2
    jalon, bad = str(build / "src/jalon"), 0
    with tempfile.TemporaryDirectory() as work:
        prefix = os.path.join(work, "street")
        subprocess.run([str(build / "tests/bench/street_scene"), prefix, points], check=True, capture_output=True)
        os.remove(prefix + ".f64")
        subprocess.run([jalon, "scan", "--scene", "facade", "-o", prefix + "_sample.las", "-q"], check=True)
        for name, scan in (("street", "_pf0"), ("street with time and colour", "_pf3"), ("sample", "_sample")):
            bad += tell(name, prefix + scan + ".las", os.path.join(work, "out" + scan), jalon, threads, sys.argv[4:])
    return 1 if bad else 0


if __name__ == "__main__":
    sys.exit(main())

#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The Jalon authors
# SPDX-License-Identifier: Apache-2.0
"""`jalon adjust` whole, all its files written, beside the time that the drive took: drive_whole.py BUILD [PULSES [THREADS]].

The L-shaped street driven in 53 s by a plane scanner of 300 kHz (pulses a revolution at 100 revolutions a second; 3000: 16 million
pulses), the positions half a metre unsure. One pass over the file and one over its points; rays for one point a cube of 0.2 m that
looks like a wall's, in a few passes (printed). Monnier (2014) needed three times the acquisition."""

import json
import os
import pathlib
import sys
import tempfile

from facade_whole import measured

REVOLUTIONS = 100  # a second


def main():
    jalon = str(pathlib.Path(sys.argv[1]).resolve() / "src/jalon")
    pulses = int(sys.argv[2]) if len(sys.argv) > 2 else 3000
    threads = sys.argv[3] if len(sys.argv) > 3 else "2"
    with tempfile.TemporaryDirectory() as work:
        drive, model, trajectory = (os.path.join(work, n) for n in ("drive.las", "street.obj", "drive.txt"))
        measured([jalon, "scan", "--method", "mobile", "-o", drive, "--model", model, "--trajectory", trajectory,
                  "--set", f"pulses={pulses}", "--set", f"revolutions_per_s={REVOLUTIONS}", "--set", "noise_range_m=0.005",
                  "--scene-set", "sigma_position_m=0.5", "-q"])
        with open(trajectory, encoding="utf-8") as f:
            times = [float(line.split()[0]) for line in f if line[:1].isdigit()]
        wall, cpu, out = measured([jalon, "adjust", model, drive, trajectory, "-o", os.path.join(work, "out"), "--strips-set", "touch_m=2",
                                   "--json", "--threads", threads])
        result, lasted = json.loads(out), times[-1] - times[0]
        print(f"FIGURE drive whole: {pulses * REVOLUTIONS * lasted / 1e6:.1f} M pulses in {lasted:.0f} s, adjusted in {wall:.1f} s "
              f"({wall / lasted:.2f} of the drive), {cpu:.1f} processor seconds on {threads} threads, "
              f"{result['summary']['points']} rays a pass, {result['summary']['passes']} passes")
        return 0 if wall < lasted else 1


if __name__ == "__main__":
    sys.exit(main())

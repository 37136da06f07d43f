#!/usr/bin/env bash
# SPDX-FileCopyrightText: 2026 The Jalon authors
# SPDX-License-Identifier: Apache-2.0
# Sets up, builds and runs the main job on the bundled sample: a facade, scanned virtually, to planes, a model, a drawing and
# a report. Usage: bash examples/run.sh [SCAN] - a scan of your own instead of the sample.
set -euo pipefail
root=$(cd "$(dirname "$0")/.." && pwd)
. "$root/examples/packages.sh"
need_packages "${build_packages[@]}"

build=$root/build/example
[ -f "$build/build.ninja" ] ||
  cmake -S "$root" -B "$build" -G Ninja -DCMAKE_BUILD_TYPE=Release -DJALON_BUILD_EXAMPLES=ON >/dev/null
# How far the build is: a moving count on a terminal, a line every tenth elsewhere; what the compiler says, in any case.
show_build() {
  local terminal=0
  [ ! -t 1 ] || terminal=1
  NINJA_STATUS='@%f/%t@' ninja -C "$build" | awk -v terminal=$terminal '
    /^@[0-9]+\/[0-9]+@/ {
      split(substr($0, 2), n, /[\/@]/)
      if (terminal) printf "\rbuilding: %d of %d files", n[1], n[2]
      else if (int(10 * n[1] / n[2]) > tenth) { tenth = int(10 * n[1] / n[2]); print "building: " n[1] " of " n[2] " files" }
      fflush(); seen = 1; next
    }
    /^ninja: (no work to do|Entering directory)/ { next }
    { print }
    END { if (seen && terminal) print "" }'
}
echo "building: the first time takes about $((16 / $(nproc) + 1)) minutes on the $(nproc) processors of this machine"
show_build

out=$root/out
mkdir -p "$out"
scan=${1:-}
if [ -z "$scan" ]; then
  scan=$out/sample.las
  [ -f "$scan" ] || "$build/src/jalon" scan --scene facade -o "$scan"
fi
"$build/src/jalon" facade "$scan" -o "$out/facade"
echo
echo "Ten lines of C, on the same scan:"
"$build/examples/example_01_planes" "$scan"
echo
echo "Look at:"
echo "  $out/facade/report.html     the report: open it in a browser"
echo "  $out/facade/elevation.svg   the drawing, to scale"
echo "  $out/facade/model.*         the model with its openings, for CAD, GIS and 3D tools"
echo "  $out/facade/segments.las    the points with their plane, residual and orientation class"

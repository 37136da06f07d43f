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
echo "building (the first time takes a few minutes) ..."
ninja -C "$build" --quiet

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

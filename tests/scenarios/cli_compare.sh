#!/usr/bin/env bash
# SPDX-FileCopyrightText: 2026 The Jalon authors
# SPDX-License-Identifier: Apache-2.0
# All that "jalon compare" makes besides distances and changes, and a slide. Usage: cli_compare.sh JALON
set -uo pipefail
jalon=$(realpath "$1")
here=$(realpath "$(dirname "$0")")
. "$(dirname "$0")/cli_judges.sh"
step="--set horizontal_step_rad=0.006 --set vertical_step_rad=0.006 --quiet"

# Days of earthworks: a heap comes on day 2, a pit on day 3, when the excavator stands there, a wall goes on day 4.
# shellcheck disable=SC2086
for day in 1 3 4; do
  judge "scan of day $day" "$jalon" scan --scene earthworks --scene-set day=$day --set seed=$day --station 30,1,2.4 $step -o day$day.las
done

judge "compare makes volumes, closest points and depth maps" "$jalon" compare day1.las day3.las -o all --json --quiet \
  --volumes --volume-set cell_m=1 --volume-set direction=0,0,2 --closest --depth-maps --third day4.las
for file in volumes.csv closest.las closest.ply depth_reference_1.png depth_reference_1.tif depth_compared_1.png depth_compared_1.tif; do
  judge "it made $file" test -s all/$file
done
judge "the result tells of them" python3 -c '
import json
d = json.load(open("all/comparison.json"))
v = d["volumes"]
assert v["parameters"]["direction"] == [0, 0, 2] and v["cell"] == 1, v
assert abs(v["fill"] - v["cut"] - v["net"]) < 1e-6 and v["sigma"] > 0, v
assert 100 < d["closest_points"] <= d["reverse_summary"]["points"]
assert d["depth_maps"] == ["depth_%s_1%s" % (side, end) for side in ("reference", "compared") for end in (".png", ".tif")]
t = d["third_epoch"]
assert t["hidden"] == d["summary"]["hidden"] >= t["probably_unchanged"] + t["changed_meanwhile"] > 0, t
assert len(open("all/volumes.csv").readlines()) > v["cells"]'

# The fields of a LAS file are read when its points are written; another format's come with the points.
judge "LAS as PLY" "$jalon" convert day1.las day1.ply --quiet
judge "compare reads fields later" "$jalon" compare day1.las day3.las -o later --json --quiet
judge "compare reads fields at once" "$jalon" compare day1.ply day3.las -o once --json --quiet
judge "the points compared are the same with their fields" cmp later/compared.ply once/compared.ply
judge "so are those of the reference" python3 -c '
fields = lambda name: sorted(l for l in open(name + "/reference.ply", "rb").read().split(b"end_header")[0].split(b"\n") if l.startswith(b"property"))
later, once = fields("later"), fields("once")
assert later == once and any(b"face" in f for f in later) and any(b"evidence" in f for f in later), (later, once)'

judge "LAS as text, which takes long to read" "$jalon" convert day1.las day1.xyz --quiet
judge "a file that is cut, replaced or removed meanwhile is told, and nothing written" python3 "$here/changed_meanwhile.py" "$jalon" day1.xyz day3.las day1.las

judge "files written beside others are whole or not there" python3 "$here/written_beside.py" "$jalon" day1.las day3.las

# A box of both scans, and one of their own.
judge "compare reads a box of all scans" "$jalon" compare day1.las day3.las -o boxed --box=-100,-100,-10,30,100,50 --json --quiet
judge "compare reads a box of one scan" "$jalon" compare day1.las day3.las -o half --compared-box=-100,-100,-10,30,100,50 --json --quiet
judge "only the points of the box are compared" python3 -c '
import json
read = lambda name: json.load(open(name + "/comparison.json"))
points = lambda name: (read(name)["summary"]["points"], read(name)["reverse_summary"]["points"])
boxed, half, whole = points("boxed"), points("half"), points("all")
assert boxed[0] == half[0] < whole[0], (boxed, half, whole)
assert boxed[1] < half[1] == whole[1], (boxed, half, whole)'

# What is done with distances, one after the other; --then says as --params and the result do.
judge "compare runs what is done with distances one after the other" "$jalon" compare day1.las day3.las -o then --one-way --json --quiet \
  --set detection=false --set max_distance_m=5 \
  --then classes --then "noise_law law=weibull" --then "chi_square error_margin=0.01 neighbours=25" --then "histogram bins=20" \
  --then normality --then "gradient radius_m=1.5" --then "field_filter method=median" --then "field_arithmetic operation=square" \
  --then "propagation cell_m=0.5 minimum_seed=0.5" --then "geodesic seeds=0,7 cell_m=1" --then "distance_map cell_m=1"
judge "the result has each with its parameters and tables" python3 -c '
import json
then = json.load(open("then/comparison.json"))["then"]
assert [t["operation"] for t in then] == ["classes", "noise_law", "chi_square", "histogram", "normality", "gradient", "field_filter",
    "field_arithmetic", "propagation", "geodesic", "distance_map"]
by = {t["operation"]: t for t in then}
assert by["classes"]["summary"]["low_cut"] > 0 and by["classes"]["summary"]["count_1"] > 0
assert by["noise_law"]["law"]["law"] == "weibull" and by["noise_law"]["law"]["scale"] > 0
assert by["chi_square"]["parameters"]["neighbours"] == 25 and by["chi_square"]["summary"]["changed"] > 0
assert len(by["histogram"]["bins"]) == 20 and "expected" in by["histogram"]["bins"][0]
assert by["propagation"]["regions"] and by["normality"]["summary"]["is_normal"] == 0'
judge "compared.ply has their fields" python3 -c '
head = open("then/compared.ply", "rb").read(8000).split(b"end_header")[0].decode()
for field in "class chi_square gradient filtered computed geodesic map_distance".split():
    assert " " + field + "\n" in head, (field, head)'

# A slide: what went, what came, what was not measured.
judge "compare by landslide" "$jalon" compare day1.las day3.las -o slide --method landslide --set cell_m=1 --set min_points=4 \
  --set outline="3,3,0, 57,3,0, 57,36,0, 3,36,0" --json --quiet
judge "it tells zones, volumes and what was not measured" python3 -c '
import csv, json
d = json.load(open("slide/comparison.json"))
s = d["summary"]
assert s["depletion"] > 0 and s["depletion_sigma"] > 0 and abs(s["net"] - s["accumulation"] + s["depletion"]) < 1e-6
all_m2 = s["measured_area"] + s["unmeasured_reference"] + s["unmeasured_compared"] + s["unmeasured_both"]
assert abs(all_m2 - 54 * 33) < 60, all_m2
assert abs(s["unmeasured_share"] - 1 + s["measured_area"] / all_m2) < 1e-9 and s["unmeasured_hidden"] > 0
assert d["regions"] and all(r["volume_sigma"] > 0 and r["open_boundary"] <= r["boundary"] for r in d["regions"])
assert [float(r["volume"]) for r in csv.DictReader(open("slide/regions.csv"))] == [r["volume"] for r in d["regions"]]
features = json.load(open("slide/regions.geojson"))["features"]
classes = {f["properties"].get("class") for f in features}
assert "unmeasured" in classes and classes & {"depletion", "accumulation"}, classes'
judge "its report and drawing say so" bash -c "grep -q 'What was not measured' slide/report.html && grep -q 'outline: rose' slide/distances.svg && grep -q UNMEASURED slide/regions.dxf"
says 'not measured: .* of the area' compare day1.las day3.las -o slide --method landslide --set cell_m=1

# Wrong ones, told before the work.
ends 2 'there are: classes' compare day1.las day3.las -o no --then fourier
ends 2 'no parameter "radius"' compare day1.las day3.las -o no --then "gradient radius=1"
ends 2 'noise_law before it' compare day1.las day3.las -o no --then chi_square
ends 2 'direction takes numbers' compare day1.las day3.las -o no --volumes --volume-set direction=up
ends 6 'method distance' compare day1.las day3.las -o no --method m3c2 --closest
ends 2 'it needs x, y, z' compare day1.las day3.las -o no --method landslide --set direction=0,1
judge "what was refused left nothing" test ! -e no
judge "a file of the M3C2 plug-in sets its parameters" bash -c "printf 'M3C2VER=1\nNormalScale=4\nSearchScale=3\nSearchDepth=5\nSubsampleRadius=2\n' >m3c2.txt && '$jalon' compare day1.las day3.las -o plugin --method m3c2 --m3c2-file m3c2.txt --json --quiet | python3 -c 'import json,sys; p = json.load(sys.stdin)[\"parameters\"]; assert p[\"normal_radius_m\"] == 2 and p[\"cylinder_radius_m\"] == 1.5, p'"
echo "$passed passed, $failed failed"
[ $failed -eq 0 ]

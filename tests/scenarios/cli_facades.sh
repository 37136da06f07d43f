#!/usr/bin/env bash
# SPDX-FileCopyrightText: 2026 The Jalon authors
# SPDX-License-Identifier: Apache-2.0
# What the command line makes of facades beyond their drawing. Usage: cli_facades.sh JALON
set -uo pipefail
jalon=$(realpath "$1")
here=$(cd "$(dirname "$0")" && pwd)
. "$here/cli_judges.sh"

judge "a facade is scanned" "$jalon" scan --scene arches -o arches.las --quiet --set horizontal_step_rad=0.003 --set vertical_step_rad=0.003

# Relations of a model's parts, faces and solids.
says 'relations.csv' facade arches.las -o parts --relations parts
judge "eight windows are contained in their walls" python3 -c '
import csv
rows = list(csv.DictReader(open("parts/relations.csv")))
assert sum(r["relation"] == "6" and [r["matrix_%d" % k] for k in range(9)] == "-1 -1 1 1 2 2 -1 -1 2".split() for r in rows) >= 8, rows
assert all(float(r["distance"]) <= 0.5 for r in rows)'
says 'relations.csv' model arches.las -o faces --relations faces
judge "faces meet" grep -q ',2,1,-1,1,-1,-1,2,1,2,3,' faces/relations.csv
says 'relations.csv' model arches.las -o solids --method extrusion --relations solids
ends 5 'no solids' model arches.las -o none --method outlines --relations solids
ends 2 'parts' model arches.las -o none --relations roofs

# Openings by class: as many in every file as the tool says, of walls drawn by their contours and by their evidence.
judge "a facade with doors is scanned" "$jalon" scan --scene grammar -o grammar.las --quiet --set seed=12 --set spacing_m=0.04
for way in evidence=false evidence=true; do
  judge "facade --model-set $way" bash -c '"$0" facade grammar.las -o counted --model-set "$1" >said.txt' "$jalon" "$way"
  judge "every file counts the same openings, $way" python3 "$here/opening_counts.py" counted said.txt
  judge "doors and windows have layers in DXF, $way" bash -c 'grep -qx DOOR counted/model.dxf && grep -qx WINDOW counted/model.dxf'
  rm -rf counted
done

# Picks: a segment each, from a seed, from corners that bound it, and of other shapes.
says 'segments.las' segment arches.las -o picked --pick 0.3,0,0.3
judge "a seed grows one plane" python3 -c '
import json
d = json.load(open("picked/segments.json"))
assert d["method"] == "pick" and len(d["segments"]) == 1 and d["segments"][0]["inliers"] > 1000, d["segments"]
assert abs(d["segments"][0]["normal"][1]) > 0.999, d["segments"]'
says 'segments.las' segment arches.las -o bounded --pick '0.2,0,0.2; 0.8,0,0.2; 0.8,0,0.8; 0.2,0,0.8' --pick-set min_points=10
judge "corners bound their plane" python3 -c '
import json
s = json.load(open("bounded/segments.json"))["segments"]
assert len(s) == 1 and s[0]["length_u"] < 0.7 and s[0]["length_v"] < 0.7, s'
ends 2 'X,Y,Z' segment arches.las -o none --pick 1,2
ends 2 '--pick-set' segment arches.las -o none --pick-set min_points=5
ends 2 'no --tolerance' segment arches.las -o none --pick 1,2,3 --tolerance 0.02
ends 5 'pick 90,90,90' segment arches.las -o none --pick 90,90,90

# The curve of edge lengths.
says 'the curve turns at' segment arches.las -o curve --edge-curve 1
judge "edge lengths rise, contour points stand beside them" python3 -c '
import csv
l = [float(r["length"]) for r in csv.DictReader(open("curve/edge_lengths.csv"))]
assert len(l) > 1000 and l == sorted(l)
assert len(list(csv.DictReader(open("curve/contour_points.csv")))) > 100'
ends 3 'label 99' segment arches.las -o none --edge-curve 99
ends 2 '--edge-curve' segment arches.las -o none --edge-threshold 0.3

# Cuts by a polygon, in plan and in a plane.
printf '0 0\n1 0\n1 1\n0 1\n' >square.txt
python3 - <<'END'
with open("cube.xyz", "w") as f:
    for i in range(21):
        for j in range(21):
            for k in range(21):
                f.write("%.2f %.2f %.2f\n" % (0.1 * i + 0.05, 0.1 * j + 0.05, 0.1 * k + 0.05))
END
says '2 100 of 9 261 points' cut cube.xyz -o plan.xyz --polygon-file square.txt
says '1 000 of 9 261 points' cut cube.xyz -o low.xyz --polygon '0,0; 1,0; 1,1; 0,1' --to 1
says '7 161 of 9 261 points' cut cube.xyz -o rest.xyz --polygon-file square.txt --outside
# In the plane y = 0, before it (towards -y) and behind it.
says '2 100 of 9 261 points' cut cube.xyz -o front.xyz --polygon '0,0,0; 1,0,0; 1,0,1; 0,0,1'
says '500 of 9 261 points' cut cube.xyz -o skin.xyz --polygon '0,0,0; 1,0,0; 1,0,1; 0,0,1' --from -0.5
ends 5 'no point lies in' cut cube.xyz -o none.xyz --polygon '0,0,0; 1,0,0; 1,0,1; 0,0,1' --from 0
ends 5 'no point lies in' cut cube.xyz -o none.xyz --polygon '9,9; 10,9; 10,10'
ends 2 'one line' cut cube.xyz -o none.xyz --polygon '0,0,0; 1,0,0; 2,0,0'
ends 2 'needs 3' cut cube.xyz -o none.xyz --polygon '0,0; 1,0'
ends 2 'two numbers' cut cube.xyz -o none.xyz --polygon '0,0; 1,0,3; 2,0'
ends 2 'no number' cut cube.xyz -o none.xyz --polygon '0,0; 1,x; 2,0'
ends 2 'polygon-file' cut cube.xyz -o none.xyz

# Sections at heights and along an alignment, of a hall 8 x 5 m, 3 m high.
python3 - <<'END'
with open("hall.xyz", "w") as f:
    for i in range(401):
        for k in range(61):
            for x, y in ((0.02 * i, 0), (0.02 * i, 5), (0, 0.0125 * i), (8, 0.0125 * i)):
                f.write("%.4f %.4f %.4f\n" % (x, y, 0.05 * k))
END
printf '# along the hall\n-1 2.5\n9 2.5 7\n' >axis.txt
says 'Z 2.000: 1 line, 26.00 m' sections hall.xyz --unit m -o plans --heights 1,2 --set thickness_m=0.06
judge "a section is a polyline on a layer of its name" bash -c '[ "$(grep -c LWPOLYLINE plans/sections.dxf)" = 2 ] && grep -q ^Z_2.000 plans/sections.dxf'
judge "the drawing tells heights and scale" bash -c 'grep -q "Z 2.000" plans/sections.svg && grep -q "scale 1 : " plans/sections.svg'
says 'STATION 5.000: 2 lines, 6.00 m' sections hall.xyz --unit m -o cross --alignment axis.txt --stations 5
says 'D 4.000: 2 lines' sections hall.xyz -o along --direction 1,0,0 --heights 4
ends 5 'no line in any section' sections hall.xyz -o none --heights 9
ends 2 'no numbers' sections hall.xyz -o none --heights 1,x
ends 2 'no --heights' sections hall.xyz -o none --heights 1 --alignment axis.txt
ends 2 'the alignment has 0 to 10 m' sections hall.xyz -o none --alignment axis.txt --stations 11
ends 2 'above --to' cut cube.xyz -o none.xyz --polygon-file square.txt --from 2 --to 1
ends 3 'nowhere.txt' cut cube.xyz -o none.xyz --polygon-file nowhere.txt

# A scan as noisy as those from vehicles: the tool tells the tolerance it takes, finds every opening, and takes what is set.
judge "a noisy facade is scanned" "$jalon" scan --scene facade -o noisy.las --quiet --set max_points=100000 --set range_noise_m=0.02
says '1 wall, 19 window, 2 door' facade noisy.las -o noisy
says 'noise of 1[5-9] mm: planes were found with a tolerance of [45][0-9] mm instead of 25; --tolerance sets it' facade noisy.las -o noisy
lacks 'noise of' segment noisy.las -o noisy_set --tolerance 0.06
says 'noise of' segment noisy.las -o noisy_all --compare-methods
lacks 'noise of' facade grammar.las -o quiet

# What is no facade gets a line of advice, a status and no files.
judge "a bent wall is scanned" "$jalon" scan --scene bow -o bow.las --quiet --set horizontal_step_rad=0.004 --set vertical_step_rad=0.004
judge "a room is scanned" "$jalon" scan --scene room -o room.las --quiet --set horizontal_step_rad=0.01 --set vertical_step_rad=0.01
judge "open land is scanned, with a box on it" "$jalon" scan --scene box --method sample -o land.las --quiet --set points=60000
ends 5 'room.las: .*seen from inside is no facade; nothing is written' facade room.las -o none
judge "turned, and without its station, it is a room all the same" bash -c "'$jalon' scan --scene room --scene-set rotation_rad=0.6 -o turned.xyz --quiet --set horizontal_step_rad=0.01 --set vertical_step_rad=0.01"
ends 5 'turned.xyz: .*seen from inside' facade turned.xyz -o none
ends 5 'land.las: .* on upright surfaces, so this is no facade .*nothing is written' facade land.las -o none
says 'faces' model room.las -o room_outlines --method outlines
# A bent wall is one cylinder, and a line says so.
says 'bent walls \(radius 6\.00.*cylinders' facade bow.las -o bow --unit m
judge "the bent wall is one surface of its radius" bash -c "'$jalon' facade bow.las -o bow --json 2>/dev/null | python3 -c '
import json, sys
d = json.load(sys.stdin)
wide = [p for p in d[\"planes\"] if p[\"area_m2\"] > 20]
assert len(d[\"planes\"]) <= 3 and len(wide) == 2, d[\"planes\"]'"
ends 5 'on upright surfaces, so this is no facade' facade bow.las -o none --segment-set primitives=planes

# One name a stage in all commands; --set means the stage that a command is about, as ever.
for option in --segment-set --set; do
  judge "facade takes $option for the planes" bash -c "'$jalon' facade arches.las -o few --json $option max_planes=2 | python3 -c 'import json,sys; assert len(json.load(sys.stdin)[\"planes\"]) == 2'"
  judge "segment takes $option" bash -c "'$jalon' segment arches.las -o few --json $option max_planes=2 | python3 -c 'import json,sys; assert len(json.load(sys.stdin)[\"segments\"]) == 2'"
done
for option in --model-set --set; do
  judge "model takes $option for the model" bash -c "'$jalon' model arches.las -o few --json $option solids=true | python3 -c 'import json,sys; assert json.load(sys.stdin)[\"parameters\"][\"solids\"] is True'"
done
judge "model takes --segment-set for the planes" bash -c "'$jalon' model arches.las -o few --json --method outlines --segment-set max_planes=1 | python3 -c 'import json,sys; assert json.load(sys.stdin)[\"model\"][\"faces\"] == 1'"
ends 2 'segment-set max_planes=many: max_planes takes a number' facade arches.las -o none --segment-set max_planes=many
ends 2 '^jalon: --set max_planes=many: max_planes takes a number' facade arches.las -o none --set max_planes=many
ends 2 'no parameter "max_planes"' model arches.las -o none --set max_planes=2
for command in facade model; do
  ends 2 'scale' $command arches.las -o none --drawing-set scale=-1
done

echo "$passed passed, $failed failed"
[ $failed -eq 0 ]

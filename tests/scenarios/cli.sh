#!/usr/bin/env bash
# SPDX-FileCopyrightText: 2026 The Jalon authors
# SPDX-License-Identifier: Apache-2.0
# The command line tool as a user meets it. Usage: cli.sh JALON
set -uo pipefail
jalon=$(realpath "$1")
root=$(cd "$(dirname "$0")/../.." && pwd)
data=$root/../shared/data
work=$(mktemp -d)
trap 'umount "$work/small" 2>/dev/null; rm -rf "$work"' EXIT
cd "$work" || exit 1
passed=0 failed=0 skipped=0
check() { # check NAME COMMAND ...
  local name=$1
  shift
  if "$@" >log 2>&1; then echo "ok - $name" && passed=$((passed + 1)); else
    echo "not ok - $name" && failed=$((failed + 1)) && tail -n 5 log
  fi
}
# refuses NAME CODE PATTERN COMMAND ...: ends with this exit code and exactly one line on standard error that matches.
refuses() {
  local name=$1 code=$2 pattern=$3 got
  shift 3
  "$@" >out 2>err
  got=$?
  if [ $got -eq "$code" ] && [ "$(wc -l <err)" -eq 1 ] && grep -qE "$pattern" err && [ ! -s out ]; then
    echo "ok - $name" && passed=$((passed + 1))
  else
    echo "not ok - $name (exit $got, wanted $code): $(head -n 3 err)" && failed=$((failed + 1))
  fi
}

check "--help shows examples and exit codes" bash -c "'$jalon' --help | grep -q 'jalon facade scan.las' && '$jalon' --help | grep -q 'Exit codes'"
for command in info convert formats clean normals facade model scan segment evaluate-segmentation evaluate-model compare clearance adjust code network; do
  check "$command --help shows an example" bash -c "'$jalon' $command --help | grep -q 'jalon $command'"
done
check "--version tells the release" bash -c "'$jalon' --version | grep -qE '^jalon [0-9]+\.[0-9]+\.[0-9]+$'"

step_rad=0.003
[ -z "${JALON_SANITIZED:-}" ] || step_rad=0.006 # a point costs ten times as much
check "scan makes a sample" "$jalon" scan --scene facade -o sample.las --set horizontal_step_rad=$step_rad --set vertical_step_rad=$step_rad
check "scan samples a scene and tells its true planes" bash -c "'$jalon' scan --scene sills --method sample --set points=6060 -o sills.ply --json | python3 -c 'import json,sys; d=json.load(sys.stdin); assert d[\"points\"]==6060 and d[\"true_planes\"]==3, d'"
check "scan of the grammar brings its scanner and writes the truth beside the cloud" bash -c "
'$jalon' scan --scene grammar --set seed=7 --scene-set kind=shops --scene-set spacing_m=0.05 -o shops.las --json | python3 -c '
import json,sys; d=json.load(sys.stdin); assert d[\"truth\"]==\"shops.truth.json\" and d[\"points\"]>5000, d
t=json.load(open(d[\"truth\"])); assert t[\"kind\"]==\"shops\" and t[\"seed\"]==7, t[\"kind\"]
assert any(o[\"class\"]==\"shop_front\" and o[\"area_seen_share\"]>0.5 for o in t[\"openings\"])'"
check "scan of the grammar takes a seed of the scene and stations of the user" bash -c "
'$jalon' scan --scene grammar --set seed=7 --scene-set seed=8 --set horizontal_step_rad=0.01 --set vertical_step_rad=0.01 --station 5,-9,1.7 \
  -o one.las --quiet && python3 -c '
import json; t=json.load(open(\"one.truth.json\")); assert t[\"seed\"]==8, t[\"seed\"]
assert any(o[\"area_seen_share\"]>0.5 for o in t[\"openings\"])'"
check "--help has the parameters of every method" bash -c "
for pair in segment:ransac segment:region_growing compare:distance compare:m3c2 compare:preview compare:landslide register:icp register:targets \
            register:coarse register:automatic model:outlines model:facade model:cell_decomposition model:extrusion model:region_growing scan:static; do
  '$jalon' \${pair%:*} --help | grep -q \"^Parameters of .* \${pair#*:}:\" || { echo \$pair; exit 1; }
done"
check "scan --help lists scenes and both methods" bash -c "'$jalon' scan --help | grep -q 'insa_surveyed' && '$jalon' scan --help | grep -q 'method sample'"
check "--quiet is silent" bash -c "[ -z \"\$('$jalon' scan --scene facade -o quiet.las --quiet --set horizontal_step_rad=0.005 --set vertical_step_rad=0.005 2>&1)\" ]"
check "info tells points and box" bash -c "'$jalon' info sample.las | grep -q '^points' && '$jalon' info sample.las | grep -q '^max'"
check "info --json is JSON" bash -c "'$jalon' info sample.las --json | python3 -c 'import json,sys; d=json.load(sys.stdin); assert d[\"points\"]>50000, d'"
check "formats lists extensions and abilities" bash -c "'$jalon' formats | grep -qE '^PCD +\.pcd +read write +-$' && '$jalon' formats --json | python3 -c 'import json,sys; f={x[\"name\"]: x for x in json.load(sys.stdin)[\"formats\"]}; assert f[\"PTX\"][\"clouds\"]==[\"read\"] and f[\"DXF\"][\"models\"]==[\"read\",\"write\"] and f[\"IFC\"][\"models\"]==f[\"GeoPackage\"][\"models\"]==[\"write\"], f'"
check "convert LAS to PLY" "$jalon" convert sample.las sample.ply
check "convert PLY to XYZ" "$jalon" convert quiet.las quiet.xyz
check "convert XYZ to LAS keeps the points" bash -c "'$jalon' convert quiet.xyz back.las --quiet && [ \$('$jalon' info back.las --json | python3 -c 'import json,sys; print(json.load(sys.stdin)[\"points\"])') -eq \$('$jalon' info quiet.las --json | python3 -c 'import json,sys; print(json.load(sys.stdin)[\"points\"])') ]"
check "convert writes EPT, whose definition alone reads it" bash -c "'$jalon' convert quiet.las quiet.csv --quiet && '$jalon' convert quiet.csv tiles/ept.json --quiet && python3 '$root/tests/formats/check_ept.py' tiles/ept.json quiet.csv && '$jalon' info tiles/ept.json --spacing 1e9 --json | grep -q points"
refuses "an EPT data set of another name" 2 'folder/ept.json' "$jalon" convert quiet.las tiles.ept.json
has_codecs=$("$jalon" formats | grep -c '^LAZ .*read write')
if [ "$has_codecs" -ne 0 ]; then
  check "convert writes COPC, and reads a box of it as of LAS" bash -c "'$jalon' convert quiet.las quiet.copc.laz --quiet && box=\$('$jalon' info quiet.las --json | python3 -c 'import json,sys; d=json.load(sys.stdin); a,b=d[\"min\"],d[\"max\"]; print(\",\".join(map(repr, a+[(x+y)/2 for x,y in zip(a,b)])))') && '$jalon' convert --box=\$box quiet.las part.las --json | grep points >n && '$jalon' convert --box=\$box quiet.copc.laz part.ply --json | grep points | cmp - n"
  check "info of COPC by levels has fewer points" bash -c "'$jalon' info --spacing 1e9 quiet.copc.laz --json | grep -q points"
else
  echo "skipped: COPC was not built" && skipped=$((skipped + 1))
fi
check "convert keeps at most so many points, and the fields that are named" bash -c "'$jalon' convert quiet.las few.ply --max-points 1000 --fields 'intensity' --quiet && '$jalon' info few.ply --json | python3 -c 'import json,sys; d=json.load(sys.stdin); assert d[\"points\"] == 1000 and [f[\"name\"] for f in d[\"fields\"]] == [\"intensity\"], d'"
check "info of one station alone" bash -c "'$jalon' info quiet.las --only-station 1 --json | python3 -c 'import json,sys; d=json.load(sys.stdin); assert len(d[\"stations\"]) == 1 and d[\"stations\"][0][\"points\"] == d[\"points\"], d'"
refuses "a field that the scan lacks" 3 'no field "colour"; there are: ' "$jalon" info --fields colour quiet.las
refuses "a box of three numbers" 2 'box' "$jalon" info --box 1,2,3 quiet.las
refuses "levels of a file that has none" 6 'COPC' "$jalon" info --spacing 0.1 quiet.las
check "convert joins scans, and PCD keeps them" bash -c "'$jalon' convert quiet.las quiet.xyz quiet.las both.pcd --json | python3 -c 'import json,sys; d=json.load(sys.stdin); assert len(d[\"inputs\"])==3, d; print(d[\"points\"])' >n && '$jalon' convert both.pcd again.ply --json | grep -q \"\$(cat n)\""
refuses "several models for one" 2 'several models' bash -c "printf 'v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n' >m.obj; exec '$jalon' convert m.obj m.obj m.stl"
check "convert takes models" bash -c "'$jalon' convert m.obj m.stl && '$jalon' convert m.stl m.dxf --quiet && '$jalon' convert m.obj m.ply --quiet && grep -q 'element face' -a m.ply && test -s m.dxf"
"$jalon" scan --method mobile -o drive.ply --model street.obj --trajectory drive.txt --quiet --scene-set sigma_position_m=1 --scene-set leg_m=60
check "adjust locates a drive that is a metre off" bash -c "'$jalon' adjust street.obj drive.ply drive.txt -o adjusted --strips-set touch_m=2 --json | python3 -c '
import csv,json,sys
d=json.load(sys.stdin)
assert d[\"summary\"][\"converged\"]==1 and d[\"summary\"][\"matched\"]>0.9*d[\"summary\"][\"points\"], d
rows=list(csv.DictReader(open(\"adjusted/controls.csv\")))
assert all(float(r[\"sigma_0\"])<0.5*float(r[\"prior_sigma_0\"]) for r in rows)'"
for file in report.html trajectory.txt cloud.las cloud.ply model.obj model.city.json adjustment.json strips.csv matches.csv; do check "adjust made $file" test -s adjusted/$file; done
check "scan makes a scenario with its truth, whose blocks adjust brings home" bash -c "'$jalon' scan --method mobile -o off.las --model off.city.json --trajectory off.txt --scenario 2 --scene-set leg_m=60 --quiet && '$jalon' adjust off.city.json off.las off.txt -o home --truth off.true.txt --set sigma_block_x_m=2 --set sigma_block_y_m=2 --set sigma_facade_m=0.01 --set sigma_strip_m=0.01 --quiet && python3 -c '
import json
def walls(path):
  m = json.load(open(path)); s, t = m[\"transform\"][\"scale\"], m[\"transform\"][\"translate\"]; made = {}
  for o in m[\"CityObjects\"].values():
    for g in o.get(\"geometry\", []):
      for k, ring in enumerate(g[\"boundaries\"]):
        a = g[\"semantics\"][\"surfaces\"][g[\"semantics\"][\"values\"][k]]
        if a[\"type\"] == \"WallSurface\": made[a[\"name\"]] = [m[\"vertices\"][ring[0][0]][i] * s[i] + t[i] for i in (0, 1)]
  return made
true, given, found = walls(\"off.true.city.json\"), walls(\"off.city.json\"), walls(\"home/model.city.json\")
off = lambda m: sum(sum((m[n][i] - true[n][i]) ** 2 for i in (0, 1)) for n in true) ** 0.5
assert len(true) > 100 and true.keys() == given.keys() == found.keys(), len(true)
assert off(found) < 0.4 * off(given), (off(given), off(found))'"
refuses "a scenario without a drive" 2 'method mobile' "$jalon" scan -o none.las --scenario 2
refuses "a scenario without errors" 2 'has errors' "$jalon" scan --method mobile -o none.las --trajectory none.txt --scenario 2 --drift-seed 0
refuses "a scenario that is told another scanner" 2 'no --set' "$jalon" scan --method mobile -o none.las --trajectory none.txt --scenario 2 --set pulses=100
check "adjust tells of a drive with a gap" bash -c "awk 'NR < 3 || \$1 < 5 || \$1 > 10' drive.txt >gap.txt && '$jalon' adjust street.obj drive.ply gap.txt -o gapped --json 2>&1 >/dev/null | grep -q 'no epochs for 5.0. s from 4.99 s on'"
check "adjust tells that hardly a point is on a wall of a model in feet" bash -c "awk '\$1 == \"v\" { print \"v\", \$2 / 0.3048, \$3 / 0.3048, \$4 / 0.3048; next } 1' street.obj >feet.obj && '$jalon' adjust feet.obj drive.ply drive.txt -o footed --json 2>&1 >/dev/null | grep -q 'in one unit and coordinate system'"
check "adjust writes CityJSON whose walls tell what moved them, and keeps their numbers when it is read again" bash -c "'$jalon' adjust adjusted/model.city.json drive.ply drive.txt -o adjusted2 --quiet && python3 -c '
import csv,json
def walls(folder):
  file=json.load(open(folder+\"/model.city.json\"))
  at=[[s*k+t for s,k,t in zip(file[\"transform\"][\"scale\"],v,file[\"transform\"][\"translate\"])] for v in file[\"vertices\"]]
  made={}
  for id,o in file[\"CityObjects\"].items():
    for g in o[\"geometry\"]:
      sem=g[\"semantics\"]
      for b,v in zip(g[\"boundaries\"],sem[\"values\"]):
        w=sem[\"surfaces\"][v]
        if \"strip\" in w: made[w[\"strip\"]]=(id,w,[at[i] for i in b[0]],o[\"attributes\"])
  return made
one,two=walls(\"adjusted\"),walls(\"adjusted2\")
for folder,of in ((\"adjusted\",one),(\"adjusted2\",two)):
  rows=list(csv.DictReader(open(folder+\"/strips.csv\")))
  blocks=list(csv.DictReader(open(folder+\"/blocks.csv\")))
  assert len(rows)==len(of), (len(rows),len(of))
  for i,r in enumerate(rows):
    id,w,ring,building=of[i]
    assert w[\"type\"]==\"WallSurface\" and w[\"strip_matches\"]==int(r[\"points\"]) and abs(w[\"strip_offset_m\"]-float(r[\"offset\"]))<1e-9 and abs(w[\"strip_sigma_m\"]-float(r[\"sigma\"]))<1e-9 and w[\"strip_prior_sigma_m\"]==0.3, (w,r)
    assert abs(building[\"block_offset_east_m\"]-float(blocks[w[\"block\"]][\"offset_0\"]))<1e-9
for k,(id,w,ring,b) in one.items():
  id2,w2,ring2,b2=two[k]
  assert id==id2 and w[\"facade\"]==w2[\"facade\"] and w[\"block\"]==w2[\"block\"] and len(ring)==len(ring2), (w,w2)
  # The same wall, moved by what the second run says of it: upright, so its heights stay.
  assert max(abs(p[2]-q[2]) for p,q in zip(ring,ring2))<3e-4, (ring,ring2)
  e,n=(b2[\"block_offset_east_m\"],b2[\"block_offset_north_m\"]); f=abs(w2[\"facade_offset_m\"]+w2[\"strip_offset_m\"])
  assert all(abs(((q[0]-p[0]-e)**2+(q[1]-p[1]-n)**2)**.5-f)<1e-3 for p,q in zip(ring,ring2)), (ring,ring2,w2,b2)'"
check "clean removes and thins" "$jalon" clean sample.las -o clean.ply --outliers --voxel 0.05
check "normals writes normals" bash -c "'$jalon' normals quiet.las -o normals.ply --set orientation=centroid && head -c 2000 normals.ply | grep -aq 'property float nx'"
check "facade writes its files" "$jalon" facade sample.las -o result
for file in report.html report.json elevation.svg orthoimage.png model.obj segments.las segments.ply; do check "facade made $file" test -s result/$file; done
check "facade leaves what it names and no private folder" bash -c "'$jalon' facade sample.las -o named --json | python3 -c '
import json,os,sys
d=json.load(sys.stdin)
assert sorted(os.listdir(\"named\"))==sorted(d[\"files\"]), d[\"files\"]'"
check "facade shows its orthoimage in the drawing and the report" bash -c "grep -q '^orthoimage.png' result/model.dxf && [ \$(wc -l <result/orthoimage.pgw) -eq 6 ] && grep -q '>Orthoimage<' result/report.html"
check "facade and convert write GeoPackages" bash -c "'$jalon' convert result/model.city.json house.gpkg --quiet && test -s result/model.gpkg && [ \"\$(head -c 15 house.gpkg)\" = 'SQLite format 3' ]"
files=$(ls -A result | wc -l)
check "the report is self-contained" bash -c "! grep -qE '(src|href)=\"(https?:|//|/)' result/report.html"
# A scan whose file tells no station: through text, whose stations stand in a file beside it.
without_stations() {
  "$jalon" convert "$1" unplaced.xyz --quiet && rm -f unplaced.stations.json && "$jalon" convert unplaced.xyz "$2" --quiet
}
check "a scan loses its stations with the file beside it" without_stations sample.las unplaced.las
check "facade tells the viewing side of the walls by evidence" bash -c "'$jalon' facade unplaced.las -o sides --json | python3 -c '
import json,sys
wall=max(json.load(sys.stdin)[\"planes\"], key=lambda p: p[\"area_m2\"] if p[\"orientation\"]==\"parallel\" else 0)
assert wall[\"front_source\"]==\"evidence\" and wall[\"front_confidence\"]>0.99 and wall[\"normal\"][1]<0, wall'"
check "facade has no guess to tell where the evidence is strong" bash -c "! '$jalon' facade unplaced.las -o sides | grep -q 'is a guess'"
"$jalon" scan --scene normal -o placed.las --quiet --set horizontal_step_rad=0.01 --set vertical_step_rad=0.01
check "a bare wall loses its station too" without_stations placed.las bare.las
check "facade says in one line that the side of a bare wall is a guess" bash -c "'$jalon' facade bare.las -o bare | grep -c 'of 1 walls is a guess.*--station X,Y,Z' | grep -qx 1"
check "facade --station tells the side" bash -c "! '$jalon' facade bare.las -o bare --station 5,-10,1.7 | grep -q 'is a guess'"
check "facade --json lists the planes" bash -c "'$jalon' facade sample.las -o result --json | python3 -c 'import json,sys; d=json.load(sys.stdin); assert len(d[\"planes\"])>5 and d[\"times\"][\"segment\"]>0, d'"
check "the same seed gives the same files" bash -c "'$jalon' facade sample.las -o again --quiet --threads 1 && cmp result/model.obj again/model.obj && cmp result/segments.las again/segments.las && cmp result/segments.ply again/segments.ply"
check "a terminal sees a progress bar" bash -c "script -qec \"'$jalon' facade sample.las -o bar\" /dev/null | grep -q '%'"
check "--set reaches the segmenter" bash -c "'$jalon' facade sample.las -o few --json --set max_planes=2 | python3 -c 'import json,sys; d=json.load(sys.stdin); assert len(d[\"planes\"])==2, len(d[\"planes\"])'"
check "evaluate-model of a model against itself is perfect" bash -c "'$jalon' evaluate-model result/model.obj result/model.obj -o judged --json | python3 -c '
import json,sys
t=json.load(sys.stdin)[\"totals\"]
assert t[\"pairs\"]>5 and t[\"total_quality\"]==1 and t[\"total_branching\"]==t[\"total_miss\"]==t[\"total_failure\"]==t[\"max_distance\"]==0, t'"
for file in faces.csv vertices.csv evaluation.json; do check "evaluate-model made $file" test -s judged/$file; done
check "evaluate-model prints its table" bash -c "'$jalon' evaluate-model few/model.obj result/model.obj --set group=plane | grep -qE '^ +total .* [01][.][0-9]{3} '"
refuses "no reference to judge a model by" 3 'none.obj' "$jalon" evaluate-model result/model.obj none.obj

check "segment writes its seven files" "$jalon" segment sample.las -o segments
for file in report.html segments.svg segments.csv segments.json segments.las segments.ply primitives.txt; do check "segment made $file" test -s segments/$file; done
check "segment leaves no private folder" bash -c "[ \$(ls -A segments | wc -l) -eq 7 ]"
check "segment by another method, --json" bash -c "'$jalon' segment sample.las -o grown --method region_growing --json | python3 -c 'import json,sys; d=json.load(sys.stdin); assert len(d[\"segments\"])>5 and d[\"method\"]==\"region_growing\", d'"
printf 'id x y z sx sy sz\nA 652000 6861000 40 0 0 0\nB 652000 6861050 40 0 0 0\n' >nails.txt
printf 'from;to;direction;zenith;distance;code\nA;B;0;100;50;\nA;C;40;100;30;350\nB;C;361.81;100;31.19;350\nB;A;0;100;50;\n' >sights.txt
check "network adjusts a survey" bash -c "'$jalon' network sights.txt --points nails.txt -o survey --json --set sigma_direction_rad=1e-3 | python3 -c '
import json, sys
d = json.load(sys.stdin)
assert d[\"summary\"][\"converged\"] == 1 and d[\"points\"][2][\"id\"] == \"C\" and abs(d[\"points\"][2][\"xyz\"][0] - 652017.6) < 0.1, d'"
check "network writes its points as a table" bash -c "head -1 survey/points.csv | grep -q '^id,xyz_0,' && grep -q '^C,65201' survey/points.csv && grep -q '^C;65201.*;350$' survey/codes.txt && grep -q '^distance,5,B,A,' survey/observations.csv"
check "network draws its plan with ellipses and lists the reliability" bash -c "grep -q '95 % ellipse' survey/plan.svg && grep -q 'Reliability (Baarda)' survey/report.html"
refuses "a survey with a wrong line" 3 'observations, line 2' bash -c "printf 'from to distance\\nA B far\\n' >wrong.txt; exec '$jalon' network wrong.txt -o no"
refuses "a survey that nothing holds" 5 'nothing holds' "$jalon" network sights.txt -o no
if "$jalon" formats | grep -q '^PNG .*read write'; then
  check "a raster is written, and segmented again" bash -c "'$jalon' segment sample.las -o grown --method raster_growing --raster --raster-tif --quiet && head -c 4 grown/raster.tif | od -An -tx1 | grep -q '49 49 2a 00' && '$jalon' segment grown/raster.png -o again --method raster_growing --json --quiet | python3 -c 'import json,sys; d=json.load(sys.stdin); assert d[\"segments\"], d'"
else
  echo "skipped: depth images (libpng was not built)" && skipped=$((skipped + 1))
fi
check "segment compares all methods with the true faces" bash -c "'$jalon' segment sample.las -o methods --compare-methods --reference-labels face --json --quiet | python3 -c '
import json, sys
rows = {row[\"method\"]: row for row in json.load(sys.stdin)[\"methods\"]}
assert rows[\"ransac\"][\"planes\"] > 5 and rows[\"hough\"][\"tdr\"] > 0.5 and rows[\"scan_lines\"][\"planes\"] > 5, rows
best = max(rows.values(), key=lambda r: 2 * r[\"tdr\"] * r[\"tda\"] / (r[\"tdr\"] + r[\"tda\"]) if r[\"tdr\"] else 0)
assert all(r[\"unsupported\"] or 1e5 < r[\"memory_bytes\"] < 1e9 for r in rows.values()), rows
assert best[\"method\"] in json.load(open(\"methods/methods.json\"))[\"advice\"], best'"
check "comparing methods says that nothing is known without true faces" bash -c "'$jalon' segment sample.las -o untold --compare-methods | grep -q 'Without true segments'"
for file in methods.csv methods.json methods.html ransac.svg hough.svg; do check "comparing methods made $file" test -s methods/$file; done
refuses "comparing methods with settings of one" 2 'compare-methods' "$jalon" segment sample.las -o no --compare-methods --set min_points=30
printf '1;5;0;1;360\n2;9;0;3;360\n3;0;0;0;777\n' >codes.txt
check "code classifies the points of coded objects" bash -c "'$jalon' code sample.las codes.txt -o coded --method survey --json --quiet | python3 -c '
import json, sys
d = json.load(sys.stdin)
assert d[\"objects\"][0][\"points\"] > 100 and d[\"warnings\"][0][\"line\"] == 3 and len(d[\"steps\"]) == 3, d'"
for file in classified.las objects.csv warnings.csv codes.json model.dxf model.city.json model.geojson plan.svg report.html; do check "code made $file" test -s coded/$file; done
check "code writes objects with their codes for CAD and GIS" bash -c "grep -q 'part=window 1 (360)' coded/model.dxf && grep -q 'window 1 (360)' coded/model.geojson && grep -q 'window 1 (360)' coded/model.city.json"
check "rsvg draws the plan of codes" rsvg-convert coded/plan.svg -o plan.png
check "scan of the yard brings its code lists and classes" bash -c "'$jalon' scan --scene yard --method sample --set spacing_m=0.2 --set densities=target=64 -o yard.las --quiet && grep -q ';300.2$' yard.survey.txt && grep -q ';3$' yard.targets.txt && test -s yard.truth.json"
for method in survey targets; do
  check "the yard is coded by its $method" bash -c "'$jalon' code yard.las yard.$method.txt -o yard_$method --method $method --quiet && '$jalon' evaluate-segmentation yard_$method/classified.las yard.las --classes-only --class-field classification --reference-class-field classification --json --quiet | python3 -c '
import json, sys
print(json.load(sys.stdin))'"
done
python3 -c '
import math, random
random.seed(1)
print("x y z intensity")
for i in range(200):
    for k in range(200):
        x, z = i * 0.005 + random.uniform(-1e-3, 1e-3), k * 0.005 + random.uniform(-1e-3, 1e-3)
        u, v = x - 0.3, z - 0.4
        on = max(abs(u), abs(v)) < 0.075
        level = (52000 if (u > 0) == (v > 0) else 9000) if on else 8000 if math.hypot(x - 0.7, z - 0.6) < 0.05 else 30000
        print("%.4f %.4f %.4f %d" % (x, random.gauss(0, 0.001), z, level + random.gauss(0, 900)))' >pattern.txt
printf '{"targets": [{"code": "1", "kind": "checker", "size_m": 0.15}, {"code": 3, "kind": "disc", "size_m": 0.12}]}' >catalogue.json
printf 'x y z' >words.json
check "targets finds those of a catalogue and lists the others without a code" bash -c "'$jalon' targets pattern.txt catalogue.json -o found --json --quiet | python3 -c '
import json, sys
d = json.load(sys.stdin)
assert d[\"counts\"] == {\"known\": 1, \"ambiguous\": 0, \"foreign\": 1, \"uncertain\": 0}, d
t = d[\"targets\"][0]
assert t[\"code\"] == \"1\" and abs(t[\"x\"] - 0.3) < 0.002 and t[\"confidence\"] > 0.9, t' && grep -q '^T1;0\.[0-9]*;.*;1$' found/targets.txt && test \$(wc -l <found/targets.csv) = 3 && test \$(wc -l <found/targets.txt) = 1"
cut -d' ' -f1-3 pattern.txt >bare.txt
refuses "targets of a scan without intensities" 3 'no field' "$jalon" targets bare.txt catalogue.json -o no
refuses "targets of a catalogue that is none" 2 'no JSON' "$jalon" targets pattern.txt words.json -o no
refuses "code without a list of codes" 3 'none.txt' "$jalon" code sample.las none.txt -o no --method targets
printf '1;0;0;0;360\n2;0;0;0;360 caf\351\n' >latin.txt
refuses "code with a list that is not UTF-8" 3 'latin.txt: value is not valid UTF-8 in line 2' "$jalon" code sample.las latin.txt -o no --method survey
refuses "code with a table that is none" 2 'no JSON' "$jalon" code sample.las codes.txt -o no --method survey --table coded/objects.csv
for epoch in 1 2; do check "scan of the street, epoch $epoch" "$jalon" scan --scene street --scene-set epoch=$epoch --method sample --set points=100000 --set seed=$epoch -o street$epoch.ply --quiet; done
check "compare both ways" bash -c "'$jalon' compare street1.ply street2.ply -o both --threshold 0.3 --json | python3 -c '
import json, sys
d = json.load(sys.stdin)
assert d[\"summary\"][\"points\"] == 100000 and d[\"reverse_summary\"][\"points\"] == 100000, d[\"summary\"]
assert len(d[\"changes\"]) > 0 and all(0 < c[\"class\"] < 7 for c in d[\"changes\"]), d[\"changes\"]'"
for file in report.html distances.svg histogram.svg comparison.json changes.csv regions.geojson regions.dxf compared.las compared.ply reference.las reference.ply; do check "compare made $file" test -s both/$file; done
check "compare one way lists regions" bash -c "'$jalon' compare street1.ply street2.ply -o one --one-way --threshold 0.3 | grep -q '^region ' && test -s one/regions.csv"
check "compare with a model" bash -c "'$jalon' compare result/model.obj sample.las -o as_built --set tolerance_m=0.02 --quiet && test -s as_built/report.html && test -s as_built/regions.csv"
check "compare outlines every region on a layer of its class" bash -c "python3 -c '
import json
features = json.load(open(\"both/regions.geojson\"))[\"features\"]
changes = json.load(open(\"both/comparison.json\"))[\"changes\"]
named = {f[\"properties\"][\"face\"] for f in features if f[\"properties\"][\"class\"] != \"region\"}
assert named and named <= {c[\"change\"] for c in changes}, (named, len(changes))
assert all(f[\"properties\"][\"class\"].upper() in open(\"both/regions.dxf\").read() for f in features)'"
check "compare without stations says what that means" bash -c "grep -q 'may show as changes' both/report.html && grep -q '\"visibility\": \"found\"' both/comparison.json"
check "compare with stations leaves out shadows" bash -c "'$jalon' compare street1.ply street2.ply -o seen --one-way --threshold 0.3 --reference-station 30,-5,2 --quiet && grep -q '\"visibility\": \"stations\"' seen/comparison.json && grep -q 'could not see' seen/report.html"
check "compare lets --set win over stations" bash -c "'$jalon' compare street1.ply street2.ply -o unseen --one-way --threshold 0.3 --reference-station 30,-5,2 --set visibility=none --quiet && grep -q '\"visibility\": \"none\"' unseen/comparison.json"
check "compare two models by points on them" bash -c "'$jalon' compare result/model.obj result/model.obj -o models --sample-set points=2000 --json | python3 -c '
import json, sys
h = json.load(sys.stdin)[\"hausdorff\"]
assert h[\"symmetric\"] == max(h[\"forward\"], h[\"reverse\"]) < 1e-6, h'"
check "compare a scan with a model's surfaces" "$jalon" compare sample.las result/model.obj -o covered --sample-set points=2000 --quiet
refuses "compare with a model refuses what only scans have" 6 'parameter "visibility"' "$jalon" compare result/model.obj sample.las -o no --set visibility=stations
check "compare by m3c2" bash -c "'$jalon' compare street1.ply street2.ply -o m3c2 --method m3c2 --set normal_radius_m=1 --set cylinder_radius_m=0.5 --set core_spacing_m=1 --quiet && grep -q points m3c2/comparison.json"
check "compare by m3c2 at given core points" bash -c "'$jalon' convert street1.ply street1.xyz --quiet && sed -n '10p;20p;30p' street1.xyz > core.xyz && '$jalon' compare street1.ply street2.ply -o core --method m3c2 --core core.xyz --set normal_radius_m=1 --set cylinder_radius_m=0.5 --quiet && grep -q '\"points\": 3' core/comparison.json"
refuses "compare refuses core points for other methods" 6 'core' "$jalon" compare street1.ply street2.ply -o no --core core.xyz
refuses "compare refuses an unknown method" 2 "no comparison method" "$jalon" compare street1.ply street2.ply -o no --method nonsense
check "scan of the arches" "$jalon" scan --scene arches -o arches.las --quiet --set horizontal_step_rad=0.003 --set vertical_step_rad=0.003
check "segment finds the soffits of the arches as cylinders" bash -c "'$jalon' segment arches.las -o arches --set primitives=all --json | python3 -c '
import json,sys
d=json.load(sys.stdin)
kinds={1:5,2:5,3:8}
rows=[line.split() for line in open(\"arches/primitives.txt\")]
assert len(rows)==len(d[\"segments\"]) and all(len(r)==kinds[int(r[0])] for r in rows), rows
round_=[s for s in d[\"segments\"] if s[\"type\"]==3]
assert len(round_)==2 and all(abs(s[\"radius\"]-0.6)<0.002 for s in round_) and not any(s[\"type\"]==2 for s in d[\"segments\"]), round_
assert all(float(r[7])==s[\"radius\"] for r,s in zip(rows,d[\"segments\"]) if s[\"type\"]==3)'"
check "the report lists spheres and cylinders" grep -q 'Spheres and cylinders' arches/report.html
check "segments.csv has a row a segment" python3 -c "
import csv, json
rows = list(csv.DictReader(open('segments/segments.csv')))
table = json.load(open('segments/segments.json'))['segments']
assert len(rows) == len(table) > 5
assert all(int(r['label']) == t['label'] and float(r['offset']) == t['offset'] and float(r['normal_2']) == t['normal'][2] for r, t in zip(rows, table))"
check "the picture is a whole PNG in an SVG below 2 MB" python3 -c "
import base64, re, struct, xml.dom.minidom, zlib
text = open('segments/segments.svg').read()
xml.dom.minidom.parseString(text)
assert len(text) < 2000000
png = base64.b64decode(re.search('data:image/png;base64,([A-Za-z0-9+/=]+)', text).group(1))
assert png[:8] == b'\x89PNG\r\n\x1a\n'
at, chunks = 8, {}
while at < len(png):
    n, kind = struct.unpack('>I4s', png[at:at + 8])
    body = png[at + 8:at + 8 + n]
    assert struct.unpack('>I', png[at + 8 + n:at + 12 + n])[0] == zlib.crc32(kind + body)
    chunks[kind], at = chunks.get(kind, b'') + body, at + 12 + n
width, height = struct.unpack('>II', chunks[b'IHDR'][:8])
rows = zlib.decompress(chunks[b'IDAT'])
assert len(rows) == height * (width + 1) and len(set(rows)) > 5
assert max(rows) < len(chunks[b'PLTE']) // 3"
check "rsvg draws the picture" rsvg-convert segments/segments.svg -o picture.png
check "the report of segments is self-contained" bash -c "! grep -qE '(src|href)=\"(https?:|//|/)' segments/report.html && grep -q 'data:image/png' segments/report.html"
check "evaluate-segmentation on the true planes of the sample" bash -c "'$jalon' evaluate-segmentation segments/segments.las --reference-labels segment --set min_points=50 --json | python3 -c '
import json,sys
d=json.load(sys.stdin)[\"segments\"]
t=d[\"totals\"]
assert t[\"pairs\"]==len(d[\"pairs\"])>20 and t[\"global_tdr\"]>0.98 and t[\"mean_angle\"]<0.02, t
assert len(d[\"unmatched_reference\"])==t[\"unmatched_reference\"]'"
check "evaluate-segmentation prints its table" bash -c "'$jalon' evaluate-segmentation segments/segments.las grown/segments.las | grep -qE '^ +total .* [01][.][0-9]{3} '"
check "evaluate-segmentation of two formats of one result is perfect" bash -c "'$jalon' evaluate-segmentation segments/segments.las segments/segments.ply --csv pairs.csv | grep -q 'detection 1.0000, accuracy 1.0000' && head -n 1 pairs.csv | grep -q '^automatic,reference,card_automatic'"
printf '0 0 0 1 1\n1 0 0 1 1\n2 0 0 2 1\n3 0 0 2 2\n' >classes.xyz
check "evaluate-segmentation --classes-only has precision and recall" bash -c "'$jalon' evaluate-segmentation classes.xyz --columns 'x y z found class' --classes-only --class-field found --reference-class-field class --json | python3 -c '
import json,sys
c=json.load(sys.stdin)[\"classes\"]
assert c[\"totals\"][\"accuracy\"]==0.75 and [r[\"confusion\"] for r in c[\"classes\"]]==[[2,1],[0,1]], c'"

check "model of the labels that segment wrote" bash -c "'$jalon' model segments/segments.las -o model --labels label --json | python3 -c '
import json,os,sys
d=json.load(sys.stdin)
assert d[\"segments\"]==\"labels of field label\" and d[\"model\"][\"faces\"]>20 and d[\"parameters\"], d
assert sorted(os.listdir(\"model\"))==sorted(d[\"files\"]), d[\"files\"]
assert {\"report.html\",\"report.json\",\"elevation.svg\",\"model.obj\"} <= set(d[\"files\"]), d[\"files\"]'"
check "model segments first, by another method" bash -c "'$jalon' model sample.las -o grown_model --segmenter region_growing --tolerance 0.02 --drawing-set scale=200 --drawing-set title=North | grep -q 'faces;' && grep -q '1:200' grown_model/elevation.svg && grep -q North grown_model/elevation.svg"
check "the report of a model has its openings and their precision" python3 -c "
import json
d = json.load(open('model/report.json'))
assert len(d['openings']) > 10 and d['opening_types'] and d['parts'], d['opening_types']
assert all(p['sigma_normal_rad'] > 0 and p['sigma_offset_m'] > 0 for p in d['planes'])"
check "a known station and scanner reach the report" bash -c "'$jalon' model quiet.las -o scanner --quiet --station 11,-15,1.6 --scanner-set sigma_range_m=0.002 && python3 -c '
import json
d=json.load(open(\"scanner/report.json\"))
assert d[\"scanner\"][\"sigma_range_m\"]==0.002 and len(d[\"scanner\"])==3, d[\"scanner\"]
assert 0.5<d[\"planes\"][0][\"variance_factor\"]<5, d[\"planes\"][0]'"
check "scan of a building of several facades" "$jalon" scan --scene lycee -o lycee.las --quiet --set horizontal_step_rad=0.003 --set vertical_step_rad=0.003
check "each of several facades has its drawing, in the report too" bash -c "'$jalon' model lycee.las -o lycee --json | python3 -c '
import json,re,sys
d=json.load(sys.stdin)
n=d[\"model\"][\"parts\"][\"facade\"]
assert n>1 and all(name % k in d[\"files\"] for k in range(1,n+1) for name in (\"elevation_%d.svg\",\"orthoimage_%d.png\",\"orthoimage_%d.pgw\")) and \"elevation_%d.svg\" % (n+1) not in d[\"files\"], d[\"files\"]
page=open(\"lycee/report.html\").read()
assert all(page.count(\"facade %d</\" % k) for k in range(1,n+1))
ids=re.findall(r\"id=.([a-z-]+[0-9]*)\",page)
assert len(ids)==len(set(ids)) and len(ids)>=2*(n+1), ids'"
check "rsvg draws the elevation" rsvg-convert model/elevation.svg -o picture.png

sha256sum result/* >before
refuses "a missing file" 3 'none.las' "$jalon" facade none.las -o result
: >empty.las
refuses "an empty file" 3 'empty.las' "$jalon" facade empty.las -o result
head -c 1000 sample.las >short.las
refuses "a truncated file names file and offset" 3 'short.las.*offset' "$jalon" facade short.las -o result
printf '1 2 3\n4 5 nan\n' >nan.xyz
refuses "NaN coordinates name the point" 3 'nan.xyz: point 1 ' "$jalon" facade nan.xyz -o result
printf '1 2 3\n4 five 6\n' >word.xyz
refuses "a word among the numbers names file and line" 3 'word.xyz.*line 2' "$jalon" facade word.xyz -o result
refuses "a wrong column" 2 'colu' "$jalon" facade nan.xyz -o result --columns "x y"
python3 -c "print('\n'.join('%g 0 0' % (i*0.01) for i in range(500)))" >line.xyz
refuses "collinear points" 5 'one line' "$jalon" facade line.xyz -o result
python3 -c "print('\n'.join(['1 2 3']*500))" >same.xyz
refuses "equal points" 5 'equal' "$jalon" facade same.xyz -o result
printf '1 2 3\n' >one.xyz
refuses "one point" 5 'point' "$jalon" facade one.xyz -o result
refuses "an unknown parameter lists the names" 2 'there are' "$jalon" facade sample.las -o result --set nose=1
refuses "a parameter out of range" 2 'outside' "$jalon" facade sample.las -o result --set distance_tolerance_m=-1
refuses "an unknown method lists what there is" 2 'ransac' "$jalon" segment sample.las -o never --method magic
refuses "a modelling method that is not there" 2 'outlines' "$jalon" model sample.las -o never --method magic
refuses "a label field that the cloud lacks" 3 'nose' "$jalon" model sample.las -o never --labels nose
refuses "labels and parameters of a segmenter" 2 'as they are' "$jalon" model sample.las -o never --labels label --segment-set seed=3
refuses "a scanner without a place" 2 'station X,Y,Z' "$jalon" model unplaced.las -o never --scanner-set sigma_range_m=0.002
refuses "a station that is no place" 2 'needs X,Y,Z' "$jalon" facade sample.las -o never --station 1,2
refuses "a facade that the model does not have" 2 'facade 9' "$jalon" model segments/segments.las -o never --labels label --drawing-set facade=9
check "refusals leave no folder" bash -c "[ ! -e never ]"
refuses "no reference to evaluate against" 2 'reference-labels' "$jalon" evaluate-segmentation segments/segments.las
refuses "a label field that is not there" 3 'label' "$jalon" evaluate-segmentation segments/segments.las --labels nose --reference-labels segment
refuses "clouds of unequal size" 3 'same points' "$jalon" evaluate-segmentation segments/segments.las quiet.las
refuses "labels that are no whole numbers" 2 'whole' "$jalon" evaluate-segmentation segments/segments.las --reference-labels residual
refuses "a class field alone" 2 'together' "$jalon" evaluate-segmentation segments/segments.las --reference-labels segment --class-field label
refuses "an unknown extension" 6 'xxx' "$jalon" convert sample.las sample.xxx
mkdir folder.ply
refuses "a folder as output file" 4 'folder.ply' "$jalon" convert sample.las folder.ply
refuses "no disk" 4 'full' bash -c "trap '' XFSZ; ulimit -f 40; exec '$jalon' convert sample.las full.ply"
check "no disk leaves nothing behind" bash -c "! ls | grep -q full"
cp quiet.ply good.ply 2>/dev/null || "$jalon" convert quiet.las good.ply --quiet
sha256sum good.ply >good.sum
refuses "no disk over an existing file" 4 'good' bash -c "trap '' XFSZ; ulimit -f 40; exec '$jalon' convert sample.las good.ply"
check "a failed write leaves the good file" sha256sum -c good.sum
refuses "no disk for the results" 4 '.' bash -c "trap '' XFSZ; ulimit -f 40; exec '$jalon' facade sample.las -o result"
check "failures left the existing results untouched" sha256sum -c before
# A run that is killed leaves its private folder, which nobody locks; the next one into the same folder takes it away.
mkdir -p killed/.jalon-0 && touch killed/.jalon-0/half.las
check "a killed run's leftovers go with the next run" bash -c "'$jalon' segment quiet.las -o killed --quiet && [ \$(ls -A killed | wc -l) -eq 7 ]"
mkdir -p shared/.jalon-0 && touch shared/.jalon-0/half.las
check "what a run at work holds stays" bash -c "flock shared/.jalon-0 '$jalon' segment quiet.las -o shared --quiet && [ \$(ls -A shared | wc -l) -eq 8 ] && [ -e shared/.jalon-0/half.las ]"
check "failures left no private folder" bash -c "[ \$(ls -A result | wc -l) -eq $files ]"

# A disk that is full, then one that is read only: a small file system of its own, where it may be mounted.
mkdir small
if mount -t tmpfs -o size=96m tmpfs small 2>/dev/null; then
  "$jalon" convert quiet.las small/good.ply --quiet && cp -r result small/result
  find small -type f -exec sha256sum {} + >small.sum
  dd if=/dev/zero of=small/filler bs=4k 2>/dev/null
  refuses "a full disk names the cause" 4 'small/good.ply.*no space left' "$jalon" convert sample.las small/good.ply
  refuses "a full disk names the cause, results" 4 'small/result.*no space left' "$jalon" facade sample.las -o small/result
  refuses "a full disk names the cause, segments" 4 'small/new.*no space left' "$jalon" segment sample.las -o small/new
  check "a full disk leaves the existing output untouched" sha256sum -c small.sum
  check "a full disk leaves nothing behind" bash -c "[ \"\$(ls -A small | sort | xargs)\" = 'filler good.ply result' ] && [ \$(ls -A small/result | wc -l) -eq $files ]"
  mount -o remount,ro small
  refuses "a read-only folder names the cause" 4 'small/good.ply.*read-only' "$jalon" convert quiet.las small/good.ply
  refuses "a read-only folder names the cause, results" 4 'small/result.*[Rr]ead-only' "$jalon" facade quiet.las -o small/result
  check "a read-only folder keeps its files" sha256sum -c small.sum
  umount small
else
  echo "skipped: a full disk, a read-only disk (a file system cannot be mounted here)" && skipped=$((skipped + 1))
fi
if [ "$(id -u)" -ne 0 ]; then
  cp quiet.las small/ && chmod a-w small
  refuses "a folder without permission names the cause" 4 'small/new.ply.*ermi' "$jalon" convert quiet.las small/new.ply
  chmod u+w small
fi

if [ -d "$data/facades" ]; then
  streets="street_1 street_3"
  [ -z "${JALON_SANITIZED:-}" ] || [ -n "${JALON_FULL:-}" ] || streets=street_3 # the smaller one takes the same ways
  for street in $streets; do
    check "facade on the real $street" "$jalon" facade "$data/facades/$street.txt" -o $street
    for file in report.html report.json elevation.svg model.obj segments.las segments.ply; do check "$street: $file" test -s $street/$file; done
  done
else
  echo "skipped: real facades (shared data absent)" && skipped=$((skipped + 1))
fi
# A tunnel of radius 3 m along x, one point of it bulged inward; a gauge of two boxes through it.
python3 - <<'END'
import math
with open("tunnel.xyz", "w") as f:
    for i in range(401):
        for k in range(60):
            r = 2.0 if (i, k) == (200, 5) else 3.0
            f.write("%.9f %.9f %.9f\n" % (0.1 * i, r * math.cos(k * math.pi / 30), r * math.sin(k * math.pi / 30)))
with open("track.txt", "w") as f:
    f.write("x y z\n" + "".join("%g 0 0\n" % x for x in (2, 12, 22, 32)))
with open("gauge.json", "w") as f:
    f.write('{"pieces": [{"type": "box", "size": [2, 3.6, 2.4]}, {"type": "box", "size": [1, 2, 3.4]}]}')
END
check "clearance of a gauge along a track: touches between two far poses" bash -c "'$jalon' clearance tunnel.xyz --gauge gauge.json --trajectory track.txt -o swept --json | python3 -c '
import json,math,sys
d=json.load(sys.stdin)
depth=2.0*math.sin(math.pi/6)-1.2
side=2.0*math.cos(math.pi/6)-1.8
truth=math.hypot(max(side,0),max(depth,0)) if max(side,depth)>0 else max(side,depth)
least=d[\"least\"]
assert abs(least[\"clearance\"]-truth)<1e-6 and least[\"interval\"]==1 and abs(least[\"parameter\"]-1.8)<0.11, d
assert d[\"poses\"]==4 and d[\"places\"]==1 and d[\"intervals_within_margin\"]==1, d'"
for file in places.csv intervals.csv clearance.svg clearance.json report.html; do check "clearance made $file" test -s swept/$file; done
check "rsvg draws the clearance" rsvg-convert swept/clearance.svg -o swept.png
check "clearance of a model from a cloud" bash -c "'$jalon' clearance result/model.obj sample.las -o measured --set margin_m=0.005 | grep -q 'within the margin' && test -s measured/near.csv"
# A corner of three walls, scanned twice; the second scan lies turned by half a degree about the vertical and shifted.
python3 - <<'END'
import math, random
random.seed(7)
def wall_points(n):
    for i in range(n):
        a, b, e = random.uniform(0, 8), random.uniform(0, 5), random.gauss(0, 0.002)
        yield [(a, b, e), (a, e, b), (e, a, b)][i % 3]
with open("corner_1.xyz", "w") as f, open("corner_2.xyz", "w") as g:
    for p in wall_points(30000):
        f.write("%.6f %.6f %.6f\n" % p)
    c, s = math.cos(math.radians(0.5)), math.sin(math.radians(0.5))
    for x, y, z in wall_points(30000):
        x, y, z = x - 0.1, y - 0.05, z + 0.08
        g.write("%.6f %.6f %.6f\n" % (c * x + s * y, -s * x + c * y, z))
END
check "register finds the pose and says what it is worth" bash -c "'$jalon' register corner_1.xyz corner_2.xyz --method icp -o joined --json | python3 -c '
import json,math,sys
d=json.load(sys.stdin)
m=d[\"T_reference_moving\"]
assert d[\"summary\"][\"converged\"]==1 and d[\"summary\"][\"unobservable\"]==0, d[\"summary\"]
assert abs(math.degrees(math.atan2(m[1][0],m[0][0]))-0.5)<0.002, m
assert max(abs(m[0][3]-0.1),abs(m[1][3]-0.05),abs(m[2][3]+0.08))<0.0005, m
assert len(d[\"directions\"])==6 and d[\"iterations\"], d'"
for file in report.html registration.json pose.txt registered.las registered.ply; do check "register made $file" test -s joined/$file; done
check "register help tells of all methods" bash -c "'$jalon' register --help | grep -q 'with --method coarse' && '$jalon' register --help | grep -q 'with --method automatic'"
python3 - <<'END'
import math, random
r = random.Random(11)
sheets = [((0, 0, 0), (6, 0, 0), (0, 5, 0)), ((0, 0, 0), (6, 0, 0), (0, 0, 3)), ((0, 0, 0), (0, 5, 0), (0, 0, 3)),
          ((3, 1, 0), (1.5, 0, 0), (0, 0, 1)), ((3, 1, 1), (1.5, 0, 0), (0, 1, 0)), ((3, 1, 0), (0, 1, 0), (0, 0, 1))]
def points():
    for o, u, v in sheets:
        for i in range(2500):
            s, t = r.random(), r.random()
            yield [o[c] + s * u[c] + t * v[c] + r.gauss(0, 0.002) for c in range(3)]
with open("room_1.xyz", "w") as f, open("room_2.xyz", "w") as g:
    for p in points(): f.write("%.6f %.6f %.6f\n" % tuple(p))
    for x, y, z in points(): g.write("%.6f %.6f %.6f\n" % (12 - y, x - 7, z + 1))  # a quarter turn away
END
check "register without a method finds a scan that was turned and shifted" bash -c "'$jalon' register room_1.xyz room_2.xyz -o plain --json | python3 -c '
import json,sys
d=json.load(sys.stdin)
m=d[\"T_reference_moving\"]
assert d[\"method\"]==\"automatic\" and d[\"summary\"][\"converged\"]==1 and d[\"summary\"][\"score\"]>0.8, d
at=[sum(a*b for a,b in zip(row,(10,-6,4,1))) for row in m[:3]]
assert max(abs(a-b) for a,b in zip(at,(1,2,3)))<0.002, at'"
check "with a start it is the same method" bash -c "'$jalon' register room_1.xyz room_2.xyz --start plain/pose.txt -o plain_again --json | python3 -c '
import json,sys
d=json.load(sys.stdin)
assert d[\"method\"]==\"automatic\" and d[\"summary\"][\"converged\"]==1, d'"
check "register starts from a pose" bash -c "'$jalon' register corner_1.xyz corner_2.xyz --method icp --start joined/pose.txt -o again | grep -q '^converged'"
check "m3c2 takes the covariance of the registration" "$jalon" compare joined/registered.ply corner_1.xyz --method m3c2 --registration joined/registration.json -o creep --set core_spacing_m=0.5
refuses "a pose of seven numbers" 3 'has 12 numbers' bash -c "echo 1 2 3 4 5 6 7 >seven.txt; '$jalon' register corner_1.xyz corner_2.xyz --method icp --start seven.txt -o none"
python3 - <<'END'
import random
r = random.Random(5)
with open("box.xyz", "w") as f:  # half a turn lays a bare box onto itself
    for i in range(8000):
        p = [6 * r.random(), 5 * r.random(), 2.8 * r.random()]
        p[i % 3] = round(p[i % 3] / (6, 5, 2.8)[i % 3]) * (6, 5, 2.8)[i % 3]
        f.write("%.6f %.6f %.6f\n" % tuple(p))
with open("hills.xyz", "w") as f:
    import math
    for i in range(8000):
        x, y = 40 * r.random(), 30 * r.random()
        f.write("%.4f %.4f %.4f\n" % (x, y, 2 * math.sin(x / 4) * math.cos(y / 5) + 0.1 * x))
END
check "register tells of a second pose" bash -c "'$jalon' register box.xyz box.xyz -o twice | grep -q 'clearly different pose fits'"
check "and of none" bash -c "'$jalon' register room_1.xyz hills.xyz -o nowhere >said; test \$? = 5 && grep -q '^nothing found' said && ! grep -q nan said"
check "a pose that is not accepted gives a report and no cloud" bash -c "test -s nowhere/report.html && grep -q '\"verdict\": 3' nowhere/registration.json && ! ls nowhere | grep -q -e registered -e pose.txt"
check "register says that a pose is accepted, and how sure that is" bash -c "'$jalon' register corner_1.xyz corner_2.xyz --method icp -o joined | grep -q 'the pose is accepted, confidence 0.9'"
awk '{ print -$1, $2, $3 }' room_2.xyz >mirrored.xyz
check "a mirrored scan is not laid onto its own, from any start" bash -c "'$jalon' register room_1.xyz mirrored.xyz -o mirror >said; test \$? = 5 && '$jalon' register room_1.xyz mirrored.xyz --method icp -o mirror >said; test \$? = 5 && ! test -e mirror/registered.las"
check "but for --force" bash -c "'$jalon' register room_1.xyz mirrored.xyz --method icp --force -o forced && test -s forced/registered.las && test -s forced/pose.txt"
printf 'name x y z\nA 0 0 0 0.002\nB 9 0 1 0.002 0.002 0.004\nC, 8, 7, 2\n- 1 6 0 # unnamed\n' >control.txt
printf 'C 8 7 2\nA 0 0 0\n1 6 0\nB 9 0 1\n' >measured.txt
check "targets register two scans" bash -c "'$jalon' register corner_1.xyz corner_2.xyz --targets control.txt measured.txt -o by_targets | grep -q 'on 4 pairs'"
check "and their residuals have names" grep -q '"name": "C"' by_targets/registration.json
refuses "a target without a height" 3 'line 2: 2 numbers after the name' bash -c "printf 'A 1 2 3\nB 1 2\n' >short.txt; '$jalon' register corner_1.xyz corner_2.xyz --targets short.txt measured.txt -o none"
refuses "a target with a word for a number" 3 '"5m" is no number' bash -c "printf 'A 1 2 3\nB 1 2 5m\n' >word.txt; '$jalon' register corner_1.xyz corner_2.xyz --targets word.txt measured.txt -o none"
refuses "an unknown registration method" 2 'no registration method' "$jalon" register corner_1.xyz corner_2.xyz --method nothing -o none
refuses "a gauge without a trajectory" 2 'go together' "$jalon" clearance tunnel.xyz --gauge gauge.json
printf '{"pieces": [{"type": "cone"}]}' >cone.json
refuses "a gauge of an unknown piece" 3 'cone' "$jalon" clearance tunnel.xyz --gauge cone.json --trajectory track.txt
echo "$passed passed, $failed failed, $skipped skipped"
[ $failed -eq 0 ]

#!/usr/bin/env bash
# SPDX-FileCopyrightText: 2026 The Jalon authors
# SPDX-License-Identifier: Apache-2.0
# What a new user of the command line does wrong: each mistake has the exit code of the table in README.md, one line that
# helps on standard error, nothing on standard output and nothing written. And what is shown of lengths whose unit nobody
# told. Usage: cli_mistakes.sh JALON
set -uo pipefail
jalon=$(realpath "$1")
root=$(cd "$(dirname "$0")/../.." && pwd)
. "$(dirname "$0")/cli_judges.sh"

python3 - <<'END'
import random
r = random.Random(1)
def write(name, points): open(name, "w").write("".join("%.4f %.4f %.4f\n" % p for p in points))
wall = [(5 * r.random(), r.gauss(0, 0.003), 4 * r.random()) for _ in range(4000)]
write("wall.xyz", wall)
write("wall_mm.xyz", [(1000 * x, 1000 * y, 1000 * z) for x, y, z in wall])
write("ball.xyz", [(5 * r.random(), 5 * r.random(), 5 * r.random()) for _ in range(300)])
write("far.xyz", [(x + 1000, y, z) for x, y, z in wall])
write("one.xyz", [(1, 2, 3)])
hall = [[(30 + 20 * r.random(), 50 + 9 * r.random(), 2), (30 + 20 * r.random(), 50, 2 + 5 * r.random()),
         (30, 50 + 9 * r.random(), 2 + 5 * r.random())][k % 3] for k in range(6000)]
write("hall.xyz", hall)
write("hall_yx.xyz", [(y, x, z) for x, y, z in hall])
write("hall_up.xyz", [(x, z, -y) for x, y, z in hall])
write("hall_ft.xyz", [(x / 0.3048, y / 0.3048, z / 0.3048) for x, y, z in hall])
write("inside.xyz", [(x - 32, y - 52, z - 3) for x, y, z in hall])
write("inside_ft.xyz", [((x - 32) / 0.3048, (y - 52) / 0.3048, (z - 3) / 0.3048) for x, y, z in hall])
write("hall_grid.xyz", [(652000 + x, 6862000 + y, z) for x, y, z in hall])
open("hall_degrees.xyz", "w").write("".join("%.8f %.8f %.3f\n" % (2.35 + x / 73000, 48.86 + y / 111000, z) for x, y, z in hall))
write("screen.xyz", [(33 + 14 * r.random(), 55, 4 + 2 * r.random()) for _ in range(2000)])
END
mkdir folder folder.las
: >empty.las
: >empty.obj
echo hello | tee words.txt >words.json
printf 'v 0 0 0\nv 5 0 0\nv 5 0 4\nv 0 0 4\nf 1 2 3 4\n' >wall.obj
printf '0 0 0\n1 0 0\n' >track.txt
printf '0 0 0\n1 0 north\n' >lost.txt
printf '{"pieces": [{"type": "box", "size": [1, 1]}]}' >flat.json
printf '{"pieces": [{"type": "box", "size": [0.2, 0.2, 0.2]}]}' >box.json
judge "a wall is segmented" "$jalon" segment wall.xyz -o seg

# The table of exit codes stands in --help and in README.md, with the same words.
codes() { grep -oE '^ +(0|1|2|3|4|5|6|7|130)  .*' "$1" | sed 's/^ *//'; }
"$jalon" --help >"$logs/help"
codes "$logs/help" >"$logs/codes"
codes "$root/README.md" >"$logs/readme"
judge "nine exit codes in --help" [ "$(wc -l <"$logs/codes")" -eq 9 ]
judge "the same in README.md" diff "$logs/codes" "$logs/readme"

# Commands and options.
ends 2 'a command is missing; there are: info, '
ends 2 'no command "facad"; there are: info, .*help: jalon --help' facad wall.xyz
ends 2 'no command "nonsense"' nonsense --help
ends 2 'no option "--json" before the command' --json info wall.xyz
ends 2 'jalon info: scan is required .help: jalon info --help' info
ends 2 'unexpected argument --nonsense' info wall.xyz --nonsense
ends 2 'unexpected argument' info wall.xyz wall.xyz
ends 2 '--output is required' segment wall.xyz
ends 2 '--output: needs a value' segment wall.xyz -o ''
ends 2 '--labels: needs a value' model wall.xyz -o new --labels ''
ends 2 '--output: takes one value, not 2' segment wall.xyz -o new -o newer
ends 2 '--targets: takes two values, not 1' register wall.xyz wall.xyz -o new --targets track.txt
for bad in nan inf -0.02 0 20mm 0x10; do ends 2 "--tolerance: \"$bad\" is no number" segment wall.xyz -o new --tolerance "$bad"; done
ends 2 '--voxel: "nan" is no number' clean wall.xyz -o new.las --voxel nan
ends 2 '--duplicate-tolerance: "-1" is no number above 0' clean wall.xyz -o new.las --duplicate-tolerance -1
ends 2 '--threshold: "nan" is no number' compare wall.xyz wall.xyz -o new --threshold nan
ends 2 '--threads: "two" is no whole number' info wall.xyz --threads two
ends 2 '--memory-limit: "lots" is no whole number' info wall.xyz --memory-limit lots
ends 7 'its memory limit is 1.0 MiB' segment hall.xyz -o new --memory-limit 1
ends 2 '--part: "1.5" is no whole number' clearance wall.obj wall.xyz --part 1.5
ends 2 '--part: "-3" is no number from 0' clearance wall.obj wall.xyz --part -3
ends 2 'X,Y,Z in metres, not "1,2,nan"' info wall.xyz --station 1,2,nan
ends 2 'side not in' segment wall.xyz -o new --view side
ends 2 'mile not in' info wall.xyz --unit mile

# Methods.
ends 2 'there are: ransac' segment wall.xyz -o new --method magic
ends 2 'there are: ransac' model wall.xyz -o new --segmenter magic
ends 2 'there are: outlines' facade wall.xyz -o new --model-method magic
ends 2 'there are: distance' compare wall.xyz wall.xyz -o new --method magic
ends 2 'there are: ' register wall.xyz wall.xyz -o new --method magic
ends 2 'there are: static' scan -o new.las --method magic
ends 2 'needs --targets' register wall.xyz wall.xyz -o new --method targets

# Options that would do nothing.
ends 2 'are for --outliers' clean wall.xyz -o new.las --set k=3
ends 2 '--noise-label needs --labels' model wall.xyz -o new --noise-label 1
ends 2 '--ignore-class needs' evaluate-segmentation seg/segments.las seg/segments.las --ignore-class 3
ends 2 'without a gauge' clearance wall.xyz --gauge box.json --trajectory track.txt --part 0
ends 2 'is a model' compare wall.obj wall.xyz -o new --reference-unit mm
ends 2 'is a model' compare wall.obj wall.xyz -o new --reference-box 0,0,0,5,5,5
ends 2 'box is of scans' compare wall.obj wall.obj -o new --box 0,0,0,5,5,5
ends 2 'a box needs X,Y,Z' register wall.xyz wall.xyz -o new --moving-box 0,0,0
ends 6 'COPC' register wall.xyz wall.xyz -o new --reference-spacing 1
ends 2 'none is among the inputs' clearance wall.obj wall.obj --box 0,0,0,5,5,5

# Parameters.
ends 2 '--set needs NAME=VALUE, not "k"' segment wall.xyz -o new --set k
ends 2 'no parameter "nose"; there are: ' segment wall.xyz -o new --set nose=1
ends 2 '--set max_planes=many: max_planes takes a number' segment wall.xyz -o new --set max_planes=many
ends 2 '"max_planes" = -2 is outside 0' segment wall.xyz -o new --set max_planes=-2
ends 2 '--set max_planes=1.5: .*integer' segment wall.xyz -o new --set max_planes=1.5
ends 2 '--set refit=perhaps: refit takes true or false' segment wall.xyz -o new --set refit=perhaps
ends 2 '--drawing-set scale=nan: scale takes a number' facade wall.xyz -o new --drawing-set scale=nan
ends 2 '--change-set threshold_m=2cm: threshold_m takes a number' compare wall.xyz wall.xyz -o new --change-set threshold_m=2cm
ends 2 'words.txt: no JSON' segment wall.xyz -o new --params words.txt
ends 3 'folder: it is a folder' segment wall.xyz -o new --params folder
ends 3 'none.json: cannot be opened' segment wall.xyz -o new --params none.json
for list in 1,x,3 1,nan,3 '[1,2,3' '1,2,3]' 1,2mm,3; do
  ends 2 'takes numbers, as viewpoint=1,2,3' normals wall.xyz -o new.ply --set "viewpoint=$list"
done
# The wall stands in the plane y = 0: its normals turn to a viewpoint before it, then behind it.
for list in 1,%s2,3 '[1, %s2, 3]' '1 %s2 3' '1;%s2;3'; do
  for sign in - ''; do
    # shellcheck disable=SC2059
    "$jalon" normals wall.xyz -o n.ply --quiet --set orientation=point --set "viewpoint=$(printf "$list" $sign)" &&
      "$jalon" convert n.ply n.xyz --quiet && awk '!/^[#\/]/ { s += $5 } END { printf s < 0 ? "before " : "behind " }' n.xyz
  done >"$logs/sides"
  judge "--set viewpoint=$list is an array" grep -q '^before behind $' "$logs/sides"
done

# Inputs.
for command in info 'segment -o new' 'facade -o new' 'model -o new' 'clean -o new.las' 'normals -o new.ply'; do
  # shellcheck disable=SC2086
  set -- $command
  name=$1
  shift
  ends 3 'none.las: cannot open' "$name" none.las "$@"
  ends 3 'folder.las: cannot read: it is a folder' "$name" folder.las "$@"
  ends 3 'empty.las: .*empty' "$name" empty.las "$@"
done
ends 3 'folder: cannot read: it is a folder' convert folder new.las
ends 3 'words.txt: .*no line of numbers' convert words.txt new.las
ends 6 'hold a model, no cloud' segment wall.obj -o new
ends 6 'wall.xyz: no model' evaluate-model wall.obj wall.xyz
ends 3 'folder: ' evaluate-model folder wall.obj
ends 3 'empty.obj: ' evaluate-model wall.obj empty.obj
ends 3 'folder: ' compare wall.xyz folder -o new
ends 3 'folder: ' register folder wall.xyz -o new
ends 3 'no field "label"' evaluate-segmentation wall.xyz wall.xyz
ends 3 'not a registration.json' compare wall.xyz wall.xyz -o new --method m3c2 --registration seg/segments.las
ends 3 'folder: it is a folder' register wall.xyz wall.xyz -o new --start folder
ends 3 'lost.txt, line 2: "north" is no number' clearance wall.xyz --gauge box.json --trajectory lost.txt
ends 3 'no line of numbers' clearance wall.xyz --gauge box.json --trajectory words.txt
ends 3 'flat.json: piece 0: "size" needs three numbers' clearance wall.xyz --gauge flat.json --trajectory track.txt
ends 3 'words.json: no JSON object' clearance wall.xyz --gauge words.json --trajectory track.txt

# Outputs, told before the work.
for command in segment facade model; do
  ends 4 'wall.xyz: it is a file; the results need a folder' $command ball.xyz -o wall.xyz
  ends 4 'wall.xyz is a file, no folder' $command ball.xyz -o wall.xyz/below
done
ends 4 'it is a file; the results need a folder' compare wall.xyz wall.xyz -o words.txt
ends 4 'it is a file; the results need a folder' register wall.xyz wall.xyz -o words.txt
ends 4 'it is a file; the results need a folder' evaluate-model wall.obj wall.obj -o words.txt
ends 4 'it is a file; the results need a folder' clearance wall.obj wall.xyz -o words.txt
ends 4 'folder.las: it is a folder; a file is needed' convert wall.xyz folder.las
ends 4 'folder.las: it is a folder; a file is needed' clean wall.xyz -o folder.las
ends 4 'there is no folder nowhere' normals wall.xyz -o nowhere/new.ply
ends 4 'there is no folder nowhere' evaluate-segmentation seg/segments.las seg/segments.las --csv nowhere/new.csv
ends 4 'folder: it is a folder; a file is needed' scan -o new.las --model folder
ends 6 'there are: .*las, ply' normals wall.xyz -o new.xxx
ends 6 'there are: ply, obj' scan -o new.las --model new.xxx

# Nothing found: a code of its own and no empty files.
for command in segment facade model; do
  ends 5 'ball.xyz: found no .* in 300 points over .* units; nothing is written: see --tolerance.*--unit' $command ball.xyz -o new
  ends 5 '1 points' $command one.xyz -o new
done
ends 5 'wall_mm.xyz: found no segment' segment wall_mm.xyz -o new
ends 5 'no pulse met scene' scan -o new.las --station 1e6,0,0
ends 5 'no point of far.xyz has a distance from wall.xyz' compare wall.xyz far.xyz -o new --set max_distance_m=1 --force --quiet
ends 5 'no point has a segment' evaluate-segmentation seg/segments.las seg/segments.las \
  --reference-noise-label 0 --reference-noise-label 1

# Two epochs that hardly share a place: both boxes, the gap and the likely cause, before anything is computed.
ends 5 'wall.xyz .x 0.0 .* and far.xyz .x 1000.0 .* lie 995.0 apart: likely another origin.*same size.*-1000, .*0, .*0 .*jalon register' \
  compare wall.xyz far.xyz -o new
ends 5 'other axes: they meet where .y, x, z. of hall_yx.xyz' compare hall.xyz hall_yx.xyz -o new
ends 5 'other axes: they meet where .x, -z, y. of hall_up.xyz' compare hall.xyz hall_up.xyz -o new
ends 5 'as if hall_ft.xyz were in feet; --compared-unit names it' compare hall.xyz hall_ft.xyz -o new
ends 5 'as if hall_ft.xyz were in feet; --reference-unit names it' compare hall_ft.xyz hall.xyz -o new
ends 5 'as if wall_mm.xyz were in millimetres' compare wall.obj wall_mm.xyz -o new
ends 5 'degrees of longitude and latitude' compare hall_grid.xyz hall_degrees.xyz -o new
ends 5 'share [0-9.]+ % of their space: they may have other units, axes or CRS' compare hall.xyz screen.xyz -o new
lacks 'warning' compare hall.xyz hall_ft.xyz -o feet --compared-unit ft
says 'warning: .*share .* of their space: .*as if inside_ft.xyz were in feet; --compared-unit' compare inside.xyz inside_ft.xyz -o inside
says 'warning: .*lie 995.0 apart' compare wall.xyz far.xyz -o far --force

# A list of codes that lies elsewhere than its scan, or was saved as no UTF-8: the likely cause, before anything is computed.
printf '1;30;58;2;300.2\n2;33;58;7;300.4\n3;33;59;7;300.4\n' >codes.txt
awk -F';' '{ OFS = ";"; print $1, $3, $2, $4, $5 }' codes.txt >codes_yx.txt
awk -F';' '{ OFS = ";"; for (i = 2; i < 5; ++i) $i = $i / 0.3048; print }' codes.txt | tee codes_ft.txt | tr ';' '\t' >codes_ft_tab.txt
awk -F';' '{ OFS = ";"; print $1, $2 + 1000, $3, $4, $5 }' codes.txt >codes_far.txt
printf '\377\3761\000;\000' >codes_utf16.txt
printf 'code\n' >codes_words.txt
ends 5 'codes_yx.txt: none of its points lies within 10 m of the scan; with X and Y exchanged they do' code hall.xyz codes_yx.txt -o new --method survey
ends 5 'codes_ft.txt: none .* taken for feet they do: see --set codes_unit=ft' code hall.xyz codes_ft.txt -o new --method survey
ends 5 'codes.txt: none .* taken for metres they do' code hall.xyz codes.txt -o new --method survey --set codes_unit=ft
ends 5 'codes.txt: none .* the scan is in feet: see --unit ft' code hall_ft.xyz codes.txt -o new --method survey
ends 5 'codes_far.txt: none .* are both in one system' code hall.xyz codes_far.txt -o new --method survey
ends 3 'codes_utf16.txt: is UTF-16; save the file as UTF-8' code hall.xyz codes_utf16.txt -o new --method survey
ends 3 'empty.las: is empty' code hall.xyz empty.las -o new --method survey
ends 3 'empty.las: is empty' code hall.xyz codes.txt -o new --method survey --table empty.las
ends 3 'folder: it is a folder' code hall.xyz folder -o new --method survey
ends 3 'codes_words.txt: .*1 columns|code list, line 1: 1 columns' code hall.xyz codes_words.txt -o new --method survey
ends 2 'code table: no JSON' code hall.xyz codes.txt -o new --method survey --table words.txt
lacks 'outside the cloud' code hall.xyz codes_ft_tab.txt -o coded_ft --method survey --set codes_unit=ft

# Units: metres where the file or an option says so, and no guess where nothing does.
says 'size .* 3\.[0-9]+ units$' info wall.xyz
says 'lengths are in the units of wall.xyz, not named there and taken for metres; --unit names them' info wall.xyz
says 'size .* m$' info wall.xyz --unit m
lacks 'units' info wall.xyz --unit m
judge "a cloud without a reference system becomes an E57 file" "$jalon" convert wall.xyz wall.e57
lacks 'units' info wall.e57
says 'size .* 3\.[0-9]+ m$' info wall.e57
says 'size       4\.[0-9]+ x 0\.0[0-9]+ x 3' info wall_mm.xyz --unit mm
lacks ' mm| m2' segment wall.xyz -o seg
says 'area m2   sigma mm' segment wall_mm.xyz -o seg_mm --unit mm
lacks 'units' segment wall_mm.xyz -o seg_mm --unit mm
judge "a report tells that no unit was named" grep -q 'not named by wall.xyz: taken as metres' seg/report.html
judge "a report tells the unit" grep -q '>metre<' seg_mm/report.html
says 'rms 0\.[0-9]+ units' register wall.xyz wall.xyz -o same --method icp --force
says ' mm, ' compare wall.xyz wall_mm.xyz -o same_wall --reference-unit m --compared-unit mm
lacks 'units|warning' compare wall.xyz wall_mm.xyz -o same_wall --reference-unit m --compared-unit mm
says 'warning: wall_mm.xyz is about 1 000 times as large as wall.xyz' compare wall.xyz wall_mm.xyz -o large --force
says 'warning: wall_mm.xyz is about 1 000 times as large as wall.obj' clearance wall.obj wall_mm.xyz
lacks 'warning' compare wall.xyz ball.xyz -o other
judge "a sample is scanned" "$jalon" scan --scene sills --method sample --set points=6060 -o sills.las
says 'size .* m$' info sills.las
says 'sigma mm' segment sills.las -o sills
echo "$passed passed, $failed failed"
[ $failed -eq 0 ]

#!/usr/bin/env bash
# SPDX-FileCopyrightText: 2026 The Jalon authors
# SPDX-License-Identifier: Apache-2.0
# Stations travel from the scanner through files of every kind to the comparison. Usage: cli_stations.sh JALON
set -uo pipefail
jalon=$(realpath "$1")
. "$(dirname "$0")/cli_judges.sh"
stations() { "$jalon" info "$1" --json | python3 -c 'import json,sys; print([(s["name"], s["points"], [round(x, 6) for x in s.get("position", [])]) for s in json.load(sys.stdin)["stations"]])'; }
step="--set horizontal_step_rad=0.008 --set vertical_step_rad=0.008 --quiet"

# shellcheck disable=SC2086
for epoch in 1 2; do
  judge "scan of epoch $epoch from two stations" "$jalon" scan --scene street --scene-set epoch=$epoch --set seed=$epoch $step -o street$epoch.las
done
stations street1.las >"$logs/told"
judge "info lists two stations with poses" python3 -c 'import sys; t = eval(open(sys.argv[1]).read()); assert len(t) == 2 and all(n > 5000 and len(p) == 3 for _, n, p in t), t' "$logs/told"
says '^station    .*: [0-9 ]+ points, at ' info street1.las
for name in a.ply a.xyz a.csv a.pcd b.las; do
  judge "convert to $name" "$jalon" convert street1.las $name --quiet
  stations $name >"$logs/now"
  judge "$name has the same stations" diff "$logs/told" "$logs/now"
done
judge "text has its stations beside it" test -s a.stations.json
printf '1 0 0 5\n0 1 0 6\n0 0 1 7\n' >pose.txt
judge "register writes them moved" "$jalon" register street1.las street1.las --start pose.txt -o moved --force --quiet --method icp --set max_iterations=1
judge "registered.las has two stations" bash -c "'$jalon' info moved/registered.las --json | python3 -c 'import json,sys; assert len(json.load(sys.stdin)[\"stations\"]) == 2'"
judge "compare uses the stations of both files" bash -c "'$jalon' compare street1.las street2.las -o by_files --json | python3 -c '
import json, sys
d = json.load(sys.stdin)
assert d[\"parameters\"][\"visibility\"] == \"stations\", d[\"parameters\"]
assert d[\"summary\"][\"stations\"] == d[\"reverse_summary\"][\"stations\"] == 2
assert 0 < len(d[\"changes\"]) < 12, len(d[\"changes\"])'"
judge "of other formats the same changes" bash -c "'$jalon' convert street2.las c.csv --quiet && '$jalon' compare a.ply c.csv -o by_others --json --quiet | python3 -c '
import json, sys
d = json.load(sys.stdin)
assert d[\"parameters\"][\"visibility\"] == \"stations\"
other = json.load(open(\"by_files/comparison.json\"))
assert [c[\"class\"] for c in d[\"changes\"]] == [c[\"class\"] for c in other[\"changes\"]]'"
judge "compared.las keeps them" bash -c "'$jalon' info by_files/compared.las --json | python3 -c 'import json,sys; assert len(json.load(sys.stdin)[\"stations\"]) == 2'"
echo hello >a.stations.json
says 'warning: .*a.stations.json: the stations are left out' info a.csv
echo "$passed passed, $failed failed"
[ $failed -eq 0 ]

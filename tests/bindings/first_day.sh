#!/usr/bin/env bash
# SPDX-FileCopyrightText: 2026 The Jalon authors
# SPDX-License-Identifier: Apache-2.0
# The first day of the pages. first_day.sh scan JALON FOLDER: its two scans, of a street along the x axis, as before.las and after.las.
# first_day.sh said FILE: whether a program printed what all languages must print (first_day.txt); that this is true, python/first_day_test.py tells.
set -euo pipefail
here=$(cd "$(dirname "$0")" && pwd)
case $1 in
  scan)
    epoch=1
    for name in before after; do
      # The scene stands turned by 17 degrees (src/scan/scenes/scenes.h); this turns it back.
      "$2" scan --quiet --scene street -o "$3/$name.las" --scene-set rotation_rad=-0.29670597283903605 --scene-set epoch=$epoch \
        --set seed=$epoch --set horizontal_step_rad=0.006 --set vertical_step_rad=0.006
      epoch=$((epoch + 1))
    done
    ;;
  said)
    sed -E 's/([0-9]),([0-9])/\1.\2/g' "$2" >"$2.points" # a decimal comma is the locale's
    missing=0
    while IFS= read -r line; do
      grep -qF -- "$line" "$2.points" || { echo "not printed: $line"; missing=1; }
    done <"$here/first_day.txt"
    [ $missing -eq 0 ] || { cat "$2"; exit 1; }
    ;;
esac

#!/usr/bin/env bash
# SPDX-FileCopyrightText: 2026 The Jalon authors
# SPDX-License-Identifier: Apache-2.0
# Models in every format, read by programs that are not ours: validators.sh BUILD_FOLDER [SCAN ...]
# Without scans: a house made by hand, and models of virtual scans on coordinates of a national grid.
# ezdxf, trimesh, GDAL (pyogrio) and shapely come from PyPI into BUILD_FOLDER/validators, cjval from crates.io, once.
# Without them the test is skipped (77), visibly; where CI is set that is a failure.
set -uo pipefail
here=$(cd "$(dirname "$0")" && pwd)
build=$(realpath "${1:?usage: validators.sh BUILD_FOLDER [SCAN ...]}")
shift
tools=$build/validators
log=$build/validators_setup.log
python=$tools/bin/python
passed=0 failed=0 skipped=0

# miss WHAT: says that a validator is not there; ends the test where nothing can be checked without it.
miss() {
  tail -n 3 "$log"
  if [ -n "${CI:-}" ]; then
    echo "not ok - $1 cannot be installed"
    failed=$((failed + 1))
  else
    echo "skipped: $1 cannot be installed"
    skipped=$((skipped + 1))
  fi
}
finish() {
  echo "$passed passed, $failed failed, $skipped skipped"
  [ $failed -eq 0 ] || exit 1
  [ $((passed + failed)) -gt 0 ] || exit 77
  exit 0
}

has_python() { "$python" -c "import ezdxf, numpy, pyogrio, shapely, trimesh" 2>/dev/null; }
if ! has_python; then
  python3 -m venv "$tools" >"$log" 2>&1 &&
    "$tools/bin/pip" install --disable-pip-version-check ezdxf numpy pyogrio shapely trimesh >>"$log" 2>&1
  has_python || { miss "ezdxf, pyogrio, shapely or trimesh"; finish; }
fi

cjval=$tools/cjval/debug/city_report
if [ ! -x "$cjval" ]; then
  # From a copy, so that nothing is written into the sources; a debug build: half the time to compile, and the files are small.
  cp -r "$here/city_report" "$tools" &&
    CARGO_TARGET_DIR=$tools/cjval cargo build --manifest-path "$tools/city_report/Cargo.toml" >>"$log" 2>&1
  [ -x "$cjval" ] || { cjval=; miss cjval; }
fi

# Khronos's validator runs in Node.js, which is not everywhere: without it that part is skipped, even where CI is set.
gltf=$tools/gltf
if command -v node >/dev/null && command -v npm >/dev/null; then
  [ -d "$gltf/node_modules/gltf-validator" ] || npm install --silent --prefix "$gltf" gltf-validator >>"$log" 2>&1
  [ -d "$gltf/node_modules/gltf-validator" ] || { gltf=; miss gltf-validator; }
else
  gltf=
  echo "skipped: gltf-validator needs node and npm"
  skipped=$((skipped + 1))
fi

work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

# count WHAT COMMAND ...: adds the sum that the command's last line says.
count() {
  local what=$1
  shift
  "$@" >"$work/counts"
  sed -E 's/^[0-9]+ passed, /  &/' "$work/counts" # indented: the sum at the end is what counts
  if [[ $(tail -n 1 "$work/counts") =~ ^([0-9]+)\ passed,\ ([0-9]+)\ failed ]]; then
    passed=$((passed + BASH_REMATCH[1])) failed=$((failed + BASH_REMATCH[2]))
  else
    failed=$((failed + 1)); echo "not ok - $what: the checks did not end"
  fi
}
# check NAME COMMAND ...: the command fills a folder with the files of a model, which are then looked at.
check() {
  local name=$1 folder=$work/$1
  shift
  mkdir -p "$folder"
  if ! "$@" "$folder"; then
    failed=$((failed + 1)); echo "not ok - $name: no files"
    return
  fi
  count "$name" env PYTHONWARNINGS=ignore "$python" "$here/check_files.py" "$name" "$folder" $cjval
}

programs=$build/tests/formats
scanned() { "$programs/scan_files" "$1" "$2" "$3"; }
if [ $# -gt 0 ]; then
  for scan in "$@"; do
    check "$(basename "$scan")" scanned "$scan" facade
  done
  finish
fi

check house "$programs/house_files"
grid="shift_m=[652000,6861000,100]"
"$build/src/jalon" scan --quiet --scene facade --scene-set "$grid" --scene-set rotation_rad=0.4 -o "$work/facade.las" &&
  "$build/src/jalon" scan --quiet --scene arches --scene-set "$grid" -o "$work/arches.las" ||
  { failed=$((failed + 1)); echo "not ok - no scans"; }
check facade scanned "$work/facade.las" facade
check arches scanned "$work/arches.las" facade
check solids scanned "$work/facade.las" extrusion
check outlines scanned "$work/arches.las" outlines
for day in 1 4; do
  "$build/src/jalon" scan --quiet --scene earthworks --scene-set "$grid" --scene-set day=$day --method sample \
    --set points=300000 --set seed=$day -o "$work/day$day.las" || { failed=$((failed + 1)); echo "not ok - no scan of day $day"; }
done
# The model of strips that an adjustment gives, with attributes of what moved it.
if [ -n "$cjval" ]; then
  "$build/src/jalon" scan --method mobile -o "$work/drive.ply" --model "$work/street.obj" --trajectory "$work/drive.txt" --quiet \
    --scene-set sigma_position_m=1 --scene-set leg_m=60 &&
    "$build/src/jalon" adjust "$work/street.obj" "$work/drive.ply" "$work/drive.txt" -o "$work/adjusted" --quiet --strips-set touch_m=2 &&
    "$cjval" "$work/adjusted/model.city.json" >"$work/adjusted.report" &&
    "$python" -c 'import json, sys; r = json.load(sys.stdin); sys.exit(not r["valid"] or r["has_warnings"])' <"$work/adjusted.report" &&
    { passed=$((passed + 1)); echo "ok - cjval: the model of an adjustment is valid"; } ||
    { failed=$((failed + 1)); echo "not ok - cjval: the model of an adjustment is valid"; }
fi
# The models above as glTF: those with parts by way of CityJSON, the earth's mesh as OBJ.
if [ -n "$gltf" ]; then
  files=()
  for name in house facade arches solids outlines; do
    "$build/src/jalon" convert --quiet "$work/$name/model.city.json" "$work/$name/model.glb" && files+=("$work/$name/model.glb") ||
      { failed=$((failed + 1)); echo "not ok - $name: no glTF"; }
  done
  count glTF node "$here/check_glb.js" "$gltf" "${files[@]}"
fi
count "drawings by ezdxf" "$python" "$here/check_dxf_read.py" "$build/src/jalon" "$work"
# IFC by ifcopenshell, in the long run: its installation is large.
if [ -n "${JALON_FULL:-}" ]; then
  bim=$build/bim
  [ -x "$bim/bin/python" ] && "$bim/bin/python" -c "import ifcopenshell, numpy, pytest" 2>/dev/null ||
    { python3 -m venv "$bim" && "$bim/bin/pip" install --disable-pip-version-check ifcopenshell numpy pytest; } >>"$log" 2>&1
  if "$bim/bin/python" -c "import ifcopenshell, numpy, pytest" 2>/dev/null; then
    for name in house facade arches solids outlines; do
      count "IFC of $name" "$bim/bin/python" "$here/check_ifc.py" "$name" "$work/$name"
    done
    # Facades drawn by the grammar: kinds, openings and misfits that nobody chose.
    for seed in $(seq 4001 4050); do
      "$build/src/jalon" scan --quiet --scene grammar --set seed="$seed" --scene-set spacing_m=0.05 -o "$work/drawn.las" &&
        mkdir -p "$work/drawn$seed" && scanned "$work/drawn.las" facade "$work/drawn$seed" ||
        { failed=$((failed + 1)); echo "not ok - grammar $seed: no files"; continue; }
      count "IFC of grammar $seed" "$bim/bin/python" "$here/check_ifc.py" "grammar $seed" "$work/drawn$seed"
      rm -r "$work/drawn$seed"
    done
  else
    miss ifcopenshell
  fi
fi
# orthoimages FOLDER SCAN OPTION ...: fills the folder with those of a scan and its model's GeoPackage.
orthoimages() { "$build/src/jalon" facade "${@:2}" -o "$1" --quiet --orthoimage both --viewer-points 0; }
# depths FOLDER SCAN: fills the folder with the scan as text, a depth map of each of its stations and a depth image.
depths() {
  "$build/src/jalon" convert --quiet "$2" "$1/scan.xyz" && "$build/src/jalon" convert --quiet "$2" "$1/front.png" &&
    "$build/src/jalon" compare --quiet "$2" "$2" -o "$1" --depth-maps --viewer-points 0
}
# without_a_word TOOL FILE ...: GDAL's own tools read each file whole and have nothing to say of it.
without_a_word() {
  local tool=("$1") file
  [ "$1" = gdalinfo ] && tool+=(-checksum -stats --config GDAL_PAM_ENABLED NO) || tool+=(-ro -al)
  for file in "${@:2}"; do
    if "${tool[@]}" "$file" >/dev/null 2>"$work/words" && [ ! -s "$work/words" ]; then
      passed=$((passed + 1)); echo "ok - $1 reads ${file#"$work/"}"
    else
      failed=$((failed + 1)); echo "not ok - $1 reads ${file#"$work/"}"; head -n 3 "$work/words"
    fi
  done
}
# GeoPackage, GeoTIFF and depths by Debian's GDAL, in the long run too: pyogrio has neither validate_gpkg nor GDAL's Python.
if [ -n "${JALON_FULL:-}" ]; then
  . "$here/../../examples/packages.sh"
  need_packages gdal-bin python3-gdal >>"$log" 2>&1
  if /usr/bin/python3 -c "from osgeo import ogr" 2>>"$log"; then
    for name in house facade arches solids outlines; do
      count "GeoPackage of $name" /usr/bin/python3 "$here/check_gpkg.py" "$name" "$work/$name"
    done
    "$build/src/jalon" convert --quiet "$work/facade.las" "$work/plain.xyz" &&
      awk 'NF > 2 && $1 ~ /^[0-9]/ { print $1, $2, $3, NR % 256, NR % 199, 77 }' "$work/plain.xyz" >"$work/coloured.xyz"
    orthoimages "$work/distances" "$work/facade.las" && orthoimages "$work/colours" "$work/coloured.xyz" --columns "x y z r g b" ||
      { failed=$((failed + 1)); echo "not ok - no orthoimages"; }
    for name in distances colours; do
      count "GeoTIFF of $name" /usr/bin/python3 "$here/check_tiff.py" "$name" "$work/$name"
      count "images of $name" "$python" "$here/check_images.py" "$name" "$work/$name"
    done
    for name in facade arches; do
      mkdir "$work/depths_$name" && depths "$work/depths_$name" "$work/$name.las" ||
        { failed=$((failed + 1)); echo "not ok - $name: no depths"; continue; }
      count "depths of $name" /usr/bin/python3 "$here/check_depths.py" "$name" "$work/depths_$name"
    done
    if command -v gdalinfo >/dev/null && command -v ogrinfo >/dev/null; then
      without_a_word gdalinfo "$work"/{distances,colours}/orthoimage*.{png,tif} "$work"/depths_*/{depth_*.{png,tif},front.png}
      without_a_word ogrinfo "$work"/{house,facade,arches,solids,outlines}/model.gpkg "$work"/depths_*/regions.geojson
    else
      miss gdal-bin
    fi
  else
    miss python3-gdal
  fi
fi
changed() { "$programs/scan_files" "$work/day4.las" changes "$1" "$work/day1.las"; }
check changes changed
finish

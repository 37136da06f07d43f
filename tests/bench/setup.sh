#!/usr/bin/env bash
# SPDX-FileCopyrightText: 2026 The Jalon authors
# SPDX-License-Identifier: Apache-2.0
#
# setup.sh FOLDER: gets the peers of the benchmarks on Debian 12. Packages from apt (only the missing
# ones; by sudo when not root), the rest from PyPI into FOLDER: a Python environment with Open3D and py4dgeo, and
# the sources of small_gicp (C++ headers) and LASzip (inside those of the Python package laszip).
# Never needed by the library, its tests or CI. Does nothing twice.
set -euo pipefail

folder=${1:?usage: setup.sh FOLDER, the JALON_BENCH_PEERS of CMake: BUILD/peers by default}
. "$(dirname "$0")/../../examples/packages.sh"
need_packages "${build_packages[@]}" libpcl-dev libflann-dev liblz4-dev libnanoflann-dev libcgal-dev libgmp-dev libmpfr-dev libtbb-dev \
  python3 python3-venv libgomp1 libx11-6 libgl1

mkdir -p "$folder"
cd "$folder"
if [[ ! -x venv/bin/python ]]; then python3 -m venv venv; fi
# Open3D has wheels for Python up to 3.12; Debian 12 has 3.11.
if ! venv/bin/python -c 'import numpy, open3d' 2>/dev/null; then
  venv/bin/python -m pip install --quiet numpy open3d
fi
if ! venv/bin/python -c 'import py4dgeo' 2>/dev/null; then
  venv/bin/python -m pip install --quiet py4dgeo==1.2.0
fi
for peer in small_gicp==1.0.1 laszip==0.3.0; do
  name=${peer%%==*}
  unpacked=$name-${peer##*==}
  if [[ -d $unpacked ]]; then continue; fi
  rm -rf download
  venv/bin/python -m pip download --quiet --no-deps --no-binary :all: --dest download "$peer"
  tar -xzf download/"$unpacked".tar.gz
  rm -rf download
done
echo "peers are in $(pwd)"

#!/usr/bin/env bash
# SPDX-FileCopyrightText: 2026 The Jalon authors
# SPDX-License-Identifier: Apache-2.0
# need_packages NAME ...: installs those of Debian's packages that are missing, and nothing otherwise. Sourced by
# examples/run.sh and tests/run.sh.
need_packages() {
  local missing=() name
  for name in "$@"; do
    dpkg-query -W -f='${db:Status-Status}' "$name" 2>/dev/null | grep -qx installed || missing+=("$name")
  done
  [ ${#missing[@]} -eq 0 ] && return 0
  echo "installing: ${missing[*]}"
  local sudo=()
  [ "$(id -u)" -eq 0 ] || sudo=(sudo)
  "${sudo[@]}" env DEBIAN_FRONTEND=noninteractive apt-get -qq update >/dev/null
  "${sudo[@]}" env DEBIAN_FRONTEND=noninteractive apt-get -qq install -y --no-install-recommends "${missing[@]}" >/dev/null
}

# What the library and its command line tool are built with.
build_packages=(g++ cmake ninja-build libeigen3-dev libboost-dev nlohmann-json3-dev libcli11-dev libfcl-dev libccd-dev libsqlite3-dev zlib1g-dev libpng-dev)
# What the bindings are built with beside: Python, Java and C#; each is left out where its tools are missing.
binding_packages=(swig python3-dev default-jdk-headless mono-mcs mono-runtime libmono-system-core4.0-cil unzip patchelf)

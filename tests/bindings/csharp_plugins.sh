#!/usr/bin/env bash
# SPDX-FileCopyrightText: 2026 The Jalon authors
# SPDX-License-Identifier: Apache-2.0
# The package within plug-ins, whose folders are not that of the host: csharp_plugins.sh PACKAGE_FOLDER (as unpacked). The
# native library lies in runtimes/ beside the assembly, as NuGet restores it, or flat beside it, as publishing for one platform does.
set -uo pipefail
here=$(cd "$(dirname "$0")" && pwd)
package=$(cd "$1" && pwd)
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
passed=0 failed=0

mkdir "$work/host" "$work/packaged" "$work/flat"
cp -r "$package/runtimes" "$work/packaged"
cp "$package"/runtimes/*/native/* "$work/flat"
for plugin in packaged flat; do
  cp "$package/lib/netstandard2.0/Jalon.dll" "$work/$plugin"
  mcs -nologo -warnaserror -target:library "-r:$work/$plugin/Jalon.dll" "-out:$work/$plugin/Plugin.dll" "$here/plugins/Plugin.cs" || exit 1
done
mcs -nologo -warnaserror "-out:$work/host/host.exe" "$here/plugins/Host.cs" || exit 1

host() { (cd / && env -i PATH="$PATH" HOME="$work" mono "$work/host/host.exe" "$@"); }
# works NAME MANNER FOLDER ...: the plug-in of each folder says what it did.
works() {
  local name=$1 lines=$(($# - 2))
  shift
  host "$@" >"$work/said" 2>"$work/log"
  if [ "$(grep -c ', 3 points$' "$work/said")" -eq $lines ]; then passed=$((passed + 1)); echo "ok - plug-in: $name"; else
    failed=$((failed + 1)); echo "not ok - plug-in: $name"; head -n 8 "$work/log"
  fi
}

works "loaded from its folder, the native library in runtimes" from "$work/packaged"
works "loaded from its folder, the native library beside it" from "$work/flat"
works "two in one process, each with a copy of its own" from "$work/packaged" "$work/flat"
works "in a domain of its own, twice, unloaded between" domain "$work/packaged" "$work/packaged"
works "run as a copy in the host's cache, the native library in runtimes" shadow "$work/packaged"
works "run as a copy in the host's cache, the native library beside the original" shadow "$work/flat"
if host bytes "$work/packaged" >"$work/said" 2>&1; then failed=$((failed + 1)); echo "not ok - plug-in: of bytes, it has found something"; else
  grep -q "DllNotFoundException: .*Tried: $work/host/" "$work/said" && passed=$((passed + 1)) && echo "ok - plug-in: of bytes, it says where it looked" ||
    { failed=$((failed + 1)); echo "not ok - plug-in: of bytes"; head -n 5 "$work/said"; }
fi
cp -r "$package/runtimes" "$work/host"
works "of bytes, the native library with the host" bytes "$work/packaged"
echo "$passed passed, $failed failed, 0 skipped"
[ $failed -eq 0 ]

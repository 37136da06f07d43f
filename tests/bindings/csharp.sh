#!/usr/bin/env bash
# SPDX-FileCopyrightText: 2026 The Jalon authors
# SPDX-License-Identifier: Apache-2.0
# C# from the package, unpacked where nothing else is: the tests, and the examples with the numbers of their C twins.
# csharp.sh BUILD_FOLDER; JALON_FULL=1 runs 10 000 cycles of every kind.
set -uo pipefail
root=$(cd "$(dirname "$0")/../.." && pwd)
build=$(cd "$1" && pwd)
for tool in mcs mono unzip; do
  command -v $tool >/dev/null || { echo "skipped: $tool is missing"; exit 77; }
done
package=$(ls "$build"/bindings/Jalon.*.nupkg 2>/dev/null | head -n 1)
[ -n "$package" ] || { echo "skipped: the package was not built"; exit 77; }
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
passed=0 failed=0 skipped=0

# check NAME COMMAND ...: one behaviour.
check() {
  local name=$1
  shift
  if "$@" >"$work/log" 2>&1; then passed=$((passed + 1)); echo "ok - $name"; else
    failed=$((failed + 1)); echo "not ok - $name"; tail -n 8 "$work/log"
  fi
}

# add_up: takes over what a test program counted and how it ended.
add_up() {
  local p f s code=$1
  grep -vE '^[0-9]+ passed, ' "$work/tests.log" # they are added up below
  read -r p f s < <(awk '/^[0-9]+ passed, [0-9]+ failed, [0-9]+ skipped$/ { print $1, $3, $5 }' "$work/tests.log")
  passed=$((passed + ${p:-0})) failed=$((failed + ${f:-0})) skipped=$((skipped + ${s:-0}))
  [ "$code" -eq 0 ] || [ "${f:-0}" -gt 0 ] || { failed=$((failed + 1)); echo "not ok - the program ended with $code"; }
}

# As on a machine without FCL and libccd, where such a place can be made.
hidden=(bash "$root/tests/bindings/hidden.sh")
if ! "${hidden[@]}" true 2>"$work/log"; then
  echo "skipped: the system's FCL cannot be hidden: $(cat "$work/log")"
  hidden=() skipped=$((skipped + 1))
fi

# clean FOLDER COMMAND ...: with nothing of this environment but what finds the tools, in a decimal-comma locale.
clean() {
  local folder=$1
  shift
  (cd "$work" && "${hidden[@]}" env -i PATH="$PATH" HOME="$work" LC_ALL="${JALON_COMMA_LOCALE:-C.UTF-8}" JALON_FULL="${JALON_FULL:-}" \
    MONO_PATH="$work/package/lib/$folder" "$@")
}

check "package: it unpacks" unzip -q -d "$work/package" "$package"
check "package: assemblies, native library, documentation" bash -c "cd '$work/package' && ls lib/netstandard2.0/Jalon.dll \
  lib/netstandard2.0/Jalon.xml lib/netstandard2.1/Jalon.dll runtimes/*/native/libjalon_csharp.so runtimes/*/native/libjalon.so.* \
  build/netstandard2.0/Jalon.targets Jalon.nuspec README.md '[Content_Types].xml' _rels/.rels"
check "package: its XML is well-formed" python3 -c "import glob, xml.dom.minidom as x
[x.parse(f) for f in glob.glob('$work/package/**/*.xml', recursive=True) + glob.glob('$work/package/*.nuspec')]"
python3 "$root/tests/bindings/closure.py" csharp "$(ls -d "$work"/package/runtimes/*/native)" \
  "$work/package/THIRD-PARTY-LICENSES.txt" >"$work/tests.log" 2>&1
add_up $?

# The tests, with spans and without.
for framework in netstandard2.1 netstandard2.0; do
  define=""
  [ $framework = netstandard2.0 ] || define=-define:JALON_SPANS
  only=""
  [ $framework = netstandard2.1 ] || only=Arrays # the others are the same code
  check "tests compile for $framework" mcs -nologo -langversion:7.2 -warnaserror $define "-r:$work/package/lib/$framework/Jalon.dll" \
    "-out:$work/tests.exe" "$root"/tests/bindings/csharp/*.cs
  clean $framework mono --debug "$work/tests.exe" $only >"$work/tests.log" 2>&1
  add_up $?
done

# Every public member is called with real data: as Mono's own trace tells, which says LEAVE of what returned and not of what threw.
record=$build/work/bindings_called/csharp
mkdir -p "$record"
check "tests compile for the trace" mcs -nologo -langversion:7.2 -warnaserror -define:JALON_SPANS \
  "-r:$work/package/lib/netstandard2.1/Jalon.dll" "-out:$work/tests.exe" "$root"/tests/bindings/csharp/*.cs
clean netstandard2.1 mono "$work/tests.exe" --public | sort -u >"$record/public.txt"
clean netstandard2.1 mono -O=-inline --trace=N:Jalon "$work/tests.exe" EveryCall Parameters. Arrays. Calls.Failures |
  grep -aoE 'LEAVE: [^:(]*:[^(]*\([^)]*\)' |
  sed -E 's/^LEAVE: //; s/([A-Za-z_]+\.)+([A-Za-z])/\2/g; s/:/./; s/ \(/(/; s/,/, /g; s/\[, \]/[,]/g; s/<[^<>(]*>\(/(/' | sort -u >"$record/called.txt"
check "tests pass under the trace" test "${PIPESTATUS[0]}" -eq 0
python3 "$root/tests/bindings/called_jvm.py" csharp "$record" >"$work/tests.log"
add_up $?

# What is said where the native library is missing.
mkdir "$work/bare" && cp "$work/package/lib/netstandard2.0/Jalon.dll" "$work/bare"
cat >"$work/bare.cs" <<'END'
class Bare { static void Main() { System.Console.WriteLine(Jalon.Library.Version()); } }
END
check "loader: a bare program compiles" mcs -nologo "-r:$work/bare/Jalon.dll" "-out:$work/bare/bare.exe" "$work/bare.cs"
check "loader: it says what it tried" bash -c "! env -i PATH='$PATH' HOME='$work' mono '$work/bare/bare.exe' 2>'$work/said' && \
  grep -q 'DllNotFoundException' '$work/said' && grep -q 'Tried: .*runtimes' '$work/said'"
check "loader: JALON_NATIVE names a folder" env JALON_NATIVE="$(ls -d "$work"/package/runtimes/*/native)" mono "$work/bare/bare.exe"
cp -r "$work/package/runtimes" "$work/bare"
check "loader: runtimes beside the program" env -i PATH="$PATH" HOME="$work" mono "$work/bare/bare.exe"
bash "$root/tests/bindings/csharp_plugins.sh" "$work/package" >"$work/tests.log" 2>&1
add_up $?

# The examples print what their C twins print.
scan() { "$build/src/jalon" scan --quiet -o "$work/$1" "${@:2}"; }
scan facade.las --scene facade --set horizontal_step_rad=0.004 --set vertical_step_rad=0.004
scan second.las --scene facade --set horizontal_step_rad=0.004 --set vertical_step_rad=0.004 --set seed=2
for day in 1 3; do
  scan day$day.las --scene earthworks --scene-set day=$day --set horizontal_step_rad=0.001 --set vertical_step_rad=0.001
done
scan drive.ply --method mobile --model "$work/street.obj" --trajectory "$work/drive.txt" --scene-set sigma_position_m=1 \
  --scene-set leg_m=60 --set revolutions_per_s=10
same() { # same EXAMPLE ARGUMENT ...: the outputs and the exit status
  local name=$1 c cs
  shift
  "$build/examples/example_$name" "$@" >"$work/c.txt" 2>/dev/null
  c=$?
  clean netstandard2.0 mono "$work/$name.exe" "$@" >"$work/cs.txt" 2>"$work/cs.err"
  cs=$?
  cat "$work/cs.err"
  [ $c -eq $cs ] && diff "$work/c.txt" "$work/cs.txt"
}
for source in "$root"/examples/csharp/0*.cs; do
  name=$(basename "$source" .cs)
  check "example $name compiles" mcs -nologo -warnaserror "-r:$work/package/lib/netstandard2.0/Jalon.dll" "-out:$work/$name.exe" \
    "$source" "$root/examples/csharp/Print.cs"
done
check "example 01_planes prints what C prints" same 01_planes "$work/facade.las"
check "example 01_planes fails as C fails" same 01_planes "$work/none.las"
check "example 02_progress prints what C prints" same 02_progress
check "example 03_model prints what C prints" same 03_model "$work/facade.las" "$work/facade.dxf"
check "example 04_register prints what C prints" same 04_register "$work/facade.las" "$work/second.las" "$work/registered.las"
check "example 05_changes prints what C prints" same 05_changes "$work/day1.las" "$work/day3.las"
check "example 05_changes has something to compare" grep -q '^region 2' "$work/cs.txt"
check "example 06_joint prints what C prints" same 06_joint "$work/street.obj" "$work/drive.ply" "$work/drive.txt" "$work/adjusted.txt"
printf '1;0;0;10;300.2\n2;22;0;10;300.4\n3;22;8;10;300.4\n4;0;8;10;300.4\n5;0;0;0;300.4\n6;0.971;0.2;4.18;360\n7;2.171;0.2;5.827;360\n8;10.4;0;7.347;361\n9;10.4;0.15;7.347;361.8\n10;11.6;0;8.994;361\n' >"$work/codes.txt"
check "example 07_feature_codes prints what C prints" same 07_feature_codes "$work/facade.las" "$work/codes.txt" "$work/classified.las" "$work/objects.dxf"

# The page: its programs compile and run, its commands do what they say.
page=$work/page
python3 "$root/tests/bindings/pages.py" "$root/bindings/csharp/README.md" "$page" .cs >"$work/programs"
cp "$package" "$page" && cp "$work/facade.las" "$page/scan.las"
for command in unzip mcs MONO_PATH; do
  line=$(grep "^$command" "$page/commands.txt")
  check "the page's command runs: $line" bash -c "cd '$page' && ${line%% \#*}"
done
# said CLASS PATTERN ARGUMENT ...: the program compiles, ends well and says so.
said() {
  local class=$1 pattern=$2
  shift 2
  mcs -nologo -warnaserror "-r:$work/package/lib/netstandard2.0/Jalon.dll" "-out:$page/$class.exe" "$page/$class.cs" &&
    clean netstandard2.0 mono "$page/$class.exe" "$@" >"$work/said.txt" 2>&1 && grep -q "$pattern" "$work/said.txt" ||
    { cat "$work/said.txt"; return 1; }
}
check "the page's Planes runs" said Planes ' planes, the largest of ' "$work/facade.las"
bash "$root/tests/bindings/first_day.sh" scan "$build/src/jalon" "$work"
check "the page's FirstDay runs" said FirstDay 'the lorry passes' "$work/before.las" "$work/after.las" "$work/first"
check "the page's FirstDay prints what all languages print" bash "$root/tests/bindings/first_day.sh" said "$work/said.txt"
check "the page's FirstDay writes a scan, a report and bytes" test -s "$work/first.las" -a -s "$work/first.html" -a -s "$work/first.bytes"
check "the page has no other program" test "$(sort "$work/programs" | tr '\n' ' ')" = "FirstDay Planes "

echo "$passed passed, $failed failed, $skipped skipped"
[ $failed -eq 0 ]

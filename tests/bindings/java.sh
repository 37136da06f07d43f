#!/usr/bin/env bash
# SPDX-FileCopyrightText: 2026 The Jalon authors
# SPDX-License-Identifier: Apache-2.0
# The jar in a folder of its own, on a class path and nothing else: behaviours, loader, examples against those in C, Javadoc, JUnit.
# java.sh BUILD_FOLDER
set -uo pipefail
build=$(cd "$1" && pwd)
root=$(cd "$(dirname "$0")/../.." && pwd)
[ -f "$build/bindings/java/jalon.jar" ] || { echo "skipped: the Java binding was not built, its tools are missing"; exit 77; }
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
passed=0 failed=0 skipped=0
pass() { echo "ok - $1"; passed=$((passed + 1)); }
miss() { echo "not ok - $1"; failed=$((failed + 1)); tail -n 10 "$work/log"; }
check() { local name=$1; shift; if "$@" >"$work/log" 2>&1; then pass "$name"; else miss "$name"; fi; }
skip() { echo "skipped: $1"; skipped=$((skipped + 1)); }

# counts_of LOG: shows what a program said of its behaviours, and adds up what it counted.
counts_of() {
  local p f s
  grep -E '^(ok|not ok|skipped|FIGURE|    )|^	at|^[a-z.]*[A-Za-z]+(Error|Exception)' "$1"
  read -r p f s < <(awk '/^[0-9]+ passed/ { print $1, $3, $5; seen = 1 } END { if (!seen) print 0, 1, 0 }' "$1")
  passed=$((passed + p)) failed=$((failed + f)) skipped=$((skipped + s))
}

cp "$build/bindings/java/jalon.jar" "$work"
mkdir "$work/tmp"
# A heap of fixed size, so that the resident memory is the library's.
# As on a machine without FCL and libccd, where such a place can be made.
hidden=(bash "$root/tests/bindings/hidden.sh")
"${hidden[@]}" true 2>"$work/log" || { hidden=(); skip "the system's FCL cannot be hidden: $(cat "$work/log")"; }
clean=("${hidden[@]}" env -i "PATH=$PATH" "JALON_FULL=${JALON_FULL:-}" LC_ALL=C.UTF-8)
java=("${clean[@]}" java -XX:+UseSerialGC -Xms64m -Xmx64m -XX:+AlwaysPreTouch "-Djava.io.tmpdir=$work/tmp")

# ---- behaviours, without any test framework, under JNI's own checks; JUnit runs them without, at the end ----
tests=$root/bindings/java/src/test/java/org/jalon
check "the tests compile" javac --release 11 -Xlint:all -Werror -encoding UTF-8 -cp "$work/jalon.jar" -d "$work/tests" \
  $(ls "$tests"/*.java | grep -v BehavioursTest)
"${java[@]}" -Xcheck:jni -cp "$work/jalon.jar:$work/tests" org.jalon.Behaviours >"$work/log" 2>&1
counts_of "$work/log"
check "JNI's checks find nothing" bash -c '! grep -E "^(WARNING|FATAL)" "$0"' "$work/log"

# ---- every public member is called with real data: seen by the virtual machine ----
record=$build/work/bindings_called/java
mkdir "$work/classes" && (cd "$work/classes" && jar xf "$work/jalon.jar" org)
"${clean[@]}" java "$root/tests/bindings/java/Called.java" "$work/classes" "$work/jalon.jar:$work/tests" "$record" \
  "org.jalon.Behaviours every_call setters errors__one lists tasks__progress" -Xmx256m "-Djava.io.tmpdir=$work/tmp" >"$work/log" 2>&1 ||
  miss "the tests pass under the debugger's interface"
python3 "$root/tests/bindings/called_jvm.py" java "$record" >"$work/called.log" 2>&1
counts_of "$work/called.log"

# ---- the loader ----
check "the loader leaves nothing behind" test -z "$(ls "$work/tmp")"
mkdir "$work/bare" && (cd "$work/bare" && jar xf "$work/jalon.jar" org)
"${java[@]}" -Djalon.library.path=/no/where -cp "$work/bare:$work/tests" org.jalon.Behaviours >"$work/loader.log" 2>&1
for place in "jalon.library.path: .*/no/where" "the jar: it has no /native/" "java.library.path: "; do
  check "without a native library the error names ${place%%:*}" grep -q "$place" "$work/loader.log"
done
mkdir "$work/own" && (cd "$work/own" && jar xf "$work/jalon.jar" native META-INF)
own=$(dirname "$(ls "$work"/own/native/*/files.txt)")
python3 "$root/tests/bindings/closure.py" java "$own" "$work/own/META-INF/THIRD-PARTY-LICENSES.txt" >"$work/closure.log" 2>&1
counts_of "$work/closure.log"
check "jalon.library.path takes a folder" "${java[@]}" "-Djalon.library.path=$own" -cp "$work/bare:$root/examples/java" \
  "$root/examples/java/Progress.java"

# ---- the same scenarios as in C print the same ----
examples=$build/examples cli=$build/src/jalon
"$cli" scan --scene facade -o "$work/sample.las" --quiet --set horizontal_step_rad=0.004 --set vertical_step_rad=0.004
"$cli" scan --scene facade -o "$work/second.las" --quiet --set horizontal_step_rad=0.004 --set vertical_step_rad=0.004 --set seed=2
for day in 1 3; do
  "$cli" scan --scene earthworks -o "$work/day$day.las" --quiet --scene-set "day=$day" \
    --set horizontal_step_rad=0.001 --set vertical_step_rad=0.001
done
"$cli" scan --method mobile -o "$work/drive.ply" --model "$work/street.obj" --trajectory "$work/drive.txt" --quiet \
  --scene-set sigma_position_m=1 --scene-set leg_m=60 --set revolutions_per_s=10
check "the examples compile" javac --release 11 -Xlint:all -Werror -cp "$work/jalon.jar" -d "$work/examples" "$root"/examples/java/*.java
# twin C_NAME JAVA_CLASS ARGUMENT ...
twin() {
  local c=$1 class=$2
  shift 2
  [ -x "$examples/example_$c" ] || { skip "$c is not built"; return; }
  "$examples/example_$c" "$@" >"$work/c.txt" 2>"$work/log" || miss "$c runs"
  "${clean[@]}" java -cp "$work/jalon.jar:$work/examples" "$class" "$@" >"$work/java.txt" 2>>"$work/log" || miss "$class runs"
  diff "$work/c.txt" "$work/java.txt" >>"$work/log" && [ -s "$work/java.txt" ]
  if [ $? -eq 0 ]; then pass "$class prints what $c prints"; else miss "$class prints what $c prints"; fi
}
twin 01_planes Planes "$work/sample.las"
twin 02_progress Progress
twin 03_model FacadeModel "$work/sample.las" "$work/model.dxf"
twin 04_register Register "$work/sample.las" "$work/second.las" "$work/registered.las"
twin 05_changes Changes "$work/day1.las" "$work/day3.las"
twin 06_joint Joint "$work/street.obj" "$work/drive.ply" "$work/drive.txt" "$work/adjusted.txt"
printf '1;0;0;10;300.2\n2;22;0;10;300.4\n3;22;8;10;300.4\n4;0;8;10;300.4\n5;0;0;0;300.4\n6;0.971;0.2;4.18;360\n7;2.171;0.2;5.827;360\n8;10.4;0;7.347;361\n9;10.4;0.15;7.347;361.8\n10;11.6;0;8.994;361\n' >"$work/codes.txt"
twin 07_feature_codes FeatureCodes "$work/sample.las" "$work/codes.txt" "$work/classified.las" "$work/objects.dxf"

# ---- the page: its programs compile and run, its commands do what they say ----
page=$work/page
python3 "$root/tests/bindings/pages.py" "$root/bindings/java/README.md" "$page" .java >"$work/programs"
mkdir -p "$page/build" && ln -s "$build" "$page/build/release" && cp "$work/sample.las" "$page/scan.las"
for command in javac java; do
  line=$(grep "^$command -cp" "$page/commands.txt")
  check "the page's command runs: $line" bash -c "cd '$page' && ${line%% \#*}"
done
check "the page's programs compile" javac --release 11 -Xlint:all -Werror -cp "$work/jalon.jar" -d "$page" "$page"/*.java
# said CLASS PATTERN ARGUMENT ...: the program ends well and says so.
said() {
  local class=$1 pattern=$2
  shift 2
  (cd "$page" && "${clean[@]}" java -cp "$work/jalon.jar:." "$class" "$@") >"$work/said.txt" 2>&1 && grep -q "$pattern" "$work/said.txt" ||
    { cat "$work/said.txt"; return 1; }
}
check "the page's Planes runs" said Planes '^[0-9.]* m2$' "$work/sample.las"
check "the page's Patience runs" said Patience cancelled "$work/sample.las"
bash "$root/tests/bindings/first_day.sh" scan "$cli" "$work"
check "the page's FirstDay runs" said FirstDay 'the lorry passes' "$work/before.las" "$work/after.las" "$work/first"
check "the page's FirstDay prints what all languages print" bash "$root/tests/bindings/first_day.sh" said "$work/said.txt"
check "the page's FirstDay writes a scan, a report and bytes" test -s "$work/first.las" -a -s "$work/first.html" -a -s "$work/first.bytes"
check "the page has no other program" test "$(sort "$work/programs" | tr '\n' ' ')" = "FirstDay Patience Planes "

# ---- every public class and method of nouns has its comment; the documentation builds ----
check "Javadoc builds" javadoc -quiet -Xdoclint:none -public -encoding UTF-8 -d "$work/doc" "$build"/bindings/java/sources/org/jalon/*.java
check "Javadoc has the comments of the headers" grep -q "distinct clouds are free of each other\|Distinct clouds are free of each other" \
  "$work/doc/org/jalon/Cloud.html"

# ---- JUnit, from Maven's cache or Maven Central ----
version=1.10.2
name=junit-platform-console-standalone
junit=${HOME:-/nonexistent}/.m2/repository/org/junit/platform/$name/$version/$name-$version.jar
if [ ! -f "$junit" ] && command -v mvn >/dev/null; then
  timeout 90 mvn -q -B org.apache.maven.plugins:maven-dependency-plugin:3.6.1:get \
    "-Dartifact=org.junit.platform:$name:$version" >"$work/mvn.log" 2>&1
fi
if [ -f "$junit" ]; then
  check "the JUnit tests compile" javac --release 11 -encoding UTF-8 -cp "$work/jalon.jar:$junit" -d "$work/junit" "$tests"/*.java
  JALON_FULL='' check "the JUnit tests pass" "${java[@]}" -jar "$junit" execute -cp "$work/jalon.jar:$work/junit" \
    --scan-classpath --details=summary --disable-banner
else
  skip "JUnit cannot be had from Maven's cache or Maven Central"
  "${java[@]}" -cp "$work/jalon.jar:$work/tests" org.jalon.Behaviours >"$work/log" 2>&1
  counts_of "$work/log"
fi
echo "$passed passed, $failed failed, $skipped skipped"
[ $failed -eq 0 ]

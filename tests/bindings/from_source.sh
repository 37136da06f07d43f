#!/usr/bin/env bash
# SPDX-FileCopyrightText: 2026 The Jalon authors
# SPDX-License-Identifier: Apache-2.0
# What a user does who has the sources: pip install . in a fresh virtual environment, mvn package over a build, and what the pages of
# Java and C# say for an installed library.
# from_source.sh BUILD_FOLDER. It compiles the library once more and needs PyPI and Maven Central; a part whose index cannot be
# reached is skipped, visibly.
set -uo pipefail
root=$(cd "$(dirname "$0")/../.." && pwd)
build=$(realpath "${1:?usage: from_source.sh BUILD_FOLDER}")
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
passed=0 failed=0 skipped=0
check() { # check NAME COMMAND ...
  local name=$1 begin=$SECONDS
  shift
  if "$@" >"$work/log" 2>&1; then passed=$((passed + 1)); echo "ok - from source: $name ($((SECONDS - begin)) s)"; else
    failed=$((failed + 1)); echo "not ok - from source: $name"; tail -n 15 "$work/log"; return 1
  fi
}
skip() { echo "skipped: $1"; skipped=$((skipped + 1)); }
elsewhere() { (cd "$work" && env -u PYTHONPATH -u LD_LIBRARY_PATH "$@"); }

# ---- pip install . in a fresh environment: the build's own needs come from PyPI, and so does NumPy ----
python=$work/venv/bin/python
python3 -m venv "$work/venv"
if "$work/venv/bin/pip" download --disable-pip-version-check -q --no-deps -d "$work/probe" scikit-build-core >"$work/log" 2>&1; then
  check "the sources are cloned" git clone -q "$root" "$work/source"
  check "pip install ." elsewhere env CCACHE_BASEDIR="$work/source" "$work/venv/bin/pip" install --disable-pip-version-check \
    "$work/source" && {
    check "it is the installed package that answers" elsewhere "$python" -P -c "import jalon, sys; assert jalon.__file__.startswith(sys.prefix)"
    check "the sources have nothing new but what git ignores" test -z "$(git -C "$work/source" status --porcelain)"
    check "NumPy came with it" elsewhere "$python" -P -c "import numpy"
    check "its libraries stand alone" python3 "$root/tests/bindings/closure.py" python_from_source \
      "$(echo "$work"/venv/lib/python3*/site-packages/jalon)" "$root/bindings/THIRD-PARTY-LICENSES.txt"
    "$build/examples/example_02_progress" >"$work/c.txt"
    elsewhere "$python" -P "$root/examples/python/02_progress.py" >"$work/python.txt"
    check "example 02_progress prints what C prints" diff "$work/c.txt" "$work/python.txt"
  }
else
  skip "PyPI cannot be reached"
fi

# ---- the pages of Java and C#: the binding alone, over an installed library ----
# over_installed LANGUAGE MADE: the two commands of the page, in a copy of the sources; MADE is what they make.
over_installed() {
  local language=$1 made=$2
  python3 "$root/tests/bindings/pages.py" "$root/bindings/$language/README.md" "$work/$language" .txt >/dev/null
  grep -E "JALON_INSTALLED|^ninja -C build/$language" "$work/$language/commands.txt" |
    sed "s|PREFIX_PATH=PREFIX|PREFIX_PATH=$work/prefix|; s| *#.*||" >"$work/$language/commands.sh"
  check "the page of $language has its two commands" test "$(wc -l <"$work/$language/commands.sh")" -eq 2
  check "the page's commands make the binding of $language" bash -ec "cd '$work/tree' && . '$work/$language/commands.sh'"
  check "they make $made" bash -c "ls '$work/tree/build/$language/bindings/'$made"
}
check "the library is installed" cmake --install "$build" --prefix "$work/prefix"
check "the sources are cloned once more" git clone -q "$root" "$work/tree"
"$build/examples/example_02_progress" >"$work/c.txt" 2>/dev/null
if command -v swig >/dev/null && command -v javac >/dev/null; then
  over_installed java java/jalon.jar
  elsewhere java -cp "$work/tree/build/java/bindings/java/jalon.jar" "$root/examples/java/Progress.java" >"$work/java.txt" 2>/dev/null
  check "example Progress over an installed library prints what C prints" diff "$work/c.txt" "$work/java.txt"
else
  skip "SWIG or a JDK is missing"
fi
if command -v swig >/dev/null && command -v mcs >/dev/null; then
  over_installed csharp 'Jalon.*.nupkg'
  unzip -q -d "$work/nuget" "$work"/tree/build/csharp/bindings/Jalon.*.nupkg
  mcs -nologo "-r:$work/nuget/lib/netstandard2.0/Jalon.dll" "-out:$work/progress.exe" "$root"/examples/csharp/{02_progress,Print}.cs
  elsewhere env "MONO_PATH=$work/nuget/lib/netstandard2.0" mono "$work/progress.exe" >"$work/csharp.txt" 2>/dev/null
  check "example 02_progress over an installed library prints what C prints" diff "$work/c.txt" "$work/csharp.txt"
else
  skip "SWIG or mcs is missing"
fi

# ---- mvn package: the jar of the pom, tested by its own JUnit tests ----
jar=$build/bindings/java/maven/jalon-$("$build/src/jalon" --version | awk '{ print $2 }').jar
if ! command -v mvn >/dev/null || [ ! -d "$build/bindings/java/sources" ]; then
  skip "Maven or the Java binding is missing"
elif ! timeout 300 mvn -q -B -f "$root/bindings/java/pom.xml" "-Djalon.build=$build" dependency:resolve-plugins >"$work/log" 2>&1; then
  skip "Maven Central cannot be reached"
else
  rm -f "$jar"
  check "mvn package" env JALON_FULL= mvn -B -l "$work/maven.log" -f "$root/bindings/java/pom.xml" "-Djalon.build=$build" package ||
    tail -n 20 "$work/maven.log"
  check "Maven ran the JUnit tests" grep -E "Tests run: [2-9][0-9], Failures: 0, Errors: 0" "$work/maven.log"
  "$build/examples/example_02_progress" >"$work/c.txt"
  check "the examples compile against Maven's jar" javac -cp "$jar" -d "$work/classes" "$root/examples/java/Progress.java"
  elsewhere java -cp "$jar:$work/classes" Progress >"$work/java.txt"
  check "example Progress prints what C prints" diff "$work/c.txt" "$work/java.txt"
fi
echo "$passed passed, $failed failed, $skipped skipped"
[ $failed -eq 0 ]

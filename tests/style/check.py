#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The Jalon authors
# SPDX-License-Identifier: Apache-2.0
"""House rules that a machine can check: check.py [BUILD_FOLDER]. The build folder adds its flags and jalon.pc."""

import json
import os
import re
import subprocess
import sys

from captures import captured_bindings
from mirrored import mirrored
from one_definition import one_definition
from rooms import CODE, ROOMS, bindings_alone, crowds, includes, layers, sublayers
from signposts import citations, cycled_handles, umbrella
from source import ROOT, Tally, public_functions, read, strings_of, tree_files, without_comments
from tolerances import wide_tolerances

MAX_LINES, LONG_LINES, MAX_COLUMNS = 400, 250, 120
# Every function of the C surface has its status from guard(); these return something else and cannot fail.
GUARDED = r"\s*return (guard|give_fields|create_worker|copy_worker|give_worker_params|worker_to_bytes|worker_from_bytes)\("  # they are guard() themselves
NO_STATUS = re.compile(r"_(retain|release)$|^jalon_(version|version_number|instruction_set|status_name|last_error_message)$")


def outsiders(files):
    """Programs that stand for a user's: the public headers and nothing of src."""
    for path in files:
        if not path.endswith(CODE) or not path.startswith(("tests/capi/", "examples/", "tests/scenarios/", "tests/install/")):
            continue
        for number, quote, name in includes(path):
            if quote == '"' and os.path.exists(os.path.join(ROOT, os.path.dirname(path), name)):
                continue
            if name.split("/")[0] in ROOMS and os.path.exists(os.path.join(ROOT, "src", name)):
                yield "%s:%d: sees src/%s" % (path, number, name)


def headers_alone():
    """Each header compiled by itself in four languages; gives (language, problems)."""
    headers = sorted(os.listdir(os.path.join(ROOT, "include", "jalon")))
    languages = [("C99", ["cc", "-x", "c", "-std=c99"]), ("C11", ["cc", "-x", "c", "-std=c11"]),
                 ("C++11", ["c++", "-x", "c++", "-std=c++11"]), ("C++20", ["c++", "-x", "c++", "-std=c++20"])]
    strict = ["-pedantic-errors", "-Wall", "-Wextra", "-Werror", "-fsyntax-only", "-I" + os.path.join(ROOT, "include")]
    for language, command in languages:
        problems = []
        for header in headers:
            run = subprocess.run(command + strict + ["-"], input="#include <jalon/%s>\n" % header, text=True,
                                 capture_output=True)
            if run.returncode:
                problems.append("%s: %s" % (header, (run.stderr.strip().splitlines() or ["failed"])[0]))
        yield language, problems


def c_types_only():
    """Exported signatures and structs use fixed-width C types: one layout for all compilers and languages."""
    banned = re.compile(r"\b(bool|long|short|size_t|ssize_t|unsigned|wchar_t|FILE|enum\s+\w+\s+\w+)\b|\.\.\.|:\s*\d+\s*;")
    for header in sorted(os.listdir(os.path.join(ROOT, "include", "jalon"))):
        text = without_comments(read("include/jalon/" + header))
        text = re.sub(r"^\s*#[^\n]*", "", text, flags=re.M)
        for number, line in enumerate(text.splitlines(), 1):
            if banned.search(line):
                yield "%s:%d: %s" % (header, number, line.strip())


def spdx(files):
    for path in files:
        name = os.path.basename(path)
        if not (path.endswith(CODE + (".py", ".sh", ".cmake", ".i")) or name == "CMakeLists.txt"):
            continue
        head = "\n".join(read(path).splitlines()[:5])
        if "SPDX-FileCopyrightText:" not in head or "SPDX-License-Identifier: Apache-2.0" not in head:
            yield path


def version(build):
    text = read("include/jalon/version.h")
    numbers = [re.search(r"JALON_VERSION_%s (\d+)" % part, text).group(1) for part in ("MAJOR", "MINOR", "PATCH")]
    release = ".".join(numbers)
    stated = re.search(r'JALON_VERSION_STRING "([^"]+)"', text).group(1)
    if stated != release:
        yield "version.h: the text says %s, the numbers %s" % (stated, release)
    if os.path.exists(os.path.join(ROOT, "CHANGELOG.md")):
        heading = re.search(r"^##\s+\[?v?([\w.]+)", read("CHANGELOG.md"), re.M)
        if not heading or heading.group(1) not in ("Unreleased", release):
            yield "CHANGELOG.md: its first heading is neither Unreleased nor %s" % release
    else:
        yield "CHANGELOG.md is missing"
    if build:
        for name, pattern in (("jalon.pc", r"^Version: (\S+)"), ("jalonConfigVersion.cmake", r'PACKAGE_VERSION "([^"]+)"')):
            path = os.path.join(build, name)
            if os.path.exists(path):
                with open(path, encoding="utf-8") as f:
                    found = re.search(pattern, f.read(), re.M)
                if not found or found.group(1) != release:
                    yield "%s does not say %s" % (name, release)


FORBIDDEN = [
    (r"\b(?:std::)?setlocale\b|\bstd::locale\b|\buselocale\b", "locale"),
    (r"\b(?:std::)?(?:strtod|strtof|strtold|atof)\s*\(|\bstd::sto(?:d|f|ld)\b", "number text by locale"),
    (r"\b(?:std::)?(?:scanf|sscanf|fscanf)\s*\(", "number text by locale"),
    (r"(?<![\w:.>])(?:std::)?exit\s*\(|\bquick_exit\b|\b_Exit\b|\babort\s*\(|\bstd::terminate\b", "ends the process"),
    (r"\bassert\s*\(", "assert"),
    (r"\b(?:std::)?s?rand\s*\(|\bstd::random_device\b|\bstd::mt19937", "unseeded or other random numbers"),
    (r"\bformat\s*\(\s*printf\s*,\s*\d", "a format of Linux alone: JALON_PRINTF of base/printf_format.h"),
]
GIVES_BACK = "src/base/default_arithmetic.h"  # takes the host's mode of arithmetic for a call and gives it back
FORBIDDEN_IN_LIBRARY = [
    (r"\bsignal\s*\(|\bsigaction\s*\(|\bputenv\b|\bsetenv\b|\bfesetround\b|\bchdir\s*\(", "touches the host's process"),
    (r"(?<![\w])(?:std::)?(?:printf|puts|putchar|vprintf|fputs|fprintf|fputc|perror)\s*\(", "prints"),
    (r"\bstd::(?:cout|cerr|clog|cin)\b|#\s*include\s*<(?:iostream|sstream|fstream|iomanip|locale|ostream|istream)>",
     "iostreams (locale)"),
]


def forbidden(files):
    for path in files:
        if not path.startswith("src/") or not path.endswith(CODE):
            continue
        library = not path.startswith("src/cli/") and path != GIVES_BACK
        code = without_comments(read(path))
        for number, line in enumerate(code.splitlines(), 1):
            for pattern, why in FORBIDDEN + (FORBIDDEN_IN_LIBRARY if library else []):
                if why and re.search(pattern, line):
                    yield "%s:%d: %s: %s" % (path, number, why, line.strip()[:80])


def number_formats(files):
    """%f and its like follow the host's locale: numbers go through text_of()."""
    for path in files:
        if not path.startswith("src/") or not path.endswith(CODE):
            continue
        for number, literal in strings_of(read(path)):
            if re.search(r"(?<!%)%[-+0#]*[\d.*]*L?[aefgAEFG](?![\w])", literal.replace("%%", "")):
                yield "%s:%d: %s" % (path, number, literal[:80])


def length(files):
    for path in files:
        if path.endswith(CODE) and path.startswith(("src/", "include/", "tests/", "examples/")):
            count = read(path).count("\n")
            if count > MAX_LINES:
                yield "%s: %d lines" % (path, count)


def formatted(files):
    """clang-format finds nothing to change."""
    sources = [path for path in files if path.endswith(CODE) and not path.endswith("epsg_units.inc")]
    found = subprocess.run(["clang-format-14", "--dry-run", "-Werror"] + sources, cwd=ROOT, capture_output=True, text=True)
    for line in found.stderr.splitlines():
        if ": error: " in line:
            yield line.split(" error: ")[0]


def width(files):
    for path in files:
        if path.endswith(CODE):
            for number, line in enumerate(read(path).splitlines(), 1):
                if len(line) > MAX_COLUMNS:
                    yield "%s:%d: %d columns" % (path, number, len(line))


def names(files):
    """Names that every system, shell and archive takes; a stray output of a test is seen here."""
    for path in files:
        if not re.match(r"[A-Za-z0-9._/-]+$", path):
            yield ascii(path)


def fast_math(files, build):
    flags = re.compile(r"-f[f]ast-math|-O[f]ast|-f[u]nsafe-math|-march=[n]ative|-ffp-[c]ontract=(?!off)")
    for path in files:
        if path.endswith(CODE + (".txt", ".cmake", ".json", ".sh", ".in", ".py")) and not path.startswith("tests/bench/"):
            for number, line in enumerate(read(path).splitlines(), 1):
                if flags.search(line) and not line.lstrip().startswith("#"):
                    yield "%s:%d: %s" % (path, number, line.strip()[:80])
    commands = os.path.join(build or "", "compile_commands.json")
    if build and os.path.exists(commands):
        with open(commands, encoding="utf-8") as f:
            for entry in json.load(f):
                ours = entry["file"].startswith(os.path.join(ROOT, "src"))
                if ours and (flags.search(entry["command"]) or "-ffp-contract=off" not in entry["command"]):
                    yield "flags of %s" % os.path.relpath(entry["file"], ROOT)


def documented():
    """In each blank-line separated block of declarations the first function that is no retain or release has a comment."""
    for header in sorted(os.listdir(os.path.join(ROOT, "include", "jalon"))):
        for block in re.split(r"\n\s*\n", read("include/jalon/" + header)):
            comment = False
            text = re.sub(r"/\*\*.*?\*/", lambda m: " @comment ", block, flags=re.S)
            for match in re.finditer(r"@comment|JALON_API[^;]*?(jalon_\w+)\s*\(", text, re.S):
                if match.group(0) == "@comment":
                    comment = True
                elif not comment and not re.search(r"_(retain|release)$", match.group(1)):
                    yield "%s: %s" % (header, match.group(1))
                    break


def walls():
    """Each public function is defined in the capi file of its header, and each status comes out of guard()."""
    bodies = {}
    for folder, _, names in sorted(os.walk(os.path.join(ROOT, "src", "capi"))):
        for name in sorted(n for n in names if n.endswith(".cpp")):
            code = without_comments(read(os.path.relpath(os.path.join(folder, name), ROOT)))
            for match in re.finditer(r"^[\w\s*]*?\b(jalon_\w+)\s*\(([^;{}]*)\)\s*(?:noexcept\s*)?\{", code, re.M):
                bodies[match.group(1)] = (name, code[match.end():match.end() + 200])
    for function in public_functions():
        stem = function.header[:-2]
        if function.name not in bodies:
            yield "%s is defined nowhere in src/capi" % function.name
            continue
        name, body = bodies[function.name]
        if not re.match(stem + r"(_\w+)?\.cpp$", name):
            yield "%s stands in %s, not in %s*.cpp" % (function.name, name, stem)
        if not NO_STATUS.search(function.name) and not re.match(GUARDED, body):
            yield "%s (%s) does not begin with return guard(" % (function.name, name)
    for name in sorted(set(bodies) - {f.name for f in public_functions()}):
        yield "%s is in no public header" % name


def hygiene(files):
    marks = re.compile(r"\bTO" r"DO\b|\bFIX" r"ME\b|\bXX" r"X\b|\bHA" r"CK\b|^\s*#\s*if\s+0\b")
    paths = re.compile(r"(?<![\w.])/(?:work|home|root|Users)/\w")
    for path in files:
        if path.endswith((".png", ".jpg", ".las", ".ply", ".xml", ".svg")) or path == "LICENSE":
            continue
        for number, line in enumerate(read(path).splitlines(), 1):
            if marks.search(line):
                yield "%s:%d: unfinished: %s" % (path, number, line.strip()[:80])
            if paths.search(line):
                yield "%s:%d: a machine's path: %s" % (path, number, line.strip()[:80])


def main():
    build = os.path.abspath(sys.argv[1]) if len(sys.argv) > 1 else None
    files = tree_files()
    tally = Tally()
    tally.check("style: #include lines follow the rooms' arrows", layers(files))
    tally.check("style: and those of the rooms within rooms", sublayers(files))
    tally.check("style: the bindings take nothing from the tests", bindings_alone(files))
    tally.check("style: no folder of src with more files than one can overlook", crowds(files))
    tally.check("style: a type name stands for one type", one_definition(files))
    tally.check("style: no lambda captures a name of a structured binding", captured_bindings(files))
    tally.check("style: every source with logic has its test at the mirrored path, or in the list", mirrored(files))
    tally.check("style: examples and C tests see include/jalon only", outsiders(files))
    for language, problems in headers_alone():
        tally.check("headers: each compiles alone as %s, -pedantic -Wall -Wextra -Werror" % language, problems)
    tally.check("headers: fixed-width C types only", c_types_only())
    tally.check("headers: every function group has its comment", documented())
    tally.check("headers: jalon.h includes all of them and names all workers", umbrella())
    tally.check("style: each kind of handle has its cycles in the reliability tests", cycled_handles())
    tally.check("capi: every public function in its file, every status from guard()", walls())
    tally.check("style: SPDX tags in every source file", spdx(files))
    tally.check("style: one version everywhere", version(build))
    tally.check("style: no forbidden calls in src", forbidden(files))
    tally.check("style: no number goes through a locale format", number_formats(files))
    tally.check("style: no file above %d lines" % MAX_LINES, length(files))
    tally.check("style: no line wider than %d columns" % MAX_COLUMNS, width(files))
    tally.check("style: C and C++ files as clang-format writes them", formatted(files))
    tally.check("style: plain file names", names(files))
    tally.check("style: comments cite what a reader can find", citations(files))
    tally.check("style: no fast-math, no flags of one machine, contraction off", fast_math(files, build))
    tally.check("style: no tolerance of a test as wide as its number", wide_tolerances(files))
    tally.check("style: no unfinished marks, no machine paths", hygiene(files))
    sources = [f for f in files if f.endswith(CODE)]
    long_files = sum(read(f).count("\n") > LONG_LINES for f in sources)
    wide = sum(len(line) > MAX_COLUMNS for f in sources for line in read(f).splitlines())
    print("    %d source files, %d above %d lines; %d lines wider than %d columns"
          % (len(sources), long_files, LONG_LINES, wide, MAX_COLUMNS))
    tally.close()


if __name__ == "__main__":
    main()

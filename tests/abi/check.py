#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The Jalon authors
# SPDX-License-Identifier: Apache-2.0
"""The binary interface against what is committed: check.py BUILD_FOLDER [--update], or check.py --types for the headers alone

symbols.txt: the exported functions; globals.txt: the writable data of the library; jalon.abi.xml: the types, by abidw. --update
writes them anew; the change belongs into the same commit as its reason, and into CHANGELOG.md.
"""

import os
import re
import shutil
import subprocess
import sys
import tempfile

HERE = os.path.dirname(os.path.abspath(__file__))
sys.path.insert(0, os.path.join(HERE, "..", "style"))
from source import ROOT, Tally, public_functions  # noqa: E402

NODE = "JALON_0"
SYSTEM_LIBRARIES = re.compile(r"lib(c|m|pthread|stdc\+\+|gcc_s)\.so\.\d+$|ld-linux.*")
OPTIONAL = {"FCL": ["libfcl", "libccd"], "SQLITE": ["libsqlite3"], "LIBPNG": ["libpng16"]}  # by the option of the build that brings them
LINKER_MADE = re.compile(r"^(completed\.\d+|__dso_handle|_DYNAMIC|_GLOBAL_OFFSET_TABLE_|__TMC_END__|__bss_start|_edata|_end|"
                         r"DW\.ref\..*|__gcov.*|__llvm.*)$")
# Of the optional component of Rust, whose names change with its compiler: what its run time keeps about panics, threads and the
# processor, the search function that memchr chose, that panics print nothing, and what a call lives on that is refused memory. None
# of it is Jalon's state.
OF_RUST = re.compile(r"^<?(std|core|alloc|std_detect|compiler_builtins|memchr)\[[0-9a-f]+\]|^<?(std|core|alloc|memchr|compiler_builtins)::\w.*"
                     r"(FN|CACHE|FUNC)\b|^jalon_codecs::(silence_panics::ONCE\b|reserve::)")


def run(*command):
    return subprocess.run(command, check=True, capture_output=True, text=True).stdout


def lines_of(name):
    path = os.path.join(HERE, name)
    if not os.path.exists(path):
        return []
    with open(path, encoding="utf-8") as f:
        return [line.rstrip("\n") for line in f if line.strip() and not line.startswith("#")]


def dynamic_symbols(library):
    """(name, version, letter of nm) of what the library defines."""
    for line in run("nm", "-D", "--defined-only", "--with-symbol-versions", library).splitlines():
        match = re.match(r"\S+ (\S) ([^@]+)(?:@@?(\S+))?$", line)
        if match:
            yield match.group(2), match.group(3) or "", match.group(1)


def exports(library):
    for name, version, letter in dynamic_symbols(library):
        if name == NODE and letter == "A":
            continue
        if letter != "T":
            yield "%s is of kind %s, not a plain function" % (name, letter)
        if version != NODE:
            yield "%s stands in node \"%s\"" % (name, version)
        if not re.match(r"jalon_[a-z0-9_]+$", name):
            yield "%s is no jalon_ name" % name


def difference(found, committed, file):
    for name in sorted(set(found) - set(committed)):
        yield "+ %s (new: add it to tests/abi/%s)" % (name, file)
    for name in sorted(set(committed) - set(found)):
        yield "- %s (in tests/abi/%s, but no longer there)" % (name, file)


def writable_globals(library):
    """Demangled names of the symbols in .data, .bss, .tdata and .tbss."""
    sections = {}
    for line in run("readelf", "-SW", library).splitlines():
        match = re.match(r"\s*\[\s*(\d+)\]\s+(\.\S+)", line)
        if match:
            sections[match.group(1)] = match.group(2)
    names = set()
    for line in run("readelf", "-sW", library).splitlines():
        parts = line.split()
        if len(parts) >= 8 and parts[3] in ("OBJECT", "TLS", "NOTYPE"):
            section = sections.get(parts[6], "")
            if section in (".data", ".bss", ".tdata", ".tbss") and not LINKER_MADE.match(parts[7]):
                names.add(re.sub(r"(\.\d+|\.lto_priv\.\d+)+$", "", parts[7].split("@")[0]))
    if not names:
        return []
    plain = subprocess.run(["c++filt"], input="\n".join(sorted(names)), check=True, capture_output=True, text=True).stdout
    return sorted(set(plain.splitlines()))


def hardening(library):
    program, dynamic = run("readelf", "-lW", library), run("readelf", "-dW", library)
    if "GNU_RELRO" not in program or not re.search(r"BIND_NOW|FLAGS.*NOW", dynamic):
        yield "not fully RELRO"
    stack = re.search(r"GNU_STACK\s+(\S+\s+){5}(\w+)", program)
    if not stack or "E" in stack.group(2):
        yield "executable stack"
    for line in program.splitlines():
        if re.match(r"\s*LOAD\b", line) and re.search(r"RWE", line):
            yield "a segment both writable and executable"
    if "TEXTREL" in dynamic:
        yield "text relocations"
    if re.search(r"R(UN)?PATH", dynamic) and not re.search(r"R(UN)?PATH.*\[\$ORIGIN", dynamic):
        yield "a run path of the build machine"


def needed(library, optional):
    """zlib, and those that options of the build bring, are the only needs beside the C++ library's own."""
    for name in re.findall(r"\(NEEDED\).*\[(.+)\]", run("readelf", "-dW", library)):
        if not SYSTEM_LIBRARIES.match(name) and name.split(".")[0] not in ["libz", *optional]:
            yield name


def soname(library):
    with open(os.path.join(ROOT, "include", "jalon", "version.h"), encoding="utf-8") as f:
        text = f.read()
    major, minor = (int(re.search(r"JALON_VERSION_%s (\d+)" % p, text).group(1)) for p in ("MAJOR", "MINOR"))
    expected = "libjalon.so." + ("0.%d" % minor if major == 0 else str(major))
    found = re.search(r"\(SONAME\).*\[(.+)\]", run("readelf", "-dW", library)).group(1)
    return [] if found == expected else ["%s, not %s" % (found, expected)]


def surface():
    """C text that defines every public function with an empty body: the interface as its users see it, handles incomplete.

    The library itself would bring the C++ inside of the handles into the dump. That it defines the same functions is checked by the
    symbols, and that it defines them with the same parameters by its compiler, which includes the headers.
    """
    lines = ["#include <jalon/jalon.h>"]
    for f in public_functions():
        parameters = ", ".join("%s %s%s" % (p.type[:-1] if p.extent else p.type, p.name, "[%d]" % p.extent if p.extent else "")
                               for p in f.parameters) or "void"
        unused = "".join(" (void)%s;" % p.name for p in f.parameters)
        lines.append("%s %s(%s) {%s%s }" % (f.result, f.name, parameters, unused, "" if f.result == "void" else " return 0;"))
    return "\n".join(lines) + "\n"


def dump_types(out):
    with tempfile.TemporaryDirectory() as folder:
        source, library = os.path.join(folder, "surface.c"), os.path.join(folder, "libjalon.so")
        with open(source, "w", encoding="utf-8") as f:
            f.write(surface())
        run("cc", "-std=c99", "-g", "-O0", "-shared", "-fPIC", "-Wall", "-Werror", "-I" + os.path.join(ROOT, "include"),
            "-Wl,--version-script=" + os.path.join(ROOT, "src", "capi", "jalon.map"), "-nostdlib", source, "-o", library)
        run("abidw", "--no-architecture", "--no-corpus-path", "--no-show-locs", "--no-comp-dir-path",
            "--headers-dir", os.path.join(ROOT, "include"), "--out-file", out, library)
    with open(out, encoding="utf-8") as f:
        text = re.sub(r" (path|comp-dir-path)='[^']*'", "", f.read())
    with open(out, "w", encoding="utf-8") as f:
        f.write(text)


def types(tally):
    name = "abi: types and signatures equal the committed abidw dump"
    if not shutil.which("abidw") or not shutil.which("abidiff"):
        tally.skip(name, "abigail-tools is not installed")
        return
    with tempfile.TemporaryDirectory() as folder:
        fresh = os.path.join(folder, "fresh.xml")
        dump_types(fresh)
        diff = subprocess.run(["abidiff", os.path.join(HERE, "jalon.abi.xml"), fresh], capture_output=True, text=True)
    # Bits of the exit code: 1 error, 2 usage, 4 change, 8 incompatible change. Additions need a new dump, no more.
    report = [line for line in (diff.stdout + diff.stderr).splitlines() if line.strip()]
    tally.check(name, report if diff.returncode else [])


def main():
    if sys.argv[1] == "--types":
        tally = Tally()
        types(tally)
        tally.close()
    build = os.path.abspath(sys.argv[1])
    update = "--update" in sys.argv[2:]
    library = next((p for p in (os.path.join(build, d, "libjalon.so") for d in ("src", "lib", "")) if os.path.exists(p)), None)
    declared = [f.name for f in public_functions()]
    if update:
        with open(os.path.join(HERE, "symbols.txt"), "w", encoding="utf-8") as f:
            f.write("# The functions that libjalon.so exports, by tests/abi/check.py --update.\n")
            f.write("\n".join(sorted(declared)) + "\n")
        dump_types(os.path.join(HERE, "jalon.abi.xml"))
        if library:
            with open(os.path.join(HERE, "globals.txt"), "w", encoding="utf-8") as f:
                f.write("# All writable data of libjalon.so; a new line needs a reason (no mutable process-wide state).\n")
                f.write("\n".join(name for name in writable_globals(library) if not OF_RUST.match(name)) + "\n")
    tally = Tally()
    if library is None:
        tally.check("abi: libjalon.so is built", ["none under " + build])
        tally.close()
    exported = [name for name, _, letter in dynamic_symbols(library) if not (name == NODE and letter == "A")]
    tally.check("abi: the headers' functions equal the committed list", difference(declared, lines_of("symbols.txt"), "symbols.txt"))
    tally.check("abi: the exported symbols equal the committed list", difference(exported, lines_of("symbols.txt"), "symbols.txt"))
    tally.check("abi: only plain jalon_ functions of node " + NODE + " leave the library", exports(library))
    tally.check("abi: SONAME is 0.MINOR before 1.0", soname(library))
    with open(os.path.join(build, "CMakeCache.txt"), encoding="utf-8") as f:
        cache = f.read()
    if re.search(r"^JALON_SANITIZE:STRING=.+", cache, re.M):
        tally.skip("abi: writable data, needed libraries and hardening", "a sanitizer adds its own")
    else:
        tally.check("abi: no writable data beyond the committed list",
                    (d for d in difference([name for name in writable_globals(library) if not OF_RUST.match(name)],
                                           lines_of("globals.txt"), "globals.txt") if d[0] == "+"))
        optional = [name for option, names in OPTIONAL.items() if "JALON_WITH_%s:BOOL=ON" % option in cache for name in names]
        tally.check("abi: needs libc, libm, libpthread, libstdc++, libgcc_s and libz only" + "".join(", " + name for name in optional),
                    needed(library, optional))
        tally.check("abi: full RELRO, no executable stack, no text relocations, no build path", hardening(library))
    types(tally)
    tally.close()


if __name__ == "__main__":
    main()

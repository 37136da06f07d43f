#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The Jalon authors
# SPDX-License-Identifier: Apache-2.0
"""The native libraries of a package stand alone: closure.py LANGUAGE FOLDER LICENCES

Each library that one of them needs lies beside it, under a name that no other build of it has, or belongs to every Linux system;
they are looked for beside the file alone; each that is not Jalon's own has its licence in the file of licences.
"""

import os
import re
import subprocess
import sys

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "style"))
from source import Tally  # noqa: E402

OF_THE_SYSTEM = re.compile(r"(libc|libm|libstdc\+\+|libgcc_s|ld-linux-[-\w]+)\.so\.\d+$")


def tags(path):
    """[(tag, value)] of the dynamic section."""
    text = subprocess.run(["readelf", "--wide", "-d", path], check=True, stdout=subprocess.PIPE, text=True).stdout
    return re.findall(r"\((NEEDED|SONAME|RPATH|RUNPATH)\).*\[(.*)\]", text)


def crates():
    """Those that LAZ and E57 are built with, our own apart."""
    lock = os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "..", "src", "formats", "codecs", "rust", "Cargo.lock")
    with open(lock, encoding="utf-8") as file:
        return set(re.findall(r'^name = "([-\w]+)"', file.read(), re.MULTILINE)) - {"jalon_codecs"}


def main():
    language, folder, licences = sys.argv[1:4]
    libraries = {name: tags(os.path.join(folder, name)) for name in sorted(os.listdir(folder)) if re.search(r"\.so(\.|$)", name)}
    others = [name for name in libraries if "jalon" not in name and not name.startswith("_native")]
    needed = {(name, value) for name, found in libraries.items() for tag, value in found if tag == "NEEDED"}
    with open(licences, encoding="utf-8") as file:
        text = file.read()
    licensed, crates_licensed = (re.findall(r"^== " + kind, text, re.MULTILINE) for kind in (r"(lib\w+)", r"crate ([-\w]+)"))
    tally = Tally()

    def check(name, wrong):
        tally.check("package__%s_%s" % (language, name), wrong)
    check("has_its_libraries", [] if len(libraries) >= 2 else ["only %d of them" % len(libraries)])
    check("takes_only_the_run_times_from_the_system",
          sorted("%s needs %s" % n for n in needed if n[1] not in libraries and not OF_THE_SYSTEM.match(n[1])))
    check("has_nothing_that_is_not_needed", sorted(set(others) - {value for _, value in needed}))
    check("has_private_names_of_what_others_may_load_too", [n for n in others if not re.match(r"lib\w+-[0-9a-f]{8}\.so", n)])
    check("looks_for_libraries_beside_them_alone",
          ["%s: %s" % (name, value) for name, found in libraries.items() for tag, value in found
           if tag == "RUNPATH" or (tag == "RPATH" and value != "$ORIGIN")])
    check("has_the_licence_of_each", [n for n in others if n.split("-")[0] not in licensed])
    check("has_the_licence_of_each_crate", sorted(crates() - set(crates_licensed)))
    print("FIGURE %s package: %d libraries, %.1f MiB" % (language, len(libraries), sum(
        os.path.getsize(os.path.join(folder, n)) for n in libraries) / 2 ** 20))
    tally.close()


if __name__ == "__main__":
    main()

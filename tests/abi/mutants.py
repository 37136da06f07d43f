#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The Jalon authors
# SPDX-License-Identifier: Apache-2.0
"""The check of the binary interface must fail when the interface changes: mutants.py

On a copy of the headers and the committed dump, one public struct or signature is changed at a time.
"""

import os
import re
import shutil
import subprocess
import sys
import tempfile

HERE = os.path.dirname(os.path.abspath(__file__))
sys.path.insert(0, os.path.join(HERE, "..", "style"))
from source import ROOT, Tally  # noqa: E402

# (what changes, header, pattern that occurs once, replacement)
MUTANTS = [
    ("a public struct gains a member", "types.h", r"(double removed_percent;)", r"\1 double kept_percent;"),
    ("a member changes its type", "types.h", r"double x, y, z;", r"float x, y, z;"),
    ("two members change places", "types.h", r"(int32_t type;[^\n]*\n)(\s*uint64_t stride_bytes;[^\n]*\n)", r"\2\1"),
    ("a parameter changes its type", "cloud.h",
     r"(jalon_cloud_remove_duplicates\([^)]*)double tolerance_m", r"\1float tolerance_m"),
    ("a function loses a parameter", "cloud.h", r"(jalon_cloud_invert_normals\([^)]*), jalon_task\* task\)", r"\1)"),
    ("a function changes its result", "version.h", r"const char\* (jalon_version\()", r"uint64_t \1"),
    ("a function is gone", "cloud.h", r"JALON_API[^;]*jalon_cloud_invert_normals\([^)]*\);", r""),
]


def copy_of_interface(to):
    shutil.copytree(os.path.join(ROOT, "include"), os.path.join(to, "include"))
    for folder in ("bindings/generator", "tests/abi", "tests/style"):
        shutil.copytree(os.path.join(ROOT, folder), os.path.join(to, folder), ignore=shutil.ignore_patterns("__pycache__"))
    os.makedirs(os.path.join(to, "src", "capi"))
    shutil.copy(os.path.join(ROOT, "src", "capi", "jalon.map"), os.path.join(to, "src", "capi"))


def types_hold(root):
    """What check.py says of the types of that copy; None when it says nothing."""
    script = os.path.join(root, "tests", "abi", "check.py")
    text = subprocess.run([sys.executable, script, "--types"], capture_output=True, text=True).stdout
    match = re.search(r"^(ok|not ok) - abi: types", text, re.M)
    return match and match.group(1) == "ok"


def main():
    tally = Tally()
    if not shutil.which("abidw") or not shutil.which("abidiff"):
        tally.skip("abi: the check fails on a changed interface", "abigail-tools is not installed")
        tally.close()
    with tempfile.TemporaryDirectory() as root:
        copy_of_interface(root)
        tally.check("abi mutants: the unchanged copy passes", [] if types_hold(root) else ["it does not"])
        for name, header, pattern, replacement in MUTANTS:
            path = os.path.join(root, "include", "jalon", header)
            with open(path, encoding="utf-8") as f:
                before = f.read()
            after, count = re.subn(pattern, replacement, before)
            problems = [] if count == 1 else ["the pattern occurs %d times in %s" % (count, header)]
            with open(path, "w", encoding="utf-8") as f:
                f.write(after)
            if types_hold(root) is not False:
                problems.append("the check passes")
            with open(path, "w", encoding="utf-8") as f:
                f.write(before)
            tally.check("abi mutants: refused: " + name, problems)
    tally.close()


if __name__ == "__main__":
    main()

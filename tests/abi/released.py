#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The Jalon authors
# SPDX-License-Identifier: Apache-2.0
"""What was built with the headers of an earlier release of this ABI still runs: released.py BUILD_FOLDER

released/X.Y.Z has of each release: jalon.abi.xml.gz, its interface as abidw dumped it; consumer.c, a host that passes every kind of
value; consumer-*, its binary as it was built then. Nothing in such a folder changes any more. Where an ABI ends (0.MINOR before 1.0,
the major after), its folder goes. released.py --freeze X.Y.Z BUILD_FOLDER makes one of what stands now.
"""

import gzip
import os
import platform
import re
import shutil
import subprocess
import sys
import tempfile

HERE = os.path.dirname(os.path.abspath(__file__))
sys.path.insert(0, os.path.join(HERE, "..", "style"))
from source import ROOT, Tally  # noqa: E402

RELEASED = os.path.join(HERE, "released")
CURRENT = os.path.join(HERE, "jalon.abi.xml")
ERROR, USAGE, INCOMPATIBLE = 1, 2, 8  # bits of abidiff's exit code; 4 alone is a compatible change
A_FUNCTION = "jalon_cloud_invert_normals"


def consumer_name():
    return "consumer-%s-%s" % (platform.system().lower(), platform.machine())


def built(source, library_folder, out):
    subprocess.run(["cc", "-std=c99", "-O1", "-s", "-Wall", "-Wextra", "-Werror", "-I" + os.path.join(ROOT, "include"), source,
                    "-o", out, "-L" + library_folder, "-ljalon"], check=True)
    return out


def said(program, library_folder):
    ended = subprocess.run([program], env=dict(os.environ, LD_LIBRARY_PATH=library_folder), capture_output=True, text=True)
    return ended.returncode, (ended.stdout + ended.stderr).splitlines()


def breaks(old, new):
    """What abidiff calls incompatible; functions that came are none."""
    diff = subprocess.run(["abidiff", old, new], capture_output=True, text=True)
    if diff.returncode & (ERROR | USAGE | INCOMPATIBLE):
        return [line for line in (diff.stdout + diff.stderr).splitlines() if line.strip()][:20] or ["abidiff ended with %d" % diff.returncode]
    return []


def dump_of(folder, out):
    with gzip.open(os.path.join(folder, "jalon.abi.xml.gz"), "rt", encoding="utf-8") as packed, open(out, "w", encoding="utf-8") as f:
        f.write(packed.read())
    return out


def without(dump, function, out):
    """The dump of a library that lacks a function."""
    with open(dump, encoding="utf-8") as f:
        text = f.read()
    text = re.sub(r"\n *<elf-symbol name='%s'[^\n]*" % function, "", text)
    text = re.sub(r"\n *<function-decl name='%s'.*?</function-decl>" % function, "", text, flags=re.S)
    with open(out, "w", encoding="utf-8") as f:
        f.write(text)
    return out


def check_types(tally, folder, work):
    name = "abi: what %s exported is still there and the same" % os.path.basename(folder)
    if not shutil.which("abidiff"):
        tally.skip(name, "abigail-tools is not installed")
        return
    then = dump_of(folder, os.path.join(work, "then.xml"))
    tally.check(name, breaks(then, CURRENT))
    lacking = without(then, A_FUNCTION, os.path.join(work, "lacking.xml"))
    tally.check("abi: a function that is gone since would be seen", [] if breaks(then, lacking) else ["it is not"])
    tally.check("abi: a function that came since breaks nothing", breaks(lacking, then))


def check_consumer(tally, folder, libraries, work):
    name = "abi: a host built with %s says what one built today says" % os.path.basename(folder)
    old = os.path.join(folder, consumer_name())
    if not os.path.exists(old):
        tally.skip(name, "there is no " + consumer_name())
        return
    code, then = said(old, libraries)
    _, now = said(built(os.path.join(folder, "consumer.c"), libraries, os.path.join(work, "consumer")), libraries)
    problems = ["it ended with %d" % code] if code else []
    problems += ["then: %s; now: %s" % pair for pair in zip(then, now) if pair[0] != pair[1]]
    tally.check(name, problems + ([] if len(then) == len(now) > 10 else ["%d lines and %d" % (len(then), len(now))]))


def freeze(release, libraries):
    folder = os.path.join(RELEASED, release)
    with open(CURRENT, "rb") as f, open(os.path.join(folder, "jalon.abi.xml.gz"), "wb") as out:
        out.write(gzip.compress(f.read(), mtime=0))
    built(os.path.join(folder, "consumer.c"), libraries, os.path.join(folder, consumer_name()))


def main():
    libraries = os.path.join(os.path.abspath(sys.argv[-1]), "src")
    if sys.argv[1] == "--freeze":
        freeze(sys.argv[2], libraries)
        return
    tally = Tally()
    for release in sorted(os.listdir(RELEASED)):
        with tempfile.TemporaryDirectory() as work:
            check_types(tally, os.path.join(RELEASED, release), work)
            check_consumer(tally, os.path.join(RELEASED, release), libraries, work)
    tally.close()


if __name__ == "__main__":
    main()

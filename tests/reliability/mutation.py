#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The Jalon authors
# SPDX-License-Identifier: Apache-2.0
"""Breaks the library in small ways, one at a time, and holds the named test to seeing each: mutation.py WORK_FOLDER [PATTERN].

The sources are copied into WORK_FOLDER/tree and built there (again only what changed since); the project itself is never
touched. PATTERN chooses rows of mutants.py by figure, file or test. The tests must pass on the copy as it is."""

import os
import re
import shutil
import subprocess
import sys

HERE = os.path.dirname(os.path.abspath(__file__))
ROOT = os.path.dirname(os.path.dirname(HERE))
sys.path[:0] = [HERE, os.path.join(ROOT, "tests", "runner")]
from counting import counts  # noqa: E402
from mutants import MUTANTS  # noqa: E402
from suites import all_suites  # noqa: E402

LONGEST_S = 1200  # of a test: one that hangs has seen the breakage


def run(command, folder, limit_s=None):
    """(exit status or None where it ran past the limit, all that it said)"""
    try:
        done = subprocess.run(command, cwd=folder, stdin=subprocess.DEVNULL, stdout=subprocess.PIPE, stderr=subprocess.STDOUT,
                              timeout=limit_s)
        return done.returncode, done.stdout.decode("utf-8", "replace")
    except subprocess.TimeoutExpired as late:
        return None, (late.stdout or b"").decode("utf-8", "replace")


def copy_sources(tree):
    """What git knows of; files that are the same keep their time, so that nothing is built for them."""
    names = subprocess.run(["git", "-C", ROOT, "ls-files", "-zco", "--exclude-standard"], check=True, capture_output=True,
                           text=True).stdout.split("\0")[:-1]
    for name in names:
        source, to = os.path.join(ROOT, name), os.path.join(tree, name)
        if not os.path.isfile(source):
            continue
        with open(source, "rb") as f:
            content = f.read()
        if os.path.isfile(to):
            with open(to, "rb") as f:
                if f.read() == content:
                    continue
        os.makedirs(os.path.dirname(to), exist_ok=True)
        shutil.copy(source, to)
    # A repository of its own: the house rules ask git which files there are, and the outer one ignores this folder.
    subprocess.run(["git", "-C", tree, "init", "-q"], check=True)


class Build:
    """A build whose outputs come back as they were, so that a breakage costs its own compiling alone."""

    def __init__(self, work):
        self.tree = os.path.join(work, "tree")
        self.folder = os.path.join(self.tree, "build", "release")
        self.kept = os.path.join(work, "kept")
        self.times = {}

    def configure(self):
        return run(["cmake", "-S", self.tree, "--preset", "release", "-DJALON_BUILD_BINDINGS=OFF"], self.tree)

    def make(self, targets):
        return run(["ninja", "-C", self.folder] + targets, self.tree) if targets else (0, "")

    def paths(self):
        for folder, _, names in os.walk(self.folder):
            for name in names:
                path = os.path.join(folder, name)
                if os.path.isfile(path) and not os.path.islink(path):
                    yield path, os.stat(path).st_mtime_ns

    def keep(self):
        shutil.rmtree(self.kept, ignore_errors=True)
        shutil.copytree(self.folder, self.kept, symlinks=True)
        self.times = dict(self.paths())

    def restore(self):
        for path, time in list(self.paths()):
            if self.times.get(path) == time:
                continue
            before = os.path.join(self.kept, os.path.relpath(path, self.folder))
            os.remove(path)
            if os.path.isfile(before):
                shutil.copy2(before, path)


class Broken:
    """The file with its one text replaced; as it was, time included, behind the block."""

    def __init__(self, tree, mutant):
        self.path, self.mutant = os.path.join(tree, mutant.file), mutant

    def __enter__(self):
        self.time = os.stat(self.path).st_mtime_ns
        with open(self.path, encoding="utf-8") as f:
            self.text = f.read()
        with open(self.path, "w", encoding="utf-8") as f:
            f.write(self.text.replace(self.mutant.text, self.mutant.becomes))
        return self.text.count(self.mutant.text)

    def __exit__(self, *_):
        with open(self.path, "w", encoding="utf-8") as f:
            f.write(self.text)
        os.utime(self.path, ns=(self.time, self.time))


def command_of(suite, test, tree):
    """The suite's command on the copy; of a doctest program the named case alone."""
    command = [word.replace(ROOT + os.sep, tree + os.sep) for word in suite.command]
    if "/unit_" in command[0]:
        command.append("-tc=" + re.sub(r"([,\\])", r"\\\1", test) + "*")
    return command


def tells(text, test):
    """Does the output name the test as one that failed, or as the one that was running when the program died?"""
    return any(test in line and re.search(r"FAILED|not ok|ERROR|^TEST CASE|RUN  ", line) for line in text.splitlines())


class Tally:
    def __init__(self):
        self.passed = self.failed = 0

    def tell(self, good, name, why):
        self.passed, self.failed = self.passed + good, self.failed + (not good)
        print("ok - " + name if good else "not ok - %s: %s" % (name, why), flush=True)
        return good


def try_unbroken(chosen, suites, build, tally):
    """Those (suite, test) that pass as things are: the others would prove nothing."""
    sound = set()
    for suite, test in sorted({(m.suite, m.test) for m in chosen}):
        code, text = run(command_of(suites[suite], test, build.tree), build.tree, LONGEST_S)
        if tally.tell(code == 0 and counts(text, code)[0] > 0, "%s: %s passes unbroken" % (suite, test), text[-600:]):
            sound.add((suite, test))
    return sound


def try_broken(mutant, suite, build, tally):
    name = "%s sees %s broken: %s" % (mutant.test, mutant.file, " ".join(mutant.text.split())[:60])
    with Broken(build.tree, mutant) as places:
        if places != 1:
            return tally.tell(False, name, "the text stands there %d times" % places)
        code, text = build.make(suite.targets)
        if code != 0:
            return tally.tell(False, name, "it does not compile: " + text[-1500:])
        code, text = run(command_of(suite, mutant.test, build.tree), build.tree, LONGEST_S)
        return tally.tell(code != 0 and tells(text, mutant.test), name, "exit status %s; %s" % (code, text[-600:]))


def main():
    work = os.path.abspath(sys.argv[1])
    pattern = sys.argv[2] if len(sys.argv) > 2 else ""
    chosen = [m for m in MUTANTS if re.search(pattern, " ".join((m.figure, m.file, m.test)))]
    suites = {s.name: s for s in all_suites()}
    build, tally = Build(work), Tally()
    copy_sources(build.tree)
    for code, text in (build.configure(), build.make(sorted({t for m in chosen for t in suites[m.suite].targets}))):
        if code != 0:
            print(text[-4000:])
            sys.exit("the copy cannot be built")
    build.keep()
    sound = try_unbroken(chosen, suites, build, tally)
    for mutant in chosen:
        if (mutant.suite, mutant.test) in sound:
            try_broken(mutant, suites[mutant.suite], build, tally)
            build.restore()
    print("FIGURE mutants: %d breakages in %d files, %d of the 44 figures among them" % (
        len(chosen), len({m.file for m in chosen}), len({m.figure for m in chosen if m.figure})))
    print("%d passed, %d failed" % (tally.passed, tally.failed))
    sys.exit(tally.failed != 0)


if __name__ == "__main__":
    main()

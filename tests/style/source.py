# SPDX-FileCopyrightText: 2026 The Jalon authors
# SPDX-License-Identifier: Apache-2.0
"""What the checks share: the files of the tree, the tally, and what the bindings' reader of the headers gives."""

import os
import subprocess
import sys

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "..", "bindings", "generator"))
from headers import ROOT, TOKENS, public_functions, read, without_comments  # noqa: E402,F401


class Tally:
    """Named behaviours, one line each, and the closing count that tests/run.sh adds up."""

    def __init__(self):
        self.passed = self.failed = self.skipped = 0

    def check(self, name, problems):
        """Passes when problems (lines of text) is empty; shows the first twenty otherwise."""
        problems = list(problems)
        if not problems:
            self.passed += 1
            print("ok - " + name)
            return
        self.failed += 1
        print("not ok - %s (%d)" % (name, len(problems)))
        for line in problems[:20]:
            print("    " + line)

    def skip(self, name, why):
        self.skipped += 1
        print("skipped - %s: %s" % (name, why))

    def close(self):
        print("%d passed, %d failed, %d skipped" % (self.passed, self.failed, self.skipped))
        sys.exit(1 if self.failed else 0)


def tree_files():
    """Paths (relative to the root) of the files that git tracks or would track; without git, all but build folders."""
    try:
        out = subprocess.run(["git", "-C", ROOT, "ls-files", "-zco", "--exclude-standard"], check=True,
                             capture_output=True, text=True).stdout
        files = out.split("\0")[:-1]
    except (OSError, subprocess.CalledProcessError):
        files = []
        for folder, folders, names in os.walk(ROOT):
            folders[:] = [f for f in folders if f not in (".git", "build", "out", ".venv", "__pycache__")]
            files += [os.path.relpath(os.path.join(folder, n), ROOT) for n in names]
    return sorted(f for f in files if os.path.isfile(os.path.join(ROOT, f)))


def strings_of(text):
    """(line number, literal) of every string literal."""
    for match in TOKENS.finditer(text):
        token = match.group(0)
        if token[0] in '"R':
            yield text.count("\n", 0, match.start()) + 1, token

# SPDX-FileCopyrightText: 2026 The Jalon authors
# SPDX-License-Identifier: Apache-2.0
import importlib.util
import os
import subprocess
import sys
import tempfile
import unittest

from scenes import SANITIZED

EXAMPLES = os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "..", "..", "examples", "python")
# What mypy is told: packages without types of their own.
CONFIG = "[mypy]\n" + "".join("[mypy-%s.*]\nignore_missing_imports = True\n" % name for name in ("pandas", "matplotlib"))
# What only one side has, by intent: SWIG's functions, and the names of types that annotations are made of. Of
# __all__ of the package mypy sees no sum of lists; those of its modules are checked.
ALLOWED = r"""jalon\.__all__
jalon\._native\..*
jalon\._api\..*\.__swig_destroy__
jalon\._api\.(Array|Bytes|CrsLike|HasWkt|Indices|Path|Progress|R|TargetsLike|ValuesLike)
"""


@unittest.skipIf(SANITIZED, "nothing of it runs native code")
@unittest.skipIf(importlib.util.find_spec("mypy") is None, "mypy is not installed")
class Stubs(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.work = tempfile.TemporaryDirectory()
        for name, text in (("mypy.ini", CONFIG), ("allowed.txt", ALLOWED)):
            with open(os.path.join(cls.work.name, name), "w") as f:
                f.write(text)

    @classmethod
    def tearDownClass(cls):
        cls.work.cleanup()

    def run_mypy(self, *command):
        done = subprocess.run([sys.executable, "-m", *command], cwd=self.work.name, stdout=subprocess.PIPE,
                              stderr=subprocess.STDOUT, text=True)
        self.assertEqual(done.returncode, 0, done.stdout)

    def python__stubs_say_what_there_is(self):
        self.run_mypy("mypy.stubtest", "--concise", "--mypy-config-file", "mypy.ini", "--allowlist", "allowed.txt", "jalon")

    def python__examples_fit_the_stubs(self):
        # Each is a program of its own, with a number for a name.
        for name in sorted(n for n in os.listdir(EXAMPLES) if n.endswith(".py")):
            self.run_mypy("mypy", "--config-file", "mypy.ini", os.path.join(EXAMPLES, name))

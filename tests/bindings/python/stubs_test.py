# SPDX-FileCopyrightText: 2026 The Jalon authors
# SPDX-License-Identifier: Apache-2.0
import importlib.util
import os
import subprocess
import sys
import tempfile
import unittest

from page import says
from scenes import SANITIZED

EXAMPLES = os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "..", "..", "examples", "python")
# What mypy is told: packages without types of their own.
CONFIG = "[mypy]\n" + "".join("[mypy-%s.*]\nignore_missing_imports = True\n" % name for name in ("pandas", "geopandas", "matplotlib"))
# What only one side has, by intent: SWIG's functions, and the names of types that annotations are made of. Of
# __all__ of the package mypy sees no sum of lists; those of its modules are checked.
ALLOWED = r"""jalon\.__all__
jalon\._native\..*
jalon\._api\..*\.__swig_destroy__
jalon\._api\.(Array|Bytes|CrsLike|HasWkt|Indices|Path|Progress|R|TargetsLike|ValuesLike)
"""
# What type checkers must say of columns; a line that they must refuse says so, and one that needs no such comment is refused.
TYPED = """
from typing import Any, List, Tuple
from numpy.typing import NDArray
import numpy
import jalon

def of_rows(segmentation: jalon.Segmentation, segment: jalon.Segment, model: jalon.Model, comparison: jalon.Comparison) -> None:
    area: float = segmentation.segments[0].area
    normal: Tuple[float, float, float] = segment.normal
    orientation: jalon.Orientation = segment.orientation
    names: List[str] = [part.name for part in model]
    width: List[float] = [part.width for part in model[2:]]
    first: float = segmentation[0].sigma
    region: int = comparison.regions().regions[0].region
    uses: List[int] = [edge.uses for edge in model.edges]
    column: NDArray[Any] = segmentation.segments["area"]
    text: str = segment.area  # type: ignore[assignment]
    whole: int = model.edges[0].sagitta  # type: ignore[assignment]
    name: str = comparison.summary.rms  # type: ignore[assignment]
    number: float = segmentation.segments["area"]  # type: ignore[assignment]

def of_summaries(registration: jalon.Registration, cloud: jalon.Cloud) -> None:
    rms: float = registration.summary.rms
    covariance: NDArray[numpy.float64] = registration.summary.covariance
    verdict: jalon.Verdict = registration.summary.verdict
    radius: float = cloud.fit_sphere().radius
    wrong: jalon.Orientation = registration.summary.verdict  # type: ignore[assignment]
"""


@unittest.skipIf(SANITIZED, "nothing of it runs native code")
@unittest.skipIf(importlib.util.find_spec("mypy") is None, "mypy is not installed")
class Stubs(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.work = tempfile.TemporaryDirectory()
        for name, text in (("mypy.ini", CONFIG), ("allowed.txt", ALLOWED), ("typed.py", TYPED)):
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

    @says("Type checkers know the columns of tables, records and summaries with their types.")
    def python__columns_have_their_types(self):
        self.run_mypy("mypy", "--config-file", "mypy.ini", "--strict", "typed.py")

    def python__examples_fit_the_stubs(self):
        # Each is a program of its own, most with a number for a name.
        for name in sorted(n for n in os.listdir(EXAMPLES) if n.endswith(".py")):
            self.run_mypy("mypy", "--config-file", "mypy.ini", os.path.join(EXAMPLES, name))

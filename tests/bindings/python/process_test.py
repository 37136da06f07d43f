# SPDX-FileCopyrightText: 2026 The Jalon authors
# SPDX-License-Identifier: Apache-2.0
import os
import shutil
import subprocess
import sys
import tempfile
import unittest

import jalon
from scenes import SANITIZED

CLEARANCE = """
import jalon
model = jalon.scene_create(name="box")
found = model.clearance_to_model(other=model, other_part=0)
print("%.3f" % found.summary.to_dict()["clearance"])
"""


class Process(unittest.TestCase):
    def run_python(self, code):
        done = subprocess.run([sys.executable, "-c", code], stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True)
        self.assertEqual((done.returncode, done.stderr), (0, ""))
        return done.stdout

    def python__the_interpreter_ends_well_with_objects_alive(self):
        """Views, tasks with callables and cycles of them, that only the end of the process gives back."""
        self.run_python("""
import jalon, threading
cloud = jalon.Cloud([(0, 0, 0), (1, 2, 3)])
view, fields, segmenter = cloud.points, cloud.fields, jalon.Segmenter()
class Holder: pass
holder = Holder()
holder.task = jalon.Task(progress=lambda *_: holder.task, log=lambda *_: holder.view)
holder.view = view
idle = threading.Thread(target=lambda: threading.Event().wait(), daemon=True)
idle.start()
cloud.prepare(task=holder.task)
""")

    @unittest.skipIf(SANITIZED or not sys.platform.startswith("linux") or shutil.which("cc") is None, "needs a C compiler, and Linux")
    @unittest.skipIf("site-packages" not in jalon.__file__, "of the installed package: the build tree takes the system's libraries")
    def python__other_builds_of_its_libraries_in_the_process_are_not_met(self):
        """As in a host that has an FCL and a libccd of its own: here empty ones, by their usual names, loaded first for all."""
        with tempfile.TemporaryDirectory() as folder:
            loads = "import ctypes\n"
            for name in ("libccd.so.2", "liboctomath.so.1.9", "liboctomap.so.1.9", "libfcl.so.0.7"):
                path = os.path.join(folder, name)
                subprocess.run(["cc", "-shared", "-fPIC", "-Wl,-soname," + name, "-x", "c", os.devnull, "-o", path], check=True)
                loads += "ctypes.CDLL(%r, ctypes.RTLD_GLOBAL)\n" % path
            self.assertEqual(self.run_python(loads + CLEARANCE), self.run_python(CLEARANCE))

    @unittest.skipIf("site-packages" not in jalon.__file__, "of the installed package: the build tree has the tool beside it")
    def python__the_package_brings_the_command_jalon(self):
        beside = os.path.join(os.path.dirname(sys.executable), "jalon")
        version = "jalon %s\n" % jalon.version()
        for command in ([beside], [sys.executable, "-m", "jalon"]):
            told = subprocess.run([*command, "--version"], stdout=subprocess.PIPE, text=True, check=True).stdout
            self.assertTrue((told + "\n").startswith(version), told)
        with tempfile.TemporaryDirectory() as folder:
            cloud = os.path.join(folder, "box with façade.las")
            subprocess.run([beside, "scan", "--quiet", "--scene", "box", "-o", cloud, "--set", "horizontal_step_rad=0.02", "--set",
                            "vertical_step_rad=0.02"], check=True)
            self.assertGreater(len(jalon.Cloud.read(cloud)), 100)
            failed = subprocess.run([beside, "info", os.path.join(folder, "none.las")], stdout=subprocess.DEVNULL, stderr=subprocess.PIPE)
            self.assertNotEqual(failed.returncode, 0)

    def python__without_the_tool_the_command_says_so(self):
        self.assertEqual(self.run_python("""
import contextlib, io
from jalon import _tool
_tool.TOOL = "no such file"
told = io.StringIO()
with contextlib.redirect_stderr(told):
    assert _tool.main() == 1
print(told.getvalue(), end="")
"""), "jalon: this package was built without the command line tool (-DJALON_BUILD_CLI=ON builds it)\n")

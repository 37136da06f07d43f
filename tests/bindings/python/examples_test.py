# SPDX-FileCopyrightText: 2026 The Jalon authors
# SPDX-License-Identifier: Apache-2.0
"""The same scenarios in Python and in C print the same numbers. JALON_BUILD: the build folder with the programs in C;
JALON_HIDE: a command before those in Python, which hides the system's FCL from them."""

import os
import subprocess
import sys
import tempfile
import unittest

EXAMPLES = os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "..", "..", "examples", "python")
CODES = """1;0;0;10;300.2
2;22;0;10;300.4
3;22;8;10;300.4
4;0;8;10;300.4
5;0;0;0;300.4
6;0.971;0.2;4.18;360
7;2.171;0.2;5.827;360
8;10.4;0;7.347;361
9;10.4;0.15;7.347;361.8
10;11.6;0;8.994;361
"""
BUILD = os.environ.get("JALON_BUILD", "")
HIDE = os.environ.get("JALON_HIDE", "").split()


@unittest.skipIf(not BUILD, "JALON_BUILD names no build folder")
class Examples(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.work = tempfile.TemporaryDirectory()
        scenes = {"facade_1": ("facade", 0.006, []), "facade_2": ("facade", 0.006, ["--set", "seed=2"]),
                  "day_1": ("earthworks", 0.002, ["--scene-set", "day=1"]), "day_3": ("earthworks", 0.002, ["--scene-set", "day=3"])}
        for name, (scene, step, more) in scenes.items():
            subprocess.run([os.path.join(BUILD, "src", "jalon"), "scan", "--quiet", "--scene", scene, "-o", cls.at(name + ".las"),
                            "--set", "horizontal_step_rad=%g" % step, "--set", "vertical_step_rad=%g" % step, *more], check=True)
        subprocess.run([os.path.join(BUILD, "src", "jalon"), "scan", "--quiet", "--method", "mobile", "-o", cls.at("drive.ply"), "--model",
                        cls.at("street.obj"), "--trajectory", cls.at("drive.txt"), "--scene-set", "sigma_position_m=1", "--scene-set",
                        "leg_m=60", "--set", "revolutions_per_s=10"], check=True)

    @classmethod
    def tearDownClass(cls):
        cls.work.cleanup()

    @classmethod
    def at(cls, name):
        return os.path.join(cls.work.name, name)

    def printed(self, command):
        return subprocess.run(command, check=True, stdout=subprocess.PIPE, stderr=subprocess.DEVNULL, text=True).stdout

    def compare(self, name, *arguments):
        arguments = [self.at(a) for a in arguments]
        in_c = self.printed([os.path.join(BUILD, "examples", "example_" + name), *arguments])
        written = {a: open(a, "rb").read() for a in arguments}
        in_python = self.printed([*HIDE, sys.executable, os.path.join(EXAMPLES, name + ".py"), *arguments])
        self.assertEqual(in_c, in_python)
        self.assertTrue(in_c.strip())
        for path, content in written.items():
            self.assertEqual(len(content), os.path.getsize(path), path)

    def python__01_planes_prints_what_c_prints(self):
        self.compare("01_planes", "facade_1.las")

    def python__02_progress_prints_what_c_prints(self):
        self.compare("02_progress")

    def python__03_model_prints_what_c_prints(self):
        self.compare("03_model", "facade_1.las", "model.dxf")

    def python__04_register_prints_what_c_prints(self):
        self.compare("04_register", "facade_1.las", "facade_2.las", "registered.las")

    def python__05_changes_prints_what_c_prints(self):
        self.compare("05_changes", "day_1.las", "day_3.las")

    def python__06_joint_prints_what_c_prints(self):
        self.compare("06_joint", "street.obj", "drive.ply", "drive.txt", "adjusted.txt")

    def python__07_feature_codes_prints_what_c_prints(self):
        with open(self.at("codes.txt"), "w") as file:
            file.write(CODES)
        self.compare("07_feature_codes", "facade_1.las", "codes.txt", "classified.las", "objects.dxf")

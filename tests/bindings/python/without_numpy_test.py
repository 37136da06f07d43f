# SPDX-FileCopyrightText: 2026 The Jalon authors
# SPDX-License-Identifier: Apache-2.0
"""The package without NumPy, each test in a process that cannot import it."""

import os
import subprocess
import sys
import tempfile
import unittest

from page import says

HEAD = """
import array, sys
for name in ("numpy", "pandas", "matplotlib"):
    sys.modules[name] = None
import jalon
from jalon import plots
cloud = jalon.Cloud([(0, 0, 0), (1, 2, 3), (4, 5, 6)])
def refuses(error, call):
    try: call()
    except error as refused: return str(refused)
    raise SystemExit("taken")
"""


class WithoutNumpy(unittest.TestCase):
    def run_python(self, code):
        with tempfile.TemporaryDirectory() as folder:
            done = subprocess.run([sys.executable, "-c", HEAD + code], stderr=subprocess.PIPE, text=True, cwd=folder, env={
                **os.environ, "PYTHONPATH": os.pathsep.join(os.path.abspath(p) for p in os.environ.get("PYTHONPATH", "").split(os.pathsep) if p)})
        self.assertEqual((done.returncode, done.stderr), (0, ""))

    @says("NumPy is not needed to import it (`pip install --no-deps`): without it arrays are `memoryview`s, and points, boxes and poses are lists.")
    def python__arrays_are_memoryviews_and_small_ones_lists(self):
        self.run_python("""
assert cloud.points.tolist()[1] == [1, 2, 3] and isinstance(cloud.points, memoryview)
assert cloud.bounds == [[0, 0, 0], [4, 5, 6]]
assert cloud.covariance().centroid[0] == 5 / 3
cloud.set_station("S", [[1, 0, 0, 5], [0, 1, 0, 6], [0, 0, 1, 7]])
assert cloud.station(0).pose == [[1, 0, 0, 5], [0, 1, 0, 6], [0, 0, 1, 7], [0, 0, 0, 1]]
moved = cloud.transform(cloud.station(0).pose)
assert moved[0].xyz == (5, 6, 7)
flat = memoryview(array.array("d", range(6))).cast("B").cast("d", [2, 3])
assert jalon.Cloud(flat).points.tolist() == [[0, 1, 2], [3, 4, 5]]
assert jalon.Cloud.create_columns(array.array("f", [1, 2]), [3, 4], 5).points.tolist() == [[1, 3, 5], [2, 4, 5]]
""")

    def python__rows_fields_and_results_work(self):
        self.run_python("""
cloud["level"] = [1, 2, 3]
cloud["one"] = 7
cloud["late"] = [False, True, True]
assert [p.level for p in cloud] == [1, 2, 3] and cloud[1:]["one"].tolist() == [7, 7] and cloud["late"].tolist() == [0, 1, 1]
assert cloud.fields.to_dict() == {"level": [1, 2, 3], "one": [7, 7, 7], "late": [0, 1, 1]}
assert cloud.select([2]).points.tolist() == [[4, 5, 6]] and cloud[[True, False, True]].count == 2
scan = jalon.Scanner("sample", spacing_m=0.3, seed=1).run(jalon.scene_create(name="box"))
segmentation = jalon.Segmenter(distance_tolerance_m=0.05).run(scan)
assert [s.label for s in segmentation] == list(range(1, len(segmentation) + 1)) and len(segmentation[0].normal) == 3
registration = jalon.Registrar("targets").run_targets(*[[("A", (0, 0, 0)), ("B", (9, 0, 0)), ("C", (0, 7, 1))]] * 2)
assert [[round(n, 9) for n in row] for row in registration.pose] == [[1, 0, 0, 0], [0, 1, 0, 0], [0, 0, 1, 0], [0, 0, 0, 1]], registration.pose
assert registration.summary.pairs == 3 and len(registration.summary.covariance) == 36
assert len(registration.summary.to_dict()["covariance"]) == 36
gauge = jalon.Gauge()
gauge.add_box((1, 1, 1))
stations = [[[1, 0, 0, x], [0, 1, 0, 0], [0, 0, 1, 0], [0, 0, 0, 1]] for x in (0, 10)]
assert jalon.gauge_sweep(gauge, stations, jalon.Cloud([(5, 0.6, 0)]), margin_m=0.5).places["point"].tolist() == [0]
assert plots.elevation(segmentation, jalon.Modeller("outlines").run(scan, segmentation)).startswith("<")
assert "segments" in repr(segmentation) and segmentation.to_dict()["segments"]["label"][0] == 1
found = cloud.knn([(0, 0, 0)], 2)
assert found.indices.tolist() == [[0, 1]] and found.to_dict()["indices"] == [[0, 1]]
""")

    @says("Only `to_pandas` (pandas), `numpy.asarray(cloud)` and two of `jalon.plots` (`histogram`, `top_view`: matplotlib) need other packages; `plots.elevation` needs none.")
    def python__what_needs_a_package_says_so(self):
        self.run_python("""
cloud["level"] = [1, 2, 3]
for call, name in ((cloud.to_pandas, "pandas"), (cloud.fields.to_pandas, "pandas"), (lambda: plots.top_view(cloud), "matplotlib"),
                   (lambda: plots.histogram(cloud, "level"), "matplotlib"), (lambda: cloud.__array__(), "numpy")):
    assert name in refuses(ImportError, call), name
for wrong in ("0.3", {1, 2}, [True, 2], memoryview(bytes(3)).cast("?"), 3j):
    assert "xyz" in refuses(TypeError, lambda: jalon.Cloud(wrong))
assert "big" not in refuses(TypeError, lambda: jalon.Cloud("here"))
""")

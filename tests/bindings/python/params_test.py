# SPDX-FileCopyrightText: 2026 The Jalon authors
# SPDX-License-Identifier: Apache-2.0
"""Parameter sets: each type set and read, as a mapping and by name; wrong types named."""

import fractions
import unittest

import numpy as np

import jalon
from scenes import box_cloud


class Parameters(unittest.TestCase):
    def python__operations_are_listed_and_each_can_be_made(self):
        names = [jalon.Params.operation_name(i) for i in range(jalon.Params.operation_count())]
        self.assertIn("normals", names)
        for name in names:
            params = jalon.Params(name)
            self.assertEqual(len(params), len(params.keys()))
            self.assertEqual(list(params), params.keys())
            self.assertEqual(dict(params.items()).keys(), set(params.keys()))
            again = jalon.Params(name)
            again.from_json(params.to_json())
            self.assertEqual(repr(again), repr(params))
            for row in params.rows:
                self.assertIn(row.name, params)
                if row.type != jalon.PARAM_DOUBLES or len(params[row.name]):
                    params[row.name] = params[row.name]

    def python__values_of_every_type_are_set_and_read(self):
        params = jalon.Params("normals")
        params.set_double("radius_m", 0.25)
        params.set_int64("k", 9)
        params.set_bool("curvature", True)
        params.set_string("method", "quadric")
        params.set_doubles("viewpoint", [1, 2, 3])
        self.assertEqual((params.get_double("radius_m"), params.get_int64("k"), params.get_bool("curvature"), params.get_string("method"),
                          params.get_doubles("viewpoint").tolist()), (0.25, 9, True, "quadric", [1, 2, 3]))
        self.assertEqual(params["viewpoint"].tolist(), [1, 2, 3])
        params["viewpoint"] = np.array([4, 5, 6], "f4")
        self.assertEqual(params.to_dict()["viewpoint"], [4, 5, 6])
        params.reset()
        self.assertEqual(params.to_dict(), jalon.Params("normals").to_dict())

    def python__numbers_are_numbers_whole_ones_are_whole_and_flags_are_flags(self):
        wrong = {"radius_m": ("0.3", True, np.True_, None, [0.3], 1j, np.array([0.3])),
                 "k": ("12", True, 12.0, 12.5, None, np.float64(12), [12]),
                 "curvature": ("yes", 1, 0, None, 0.0, "True"),
                 "method": (1, None, b"pca", True),
                 "viewpoint": ("0 0 0", None, [True, False, True], ["1", "2", "3"], {1, 2, 3})}
        for name, values in wrong.items():
            for value in values:
                params = jalon.Params("normals")
                with self.assertRaisesRegex(TypeError, "^%s: .* needed" % name):
                    params[name] = value
                if value is not None:
                    with self.assertRaisesRegex(TypeError, "^%s: .* needed" % name):
                        box_cloud().compute_normals(**{name: value})
                self.assertEqual(params.to_dict(), jalon.Params("normals").to_dict())
        for right in (0.3, np.float32(0.25), np.float64(0.3), 1, np.int8(1), fractions.Fraction(1, 4), np.array(0.5)):
            params["radius_m"] = right
            self.assertEqual(params["radius_m"], float(right))
        for right in (9, np.int16(9), np.uint64(9)):
            params["k"] = right
            self.assertEqual(params["k"], 9)
        for right in (False, np.False_, np.bool_(1 == 2)):
            params["curvature"] = right
            self.assertIs(params["curvature"], False)
        with self.assertRaisesRegex(OverflowError, "^k: "):
            params["k"] = 2 ** 63

    def python__arguments_of_the_wrong_type_are_named_with_what_was_expected(self):
        cloud, model = box_cloud(), jalon.Model.create_mesh(np.eye(3), [(0, 1, 2)])
        for call, told in (
                (lambda: cloud.knn([(0, 0, 0)], "2"), "^k: an int is needed, not str"),
                (lambda: cloud.knn([(0, 0, 0)], True), "^k: an int is needed, not bool"),
                (lambda: cloud.knn("here", 2), "^queries: an array or a sequence of numbers is needed, not str"),
                (lambda: cloud.radius_search([(0, 0, 0)], "0.3"), r"^radius_m: a number is needed, not str \('0.3'\)"),
                (lambda: cloud.radius_search([(0, 0, 0)], True), "^radius_m: a number is needed, not bool"),
                (lambda: cloud.split(3, 1), "^field: a str is needed, not int"),
                (lambda: cloud.append("other"), "^b: a jalon.Cloud is needed, not str"),
                (lambda: jalon.Segmenter().run(model), "^cloud: a jalon.Cloud is needed, not Model"),
                (lambda: jalon.Segmenter().run(None), "^cloud: a jalon.Cloud is needed, not NoneType"),
                (lambda: jalon.Segmenter(3), "^method: a str is needed, not int"),
                (lambda: jalon.Segmenter(distance_tolerance_m="0.3"), "^distance_tolerance_m: a number is needed, not str"),
                (lambda: setattr(jalon.Segmenter(), "distance_tolerance_m", True), "^distance_tolerance_m: a number is needed, not bool"),
                (lambda: cloud.moment(1, 1, 1, centred=1), "^centred: a bool is needed, not int"),
                (lambda: cloud.write(3), "^path: a path .* is needed, not int"),
                (lambda: jalon.Cloud.read(None), "^path: a path .* is needed, not NoneType"),
                (lambda: cloud.compute_normals(task="quick"), "^task: a jalon.Task is needed, not str"),
                (lambda: cloud.compute_normals(progress=3), "^progress: a callable"),
                (lambda: cloud.compute_normals(options=3), "^options: a mapping"),
                (lambda: jalon.Task(threads="2"), "^threads: an int is needed, not str"),
                (lambda: jalon.Task(log=3), "^log: a callable"),
                (lambda: jalon.Targets(["A"]), "^targets: an item: .* needed, not str"),
                (lambda: jalon.Registrar("targets").run_targets(np.eye(3), []), r"^targets: an item: \(name, \(x, y, z\)\) .* needed, not ndarray"),
                (lambda: jalon.Targets([(0, 0, 0)]), r"^targets: an item: \(name, \(x, y, z\)\) .* needed, not tuple"),
                (lambda: jalon.Targets([("A", "here")]), "^xyz: .* needed, not str"),
                (lambda: jalon.Registrar("targets").run_targets(3, []), "^reference: a jalon.Targets"),
                (lambda: cloud.fields.copy("face", "float64"), "^type: an int is needed, not str")):
            with self.assertRaisesRegex(TypeError, told):
                call()

    def python__shapes_are_checked_not_only_sizes(self):
        for call, told in ((lambda: box_cloud().transform(np.eye(4)[:, :3]), r"^transform: the shape \(4, 4\) or \(3, 4\)"),
                           (lambda: box_cloud().transform(np.eye(4).ravel()), "^transform: the shape"),
                           (lambda: box_cloud().transform(np.diag([1, 1, 1, 2.0])), "last row 0 0 0 1"),
                           (lambda: box_cloud().crop_box(np.zeros(6)), r"^box: the shape \(2, 3\)"),
                           (lambda: box_cloud().crop_cylinder((0, 0), (0, 0, 1), 1), r"^foot: the shape \(3,\)"),
                           (lambda: box_cloud().knn(np.zeros((2, 3, 1)), 1), r"^queries: the shape \(N, 3\)"),
                           (lambda: box_cloud().knn([(0, 0), (0, 0, 0)], 1), "^queries: its rows differ in length"),
                           (lambda: box_cloud().knn([(0, 0, 0)], -1), "^k: at least 0"),
                           (lambda: jalon.Targets([("A", (1, 2, 3), np.zeros(8))]), r"^covariance: the shape \(3, 3\)")):
            with self.assertRaisesRegex(ValueError, told):
                call()

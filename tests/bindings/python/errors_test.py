# SPDX-FileCopyrightText: 2026 The Jalon authors
# SPDX-License-Identifier: Apache-2.0
import inspect
import os
import pathlib
import tempfile
import unittest

import numpy as np

import jalon
from jalon import _errors, _native
from scenes import SANITIZED, box_cloud


def free_bytes():
    with open("/proc/meminfo") as f:
        return 1024 * int(f.read().split("MemAvailable:")[1].split()[0])


class Errors(unittest.TestCase):
    def python__every_status_has_its_class(self):
        codes = {getattr(_native, name) for name in dir(_native) if name.startswith("ERROR_")}
        classes = {getattr(_errors, name).code for name in _errors.__all__}
        self.assertEqual(codes - classes, set())
        for name in _errors.__all__:
            self.assertTrue(issubclass(getattr(jalon, name), jalon.Error))

    def python__failures_are_also_the_builtin_that_fits(self):
        cloud = jalon.Cloud([(0, 0, 0)])
        with self.assertRaises(FileNotFoundError) as caught:
            jalon.Cloud.read(pathlib.Path("no") / "such.las")
        self.assertEqual((caught.exception.filename, caught.exception.errno), (os.path.join("no", "such.las"), 2))
        self.assertIsInstance(caught.exception, jalon.NotFoundError)
        self.assertRaises(LookupError, lambda: cloud["nothing"])
        self.assertRaises(jalon.InsufficientDataError, jalon.Segmenter().run, cloud)
        with self.assertRaises(jalon.FormatError):
            with tempfile.TemporaryDirectory() as folder:
                path = os.path.join(folder, "bad.las")
                pathlib.Path(path).write_bytes(b"LASF" + bytes(100))
                jalon.Cloud.read(path)

    def python__what_is_missing_is_called_none(self):
        with self.assertRaisesRegex(ValueError, "^cloud and model are both None$"):
            gauge = jalon.Gauge()
            gauge.add_sphere(1)
            jalon.gauge_sweep(gauge, [np.eye(4)])

    def python__keyword_arguments_are_checked(self):
        self.assertRaises(TypeError, jalon.Segmenter, no_such=1)
        self.assertRaises(ValueError, jalon.Segmenter, distance_tolerance_m=-1)
        self.assertRaises(LookupError, jalon.Segmenter, "no such method")
        self.assertRaises(TypeError, box_cloud().compute_normals, neighbours=3)
        self.assertRaises(TypeError, box_cloud().compute_normals, k=3.5)
        segmenter = jalon.Segmenter()
        with self.assertRaises(AttributeError):
            segmenter.distance_tolerence_m = 3
        segmenter.distance_tolerance_m = 0.03
        self.assertEqual(segmenter.distance_tolerance_m, 0.03)
        self.assertEqual(segmenter.params["distance_tolerance_m"], 0.03)

    def python__options_come_as_keywords_mapping_or_set(self):
        thin = [box_cloud().subsample(method="voxel", cell_m=0.5),
                box_cloud().subsample(options={"method": "voxel", "cell_m": 0.5})]
        params = jalon.Params("subsample")
        params["method"], params["cell_m"] = "voxel", 0.5
        thin.append(box_cloud().subsample(options=params))
        self.assertEqual(len({t.count_out for t in thin}), 1)
        self.assertEqual(params.to_dict()["cell_m"], 0.5)
        self.assertRaises(jalon.InvalidArgumentError, box_cloud().subsample, options=jalon.Params("normals"))

    def python__texts_cross_as_utf8(self):
        with tempfile.TemporaryDirectory() as folder:
            path = pathlib.Path(folder) / "façade_漢_😀.las"
            box_cloud().write(path)
            self.assertEqual(len(jalon.Cloud.read(path)), len(box_cloud()))
            with self.assertRaises(FileNotFoundError) as caught:
                jalon.Cloud.read(pathlib.Path(folder) / "façade_漢_🙃.las")
            self.assertIn("façade_漢_🙃.las", str(caught.exception))
        cloud = jalon.Cloud(np.zeros((3, 3)))
        cloud.crs = "été_漢_😀"
        self.assertEqual(cloud.crs, "été_漢_😀")
        self.assertRaises(ValueError, setattr, cloud, "crs", "a\0b")

    @unittest.skipIf(SANITIZED, "the allocator of a sanitizer ends the program instead")
    def python__sizes_beyond_memory_are_refused(self):
        self.assertRaises((jalon.Error, OverflowError), box_cloud().knn, np.zeros((3, 3)), 2 ** 32)
        self.assertRaises((jalon.Error, MemoryError), box_cloud().knn_all, 2 ** 32 - 1)
        one = np.lib.stride_tricks.as_strided(np.zeros(3), shape=(2 ** 44, 3), strides=(0, 8))
        self.assertRaises((MemoryError, ValueError), jalon.Cloud, one)
        self.assertRaises(OverflowError, jalon.Params("subsample").set_int64, "seed", 2 ** 70)

    def python__sizes_above_two_to_the_31_cross_whole(self):
        """Sparse memory that is not touched: what is refused tells the count in full."""
        many = np.zeros(2 ** 32 + 3, np.uint8)
        with self.assertRaisesRegex(ValueError, "4294967299"):
            box_cloud().set_field("many", many)
        with self.assertRaisesRegex(ValueError, "2147483653"):
            box_cloud().set_field("many", many[:2 ** 31 + 5])

    @unittest.skipUnless(os.environ.get("JALON_FULL") and free_bytes() > 10e9, "JALON_FULL=1 and 10 GB of free memory")
    def python__an_array_of_more_than_two_to_the_31_elements_goes_round(self):
        rows, columns = 2 ** 19 + 1, 4096
        cloud = jalon.Cloud(np.zeros((rows, 3)))
        given = np.zeros((rows, columns), np.uint8)  # sparse: zero pages
        given[-1] = np.arange(columns) % 251
        cloud["many"] = given
        view = cloud["many"]
        self.assertEqual((view.shape, view.size > 2 ** 31), ((rows, columns), True))
        self.assertTrue(np.array_equal(view[-1], given[-1]))
        print("FIGURE %d elements go round in Python" % view.size)

    def python__counts_above_two_to_the_forty_go_round(self):
        params = jalon.Params("subsample")
        params["seed"] = 2 ** 41 + 7
        self.assertEqual(params["seed"], 2 ** 41 + 7)
        with self.assertRaisesRegex(jalon.Error, "1099511627777|2199023255559"):
            box_cloud().station(2 ** 40 + 1)

    def python__everything_is_documented(self):
        silent = []
        for name in jalon.__all__:
            value = getattr(jalon, name)
            if callable(value) and not value.__doc__:
                silent.append(name)
            for part, member in inspect.getmembers(value) if inspect.isclass(value) else ():
                if not part.startswith("_") and (inspect.isfunction(member) or isinstance(member, property)) and not member.__doc__:
                    silent.append(name + "." + part)
        self.assertEqual(silent, [])
        self.assertIn("distance_tolerance_m", jalon.Segmenter.__init__.__doc__)
        self.assertIn("(m,", jalon.Segmenter.distance_tolerance_m.__doc__)

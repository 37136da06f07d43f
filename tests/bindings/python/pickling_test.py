# SPDX-FileCopyrightText: 2026 The Jalon authors
# SPDX-License-Identifier: Apache-2.0
import concurrent.futures
import copy
import multiprocessing
import pickle
import unittest
import zlib

import numpy as np

import jalon
from scenes import box_cloud

DTYPES = ("i1", "u1", "i2", "u2", "i4", "u4", "i8", "u8", "f4", "f8")


def rich_cloud():
    """All element types, any bits, a CRS, a station."""
    cloud = box_cloud().copy()
    n = len(cloud)
    for k, dtype in enumerate(DTYPES):
        bits = np.random.default_rng(k).integers(0, 256, n * (k % 3 + 1) * np.dtype(dtype).itemsize, dtype=np.uint8)
        bits[-8:] = 255  # a NaN with a payload
        cloud.set_field("any " + dtype, bits.view(dtype).reshape(n, -1), unit="m", meaning="whatever")
    cloud.crs = "EPSG:2154"
    cloud.set_station("first", np.eye(4))
    return cloud


def objects():
    """One of each kind that has bytes, by its class."""
    cloud = rich_cloud()
    segmentation = jalon.Segmenter(min_points=20).run(cloud)
    model = jalon.Modeller().run(cloud, segmentation)
    comparison = jalon.Comparer(max_distance_m=2).run(cloud, cloud)
    targets = jalon.Segmenter("region_growing", min_points=50)
    scanner = jalon.Scanner(seed=5)
    scanner.add_station(np.eye(4), "S1")
    made = [cloud, segmentation, model, comparison, targets, scanner, jalon.Modeller("facade"), jalon.Comparer("m3c2"),
            jalon.Registrar("icp").run(cloud, cloud), jalon.Registrar(), segmentation.segments,
            segmentation.evaluate(segmentation), model.evaluate(model), targets.params,
            jalon.NoiseLaw.from_json('{"law": "gauss", "mean": 0.1, "sigma": 0.003}')]
    return {type(o).__name__: o for o in made}


class Mine(jalon.Segmenter):
    pass


class Pickling(unittest.TestCase):
    def python__objects_of_all_kinds_come_back_from_pickles(self):
        for name, made in objects().items():
            for protocol in range(2, pickle.HIGHEST_PROTOCOL + 1):
                back = pickle.loads(pickle.dumps(made, protocol))
                self.assertIs(type(back), type(made))
                self.assertEqual(back.to_bytes(), made.to_bytes(), (name, protocol))

    def python__every_class_has_bytes_or_says_that_it_has_none(self):
        classes = {n: getattr(jalon, n) for n in jalon.__all__ if hasattr(getattr(jalon, n), "close")}
        with_bytes = {n for n, of in classes.items() if hasattr(of, "from_bytes")}
        self.assertEqual(with_bytes, set(objects()))
        for made in (jalon.Task(), jalon.CloudBuilder()):
            self.assertRaisesRegex(TypeError, "cannot be pickled", pickle.dumps, made)
            self.assertRaisesRegex(TypeError, "cannot be copied", copy.copy, made)
            self.assertRaisesRegex(TypeError, "cannot be copied", copy.deepcopy, made)

    def python__a_cloud_comes_back_with_fields_crs_and_stations(self):
        cloud = rich_cloud()
        back = pickle.loads(pickle.dumps(cloud))
        np.testing.assert_array_equal(back.points, cloud.points)
        self.assertEqual(back.crs, "EPSG:2154")
        self.assertEqual(back.stations[0].name, "first")
        for k in range(cloud.fields.count):
            info = cloud.fields.info(k)
            self.assertEqual(back.fields.info(k), info)
            self.assertEqual(back[info.name].tobytes(), cloud[info.name].tobytes())

    def python__copies_share_what_never_changes_and_nothing_else(self):
        for copied in (copy.copy, copy.deepcopy, lambda o: o.copy()):
            cloud = rich_cloud()
            other = copied(cloud)
            self.assertEqual(other.to_bytes(), cloud.to_bytes())
            self.assertTrue(np.shares_memory(other.points, cloud.points))
            other["new"] = np.zeros(len(other))
            self.assertNotIn("new", cloud)
            cloud.close()
            self.assertEqual(other["new"].sum(), 0)
            worker = jalon.Segmenter(min_points=77)
            same = copied(worker)
            self.assertEqual(same.min_points, 77)
            same.min_points = 78
            self.assertEqual(worker.min_points, 77)
        for name, made in objects().items():
            other = copy.deepcopy(made)
            self.assertEqual(other.to_bytes(), made.to_bytes(), name)
            held = made.to_bytes()
            made.close()
            self.assertEqual(other.to_bytes(), held, name)

    def python__workers_and_clouds_cross_to_another_process(self):
        cloud, segmenter = box_cloud(), jalon.Segmenter(min_points=20)
        here = segmenter.run(cloud)
        with concurrent.futures.ProcessPoolExecutor(1, multiprocessing.get_context("spawn")) as pool:
            there = pool.submit(segmenter.run, cloud).result()
        self.assertGreater(len(here), 2)
        self.assertEqual(there.to_bytes(), here.to_bytes())

    def python__results_of_several_parts_come_back(self):
        split = jalon.Segmenter(min_points=20).run(box_cloud()).residuals(0, 8)
        back = pickle.loads(pickle.dumps(split))
        self.assertIs(type(back), type(split))
        self.assertEqual(back.bins.to_bytes(), split.bins.to_bytes())
        self.assertEqual(back.normal, split.normal)

    def python__rows_come_back_as_the_records_that_they_were(self):
        registration = jalon.Registrar("icp").run(box_cloud(), box_cloud())
        for again in (pickle.loads(pickle.dumps(registration.summary)), copy.copy(registration.summary), copy.deepcopy(registration.summary)):
            self.assertIs(type(again), jalon.Summary)
            self.assertIs(again.stopped, jalon.Stopped.CONVERGED)
            self.assertRaises(ValueError, again.covariance.__setitem__, 0, 1)
            self.assertEqual(again.table.to_bytes(), registration.summary.table.to_bytes())
        segments = jalon.Segmenter(min_points=20).run(box_cloud()).segments
        model = jalon.Modeller().run(box_cloud(), jalon.Segmenter(min_points=20).run(box_cloud()))
        for copied in (copy.copy, copy.deepcopy, lambda made: pickle.loads(pickle.dumps(made))):
            self.assertIs(type(copied(segments)[0]), jalon.Segment)
            self.assertIs(copied(segments)[0].type, jalon.Primitive.PLANE)
            self.assertEqual(copied(model.faces)[0].__geo_interface__, model.faces[0].__geo_interface__)
            table = registration.summary.table
            own = copied(table)
            table.close()
            self.assertEqual(own[0].table.to_dict(), own.to_dict())
        closed = registration.summary
        closed.table.close()
        self.assertEqual(pickle.loads(pickle.dumps(closed)).rms, closed.rms)

    def python__large_blocks_leave_the_pickle_where_the_pickler_takes_them(self):
        cloud, buffers = rich_cloud(), []
        data = pickle.dumps(cloud, 5, buffer_callback=buffers.append)
        self.assertLess(len(data), 500)
        self.assertEqual(len(buffers), 1)
        self.assertEqual(pickle.loads(data, buffers=buffers).to_bytes(), cloud.to_bytes())

    def python__bytes_are_taken_from_anything_with_a_buffer(self):
        cloud = rich_cloud()
        data = cloud.to_bytes()
        self.assertIs(type(data), bytes)
        for given in (data, bytearray(data), memoryview(data), np.frombuffer(data, np.uint8), np.frombuffer(data, np.int8)):
            self.assertEqual(jalon.Cloud.from_bytes(given).to_bytes(), data)
        self.assertRaises(TypeError, jalon.Cloud.from_bytes, "a text")
        self.assertRaises(TypeError, jalon.Cloud.from_bytes, 5)
        for given in (None, np.zeros(9), np.zeros(9, bool), [1, 2]):
            self.assertRaisesRegex(TypeError, "bytes: bytes, or a buffer of them is needed", jalon.Cloud.from_bytes, given)
        self.assertRaisesRegex(ValueError, "bytes side by side", jalon.Cloud.from_bytes, memoryview(data)[::2])
        self.assertRaises(jalon.FormatError, jalon.Cloud.from_bytes, b"")
        self.assertRaises(jalon.FormatError, jalon.Cloud.from_bytes, data[:-1])
        self.assertRaisesRegex(ValueError, "the bytes of a cloud, not of a model", jalon.Model.from_bytes, data)

    def python__bytes_of_a_later_release_are_told_from_damaged_ones(self):
        data = bytearray(rich_cloud().to_bytes())
        data[8:12] = (2).to_bytes(4, "little")  # the layout
        checksum = zlib.crc32(data[:24])
        for begin in range(32, len(data), 1 << 20):
            checksum = zlib.crc32(zlib.crc32(data[begin:begin + (1 << 20)]).to_bytes(4, "little"), checksum)
        data[24:28] = checksum.to_bytes(4, "little")
        self.assertRaises(jalon.UnsupportedError, jalon.Cloud.from_bytes, data)

    def python__a_result_brings_the_points_that_it_looks_at(self):
        cloud = box_cloud().copy()
        segmentation = jalon.Segmenter(min_points=20).run(cloud)
        data = pickle.dumps(segmentation)
        self.assertGreater(len(data), cloud.points.nbytes)
        faces = len(jalon.Modeller().run(cloud, segmentation).faces)
        cloud.close()
        segmentation.close()
        back = pickle.loads(data)
        self.assertEqual(len(jalon.Modeller().run(box_cloud(), back).faces), faces)
        self.assertEqual(len(back.points), len(box_cloud()))

    def python__damaged_pickles_are_refused(self):
        data = bytearray(pickle.dumps(rich_cloud()))
        data[-40] ^= 1
        self.assertRaises(jalon.FormatError, pickle.loads, bytes(data))

    def python__objects_of_derived_classes_come_back_as_what_jalon_knows(self):
        back = pickle.loads(pickle.dumps(Mine(min_points=5)))
        self.assertEqual((type(back), back.min_points), (jalon.Segmenter, 5))

# SPDX-FileCopyrightText: 2026 The Jalon authors
# SPDX-License-Identifier: Apache-2.0
"""Points, segments, parts, faces and rows of tables as records; summaries; enums; what objects say of themselves."""

import copy
import enum
import inspect
import pickle
import unittest

import numpy as np

import jalon
from scenes import box_cloud, box_model


class Records(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.segmentation = jalon.Segmenter(distance_tolerance_m=0.02).run(box_cloud())
        cls.registration = jalon.Registrar("targets").run_targets(
            [("A", (0, 0, 0)), ("B", (9, 0, 0)), ("C", (0, 7, 1))], [("A", (1, 0, 0)), ("B", (10, 0, 0)), ("C", (1, 7, 1))])

    def python__a_point_of_a_cloud_is_a_record(self):
        cloud, xyz = box_cloud(), box_cloud().points
        point = cloud[5]
        self.assertIsInstance(point, jalon.Point)
        self.assertEqual((point.index, point.xyz, (point.x, point.y, point.z)), (5, tuple(xyz[5]), tuple(xyz[5])))
        self.assertEqual((point.face, type(point.face)), (cloud["face"][5], int))
        self.assertEqual(cloud[-1].xyz, tuple(xyz[-1]))
        self.assertEqual(cloud[np.int32(7)].index, 7)
        for i in (len(cloud), -len(cloud) - 1):
            self.assertRaises(IndexError, lambda: cloud[i])
        for wrong in (1.5, True, None, (1, 2)):
            self.assertRaises(TypeError, lambda: cloud[wrong])

    def python__a_cloud_is_run_through_and_sliced(self):
        cloud, xyz = jalon.Cloud(np.arange(30000.0).reshape(-1, 3)), np.arange(30000.0).reshape(-1, 3)
        cloud["n"] = range(10000)
        self.assertEqual([p.xyz for p in cloud], [tuple(row) for row in xyz])
        self.assertEqual([p.n for p in cloud], list(range(10000)))
        for cut in (slice(2, 9), slice(None, None, -1), slice(-5, None), slice(9, 2)):
            self.assertTrue(np.array_equal(cloud[cut].points, xyz[cut]))
        self.assertTrue(np.array_equal(cloud[[3, 1]]["n"], [3, 1]))
        self.assertTrue(np.array_equal(np.asarray(cloud), xyz))
        self.assertTrue(np.array_equal(np.array(cloud, dtype="f4"), xyz.astype("f4")))

    def python__segments_are_records_with_enums(self):
        segments = self.segmentation.segments
        rows = list(self.segmentation)
        self.assertEqual(len(rows), len(self.segmentation))
        self.assertEqual([row.area for row in rows], segments["area"].tolist())
        first = self.segmentation[0]
        self.assertIsInstance(first, jalon.Segment)
        self.assertIs(first.type, jalon.Primitive.PLANE)
        self.assertIsInstance(first.orientation, jalon.Orientation)
        self.assertEqual(first.normal, tuple(segments["normal"][0]))
        self.assertEqual(repr(first), repr(segments[0]))  # some are NaN
        self.assertEqual(self.segmentation[-1].label, len(segments))
        self.assertEqual([row.label for row in segments[1:3]], [2, 3])
        self.assertEqual(len(self.segmentation[:2]), 2)
        self.assertRaises(IndexError, lambda: segments[len(segments)])
        self.assertRaises(TypeError, lambda: segments[1.0])
        self.assertEqual([repr(row) for row in segments], [repr(row) for row in rows])

    def python__records_are_read_only_mappings(self):
        row = self.segmentation[0]
        self.assertEqual(row["area"], row.area)
        self.assertEqual(dict(row), row.to_dict())
        self.assertEqual((len(row), list(row)), (len(row.to_dict()), self.segmentation.segments.keys()))
        self.assertIn("area", dir(row))
        for change in (lambda: setattr(row, "area", 3), lambda: setattr(row, "new", 3), lambda: row.__setitem__("area", 3)):
            self.assertRaises((AttributeError, TypeError), change)
        with self.assertRaisesRegex(AttributeError, "Segment has no 'aera', but label, .*area"):
            row.aera
        with self.assertRaisesRegex(KeyError, "aera"):
            row["aera"]
        self.assertEqual(repr(pickle.loads(pickle.dumps(row)).to_dict()), repr(copy.copy(row).to_dict()))
        self.assertRegex(repr(row), r"^Segment\(label=1, .*covariance=<16 numbers>")

    def python__parts_and_faces_are_records(self):
        model = box_model()
        parts = list(model)
        self.assertEqual((len(model), [p.index for p in parts]), (model.part_count, list(range(model.part_count))))
        self.assertEqual([p.name for p in parts], [model.part(i).name for i in range(model.part_count)])
        self.assertEqual(repr((model[-1], model[0:2])), repr((parts[-1], parts[:2])))  # some are NaN
        self.assertIsInstance(parts[0].evidence, jalon.Evidence)
        self.assertRaises(IndexError, lambda: model[model.part_count])
        faces = list(model.faces)
        self.assertIsInstance(faces[0], jalon.Face)
        self.assertEqual(faces[2]["class"], faces[2].class_)
        self.assertIsInstance(faces[2].class_, jalon.Orientation)
        self.assertEqual(sum(face.area for face in faces), model.faces["area"].sum())

    def python__models_faces_and_regions_are_geojson_features(self):
        model = box_model()
        collection = model.__geo_interface__
        self.assertEqual((collection["type"], len(collection["features"])), ("FeatureCollection", len(model.faces)))
        vertices = {tuple(v) for v in model.vertices["xyz"]}
        for face, feature in zip(model.faces, collection["features"]):
            self.assertEqual(face.__geo_interface__, feature)
            for ring in feature["geometry"]["coordinates"]:
                self.assertEqual(ring[0], ring[-1])
                self.assertTrue({tuple(p) for p in ring} <= vertices)
        moved = jalon.Cloud(box_cloud().points + [0, 0, 0.5])
        regions = jalon.Comparer("distance").run(box_cloud(), moved).regions(criterion="threshold", threshold_m=0.2, min_points=5).regions
        region = regions[0]
        self.assertIsInstance(region, jalon.Region)
        feature = region.__geo_interface__
        self.assertEqual(feature["geometry"]["coordinates"][0][0], region.box_min[:2])
        self.assertEqual(feature["properties"]["points"], region.points)

    def python__summaries_give_numbers(self):
        summary = self.registration.summary
        self.assertIsInstance(summary, jalon.Summary)
        self.assertEqual((summary["pairs"], summary.pairs, type(summary.rms)), (3, 3, float))
        self.assertIs(summary.stopped, jalon.Stopped.CONVERGED)
        self.assertEqual(summary["stopped"], 1)
        self.assertEqual(summary["covariance"].shape, (36,))
        self.assertEqual(list(summary), summary.table.keys())
        self.assertEqual(summary.to_dict()["covariance"], summary.covariance.tolist())
        self.assertEqual(summary.table.info(4).unit, "m")
        self.assertIn("rms", dir(summary))
        with self.assertRaisesRegex(AttributeError, "Summary has no 'rsm', but converged"):
            summary.rsm
        self.assertRaises(LookupError, lambda: summary["rsm"])
        self.assertRaises(ValueError, summary.covariance.__setitem__, 0, 1)
        self.assertRegex(repr(summary), r"^Summary\(converged=1, .*covariance=<36 numbers>")
        self.assertEqual(repr(summary), repr(self.registration.summary))  # some are NaN
        self.assertEqual(box_model().clearance(jalon.Cloud([(0, 0, 9)])).summary.closed, 0)

    def python__constants_are_members_of_enums_and_numbers(self):
        self.assertIs(jalon.FLOAT64, jalon.ElementType.FLOAT64)
        self.assertEqual(jalon.ORIENTATION_HORIZONTAL, 3)
        self.assertIs(jalon.ERROR_NOT_FOUND, jalon.Status.ERROR_NOT_FOUND)
        self.assertIs(jalon.Fields.info(box_cloud().fields, 0).type, jalon.ElementType(box_cloud().fields.info(0).type))
        self.assertIs(jalon.Params("normals").rows[0].type, jalon.ParamType.CHOICE)
        classes = [value for value in vars(jalon).values() if inspect.isclass(value) and issubclass(value, enum.IntEnum)]
        self.assertGreaterEqual(len(classes), 14)
        for each in classes:
            self.assertEqual(len(each.__members__), len({int(member) for member in each}), each)

    def python__every_object_tells_what_it_is(self):
        law = jalon.NoiseLaw.from_json('{"law": "gauss", "mean": 0, "sigma": 1}')
        gauge, targets = jalon.Gauge(), jalon.Targets([("A", (1, 2, 3))])
        gauge.add_sphere(1)
        told = {repr(o) for o in (box_cloud()[:3], box_cloud()[:3].fields, self.segmentation, box_model(), self.registration, law, gauge,
                                  targets, jalon.Task(), jalon.CloudBuilder(), jalon.Params("normals"), jalon.Scanner("sample"))}
        self.assertEqual(len(told), 12)
        for text in told:
            self.assertNotIn("object at 0x", text)
        self.assertEqual(repr(gauge), "<jalon.Gauge of 1 piece>")
        self.assertEqual(repr(targets), "<jalon.Targets of 1 target>")
        self.assertEqual(repr(self.segmentation), "<jalon.Segmentation of %d segments>" % len(self.segmentation))
        self.assertIn("CONVERGED", repr(self.registration))
        self.assertRegex(repr(box_model()), "^<jalon.Model of .*%d faces" % len(box_model().faces))

    def python__attributes_that_there_are_not_cannot_be_set(self):
        objects = (box_cloud(), box_cloud().fields, self.segmentation, box_model(), self.registration, jalon.Task(), jalon.Gauge(),
                   jalon.Targets(), jalon.Params("normals"), jalon.Segmenter(), self.registration.summary)
        for each in objects:
            with self.assertRaises(AttributeError):
                each.colour = 3
        for name in ("points", "select", "count"):
            with self.assertRaises(AttributeError):
                setattr(box_cloud(), name, 3)

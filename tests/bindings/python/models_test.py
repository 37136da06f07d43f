# SPDX-FileCopyrightText: 2026 The Jalon authors
# SPDX-License-Identifier: Apache-2.0
"""Models: meshes, tables, files, volumes, clearance and gauges, against what their shapes say."""

import json
import os
import tempfile
import unittest

import numpy as np

import jalon
from clouds_test import grid
from scenes import box_model

CORNERS = np.array([(x, y, z) for z in (0.0, 1) for y in (0.0, 1) for x in (0.0, 1)])
# Outward triangles of the unit cube.
CUBE = [(0, 2, 1), (1, 2, 3), (4, 5, 6), (5, 7, 6), (0, 1, 4), (1, 5, 4), (2, 6, 3), (3, 6, 7), (0, 4, 2), (2, 4, 6), (1, 3, 5), (3, 7, 5)]


def cube(scale=1.0, shift=(0, 0, 0)):
    return jalon.Model.create_mesh(CORNERS * scale + shift, CUBE)


def pose_at(x, y=0.0, z=0.0):
    made = np.eye(4)
    made[:3, 3] = x, y, z
    return made


def seen_past_a_screen():
    """(cloud, segmentation) of a wall of 14 x 7 m with two rows of five windows, panes 20 cm behind, as one eye sees them past a
    screen that hides the fourth window of the upper row whole."""
    eye = np.array([7.0, -9, 3])
    x, z = np.meshgrid(np.arange(0.01, 14, 0.025), np.arange(0.01, 7, 0.025), indexing="ij")
    x, z = x.ravel(), z.ravel()
    screen = (x > 8.13) & (x < 9.11) & (z > 3.46) & (z < 4.74)

    def in_windows(u, w):
        corners = [(1 + 2.7 * i, 1 + 3.0 * j) for i in range(5) for j in range(2)]
        return sum((u > x0) & (u < x0 + 1.1) & (w > z0) & (w < z0 + 1.6) for x0, z0 in corners) > 0

    def crossing(points, y):
        return eye + (points - eye) * ((y - eye[1]) / (points[:, 1] - eye[1]))[:, None]

    def sees(points):
        q = crossing(points, -3.5)
        return ~((q[:, 0] > 8.13) & (q[:, 0] < 9.11) & (q[:, 2] > 3.46) & (q[:, 2] < 4.74))
    wall = np.c_[x, np.random.default_rng(5).normal(0, 0.002, len(x)), z]
    pane = np.c_[x, np.full(len(x), 0.2), z]
    front = np.c_[x, np.full(len(x), -3.5), z][screen]
    through = crossing(pane, 0)
    seen = [wall[~in_windows(x, z) & sees(wall)], pane[in_windows(x, z) & in_windows(through[:, 0], through[:, 2]) & sees(pane)], front]
    cloud = jalon.Cloud(np.vstack(seen))
    cloud["plane"] = np.repeat([1, 2, 3], [len(points) for points in seen])
    cloud.set_station("eye", pose_at(*eye))
    return cloud, jalon.Segmentation.from_labels(cloud, "plane")


class Models(unittest.TestCase):
    def python__a_mesh_keeps_its_triangles(self):
        mesh = jalon.Model.create_mesh(CORNERS, CUBE, face_ids=np.arange(12) + 100)
        self.assertTrue(np.array_equal(mesh.triangles["vertices"], CUBE))
        self.assertEqual(mesh.triangles["face"].tolist(), list(range(100, 112)))
        self.assertTrue(np.array_equal(mesh.vertices["xyz"], CORNERS))
        with self.assertRaisesRegex(TypeError, "triangles: whole numbers"):
            jalon.Model.create_mesh(CORNERS, np.array(CUBE, float))

    def python__the_tables_of_a_model_belong_together(self):
        model = box_model()
        faces, rings, corners = model.faces, model.rings, model.corners
        self.assertEqual(int(faces["ring_count"].sum()), len(rings))
        self.assertEqual(int(rings["count"].sum()), len(corners))
        self.assertLess(corners["vertex"].max(), len(model.vertices))
        self.assertTrue((model.edges["from"] < model.edges["to"]).all())
        self.assertEqual(len(model.solids), 0)
        self.assertEqual(model.crs, "")
        face = faces[0]
        outline = rings[face.first_ring]
        at = model.vertices["xyz"][corners["vertex"][outline.first:outline.first + outline.count]]
        self.assertTrue(np.allclose(at @ face.normal, face.offset))

    def python__models_go_to_files_and_back(self):
        with tempfile.TemporaryDirectory() as folder:
            path = os.path.join(folder, "cube.obj")
            cube().write(path)
            self.assertEqual(len(jalon.Model.read(path).triangles) or len(jalon.Model.read(path).faces), 12)

    def python__parts_are_renamed_in_a_new_model(self):
        named = box_model().rename_part(1, "floor", "slab")
        self.assertEqual(named.part(1)[:2], ("floor", "slab"))
        self.assertEqual(box_model().part(1).name, "ground")
        with self.assertRaisesRegex(ValueError, "copy|copied"):
            named.remove_copy(1)

    def python__copied_openings_are_vetoed(self):
        model = jalon.Modeller("facade").run(*seen_past_a_screen())
        windows = [part for part in model if part.part_class == "window"]
        copies = [part for part in windows if part.evidence is jalon.Evidence.COPIED]
        self.assertEqual((len(windows), len(copies)), (10, 1))
        less = model.remove_copy(copies[0].index)
        self.assertEqual(sum(part.part_class == "window" for part in less), 9)

    def python__parts_and_faces_know_how_they_lie_to_each_other(self):
        model = jalon.Modeller("facade").run(*seen_past_a_screen())
        of = {part.index: part.part_class for part in model}
        table = model.relations()
        pairs = {(of[a], of[b]): r for a, b, r in zip(table["first"], table["second"], table["relation"])}
        self.assertEqual(pairs["wall", "window"], jalon.Relation.CONTAINS)
        self.assertEqual(table["matrix"].shape, (len(table["first"]), 9))
        self.assertTrue((table["distance"] <= 0.5).all())
        row = model.relations(max_distance_m=20)
        beside = [d for a, b, d in zip(row["first"], row["second"], row["direction"]) if of[a] == of[b] == "window"]
        self.assertTrue(all(d & (jalon.Direction.LEFT | jalon.Direction.RIGHT | jalon.Direction.ABOVE | jalon.Direction.BELOW) for d in beside))
        faces = model.relations(elements="faces")
        self.assertIn(jalon.Relation.MEET, faces["relation"])
        with self.assertRaises(jalon.Error):
            model.relations(elements="solids")

    def python__points_are_sampled_on_all_faces(self):
        points = cube(2).sample(points=6000, seed=1)
        self.assertEqual(len(points), 6000)
        on_faces = np.isclose(points.points, 0) | np.isclose(points.points, 2)
        self.assertTrue(on_faces.any(1).all())
        self.assertLess(np.abs(np.bincount(points["triangle"]) - 500).max(), 3)

    def python__volumes_are_those_of_the_shapes(self):
        between = cube().volume(cube(2))
        self.assertAlmostEqual(between.summary.net, 7)
        low = jalon.Cloud(grid(50, 50, 0.1))
        dug = low.points.copy()
        pit = (np.abs(dug[:, :2] - 2.45) < 0.5).all(1)
        dug[pit, 2] -= 0.4
        summary, cells = low.volume(jalon.Cloud(dug), cell_m=0.1)
        self.assertAlmostEqual(summary.cut, pit.sum() * 0.01 * 0.4, places=6)
        self.assertEqual(summary.fill, 0)
        self.assertAlmostEqual(-cells["volume"][cells["difference"] < 0].sum(), summary.cut)

    def python__clearance_is_that_of_the_shapes(self):
        points = jalon.Cloud([(3, 0.5, 0.5), (1.25, 0.5, 0.5), (0.5, 0.5, 0.9)])
        found = cube().clearance(points, margin_m=0.5)
        self.assertAlmostEqual(found.summary.depth, 0.1)
        self.assertEqual((found.summary.interferes, found.summary.inside), (1, 1))
        self.assertEqual(found.near_points["point"].tolist(), [1, 2])
        self.assertAlmostEqual(found.near_points[0].clearance, 0.25)
        both = cube().clearance_to_model(cube(1, (1.5, 0, 0)), margin_m=0.6)
        self.assertAlmostEqual(both.summary.clearance, 0.5)
        self.assertEqual(both.to_dict()["summary"]["interferes"], 0)
        self.assertGreaterEqual(len(both.near_faces), 2)

    def python__a_scene_brings_its_scanner_and_tells_its_openings(self):
        options = dict(name="grammar", kind="arcade", seed=4, spacing_m=0.1, stations=2)
        cloud = jalon.scene_scanner(**options).run(jalon.scene_create(**options))
        self.assertEqual(cloud.station_count, 2)
        with tempfile.TemporaryDirectory() as folder:
            path = os.path.join(folder, "truth.json")
            jalon.scene_write_truth(path, **options)
            with open(path, encoding="utf-8") as f:
                truth = json.load(f)
        self.assertEqual(truth["kind"], "arcade")
        arches = [o for o in truth["openings"] if o["class"] == "recess"]
        self.assertGreaterEqual(len(arches), 3)
        self.assertTrue(all(o["touches_ground"] and any(corner[2] > 0 for corner in o["contour"]) for o in arches))

    def python__gauges_are_swept(self):
        gauge = jalon.Gauge()
        gauge.add_box((1, 1, 1))
        gauge.add_sphere(0.25, pose_at(0, 2))
        gauge.add_cylinder(0.1, 1, pose_at(0, -2)[:3])
        gauge.add_hull(CORNERS + [0, 5, 0])
        self.assertEqual(len(gauge), 4)
        cloud = jalon.Cloud([(5, 0.6, 0), (7, 2, 0.5), (50, 0, 0)])
        forms = ([pose_at(0), pose_at(10)], np.stack([pose_at(0), pose_at(10)]), np.stack([pose_at(0)[:3], pose_at(10)[:3]]),
                 [pose_at(0).tolist(), pose_at(10).tolist()])
        results = [jalon.gauge_sweep(gauge, poses, cloud, margin_m=0.5) for poses in forms]
        for places, intervals in results:
            self.assertEqual(places["point"].tolist(), [0, 1])
            self.assertTrue(np.allclose(places["clearance"], [0.1, 0.25], atol=1e-6))
            self.assertEqual(places["piece"].tolist(), [0, 1])
            self.assertEqual(intervals["near"].tolist(), [2])
        with tempfile.TemporaryDirectory() as folder:
            path = os.path.join(folder, "clearance.html")
            jalon.report_write_clearance(*results[0], gauge, forms[0], path, cloud=cloud)
            with open(path, encoding="utf-8") as page:
                self.assertIn("Tight places", page.read())
            block = cube(1, (-0.5, -0.5, -0.5))
            jalon.report_write_clearance(*results[0], jalon.Gauge(), forms[0], path, gauge=block, model=cube(2, (4, -1, 5)))
            with open(path, encoding="utf-8") as page:
                text = page.read()
            self.assertIn("Black: the model, cut", text)
            self.assertIn("points on the model", text)
            jalon.report_write_clearance(*results[0], gauge, forms[0], path, gauge=block)
            with open(path, encoding="utf-8") as page:
                self.assertEqual(page.read().count('fill-opacity="0.15"'), text.count('fill-opacity="0.15"'))
        many = jalon.gauge_sweep(gauge, [pose_at(x) for x in range(4)], cloud, margin_m=0.5)
        self.assertEqual(len(many.intervals), 3)
        as_model = jalon.gauge_sweep_model(cube(1, (-0.5, -0.5, -0.5)), [pose_at(0), pose_at(10)], cloud, margin_m=0.5)
        self.assertEqual(as_model.places["point"].tolist(), [0])
        self.assertAlmostEqual(as_model.places[0].clearance, 0.1, places=6)
        for wrong in (np.eye(3), np.ones((2, 12)), pose_at(0).ravel(), [np.full((4, 4), 1.0)]):
            with self.assertRaisesRegex(ValueError, "poses"):
                jalon.gauge_sweep(gauge, wrong, cloud)
        with self.assertRaisesRegex(TypeError, "pieces: a jalon.Gauge"):
            jalon.gauge_sweep([1], [pose_at(0)], cloud)

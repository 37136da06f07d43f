# SPDX-FileCopyrightText: 2026 The Jalon authors
# SPDX-License-Identifier: Apache-2.0
"""Clouds: making, cutting, looking around, the search structure; against what NumPy says."""

import os
import tempfile
import unittest

import numpy as np

import jalon
from scenes import box_cloud


def grid(nx, ny, step=1.0):
    """A flat grid of points in rows along x."""
    x, y = np.meshgrid(np.arange(nx) * step, np.arange(ny) * step)
    return np.c_[x.ravel(), y.ravel(), np.zeros(nx * ny)]


class Clouds(unittest.TestCase):
    def setUp(self):
        self.xyz = np.random.default_rng(11).random((2000, 3)) * [10, 20, 5]
        self.cloud = jalon.Cloud(self.xyz)

    def python__a_builder_makes_a_cloud_of_pieces(self):
        builder = jalon.CloudBuilder()
        builder.set_crs("EPSG:2154")
        builder.declare_field("intensity", jalon.ElementType.UINT16, unit="1", meaning="of the echo")
        pose = np.eye(4)
        pose[:3, 3] = 1, 2, 3
        for name, where in (("S1", pose), ("S2", None)):
            builder.begin_station(name, where)
            builder.append_points(self.xyz[:100])
            builder.append_field("intensity", np.arange(100))
        cloud = builder.seal()
        self.assertEqual((len(cloud), cloud.crs, cloud.station_count), (200, "EPSG:2154", 2))
        self.assertEqual([(s.name, s.has_pose, s.first, s.count) for s in cloud.stations], [("S1", True, 0, 100), ("S2", False, 100, 100)])
        self.assertTrue(np.array_equal(cloud.station(0).pose, pose))
        self.assertEqual(cloud.fields.info(0)[:2], (jalon.UINT16, 1))
        self.assertTrue(np.array_equal(cloud["intensity"], np.tile(np.arange(100), 2)))

    def python__stations_and_texts_are_set_and_read(self):
        self.cloud.set_station("tripod", np.eye(4)[:3])
        told = self.cloud.station(0).to_dict()
        self.assertEqual((told["name"], told["pose"]), ("tripod", np.eye(4).tolist()))
        self.cloud.set_station("anywhere")
        self.assertEqual((self.cloud.stations[0].name, self.cloud.stations[0].has_pose), ("anywhere", False))

    def python__clouds_are_cut_and_joined(self):
        x, y, z = self.xyz.T
        prism = self.cloud.crop_polygon([(2, 2), (8, 2), (8, 9), (2, 9)], 1, 4)
        inside = (x >= 2) & (x <= 8) & (y >= 2) & (y <= 9) & (z >= 1) & (z <= 4)
        self.assertTrue(np.array_equal(prism.inside.points, self.xyz[inside]))
        self.assertTrue(np.array_equal(prism.outside.points, self.xyz[~inside]))
        rod = self.cloud.crop_cylinder((5, 10, 0), (5, 10, 5), 3)
        within = np.hypot(x - 5, y - 10) <= 3
        self.assertTrue(np.array_equal(rod.inside.points, self.xyz[within]))
        again = prism.inside.append(prism.outside)
        self.assertEqual(len(again), 2000)
        turn = np.array([[0.0, 1, 0, 0], [-1, 0, 0, 0], [0, 0, 1, 0], [0, 0, 0, 1]])
        boxed = self.cloud.crop_box([(0, -10, 0), (5, 0, 5)], turn)
        self.assertTrue(np.array_equal(boxed.inside.points, self.xyz[y <= 5]))

    def python__moments_are_those_of_numpy(self):
        found = self.cloud.covariance()
        self.assertTrue(np.allclose(found.centroid, self.xyz.mean(0)))
        self.assertTrue(np.allclose(found.covariance, np.cov(self.xyz.T, bias=True)))
        centred = self.xyz - self.xyz.mean(0)
        self.assertAlmostEqual(self.cloud.moment(2, 1, 0), np.mean(centred[:, 0] ** 2 * centred[:, 1]))
        self.assertAlmostEqual(self.cloud.moment(1, 0, 1, centred=False), np.mean(self.xyz[:, 0] * self.xyz[:, 2]))

    def python__neighbours_are_those_of_a_full_search(self):
        distances = np.linalg.norm(self.xyz[:, None, :] - self.xyz[None, :200, :], axis=2)
        found = self.cloud.knn_all(4)
        self.assertTrue(np.array_equal(np.sort(found.indices[:200], 1), np.sort(np.argsort(distances, 0)[:4].T, 1)))
        near = self.cloud.radius_search(self.xyz[:200], 0.9)
        first = near.ranges["first"]
        for i in range(200):
            self.assertTrue(np.array_equal(near.neighbours["index"][first[i]:first[i + 1]], np.flatnonzero(distances[:, i] <= 0.9)))

    def python__an_index_that_was_dropped_is_built_again(self):
        before = self.cloud.knn_all(4)
        self.cloud.drop_index()
        self.cloud.drop_index()
        self.assertTrue(np.array_equal(self.cloud.knn_all(4).indices, before.indices))

    def python__cells_of_the_octree_hold_all_points(self):
        self.cloud.prepare()
        cube = self.cloud.octree_cube()
        self.assertTrue(((self.xyz >= cube.origin) & (self.xyz <= cube.origin + cube.edge_m)).all())
        cells, order = self.cloud.cells(3), self.cloud.order()
        self.assertEqual(int(cells["count"].sum()), 2000)
        self.assertTrue(np.array_equal(np.sort(order["order"]), np.arange(2000)))
        fullest = max(cells, key=lambda cell: cell.count)
        members = self.xyz[order["order"][fullest.first:fullest.first + fullest.count]]
        self.assertLessEqual(np.abs(members - fullest.centre).max(), cube.edge_m / 16 + 1e-9)
        around = self.cloud.cell_neighbours(fullest.code, 1, level=3)
        self.assertTrue(set(around["code"]) <= set(cells["code"]) - {fullest.code})
        other = jalon.Cloud(self.xyz + 3)
        jalon.Cloud.share_octree([self.cloud, other])
        self.assertEqual(self.cloud.octree_cube().edge_m, other.octree_cube().edge_m)
        self.assertIn(self.cloud.best_level(other, 6), range(1, jalon.OCTREE_MAX_LEVEL + 1))
        with self.assertRaisesRegex(TypeError, r"clouds\[1\]: a jalon.Cloud"):
            jalon.Cloud.share_octree([self.cloud, "other"])

    def python__clouds_are_cleaned_and_described(self):
        twice = self.cloud.append(self.cloud).remove_duplicates(1e-4)
        self.assertEqual((len(twice.cloud), twice.removed, twice.removed_percent), (2000, 2000, 50))
        lonely = jalon.Cloud(np.vstack([self.xyz, [(500, 500, 500)]])).remove_outliers(method="radius", radius_m=5, neighbours=1)
        self.assertEqual((lonely.count_in, lonely.count_out), (2001, 2000))
        pieces = jalon.Cloud(np.vstack([grid(20, 20), grid(9, 9) + [100, 0, 0]]))
        self.assertEqual(pieces.compute_components(cell_m=2, min_points=10), 2)
        self.assertEqual(np.bincount(pieces["component"]).tolist(), [0, 400, 81])
        plane = jalon.Cloud(grid(20, 20))
        plane.compute_normals(k=8)
        before = plane["normal"].copy()
        plane.invert_normals()
        self.assertTrue(np.array_equal(plane["normal"], -before))
        plane.compute_features(which="planarity,roughness", radius_m=2.5)
        self.assertLess(np.nanmax(plane["roughness"]), 1e-6)
        self.assertGreater(np.nanmedian(plane["planarity"]), 0.9)
        plane.compute_features(which="surface_class", radius_m=3.5)
        classes = plane["surface_class"].reshape(20, 20)
        self.assertTrue((classes[4:-4, 4:-4] == 1).all())  # 1 = surface
        self.assertTrue((classes[0] == 2).all())  # 2 = edge

    def python__a_facade_is_told_from_what_stands_before_it(self):
        wall = np.random.default_rng(2).random((8000, 3)) * [20, 0.01, 8]
        cloud = jalon.Cloud(np.vstack([wall, np.random.default_rng(3).random((500, 3)) * [1, 1, 2] + [9, -4, 0]]))
        split = cloud.split_interest(viewpoint=(10, -15, 2))
        self.assertGreater(len(split.interest), 7900)
        self.assertEqual(len(split.interest) + len(split.unwanted), 8500)

    def python__files_go_round_and_formats_are_listed(self):
        names = [jalon.format_info(i).name for i in range(jalon.format_count())]
        self.assertIn("las", [name.lower() for name in names])
        with tempfile.TemporaryDirectory() as folder:
            path = os.path.join(folder, "box.ply")
            box_cloud().write(path)
            self.assertEqual(len(jalon.Cloud.read(path)), len(box_cloud()))
            part = os.path.join(folder, "part.las")
            box = (*box_cloud().points.min(axis=0), *np.median(box_cloud().points, axis=0))
            count = jalon.Cloud.convert(path, part, box=box)
            self.assertTrue(0 < count < len(box_cloud()))
            self.assertEqual(len(jalon.Cloud.read(part)), count)

    def python__the_library_tells_what_it_is(self):
        self.assertEqual(jalon.version(), jalon.__version__)
        self.assertGreater(jalon.version_number(), 0)
        self.assertTrue(jalon.instruction_set())
        self.assertIn("not found", jalon.status_name(jalon.ERROR_NOT_FOUND).lower().replace("_", " "))

    def python__columns_make_clouds_and_a_number_stands_for_a_column(self):
        x, y, z = self.xyz.T
        self.assertTrue(np.array_equal(jalon.Cloud.create_columns(x, y, z).points, self.xyz))
        self.assertTrue(np.array_equal(jalon.Cloud.create_columns(x, y, 7).points[:, 2], np.full(2000, 7.0)))

# SPDX-FileCopyrightText: 2026 The Jalon authors
# SPDX-License-Identifier: Apache-2.0
import json
import unittest

import numpy as np

import jalon

HOUSE = """1;0;0;3;300.2
2;4;0;3;300.4
3;4;4;3;300.4
4;0;4;3;300.4
5;0;0;0;300.4
6;1;0.1;0;350
7;2;0.1;2;350
8;9;9;9;999999
"""


def wall_and_door():
    x, z = np.meshgrid(np.arange(0.05, 4, 0.1), np.arange(0.05, 3, 0.1))
    wall = np.column_stack([x.ravel(), np.zeros(x.size), z.ravel()])
    door = wall[(wall[:, 0] > 1) & (wall[:, 0] < 2) & (wall[:, 2] < 2)] + [0, 0.1, 0]
    return np.vstack([wall, door]), len(wall), len(door)


class Codes(unittest.TestCase):
    def python__a_coded_survey_classifies_a_cloud(self):
        points, walls, doors = wall_and_door()
        coded = jalon.Segmenter("survey_codes", codes=HOUSE).run(jalon.Cloud(points))
        classes = coded.cloud["classification"]
        self.assertEqual([int((classes == c).sum()) for c in range(3)], [0, walls, doors])
        notes = json.loads(coded.notes)
        self.assertEqual([o["name"] for o in notes["objects"]], ["building 1", "door 6"])
        self.assertEqual(notes["objects"][1]["points"], doors)
        self.assertEqual(notes["objects"][1]["hinge"], "left")
        self.assertEqual(notes["warnings"][0]["line"], 8)
        again = jalon.Segmentation.from_bytes(coded.to_bytes())
        self.assertEqual(again.notes, coded.notes)

    def python__coded_objects_become_a_model_with_their_codes(self):
        points, _, _ = wall_and_door()
        cloud = jalon.Cloud(points)
        coded = jalon.Segmenter("survey_codes", codes=HOUSE).run(cloud)
        model = jalon.Modeller("coded_objects").run(cloud, coded)
        names = {model.part(i).part_class: model.part(i).name for i in range(model.part_count)}
        self.assertEqual(names["building"], "building 1 (300)")
        self.assertEqual(names["door"], "door 6 (350)")
        self.assertEqual(len(model.solids), 1)

    def python__other_methods_have_no_notes_and_no_coded_objects(self):
        points, _, _ = wall_and_door()
        planes = jalon.Segmenter(min_points=20).run(jalon.Cloud(points))
        self.assertEqual(planes.notes, "")
        with self.assertRaises(jalon.InsufficientDataError):
            jalon.Modeller("coded_objects").run(jalon.Cloud(points), planes)


if __name__ == "__main__":
    unittest.main()

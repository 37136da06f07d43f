# SPDX-FileCopyrightText: 2026 The Jalon authors
# SPDX-License-Identifier: Apache-2.0
import unittest

import jalon
from scenes import box_cloud, box_model

WORKERS = (jalon.Segmenter, jalon.Modeller, jalon.Comparer, jalon.Registrar, jalon.Scanner)


class Methods(unittest.TestCase):
    def python__methods_are_lists_of_names_with_the_default_first(self):
        self.assertEqual(jalon.Segmenter.methods()[0], "ransac")
        self.assertIn("region_growing", jalon.Segmenter.methods())
        for worker in WORKERS:
            names = worker.methods()
            self.assertIs(type(names), list)
            self.assertEqual([type(name) for name in names], [str] * len(names))
            self.assertEqual(worker().to_dict(), worker(names[0]).to_dict())
            names.append("mine")  # a list of the caller's own
            self.assertNotIn("mine", worker.methods())

    def python__every_listed_method_can_be_made_and_no_other(self):
        for worker in WORKERS:
            for name in worker.methods():
                self.assertTrue(worker(name).to_dict())
            with self.assertRaises(LookupError) as refused:
                worker("no such method")
            self.assertIn(", ".join(worker.methods()), str(refused.exception))

    def python__every_listed_method_works_on_a_scan(self):
        for name in jalon.Scanner.methods():
            if name == "mobile":  # it drives along a trajectory: trajectories_test.py
                continue
            steps = {"horizontal_step_rad": 0.01, "vertical_step_rad": 0.01} if name == "static" else {}
            self.assertGreater(jalon.Scanner(name, **steps).run(box_model()).count, 1000, name)
        for name in jalon.Segmenter.methods():
            if name.endswith("_codes"):  # they need a list of codes: codes_test.py
                continue
            if name == "scan_lines":  # nobody scanned these points: they have no rows
                with self.assertRaises(jalon.UnsupportedError):
                    jalon.Segmenter(name).run(box_cloud())
                continue
            segmentation = jalon.Segmenter(name).run(box_cloud())
            self.assertGreaterEqual(len(segmentation.segments), 5, name)
            for modeller in jalon.Modeller.methods():
                if modeller == "coded_objects":  # it models what codes describe: codes_test.py
                    continue
                worker = jalon.Modeller(modeller)
                if "thickness_m" in worker.to_dict():
                    worker.thickness_m = 0.3
                self.assertIsInstance(worker.run(box_cloud(), segmentation), jalon.Model)
        for name in jalon.Comparer.methods():
            self.assertGreater(len(jalon.Comparer(name).run(box_cloud(), box_cloud()).points), 0, name)
        few = jalon.Scanner("sample", spacing_m=0.5).run(box_model())
        for name in set(jalon.Registrar.methods()) - {"targets"}:
            self.assertEqual(jalon.Registrar(name).run(few, few).pose.shape, (4, 4), name)

# SPDX-FileCopyrightText: 2026 The Jalon authors
# SPDX-License-Identifier: Apache-2.0
import os
import tempfile
import unittest

import jalon
from jalon import plots
from scenes import box_cloud

try:
    import matplotlib
    matplotlib.use("Agg")
except ImportError:
    matplotlib = None


class Plots(unittest.TestCase):
    def python__the_elevation_is_a_drawing(self):
        segmentation = jalon.Segmenter(distance_tolerance_m=0.02).run(box_cloud())
        model = jalon.Modeller("outlines").run(box_cloud(), segmentation)
        text = plots.elevation(segmentation, model)
        self.assertIn("<svg", text)
        with tempfile.TemporaryDirectory() as folder:
            path = os.path.join(folder, "façade.svg")
            self.assertEqual(plots.elevation(segmentation, model, path), text)
            self.assertTrue(os.path.exists(path))

    @unittest.skipIf(matplotlib is None, "matplotlib is not installed")
    def python__histograms_and_views_are_drawn_on_the_given_axes(self):
        from matplotlib import pyplot
        cloud = jalon.Cloud(box_cloud().points)
        cloud["height"] = cloud.points[:, 2]
        figure, axes = pyplot.subplots(1, 2)
        self.assertIs(plots.histogram(cloud, "height", ax=axes[0], bins=20), axes[0])
        self.assertEqual(len(axes[0].patches), 20)
        self.assertEqual(sum(patch.get_height() for patch in axes[0].patches), len(cloud))
        self.assertIs(plots.top_view(cloud, "height", ax=axes[1], limit=1000), axes[1])
        self.assertLessEqual(len(axes[1].collections[0].get_offsets()), 1000)
        pyplot.close(figure)

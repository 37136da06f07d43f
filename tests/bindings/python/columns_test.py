# SPDX-FileCopyrightText: 2026 The Jalon authors
# SPDX-License-Identifier: Apache-2.0
"""What the stubs say of columns, in records and summaries, is what the library gives: on real tables."""

import ast
import os
import unittest

import numpy as np

import jalon
from scenes import box_cloud, box_model

FOLDER = os.path.dirname(jalon.__file__)


def classes_of(name):
    """{class: node} of a file of the package."""
    with open(os.path.join(FOLDER, name), encoding="utf-8") as file:
        return {node.name: node for node in ast.parse(file.read()).body if isinstance(node, ast.ClassDef)}


STUBS = classes_of("_api.pyi")
COLUMNS = {name[:-len("Columns")]: node for name, node in classes_of("_columns.py").items()}


def attributes(node):
    """{attribute: the text of its type}."""
    return {line.target.id: ast.unparse(line.annotation) for line in node.body if isinstance(line, ast.AnnAssign)}


def type_of(owner, member):
    """The text of what a method, a property or the field of a named tuple gives."""
    for node in STUBS[owner].body:
        if isinstance(node, ast.FunctionDef) and node.name == member and node.returns is not None:
            return ast.unparse(node.returns)
    return attributes(STUBS[owner])[member]


def fits(value, told, enums):
    """Whether a value of a row is of that type."""
    if told == "Any":
        return True
    if told.startswith("NDArray"):
        return isinstance(value, np.ndarray) and value.dtype == told[len("NDArray[numpy."):-1]
    if told.startswith("Tuple"):
        kinds = [kind.strip() for kind in told[len("Tuple["):-1].split(",")]
        kinds = kinds[:1] * len(value) if kinds[1:] == ["..."] else kinds
        return isinstance(value, tuple) and [type(v).__name__ for v in value] == kinds
    return type(value).__name__ == told or (told == "float" and type(value) is int) or (told in enums and type(value) is int)


class Columns(unittest.TestCase):
    def results(self):
        """(class, member, table or summary) of what real calls give."""
        cloud, model = box_cloud(), box_model()
        segmentation = jalon.Segmenter().run(cloud)
        facade = jalon.Modeller().run(cloud, segmentation)
        yield "Segmentation", "segments", segmentation.segments
        yield "Segmentation", "points", segmentation.points
        for member in ("vertices", "faces", "rings", "corners", "edges", "solids", "parts"):
            yield "Model", member, getattr(facade, member)
        yield "Model", "triangles", model.triangles
        evaluation = segmentation.evaluate(segmentation)
        for member in ("pairs", "automatic", "totals"):
            yield "Evaluation", member, getattr(evaluation, member)
        against = facade.evaluate(facade)
        for member in ("pairs", "automatic", "vertices", "totals"):
            yield "ModelEvaluation", member, getattr(against, member)
        yield from self.of_comparisons(cloud)
        yield from self.of_registrations(cloud)
        yield from self.of_fields(cloud)

    def of_comparisons(self, cloud):
        higher = jalon.Cloud(cloud.points + [0, 0, 0.5])
        for method in ("distance", "m3c2", "preview"):
            comparison = jalon.Comparer(method).run(cloud, higher)
            yield "Comparison", "points", comparison.points
            yield "Comparison", "summary", comparison.summary
        slide = jalon.Comparer("landslide", cell_m=2, direction=(0, 0, 1), min_points=3).run(cloud, higher)
        for owner, member, table in (("Comparison", "points", slide.points), ("Comparison", "summary", slide.summary),
                                     ("ComparisonRegions", "regions", slide.regions().regions)):
            yield owner, member, table
        to_model = jalon.Comparer().run_model(box_model(), cloud)
        yield "Comparison", "points", to_model.points
        yield "Comparison", "summary", to_model.summary
        yield "Comparison", "parts", to_model.parts
        forward, reverse = jalon.Comparer().run(cloud, higher), jalon.Comparer().run(higher, cloud)
        regions = forward.regions(criterion="threshold", threshold_m=0.1)
        diagnosis = forward.diagnose(reverse)
        for owner, result in (("ComparisonRegions", regions), ("ComparisonDiagnose", diagnosis)):
            for member in result._fields:
                yield owner, member, getattr(result, member)

    def of_registrations(self, cloud):
        marks = [("A", (0, 0, 0)), ("B", (4, 0, 0)), ("C", (0, 3, 0)), ("D", (0, 0, 2))]
        for made in (jalon.Registrar("icp").run(cloud, cloud), jalon.Registrar("coarse").run(cloud, cloud),
                     jalon.Registrar("targets").run_targets(marks, marks)):
            for member in ("summary", "iterations", "residuals", "directions"):
                yield "Registration", member, getattr(made, member)

    def of_fields(self, cloud):
        cloud = jalon.Cloud(cloud.points)
        cloud["class"] = np.arange(len(cloud)) % 3
        cloud["deviation"] = np.random.default_rng(1).gamma(2.0, 0.001, len(cloud))
        confusion = cloud.confusion("class", "class")
        histogram = cloud.field_histogram("deviation", jalon.NoiseLaw.fit(cloud, "deviation"), bins=9)
        gauge = jalon.Gauge()
        gauge.add_box((1, 1, 1))
        sweep = jalon.gauge_sweep(gauge, [np.eye(4), np.eye(4)], cloud)
        volume = cloud.volume(jalon.Cloud(cloud.points + [0, 0, 0.1]))
        for owner, result in (("CloudConfusion", confusion), ("CloudFieldHistogram", histogram), ("GaugeSweep", sweep), ("CloudVolume", volume),
                              ("CloudRadiusSearch", cloud.radius_search(cloud.points[:3], 0.3)),
                              ("ModelClearance", box_model().clearance(cloud))):
            for member in result._fields:
                yield owner, member, getattr(result, member)
        yield "Cloud", "fit_sphere", cloud.fit_sphere(robust=False, max_radius_m=1000)
        yield "Cloud", "range_precision", cloud.range_precision()
        yield "Cloud", "cells", cloud.cells(3)
        yield "NoiseLaw", "table", jalon.NoiseLaw.fit(cloud, "deviation").table

    def python__the_stubs_know_the_columns_of_real_tables(self):
        enums = {name for name in STUBS if isinstance(getattr(jalon, name, None), type) and issubclass(getattr(jalon, name), int)}
        seen, columns = set(), 0
        for owner, member, table in self.results():
            told = type_of(owner, member)
            row_class = told[len("Fields["):-1] if told.startswith("Fields[") else told
            types = attributes(COLUMNS[row_class] if row_class in COLUMNS else STUBS[row_class])
            rows = [table] if isinstance(table, jalon.Summary) else table[:2]
            for row in rows:
                for name, value in row.items():
                    attribute = name + "_" if name in ("class", "from") else name
                    if attribute in types:
                        self.assertTrue(fits(value, types[attribute], enums), "%s.%s: %s is %r, not %s" % (
                            owner, member, name, value, types[attribute]))
                        if not isinstance(value, np.ndarray):
                            self.assertEqual(repr(getattr(row, attribute)), repr(value))
                        columns += 1
                    elif row_class != "_ModelEvaluationTotals" and not hasattr(jalon.Summary, name):  # "mean_*", "values"
                        self.fail("%s.%s: the stub has no column %r" % (owner, member, name))
            seen |= {row_class} if rows else set()
        self.assertGreater(len(seen), 35)
        self.assertGreater(columns, 400)

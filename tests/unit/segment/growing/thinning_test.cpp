// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "segment/growing/thinning.h"

#include <doctest/doctest.h>

#include <algorithm>

#include "unit/segment/made_scene.h"

using namespace jalon;
using namespace jalon::test;

TEST_CASE("thinning__has_one_free_point_of_each_cell") {
  Scene scene;
  RandomStream random(8, 0);
  scene.rectangle(1, {0, 0, 0}, {2, 0, 0}, {0, 0, 1}, 40000, 0.002, random);
  MadeScene made(scene.points);
  for (size_t i = 0; i < made.scene.size(); i += 3) made.scene.owner[i] = 1;
  const Representatives cells = one_per_cell(made.scene, made.task);
  CHECK(cells.free ==
        static_cast<size_t>(std::count(made.scene.owner.begin(), made.scene.owner.end(), 0u)));
  REQUIRE(cells.points.size() == cells.first.size());
  for (size_t c = 0; c < cells.points.size(); ++c) {
    CHECK(made.scene.owner[cells.points[c]] == 0);
    CHECK(cells.points[c] >= cells.first[c]);
    if (c > 0) CHECK(cells.first[c] > cells.points[c - 1]);
  }
  CHECK(pays(cells));
  const GrowingPoints points = thinned_points(made.scene, cells, made.task);
  CHECK(points.tree->size() == cells.points.size());
  CHECK(points.points_per_member > 2);
}

TEST_CASE("thinning__of_sparse_points_keeps_the_tree_or_the_free_ones") {
  std::vector<Vec3> points;
  for (int i = 0; i < 30; ++i)
    for (int k = 0; k < 30; ++k) points.push_back({0.2 * i, 0.2 * k, 0});
  MadeScene made(points);
  const Representatives all = one_per_cell(made.scene, made.task);
  CHECK_FALSE(pays(all));
  CHECK(thinned_points(made.scene, all, made.task).tree == made.scene.tree);
  for (size_t i = 0; i < 100; ++i) made.scene.owner[i] = 1;
  const Representatives some = one_per_cell(made.scene, made.task);
  const GrowingPoints left = thinned_points(made.scene, some, made.task);
  CHECK(left.tree->size() == 800);
  for (size_t i = 0; i < 800; ++i) CHECK(made.scene.owner[left.position(i)] == 0);
}

// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "segment/front/sparse_places.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <tuple>

#include "unit/segment/scenes.h"

using namespace jalon;
using namespace jalon::test;

namespace {

using Cell = std::tuple<int, int, int>;

Cell cell_of(const double* p, double cell_m) {
  const auto at = [&](int k) { return static_cast<int>(std::floor(p[k] / cell_m)); };
  return {at(0), at(1), at(2)};
}

std::vector<Vec3> some_points() {
  RandomStream random(3, 1);
  std::vector<Vec3> points;
  for (int i = 0; i < 5000; ++i)
    points.push_back({2 * random.uniform() - 1, random.uniform(), 0.3 * random.uniform()});
  return points;
}

std::vector<double> xyz_of(const SparsePlaces& places) {
  return {places.xyz.begin(), places.xyz.end()};
}

}  // namespace

TEST_CASE("sparse_places__have_a_point_of_the_cloud_in_each_cell_that_holds_some") {
  const std::vector<Vec3> points = some_points();
  Task task;
  const SparsePlaces places = sparse_places(*cloud_of(points), {}, task);
  std::set<Cell> cells, kept;
  for (const Vec3& p : points) {
    const double xyz[] = {p.x, p.y, p.z};
    cells.insert(cell_of(xyz, places.cell_m));
  }
  for (size_t i = 0; i < places.xyz.size(); i += 3) {
    const double* xyz = &places.xyz[i];
    kept.insert(cell_of(xyz, places.cell_m));
    CHECK(std::any_of(points.begin(), points.end(), [&](const Vec3& p) {
      return p.x == xyz[0] && p.y == xyz[1] && p.z == xyz[2];
    }));
  }
  CHECK(kept == cells);
  CHECK(places.xyz.size() == 3 * cells.size());
}

TEST_CASE("sparse_places__are_the_same_whatever_the_order_of_the_points_and_the_threads") {
  std::vector<Vec3> points = some_points();
  Task::Hooks hooks;
  hooks.threads = 1;
  Task one(hooks);
  hooks.threads = 7;
  Task seven(hooks);
  const std::vector<double> places = xyz_of(sparse_places(*cloud_of(points), {-1, 0, 0}, one));
  CHECK(places == xyz_of(sparse_places(*cloud_of(points), {-1, 0, 0}, seven)));
  std::reverse(points.begin(), points.end());
  CHECK(places == xyz_of(sparse_places(*cloud_of(points), {-1, 0, 0}, seven)));
}

TEST_CASE("sparse_places__in_a_scene_too_wide_for_a_bit_a_cell_are_the_cells_centroids") {
  Task task;
  const SparsePlaces places =
      sparse_places(*cloud_of({{0, 0, 0}, {0.02, 0, 0}, {9000, 9000, 9000}}), {}, task);
  REQUIRE(places.xyz.size() == 6);
  CHECK(places.xyz[0] == doctest::Approx(0.01));
  CHECK(places.xyz[3] == doctest::Approx(9000));
}

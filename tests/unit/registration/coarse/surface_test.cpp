// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0

// Thinned surfaces against cells gathered one by one, and against scenes whose sides are known.

#include <doctest/doctest.h>

#include <array>
#include <cmath>
#include <map>

#include "unit/registration/coarse_surfaces.h"

using namespace jalon;
using namespace jalon::test;

namespace {

double cell_for(const std::vector<Vec3>& a, const std::vector<Vec3>& b, size_t target) {
  Task task;
  return coarse_cell(cloud_of(a), cloud_of(b), target, task);
}

CoarseSurface thinned_surface(const std::vector<Vec3>& points, double cell_m) {
  Task task;
  return coarse_surface(cloud_of(points), cell_m, task);
}

}  // namespace

TEST_CASE("coarse_cell__leaves_about_as_many_cells_as_asked_for") {
  const auto room = bare_room().sample(20000, 0.003, 1), small = bare_room().sample(300, 0.003, 2);
  for (const size_t target : {300u, 1000u}) {
    const double cell_m = cell_for(room, room, target);
    const auto cells = static_cast<double>(thinned_surface(room, cell_m).size());
    CHECK(std::abs(cells / static_cast<double>(target) - 1) < 0.1);  // ends at 3 % of the edge
  }
  // 300 points are 3 to a cell at the least, whatever was asked for; the coarser of both decides.
  const double cell_m = cell_for(small, small, 100000);
  CHECK(thinned_surface(small, cell_m).size() <= 110);
  CHECK(cell_for(room, small, 5000) == cell_for(small, room, 5000));
  CHECK(cell_for(room, small, 5000) >= cell_for(room, room, 5000));
  const std::vector<Vec3> one_place(60, {5, 5, 5});  // in either cloud, whatever the other is like
  CHECK(cell_for({{1, 2, 3}, {1, 2, 3}}, one_place, 500) == 0);
  CHECK(cell_for(room, one_place, 500) == 0);
  CHECK(cell_for(one_place, room, 500) == 0);
}

TEST_CASE("coarse_surface__has_the_mean_of_each_cell_and_leaves_outliers_out") {
  const auto points = random_points(2000, 3, 3);
  const CoarseSurface s = thinned_surface(points, 0.5);
  std::map<std::array<double, 3>, std::pair<Vec3, double>> cells;
  for (const Vec3& p : points) {
    const Vec3 at = (p - s.origin) / 0.5;
    auto& [sum, n] = cells[{std::floor(at.x), std::floor(at.y), std::floor(at.z)}];
    sum += p - s.origin;
    n += 1;
  }
  REQUIRE(s.size() == cells.size());
  for (const Vec3& p : s.points) {
    const Vec3 at = p / 0.5;
    const auto& [sum, n] = cells[{std::floor(at.x), std::floor(at.y), std::floor(at.z)}];
    CHECK(norm(sum / n - p) < 1e-12);
  }
  // Cells of a hundred points, and single points above them.
  auto sheet = one_plane().sample(32000, 0, 4);
  const size_t without = thinned_surface(sheet, 0.5).size();
  for (int i = 0; i < 15; ++i) sheet.push_back({0.6 * i, 4, 3});
  CHECK(thinned_surface(sheet, 0.5).size() == without);
}

TEST_CASE("coarse_surface__normals_are_those_of_the_sides_and_a_line_has_none") {
  const CoarseSurface s = thinned_surface(bare_room().sample(20000, 0, 5), 0.25);
  size_t flat = 0, right = 0;
  for (size_t i = 0; i < s.size(); ++i) {
    if (s.variation[i] > 1e-9) continue;
    ++flat;
    const Vec3 n = s.normals[i];
    right += std::max({std::abs(n.x), std::abs(n.y), std::abs(n.z)}) > 1 - 1e-6;
    CHECK(s.scatter_m2[i] < 1e-9);
  }
  CHECK(right == flat);
  CHECK(flat > s.size() / 3);  // the others lie within two cells of an edge
  std::vector<Vec3> line;
  for (int i = 0; i < 400; ++i) line.push_back({0.01 * i, 0.02 * i, 0.005 * i});
  const CoarseSurface thin = thinned_surface(line, 0.2);
  for (size_t i = 0; i < thin.size(); ++i) {
    CHECK(thin.variation[i] == 1);
    CHECK(norm(thin.normals[i]) == 0);
  }
}

TEST_CASE("balance_weights__every_direction_counts_alike_however_the_scene_is_turned") {
  const Transform turn = motion_about({}, {0.4, -0.9, 1.3}, {});
  const auto weighed = [](const Transform& by) {
    const Vec3 x = by.direction({1, 0, 0}), y = by.direction({0, 1, 0}),
               z = by.direction({0, 0, 1});
    CoarseSurface s =
        Cells().sheet({}, x, y, 20, 20).sheet({}, y, z, 10, 8).sheet({}, x, z, 10, 2).surface();
    balance_weights(s);
    return s.weights;
  };
  const std::vector<double> straight = weighed({}), turned = weighed(turn);
  CHECK(straight == turned);
  double floor = 0, wall = 0;
  for (size_t i = 0; i < 400; ++i) floor += straight[i];
  for (size_t i = 400; i < 480; ++i) wall += straight[i];
  CHECK(floor ==
        doctest::Approx(500.0 / 4));  // of 500 cells a quarter each, and one for what bends
  CHECK(wall == doctest::Approx(500.0 / 4));
  CHECK(straight[490] == 5);  // 20 cells would need 6.25: few do not outweigh many
}

// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0

// Cubes for points in lines, and the points left of them against means taken cube by cube.

#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numbers>
#include <set>

#include "geometry/plane.h"
#include "registration/icp/thinning.h"
#include "unit/registration/icp_problems.h"

using namespace jalon;
using namespace jalon::test;

namespace {

double cell_of(const std::vector<Vec3>& a, const std::vector<Vec3>& b,
               const IcpSettings& settings = {}) {
  Task task;
  return thinning_cells(cloud_of(a), cloud_of(b), settings, task).edge_m;
}

}  // namespace

TEST_CASE(
    "thinning_cell__is_none_for_even_points_and_begins_with_the_extent_of_neighbours_in_lines") {
  const auto even = floor_of_lines(0.02, 50, 50), lines = floor_of_lines(0.4, 30, 400);
  CHECK(cell_of(even, even) == 0);
  const double cell_m = cell_of(lines, lines);
  // The extent of sixteen points along a line, and wider from there on.
  CHECK(cell_m == doctest::Approx(0.02 * 16 / std::sqrt(12.0)).scale(0).epsilon(0.2));
  Task task;
  CHECK(thinning_cells(cloud_of(even), cloud_of(lines), {}, task).do_widen);
  CHECK(!thinning_cells(cloud_of(even), cloud_of(even), {}, task).do_widen);
  // Either of the clouds may be the one in lines.
  CHECK(cell_of(even, lines) == cell_m);
  CHECK(cell_of(lines, even) == cell_m);
}

TEST_CASE("thinning_cell__is_as_told_and_none_where_planes_do_not_matter") {
  const auto lines = floor_of_lines(0.4, 10, 200);
  CHECK(cell_of(lines, lines, {.cell_m = 0.125}) == 0.125);
  CHECK(cell_of(lines, lines, {.metric = IcpMetric::kPointToPoint}) == 0);
  CHECK(cell_of(lines, lines, {.metric = IcpMetric::kPointToPoint, .cell_m = 0.5}) == 0.5);
}

TEST_CASE("thinned__has_the_mean_of_each_cube_and_one_of_its_raw_points") {
  const auto points = random_points(1500, 3, 7);
  const auto raw = std::make_shared<const Cloud>(cloud_of(points));
  Task task;
  const double edge_m = 0.5;
  const ThinnedCloud few = thinned(raw, {edge_m, false}, 16, task);
  using Key = std::array<double, 3>;
  const auto key = [&](const Vec3& p) {
    return Key{std::floor(p.x / edge_m), std::floor(p.y / edge_m), std::floor(p.z / edge_m)};
  };
  std::map<Key, std::pair<Vec3, double>> cubes;
  for (const Vec3& p : points) {
    auto& [sum, n] = cubes[key(p)];
    sum += p;
    n += 1;
  }
  REQUIRE(few.cloud->size() == cubes.size());
  REQUIRE(few.index.size() == cubes.size());
  std::set<uint32_t> used;
  for (uint32_t i = 0; i < few.cloud->size(); ++i) {
    const Vec3 p = few.cloud->point(i);
    const auto& [sum, n] = cubes[key(p)];
    CHECK(norm(p - sum / n) < 1e-12);
    CHECK(key(points.at(few.raw(i))) == key(p));
    used.insert(few.raw(i));
  }
  CHECK(used.size() == cubes.size());
}

TEST_CASE("thinned__to_no_cubes_is_the_raw_cloud_itself") {
  const auto raw = std::make_shared<const Cloud>(cloud_of(random_points(20, 1, 8)));
  Task task;
  const ThinnedCloud same = thinned(raw, {}, 16, task);
  CHECK(same.cloud == raw);
  CHECK(same.raw(13) == 13);
}

TEST_CASE(
    "thinned__by_cubes_that_widen_has_planes_near_and_far_where_lines_lie_apart_by_the_range") {
  // Rings of a head 1.7 m above the ground, a degree and a third from each other, as wide apart as the range squared.
  RandomStream random(133, 0);
  std::vector<Vec3> points;
  for (int ring = 0; ring < 20; ++ring) {
    const double range_m = 1.7 / std::tan((4 + 1.33 * ring) * std::numbers::pi / 180);
    for (int k = 0; k < 2250; ++k) {
      const double turn = 2 * std::numbers::pi * k / 2250, r = range_m + 0.01 * random.normal();
      points.push_back({r * std::cos(turn), r * std::sin(turn), 0.002 * random.normal()});
    }
  }
  const auto raw = std::make_shared<const Cloud>(cloud_of(points));
  Task task;
  const ThinningCells cells = thinning_cells(*raw, *raw, {}, task);
  REQUIRE(cells.do_widen);
  const ThinnedCloud few = thinned(raw, cells, 16, task);
  CHECK(few.cloud->size() > 2000);
  CHECK(few.cloud->size() < points.size() / 2);
  CHECK(std::ranges::is_sorted(few.index));
  size_t far = 0, upright = 0;
  std::vector<Neighbour> found(16);
  const auto tree = few.cloud->octree(task);
  for (size_t i = 0; i < few.cloud->size(); ++i) {
    const Vec3 at = few.cloud->point(i);
    far += std::hypot(at.x, at.y) > 8;
    tree->knn(at, 16, found);
    Moments moments;
    moments.reference = at;
    for (const Neighbour& n : found) moments.add(few.cloud->point(n.index));
    const Eigen3 e = symmetric_eigen(moments.covariance());
    upright += std::abs(e.vectors[0].z) > 0.99 && e.values[1] > 0.01 * e.values[2];
  }
  CHECK(far > 50);
  CHECK(static_cast<double>(upright) > 0.95 * static_cast<double>(few.cloud->size()));
}

TEST_CASE("thinned__leaves_one_mark_of_no_return_and_nearly_all_else") {
  std::vector<Vec3> points = floor_of_lines(0.02, 60, 60);
  const size_t measured = points.size();
  points.insert(points.end(), 1000, Vec3{0, 0, -5});
  const auto raw = std::make_shared<const Cloud>(cloud_of(points));
  Task task;
  const ThinningCells cells = thinning_cells(*raw, *raw, {}, task);
  CHECK(!cells.do_widen);
  const ThinnedCloud few = thinned(raw, cells, 16, task);
  CHECK(few.cloud->size() > 0.9 * static_cast<double>(measured));
  CHECK(few.cloud->size() <= measured + 1);
}

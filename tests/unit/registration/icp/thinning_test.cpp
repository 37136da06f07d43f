// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0

// Cubes for points in lines, and the points left of them against means taken cube by cube.

#include <doctest/doctest.h>

#include <array>
#include <cmath>
#include <map>
#include <set>

#include "registration/icp/thinning.h"
#include "unit/cloud/clouds.h"

using namespace jalon;
using namespace jalon::test;

namespace {

// Lines along x on the floor, this far apart, points every 2 cm along them.
std::vector<Vec3> floor_of_lines(double apart_m, int lines, int points) {
  RandomStream random(131, 0);
  std::vector<Vec3> out;
  for (int i = 0; i < lines; ++i)
    for (int k = 0; k < points; ++k)
      out.push_back({0.02 * (k + random.uniform()), apart_m * i + 0.002 * random.normal(),
                     0.002 * random.normal()});
  return out;
}

double cell_of(const std::vector<Vec3>& a, const std::vector<Vec3>& b,
               const IcpSettings& settings = {}) {
  Task task;
  return thinning_cell_m(cloud_of(a), cloud_of(b), settings, task);
}

}  // namespace

TEST_CASE("thinning_cell__is_none_for_even_points_and_about_as_wide_as_lines_are_apart") {
  const auto even = floor_of_lines(0.02, 50, 50), lines = floor_of_lines(0.4, 30, 400);
  CHECK(cell_of(even, even) == 0);
  const double cell_m = cell_of(lines, lines);
  // Sixteen cubes along a line are no plane: three lines at the least, cubes of a sixteenth of these.
  CHECK(cell_m > 0.4 * 2 / 16);
  CHECK(cell_m < 2 * 0.4);
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
  const ThinnedCloud few = thinned(raw, edge_m, task);
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
  const ThinnedCloud same = thinned(raw, 0, task);
  CHECK(same.cloud == raw);
  CHECK(same.raw(13) == 13);
}

// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "fieldtools/chamfer.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>

#include "fieldtools/field_values.h"
#include "unit/cloud/clouds.h"

namespace jalon {
namespace {

using namespace test;

DistanceGrid cube_grid(uint32_t size) {
  DistanceGrid grid;
  grid.size = {size, size, size};
  return grid;
}

TEST_CASE("chamfer__one_seed__the_weights_3_4_5_in_thirds_of_a_cell") {
  Task task;
  const DistanceGrid grid = cube_grid(41);
  const std::vector<uint64_t> seed{grid.index(20, 20, 20)};
  const std::vector<float> d = chamfer_distances(grid, seed, task);
  double worst = 0;
  for (uint32_t z = 0; z < 41; ++z)
    for (uint32_t y = 0; y < 41; ++y)
      for (uint32_t x = 0; x < 41; ++x) {
        // The cheapest path: corner steps first, then edges, then faces.
        uint32_t a[3] = {x > 20 ? x - 20 : 20 - x, y > 20 ? y - 20 : 20 - y,
                         z > 20 ? z - 20 : 20 - z};
        std::sort(a, a + 3);
        const double thirds = 5 * a[0] + 4 * (a[1] - a[0]) + 3 * (a[2] - a[1]);
        const double found = double{d[grid.index(x, y, z)]};
        CHECK(found == doctest::Approx(thirds / 3).epsilon(1e-6));
        const double truth = std::sqrt(double(a[0] * a[0] + a[1] * a[1] + a[2] * a[2]));
        if (truth > 0) worst = std::max(worst, std::fabs(found / truth - 1));
      }
  MESSAGE("FIGURE Chamfer <3,4,5>: largest error ", 100 * worst, " % of the distance");
  CHECK(worst < 0.12);
}

TEST_CASE("chamfer__random_cells__equal_the_cheapest_paths") {
  Task task;
  DistanceGrid grid;
  grid.size = {12, 9, 7};
  RandomStream random(3, 0);
  std::vector<uint64_t> seeds;
  for (int i = 0; i < 5; ++i) seeds.push_back(random.below(grid.cells()));
  const std::vector<float> d = chamfer_distances(grid, seeds, task);
  const auto cell = [&](uint64_t c, int axis) {
    return static_cast<int>(axis == 0 ? c % 12 : axis == 1 ? c / 12 % 9 : c / 108);
  };
  for (uint64_t c = 0; c < grid.cells(); ++c) {
    int best = 1 << 20;
    for (const uint64_t s : seeds) {
      int a[3];
      for (int i = 0; i < 3; ++i) a[i] = std::abs(cell(c, i) - cell(s, i));
      std::sort(a, a + 3);
      best = std::min(best, 5 * a[0] + 4 * (a[1] - a[0]) + 3 * (a[2] - a[1]));
    }
    CHECK(double{d[c]} == doctest::Approx(best / 3.0).epsilon(1e-6));
  }
}

TEST_CASE("map_distance__of_a_sphere__its_radius_off") {
  // Points of a sphere of radius 1; queries around it.
  const Cloud reference = cloud_of(sphere(200000));
  RandomStream random(5, 0);
  std::vector<Vec3> queries(20000);
  for (Vec3& q : queries)
    q = {snapped(4 * random.uniform() - 2), snapped(4 * random.uniform() - 2),
         snapped(4 * random.uniform() - 2)};
  for (const char* method : {"chamfer", "fast_marching"}) {
    auto set = settings_by<DistanceMapSettings>(distance_map_rows(), {{"method", method}});
    set.cell_m = 0.05;
    Task task;
    const Cloud out = with_map_distance(cloud_of(queries), reference, set, task);
    const auto found = out.fields.require("map_distance").values<double>();
    double worst = 0, rms = 0;
    for (size_t i = 0; i < queries.size(); ++i) {
      const double truth = std::fabs(norm(queries[i]) - 1), e = std::fabs(found[i] - truth);
      rms += e * e;
      worst = std::max(worst, e - (method[0] == 'c' ? 0.12 * truth : 0));
    }
    rms = std::sqrt(rms / static_cast<double>(queries.size()));
    MESSAGE("FIGURE distance map, ", std::string(method), ", cells of 50 mm: rms ", 1000 * rms,
            " mm, largest ", 1000 * worst, " mm (Chamfer: beyond 12 % of the distance)");
    CHECK(worst < 0.05 * (method[0] == 'c' ? std::sqrt(3.0) : 1.25));
  }
}

TEST_CASE("distance_map__limits_statuses_and_bits") {
  const auto points = random_points(500, 3, 8);
  DistanceMapSettings set;
  set.cell_m = 0.25;
  set.max_distance_m = 0.3;
  Task one(threads(1)), seven(threads(7));
  const Cloud near = cloud_of(points), far = cloud_of(shifted(points, kFar));
  const Cloud map = distance_map_cloud(near, set, one);
  CHECK(map.size() > 0);
  for (const float d : map.fields.require("map_distance").values<float>()) CHECK(d <= 0.3f);
  using Method = DistanceMapSettings::Method;
  for (const Method method : {Method::kChamfer, Method::kFastMarching}) {
    set.method = method;
    const Cloud a = with_map_distance(near, near, set, one);
    CHECK(same_bits(a, with_map_distance(near, near, set, seven)));
    CHECK(same_fields(a, with_map_distance(far, far, set, one)));
  }
  CHECK(status_of([&] { with_map_distance(near, Cloud(), set, one); }) ==
        Status::kInsufficientData);
  set.cell_m = 1e-5;
  CHECK(status_of([&] { distance_map_cloud(near, set, one); }) == Status::kLimit);
  CHECK(with_map_distance(Cloud(), near, DistanceMapSettings{}, one).size() == 0);
}

}  // namespace
}  // namespace jalon

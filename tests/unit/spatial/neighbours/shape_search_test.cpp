// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "spatial/neighbours/shape_search.h"

#include <doctest/doctest.h>

#include "unit/spatial/hostile_clouds.h"
#include "unit/spatial/octree_fixture.h"
#include "spatial/neighbours/shape_kernel.h"
#include "base/simd.h"
#include "spatial/octree/impl.h"

using namespace jalon;
using namespace jalon::test;

namespace {

template <class Inside>
std::vector<uint32_t> all_inside(const std::vector<double>& xyz, Inside inside) {
  std::vector<uint32_t> found;
  for (size_t i = 0; i < xyz.size() / 3; ++i)
    if (inside(point(xyz, i))) found.push_back(static_cast<uint32_t>(i));
  return found;
}

std::vector<uint32_t> ascending(std::vector<uint32_t> indices) {
  std::sort(indices.begin(), indices.end());
  return indices;
}

}  // namespace

TEST_CASE("shape_search__equals_brute_force_for_balls_and_cylinders") {
  for (const double grid : {0.0, 0x1p-10}) {
    const auto xyz = street(5000, 4, grid);
    const auto tree = build(xyz);
    ShapeSearch search(*tree);
    RandomStream random(5, 0);
    for (int trial = 0; trial < 300; ++trial) {
      // Inside, outside and far away; thin and long, wide and flat.
      const double reach = trial % 3 == 0 ? 60 : 22;
      const Vec3 centre{reach * random.uniform() - 1, reach * random.uniform() - 1,
                        reach * random.uniform() - 1};
      const Vec3 axis = trial % 5 == 0
                            ? Vec3{0, 0, 1}
                            : normalized({random.normal(), random.normal(), random.normal()});
      const double radius = std::pow(10, 2.5 * random.uniform() - 1.5),
                   half = std::pow(10, 3 * random.uniform() - 1);
      std::vector<uint32_t> found;
      for (const auto& p : search.cylinder(centre, axis, radius, half)) {
        found.push_back(tree->order()[p.position]);
        CHECK(std::fabs(p.along_m - dot(point(xyz, found.back()) - centre, axis)) < 1e-12);
      }
      CHECK(ascending(found) == all_inside(xyz, [&](const Vec3& p) {
              const Vec3 d = p - centre;
              const double t = dot(d, axis);
              return std::fabs(t) <= half && squared_norm(d - t * axis) <= radius * radius;
            }));
      const auto offsets = search.ball(centre, radius);
      found.clear();
      for (const uint32_t position : search.ball_positions())
        found.push_back(tree->order()[position]);
      CHECK(offsets.size() == found.size());
      CHECK(ascending(found) == all_inside(xyz, [&](const Vec3& p) {
              return squared_norm(p - centre) <= radius * radius;
            }));
    }
  }
}

TEST_CASE("shape_search__baseline_and_avx2_agree") {
  if (!use_avx2()) return;
  const auto xyz = street(20000, 6);
  const auto tree = build(xyz);
  RandomStream random(7, 0);
  constexpr size_t kRoom = 32768;
  std::vector<int32_t> columns[2];
  std::vector<uint32_t> positions[2], filtered[2];
  ShapePoints points[2];
  for (int v = 0; v < 2; ++v) {
    columns[v].resize(3 * kRoom);
    positions[v].resize(kRoom);
    filtered[v].resize(kRoom);
    int32_t* x = columns[v].data();
    points[v] = {x, x + kRoom, x + 2 * kRoom, positions[v].data(), kRoom, 0};
  }
  for (int trial = 0; trial < 200; ++trial) {
    GridShape shape{};
    for (int c = 0; c < 3; ++c) {
      shape.base[c] = static_cast<int32_t>(random.below(1u << 31));
      shape.axis[c] = c == trial % 3 ? 1.0f : 0.0f;
    }
    shape.radius = static_cast<float>(1e9 * random.uniform());
    shape.half_length = static_cast<float>(1e9 * random.uniform());
    shape.is_ball = trial % 2 == 0;
    REQUIRE(gather_shape_baseline(tree->impl().view, shape, points[0]));
    REQUIRE(gather_shape_avx2(tree->impl().view, shape, points[1]));
    REQUIRE(points[0].count == points[1].count);
    const auto n = static_cast<ptrdiff_t>(points[0].count);
    CHECK(std::equal(positions[0].begin(), positions[0].begin() + n, positions[1].begin()));
    shape.radius *= 0.7f;
    const size_t left = filter_shape_baseline(points[0], shape, filtered[0].data());
    REQUIRE(filter_shape_avx2(points[1], shape, filtered[1].data()) == left);
    CHECK(std::equal(filtered[0].begin(), filtered[0].begin() + static_cast<ptrdiff_t>(left),
                     filtered[1].begin()));
  }
}

TEST_CASE("shape_search__searches_near_each_other_equal_brute_force_too") {
  const auto xyz = street(20000, 8);
  const auto tree = build(xyz);
  ShapeSearch search(*tree);
  RandomStream random(9, 0);
  Vec3 centre{10, 10, 0};
  for (int trial = 0; trial < 400; ++trial) {
    centre += 0.1 * Vec3{random.normal(), random.normal(), 0.1 * random.normal()};
    const Vec3 axis = normalized({0.02 * random.normal(), 0.02 * random.normal(), 1});
    std::vector<uint32_t> found;
    for (const auto& p : search.cylinder(centre, axis, 0.5, 1))
      found.push_back(tree->order()[p.position]);
    CHECK(ascending(found) == all_inside(xyz, [&](const Vec3& p) {
            const Vec3 d = p - centre;
            const double t = dot(d, axis);
            return std::fabs(t) <= 1 && squared_norm(d - t * axis) <= 0.25;
          }));
  }
  for (int trial = 0; trial < 400; ++trial) {
    centre += 0.1 * Vec3{random.normal(), random.normal(), 0.1 * random.normal()};
    std::vector<uint32_t> found;
    search.ball(centre, 0.4);
    for (const uint32_t position : search.ball_positions())
      found.push_back(tree->order()[position]);
    CHECK(ascending(found) ==
          all_inside(xyz, [&](const Vec3& p) { return squared_norm(p - centre) <= 0.4 * 0.4; }));
  }
}

TEST_CASE("shape_search__empty_tree_and_one_point") {
  const std::vector<double> one{1, 2, 3};
  const auto tree = build(one);
  ShapeSearch search(*tree);
  CHECK(search.ball({1, 2, 3}, 0).size() == 1);
  CHECK(search.cylinder({1, 2, 0}, {0, 0, 1}, 0, 3).size() == 1);
  CHECK(search.cylinder({1, 2, 0}, {0, 0, 1}, 0.1, 2.9).empty());
}

TEST_CASE("shape_search__equals_brute_force_where_the_grid_does_not_tell_points_apart") {
  for (const HostileCloud& cloud : hostile_clouds(1500)) {
    CAPTURE(cloud.name);
    const auto tree = build(cloud.xyz);
    ShapeSearch search(*tree);
    RandomStream random(6, 0);
    for (int trial = 0; trial < 200; ++trial) {
      const Vec3 centre = point(cloud.xyz, random.below(1500));
      const Vec3 axis = normalized({random.normal(), random.normal(), random.normal()});
      const double radius = std::pow(10, 12 * random.uniform() - 11), half = 3 * radius;
      std::vector<uint32_t> found;
      for (const auto& p : search.cylinder(centre, axis, radius, half))
        found.push_back(tree->order()[p.position]);
      CHECK(ascending(found) == all_inside(cloud.xyz, [&](const Vec3& p) {
              const Vec3 d = p - centre;
              const double t = dot(d, axis);
              return std::fabs(t) <= half && squared_norm(d - t * axis) <= radius * radius;
            }));
      search.ball(centre, radius);
      found.clear();
      for (const uint32_t position : search.ball_positions())
        found.push_back(tree->order()[position]);
      CHECK(ascending(found) == all_inside(cloud.xyz, [&](const Vec3& p) {
              return squared_norm(p - centre) <= radius * radius;
            }));
    }
  }
}

TEST_CASE("shape_search__cylinders_across_a_crowd_are_runs_that_cost_what_their_surface_cuts") {
  // A logarithmic spiral in a plane, down to 1e-13 of its radius.
  constexpr size_t kPoints = 40000;
  std::vector<double> xyz;
  for (size_t i = 0; i < kPoints; ++i) {
    const double t = static_cast<double>(i) / kPoints, radius = std::exp(-30 * t);
    xyz.insert(xyz.end(), {radius * std::cos(300 * t), radius * std::sin(300 * t), 0});
  }
  const auto tree = build(xyz);
  REQUIRE(tree->has_crowds());
  ShapeSearch search(*tree), by_points(*tree);
  RandomStream random(6, 0);
  for (int trial = 0; trial < 40; ++trial) {
    const size_t core = random.below(kPoints);
    const Vec3 axis = trial % 4 == 0 ? normalized({0.3, random.normal(), 1}) : Vec3{0, 0, 1};
    std::vector<double> truth, found;
    for (const auto& p : by_points.cylinder(point(xyz, core), axis, 0.05, 0.2))
      truth.push_back(p.along_m);
    const uint64_t before = search.looked_at();
    for (const auto& run : search.cylinder_runs(point(xyz, core), axis, 0.05, 0.2))
      found.insert(found.end(), run.count, run.along_m);
    REQUIRE(found.size() == truth.size());
    std::sort(truth.begin(), truth.end());
    std::sort(found.begin(), found.end());
    for (size_t i = 0; i < truth.size(); ++i) CHECK(std::fabs(found[i] - truth[i]) <= 0x1p-44);
    if (trial % 4 != 0) CHECK(search.looked_at() - before < kPoints / 20);
  }
}

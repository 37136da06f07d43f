// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "compare/preview/preview.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <map>

#include "base/error.h"
#include "compare/distance/closest_points.h"
#include "compare/preview/homologous_cells.h"
#include "unit/compare/distance_fixture.h"

using namespace jalon;
using namespace jalon::test;

namespace {

using Measure = PreviewSettings::Measure;

Comparison previewed(const CloudPtr& reference, const CloudPtr& compared,
                     const PreviewSettings& settings, unsigned threads = 2) {
  Task::Hooks hooks;
  hooks.threads = threads;
  Task task(hooks);
  return compare_preview(reference, compared, settings, task);
}

// Value by cell number, by brute force over all pairs in a cell.
std::vector<double> by_force(const Cloud& reference, const Cloud& compared, Measure measure,
                             int level) {
  Task task;
  Box3 box = bounds(reference, task);
  box += bounds(compared, task);
  const Cube cube = enclosing_cube(box);
  using Cell = std::array<int64_t, 3>;
  const auto cell_of = [&](const Vec3& p) {
    Cell cell;
    for (int i = 0; i < 3; ++i)
      cell[static_cast<size_t>(i)] = static_cast<int64_t>(
          std::floor((p[i] - cube.origin[i]) / cube.edge * std::ldexp(1.0, level)));
    return cell;
  };
  std::map<Cell, std::vector<Vec3>> there;
  for (size_t i = 0; i < reference.size(); ++i)
    there[cell_of(reference.point(i))].push_back(reference.point(i));
  std::map<Cell, std::vector<double>> found;
  for (size_t i = 0; i < compared.size(); ++i) {
    const Vec3 p = compared.point(i);
    double least = std::numeric_limits<double>::infinity();
    for (const Vec3& q : there[cell_of(p)]) least = std::min(least, norm(p - q));
    found[cell_of(p)].push_back(least);
  }
  std::vector<double> out;
  for (size_t i = 0; i < compared.size(); ++i) {
    const auto& all = found[cell_of(compared.point(i))];
    double sum = 0;
    for (const double d : all) sum += d;
    out.push_back(measure == Measure::kMean      ? sum / static_cast<double>(all.size())
                  : measure == Measure::kMinimum ? *std::ranges::min_element(all)
                                                 : *std::ranges::max_element(all));
  }
  return out;
}

}  // namespace

TEST_CASE("preview__equals_brute_force_in_each_cell_and_takes_the_least_of_the_levels") {
  const auto reference = cloud_of(random_square(3000, 10, 0, 1, 0.3));
  const auto other = cloud_of(random_square(2500, 11, 0.4, 2, 0.3));
  for (const Measure measure : {Measure::kMean, Measure::kMinimum, Measure::kMaximum}) {
    std::vector<double> least(other->size(), std::numeric_limits<double>::infinity());
    for (const int level : {3, 4, 5}) {
      const Comparison made = previewed(reference, other, {measure, level});
      const auto expected = by_force(*reference, *other, measure, level);
      for (size_t i = 0; i < other->size(); ++i) {
        const double d = made.points.require("distance").number(i);
        least[i] = std::min(least[i], expected[i]);
        REQUIRE(made.points.require("status").number(i) == (std::isinf(expected[i]) ? 4 : 0));
        if (std::isinf(expected[i])) REQUIRE(std::isnan(d));
        else REQUIRE(std::fabs(d - expected[i]) < 1e-6);
      }
    }
    const Comparison made = previewed(reference, other, {measure, 3, 5});
    for (size_t i = 0; i < other->size(); ++i)
      if (!std::isinf(least[i]))
        REQUIRE(std::fabs(made.points.require("distance").number(i) - least[i]) < 1e-6);
  }
}

TEST_CASE("preview__angle_of_planes_sees_a_tilt_and_no_shift") {
  const auto flat = random_square(20000, 10, 0.01, 1), again = random_square(20000, 10, 0.05, 2);
  std::vector<double> tilted = again;
  for (size_t i = 0; i < tilted.size(); i += 3) tilted[i + 2] += 0.02 * (tilted[i] - 5);
  const Comparison shifted = previewed(cloud_of(flat), cloud_of(again), {Measure::kPlaneAngle, 2});
  const Comparison turned = previewed(cloud_of(flat), cloud_of(tilted), {Measure::kPlaneAngle, 1});
  MESSAGE("FIGURE angle of planes: shifted ", shifted.summary.require("angle_maximum").number(0),
          " rad, tilted by ", std::atan(0.02),
          " rad: ", turned.summary.require("angle_mean").number(0));
  CHECK(shifted.summary.require("angle_maximum").number(0) < 1e-3);
  CHECK(shifted.points.find("distance") == nullptr);
  CHECK(turned.summary.require("compared").number(0) > 10000);
  CHECK(std::fabs(turned.summary.require("angle_mean").number(0) - std::atan(0.02)) < 1e-3);
}

TEST_CASE(
    "preview__is_the_same_for_any_number_of_threads_and_after_a_shift_and_keeps_the_clouds_index") {
  const auto snapped = [](std::vector<double> xyz, const Vec3& by) {
    for (size_t i = 0; i < xyz.size(); ++i)
      xyz[i] = std::round(xyz[i] * 1024) / 1024 + by[static_cast<int>(i % 3)];
    return xyz;
  };
  const auto a = random_square(8000, 10, 0, 7, 0.1), b = random_square(6000, 12, 0.1, 8, 0.1);
  const auto reference = cloud_of(snapped(a, {})), other = cloud_of(snapped(b, {}));
  Task task;
  const auto kept = reference->octree(task);
  for (const Measure measure : {Measure::kMean, Measure::kPlaneAngle}) {
    const PreviewSettings settings{measure, 3, 5};
    const char* name = measure == Measure::kMean ? "distance" : "plane_angle";
    const Comparison one = previewed(reference, other, settings, 1),
                     seven = previewed(reference, other, settings, 7);
    const Comparison far = previewed(cloud_of(snapped(a, {652000, 6861000, 130})),
                                     cloud_of(snapped(b, {652000, 6861000, 130})), settings);
    const auto same = [](double x, double y) { return x == y || (x != x && y != y); };
    const auto values = [&](const Comparison& c) {
      return c.points.require(name).values<double>();
    };
    CHECK(std::ranges::equal(values(one), values(seven), same));
    CHECK(std::ranges::equal(values(one), values(far), same));
  }
  CHECK(kept == reference->octree(task));
}

TEST_CASE("preview__of_single_equal_and_far_points") {
  const auto one = cloud_of({1, 2, 3}), far = cloud_of({5000, 0, 0}),
             square = cloud_of(random_square(200, 1, 0, 5));
  for (const Measure measure : {Measure::kMean, Measure::kPlaneAngle}) {
    const PreviewSettings settings{measure};
    CHECK(previewed(one, one, settings).points.require("status").number(0) ==
          (measure == Measure::kMean ? 0 : 4));
    CHECK(previewed(one, far, settings).points.require("status").number(0) == 4);
    CHECK_NOTHROW(previewed(one, square, {measure, 1, 12}));
    CHECK_THROWS_AS(previewed(cloud_of(std::vector<double>{}), square, settings), Error);
    CHECK_THROWS_AS(previewed(square, cloud_of(std::vector<double>{}), settings), Error);
  }
}

TEST_CASE("closest_points__are_the_reference_points_that_are_nearest_to_some_point_each_once") {
  const auto reference = cloud_of(random_square(3000, 10, 0, 1)),
             other = cloud_of(random_square(400, 12, 0.1, 2));
  DistanceSettings settings;
  settings.max_distance_m = 0.5;
  const Comparison made = compared(reference, other, settings);
  std::vector<bool> expected(reference->size());
  for (const uint32_t i : made.points.require("nearest").values<uint32_t>())
    if (i != kNoPoint) expected[i] = true;
  Task task;
  const Cloud closest = closest_points(made, *reference, task);
  size_t at = 0;
  for (size_t i = 0; i < reference->size(); ++i)
    if (expected[i]) REQUIRE(closest.point(at++) == reference->point(i));
  CHECK(at == closest.size());
  CHECK_THROWS_AS(closest_points(made, *cloud_of({0, 0, 0}), task), Error);
  const Comparison seen = previewed(reference, other, {Measure::kMean, 4});
  CHECK_THROWS_AS(closest_points(seen, *reference, task), Error);
}

TEST_CASE("occupied_cells__equal_those_of_the_octree") {
  const auto cloud = cloud_of(random_square(200000, 10, 0, 1, 0.1));
  Task task;
  const auto tree = cloud->octree(task);
  for (const int level : {0, 1, 4, 9, 15, 21}) {
    const auto expected = tree->cells(level, task), found = occupied_cells(*tree, level, task);
    REQUIRE(found.size() == expected.size());
    for (size_t i = 0; i < found.size(); ++i)
      REQUIRE((found[i].code == expected[i].code && found[i].first == expected[i].first &&
               found[i].count == expected[i].count));
  }
}

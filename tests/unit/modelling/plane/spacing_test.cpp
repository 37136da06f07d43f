// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0

// The typical distance of neighbouring points.
#include <doctest/doctest.h>

#include <cmath>
#include <numbers>
#include <vector>

#include "base/random.h"
#include "modelling/plane/spacing.h"

using namespace jalon;

namespace {

std::vector<Vec2> grid(double step_m, double width_m) {
  std::vector<Vec2> out;
  for (double u = 0; u < width_m; u += step_m)
    for (double v = 0; v < width_m; v += step_m) out.push_back({u, v});
  return out;
}

}  // namespace

TEST_CASE("spacing__of_scattered_points_is_the_root_of_the_area_a_point") {
  Task task;
  for (const double size_m : {1.0, 50.0}) {
    RandomStream random(4, 4);
    std::vector<Vec2> points;
    for (int i = 0; i < 5000; ++i)
      points.push_back({size_m * random.uniform(), size_m * random.uniform()});
    const double truth_m = size_m / std::sqrt(5000.0), found_m = typical_spacing(points, task);
    CHECK(found_m > 0.9 * truth_m);
    CHECK(found_m < 1.25 * truth_m);  // the upper quartile, of random distances
  }
}

TEST_CASE("spacing__grows_with_the_grid_and_does_not_hang_on_where_it_lies") {
  Task task;
  const double one = typical_spacing(grid(1, 40), task);
  CHECK(one ==
        doctest::Approx(std::sqrt(std::numbers::pi / 8) * std::sqrt(2)));  // of the 8th neighbour
  CHECK(typical_spacing(grid(2, 80), task) == doctest::Approx(2 * one));
  std::vector<Vec2> moved = grid(1, 40);
  for (Vec2& p : moved) p = p + Vec2{-300, 500};
  CHECK(typical_spacing(moved, task) == one);
}

TEST_CASE("spacing__the_sparser_part_of_a_segment_counts") {
  Task task;
  std::vector<Vec2> points = grid(1, 25);
  const double sparse = typical_spacing(points, task);
  for (const Vec2& p : grid(0.5, 10)) points.push_back(p + Vec2{200, 0});  // as many, denser
  CHECK(typical_spacing(points, task) == doctest::Approx(sparse).epsilon(0.02).scale(0));
}

TEST_CASE("spacing__is_0_of_too_few_points_and_of_equal_ones") {
  Task task;
  CHECK(typical_spacing({}, task) == 0);
  std::vector<Vec2> few = grid(1, 3);
  CHECK(typical_spacing(few, task) > 0);  // nine
  few.pop_back();
  CHECK(typical_spacing(few, task) == 0);
  CHECK(typical_spacing(std::vector<Vec2>(20, Vec2{1, 1}), task) == 0);
}

TEST_CASE("spacing__in_steps_is_the_same_for_clouds_that_are_the_same") {
  CHECK(stepped_length(0.1370) == stepped_length(0.1376));
  CHECK(stepped_length(1) == 1);
  CHECK(stepped_length(0) == 0);
  for (double length_m = 0.001; length_m < 100; length_m *= 1.013) {
    const double step = stepped_length(length_m);
    CHECK(stepped_length(step) == step);
    CHECK(std::fabs(std::log2(step / length_m)) <= 1.0 / 16 + 1e-12);
  }
}

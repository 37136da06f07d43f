// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
// What field tools share: values of any type, sorting, moments, trees of valued points, spacings.
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/numbers.h"
#include "fieldtools/field_values.h"
#include "unit/cloud/clouds.h"
#include "unit/compare/refusal.h"

using namespace jalon;
using namespace jalon::test;

TEST_CASE("scalar_values__of_any_element_type_as_doubles_and_only_of_one_component") {
  Cloud c = cloud_of(random_points(3, 1, 1));
  c.fields.set(make_column<uint8_t>({"u8"}, std::vector<uint8_t>{0, 7, 255}));
  c.fields.set(make_column<int64_t>({"i64"}, std::vector<int64_t>{-5, 0, int64_t{1} << 52}));
  c.fields.set(make_column<float>({"f32"}, std::vector<float>{-0.5f, 0.25f, kFloatNaN}));
  c.fields.set(make_column<float>({"v", ElementType::kFloat32, 3}, std::vector<float>(9)));
  Task task;
  CHECK(scalar_values(c, "u8", task) == std::vector<double>{0, 7, 255});
  CHECK(scalar_values(c, "i64", task) == std::vector<double>{-5, 0, 0x1p52});
  const auto f32 = scalar_values(c, "f32", task);
  CHECK(f32[0] == -0.5);
  CHECK(std::isnan(f32[2]));
  CHECK(refuses([&] { scalar_values(c, "v", task); }, Status::kInvalidArgument,
                "field \"v\" has 3 components"));
  CHECK(refuses([&] { scalar_values(c, "height", task); }, Status::kNotFound, "i64"));
  const double inf = std::numeric_limits<double>::infinity();
  CHECK(finite_values(std::vector<double>{1, kNaN, -2, inf, 3, -inf}) ==
        std::vector<double>{1, -2, 3});
}

TEST_CASE("sorted_values__over_several_chunks__as_std_sort_for_any_threads") {
  Task one(threads(1)), seven(threads(7));
  for (const size_t n : {size_t{0}, size_t{1}, size_t{1} << 15, size_t{100001}}) {
    RandomStream random(2, n);
    std::vector<double> values(n);
    for (double& v : values) v = static_cast<double>(random.below(5000)) - 2500;  // with ties
    std::vector<double> expected = values;
    std::sort(expected.begin(), expected.end());
    CHECK(sorted_values(values, one) == expected);
    CHECK(sorted_values(values, seven) == expected);
    std::reverse(expected.begin(), expected.end());
    CHECK(sorted_in_chunks(values, std::greater<>(), seven) == expected);
  }
}

TEST_CASE("mean_and_variance__keep_their_digits_far_from_zero_and_for_any_threads") {
  Task one(threads(1)), seven(threads(7));
  RandomStream random(6, 0);
  std::vector<double> values;
  double sum = 0, squares = 0;  // of the whole parts of 1 / 1024, exactly
  for (int i = 0; i < 100001; ++i) {
    const auto part = static_cast<double>(random.below(1024));
    values.push_back(1e12 + part / 1024);
    sum += part;
    squares += part * part;
  }
  const MeanAndVariance m = mean_and_variance(values, one);
  const double mean = sum / 100001, variance = squares / 100001 - mean * mean;
  CHECK(m.count == 100001);
  // 1e12 has steps of 2^-13; sums from 0, of 3e16 a chunk, would have lost whole numbers.
  CHECK(std::fabs(m.mean - 1e12 - mean / 1024) <= 0x1p-12);
  CHECK(m.variance == doctest::Approx(variance / (1024 * 1024)).epsilon(1e-6));
  const MeanAndVariance n = mean_and_variance(values, seven);
  CHECK(n.mean == m.mean);
  CHECK(n.variance == m.variance);
  CHECK(std::isnan(mean_and_variance({}, one).mean));
  CHECK(mean_and_variance(std::vector<double>{4}, one).variance == 0);
}

TEST_CASE("valued_points__a_tree_of_the_points_that_have_a_value_and_no_others") {
  const auto points = shifted(random_points(500, 3, 4), kFar);
  const Cloud cloud = cloud_of(points);
  std::vector<double> values(500);
  for (size_t i = 0; i < 500; ++i) values[i] = i % 4 == 1 ? kNaN : static_cast<double>(i);
  Task task;
  const ValuedPoints some = valued_points(cloud, values, task);
  REQUIRE(some.size() == 375);
  std::vector<int> seen(500, 0);
  for (size_t i = 0; i < some.size(); ++i) {
    ++seen[some.points[i]];
    CHECK(some.values[i] == values[some.points[i]]);
    // 31 bits of a cube of 4 m.
    CHECK(norm(some.tree->local(i) + some.tree->cube().origin - points[some.points[i]]) < 1e-8);
  }
  for (size_t i = 0; i < 500; ++i) CHECK(seen[i] == (i % 4 == 1 ? 0 : 1));
  std::fill(values.begin(), values.end(), 1.0);
  CHECK(valued_points(cloud, values, task).tree == cloud.octree(task));  // no second tree
  std::fill(values.begin(), values.end(), kNaN);
  CHECK(valued_points(cloud, values, task).size() == 0);
  const Buffer<double> near = relative_coordinates(cloud, task);
  const Vec3 shift = cloud.point(0) - Vec3{near[0], near[1], near[2]};
  for (int k = 0; k < 3; ++k) CHECK(shift[k] == std::round(shift[k]));  // whole metres
  for (size_t i = 0; i < 1500; ++i) CHECK((near[i] >= 0 && near[i] <= 8));
}

TEST_CASE("mean_spacing__one_over_the_root_of_the_density_of_a_surface") {
  Task task;
  for (const double spacing_m : {0.01, 0.5}) {
    std::vector<Vec3> points;
    RandomStream random(5, 0);
    const double side_m = 60 * spacing_m;
    for (int i = 0; i < 3600; ++i)
      points.push_back({side_m * random.uniform(), side_m * random.uniform(), 0});
    const Cloud cloud = cloud_of(points);
    const std::vector<double> values(points.size(), 0);
    const ValuedPoints valued = valued_points(cloud, values, task);
    // The median disc of 7 others is 6.67 / 7 of the mean one, borders make it a little larger; a root of both.
    CHECK(mean_spacing(cloud, valued) == doctest::Approx(spacing_m).epsilon(0.06).scale(0));
    CHECK(radius_or_spacings(0, 3, cloud, valued) == 3 * mean_spacing(cloud, valued));
    CHECK(radius_or_spacings(0.125, 3, cloud, valued) == 0.125);
  }
  const Cloud few = cloud_of(random_points(7, 1, 1)), pile = cloud_of(std::vector<Vec3>(50));
  for (const Cloud& cloud : {few, pile}) {
    const ValuedPoints valued = valued_points(cloud, std::vector<double>(cloud.size(), 1), task);
    CHECK(std::isnan(mean_spacing(cloud, valued)));
    CHECK(refuses([&] { radius_or_spacings(0, 3, cloud, valued); }, Status::kInsufficientData,
                  "no spacing"));
  }
}

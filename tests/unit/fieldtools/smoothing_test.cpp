// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
// Filters of a field: the k nearest by brute force, what averages keep, and what takes no part.
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>

#include "base/numbers.h"
#include "fieldtools/smoothing.h"
#include "unit/cloud/clouds.h"
#include "unit/compare/refusal.h"

using namespace jalon;
using namespace jalon::test;

namespace {

using FilterMethod = FieldFilterSettings::Method;
constexpr FilterMethod kFilters[] = {FilterMethod::kGaussian, FilterMethod::kMean,
                                     FilterMethod::kMedian, FilterMethod::kMinimum,
                                     FilterMethod::kMaximum};

// Points with a random field "f" in seconds; every seventh has none.
Cloud noisy_field(size_t n) {
  RandomStream random(1, 7);
  std::vector<double> f(n);
  for (size_t i = 0; i < n; ++i) f[i] = i % 7 == 0 ? kNaN : random.normal();
  return with_field<double>(cloud_of(random_points(n, 3, 8)), "f", "s", "", f);
}

std::vector<double> filtered(const Cloud& cloud, FilterMethod method, uint32_t k, double radius_m) {
  FieldFilterSettings set;
  set.method = method;
  set.k = k;
  set.radius_m = radius_m;
  set.sigma_m = radius_m / set.cut_sigmas;
  Task task;
  return scalar_values(with_filtered_field(cloud, "f", set, task), "filtered", task);
}

}  // namespace

TEST_CASE("with_filtered_field__k_nearest__order_statistics_and_mean_by_brute_force") {
  const Cloud cloud = noisy_field(400);
  Task task;
  const auto f = scalar_values(cloud, "f", task);
  for (const uint32_t k : {6u, 11u}) {
    const auto mean = filtered(cloud, FilterMethod::kMean, k, 0),
               middle = filtered(cloud, FilterMethod::kMedian, k, 0),
               low = filtered(cloud, FilterMethod::kMinimum, k, 0),
               high = filtered(cloud, FilterMethod::kMaximum, k, 0);
    for (size_t i = 0; i < 400; ++i) {
      if (std::isnan(f[i])) {
        CHECK(std::isnan(mean[i]));
        continue;
      }
      std::vector<std::pair<double, double>> near;  // distance and value of those that have one
      for (size_t j = 0; j < 400; ++j)
        if (!std::isnan(f[j])) near.emplace_back(norm(cloud.point(j) - cloud.point(i)), f[j]);
      std::sort(near.begin(), near.end());
      std::vector<double> some;
      for (size_t j = 0; j < k; ++j) some.push_back(near[j].second);
      std::sort(some.begin(), some.end());
      double sum = 0;
      for (const double v : some) sum += v;
      CHECK(mean[i] == doctest::Approx(sum / k).scale(1).epsilon(1e-13));
      CHECK(middle[i] == doctest::Approx((some[(k - 1) / 2] + some[k / 2]) / 2).epsilon(1e-13));
      CHECK(low[i] == some.front());
      CHECK(high[i] == some.back());
    }
  }
}

TEST_CASE("with_filtered_field__constant_fields_stay_and_averages_lie_between_the_extremes") {
  const Cloud cloud = noisy_field(600);
  const auto low = filtered(cloud, FilterMethod::kMinimum, 0, 0.6),
             high = filtered(cloud, FilterMethod::kMaximum, 0, 0.6);
  const Cloud flat = with_field<double>(cloud, "f", "s", "", std::vector<double>(600, 2.5));
  for (const FilterMethod method : kFilters) {
    const auto found = filtered(cloud, method, 0, 0.6), same = filtered(flat, method, 0, 0.6);
    for (size_t i = 0; i < 600; ++i) {
      CHECK(same[i] == doctest::Approx(2.5).epsilon(1e-14));
      if (i % 7 == 0) continue;
      CHECK(found[i] >= low[i] - 1e-14);
      CHECK(found[i] <= high[i] + 1e-14);
    }
  }
}

TEST_CASE("gaussian_means__weights_fall_with_the_distance_and_end_at_the_cut") {
  // Three points in a row, 1 m apart, and one beyond all cuts.
  Cloud cloud = cloud_of({{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {9, 0, 0}});
  const std::vector<double> f{1, 0, 0, 5};
  Task task;
  const ValuedPoints valued = valued_points(cloud, f, task);
  const auto at = [&](const std::vector<double>& by_position, uint32_t point) {
    return by_position[static_cast<size_t>(
        std::find(valued.points.begin(), valued.points.end(), point) - valued.points.begin())];
  };
  const double w = std::exp(-0.5), w2 = std::exp(-2.0);  // one and two sigma away
  const auto wide = gaussian_means(valued, 1, 2.5, task),
             cut = gaussian_means(valued, 1, 1.5, task);
  // Squared distances are floats.
  CHECK(at(wide, 0) == doctest::Approx(1 / (1 + w + w2)).epsilon(1e-6));
  CHECK(at(wide, 1) == doctest::Approx(w / (1 + 2 * w)).epsilon(1e-6));
  CHECK(at(wide, 2) == doctest::Approx(w2 / (1 + w + w2)).epsilon(1e-6));
  CHECK(at(cut, 0) == doctest::Approx(1 / (1 + w)).epsilon(1e-6));
  CHECK(at(cut, 2) == 0);
  CHECK(at(wide, 3) == 5);
}

TEST_CASE("with_filtered_field__keeps_the_unit_replaces_by_name_and_tells_what_is_wrong") {
  const Cloud cloud = noisy_field(100);
  FieldFilterSettings set;
  set.method = FilterMethod::kMedian;
  set.k = 5;
  set.name = "f";
  Task task;
  const Cloud out = with_filtered_field(cloud, "f", set, task);
  CHECK(out.fields.size() == cloud.fields.size());
  CHECK(out.fields.require("f").info().unit == "s");
  CHECK(out.fields.require("f").info().meaning.find("median of f") == 0);
  CHECK(scalar_values(out, "f", task) != scalar_values(cloud, "f", task));
  CHECK(refuses([&] { with_filtered_field(cloud, "g", set, task); }, Status::kNotFound, "g"));
  set.name = "";
  CHECK(refuses([&] { with_filtered_field(cloud, "f", set, task); }, Status::kInvalidArgument,
                "name"));
  set.name = "t";
  set.k = 0;
  const Cloud few = with_field<double>(cloud_of(random_points(3, 1, 1)), "f", "", "",
                                       std::vector<double>{1, 2, 3});
  CHECK(refuses([&] { with_filtered_field(few, "f", set, task); }, Status::kInsufficientData,
                "3 points"));
}

// Half of the points lie on one place, so that its ball holds thousands: all pairs of these would be looked at.
TEST_CASE("with_filtered_field__of_a_pile_of_points_is_what_brute_force_makes_of_each_ball") {
  constexpr size_t kPoints = 14000;
  constexpr double kRadius_m = 0.4;
  std::vector<Vec3> points = random_points(kPoints, 3, 8);
  for (size_t i = 0; i < kPoints; i += 2) points[i] = {1.5, 1.25, 1.0};
  RandomStream random(1, 7);
  std::vector<double> f(kPoints);
  for (size_t i = 0; i < kPoints; ++i) f[i] = i % 7 == 0 ? kNaN : random.normal();
  const Cloud cloud = with_field<double>(cloud_of(points), "f", "s", "", f);
  std::vector<std::vector<double>> found;
  for (const FilterMethod method : kFilters) found.push_back(filtered(cloud, method, 0, kRadius_m));
  size_t large = 0;
  for (size_t i = 0; i < kPoints; i += 59) {
    if (std::isnan(f[i])) continue;
    double weights = 0, weighted = 0, sum = 0;
    std::vector<double> some;
    for (size_t j = 0; j < kPoints; ++j) {
      const double squared = squared_norm(points[j] - points[i]);
      if (std::isnan(f[j]) || squared > kRadius_m * kRadius_m) continue;
      const double sigma = kRadius_m / 3, w = std::exp(-0.5 * squared / (sigma * sigma));
      weights += w;
      weighted += w * f[j];
      sum += f[j];
      some.push_back(f[j]);
    }
    large += some.size() > 5000;
    std::sort(some.begin(), some.end());
    const double middle = (some[(some.size() - 1) / 2] + some[some.size() / 2]) / 2;
    const double n = static_cast<double>(some.size());
    CHECK(found[0][i] == doctest::Approx(weighted / weights).scale(1).epsilon(1e-6));
    CHECK(found[1][i] == doctest::Approx(sum / n).scale(1).epsilon(1e-12));
    CHECK(found[2][i] == middle);
    CHECK(found[3][i] == some.front());
    CHECK(found[4][i] == some.back());
  }
  CHECK(large > 100);
}

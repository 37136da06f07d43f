// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
// The local filter against the test of each neighbourhood by itself, its members found among all points.
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>

#include "fieldtools/chi_square.h"
#include "unit/cloud/clouds.h"
#include "unit/compare/refusal.h"

using namespace jalon;
using namespace jalon::test;

namespace {

// Points with values of a normal law, some of them moved.
struct FilteredCloud {
  Cloud cloud;
  std::vector<double> values;
  NoiseLaw law;

  explicit FilteredCloud(size_t n) : cloud(cloud_of(random_points(n, 4, 7))), values(n) {
    law.gauss_sigma = 0.002;
    RandomStream random(8, 0);
    for (size_t i = 0; i < n; ++i)
      values[i] = 0.002 * random.normal() + (cloud.point(i).x < 1 ? 0.004 : 0);
  }
  // Indices of the nearest points, or of those within the radius.
  std::vector<size_t> around(size_t i, size_t k, double radius_m) const {
    std::vector<std::pair<double, size_t>> all;
    for (size_t j = 0; j < cloud.size(); ++j)
      all.emplace_back(norm(cloud.point(j) - cloud.point(i)), j);
    std::sort(all.begin(), all.end());
    std::vector<size_t> out;
    for (size_t j = 0; j < all.size(); ++j)
      if (radius_m > 0 ? all[j].first <= radius_m : j < k) out.push_back(all[j].second);
    return out;
  }
  std::vector<double> values_of(const std::vector<size_t>& members) const {
    std::vector<double> out;
    for (const size_t j : members) out.push_back(values[j]);
    return out;
  }
  // Whether they lie further from the law's mean than it says: 2 sigma / sqrt(2 pi) on average.
  bool louder(const std::vector<double>& some) const {
    double sum = 0;
    for (const double v : some) sum += std::fabs(v);
    return sum / static_cast<double>(some.size()) > 0.002 * std::sqrt(2 / std::numbers::pi);
  }
};

}  // namespace

TEST_CASE("filter_changes__k_nearest__the_chi_square_of_each_neighbourhood") {
  const FilteredCloud f(600);
  Task task;
  ChiSquareSettings set;
  set.passes = 1;
  set.error_margin = 0.01;
  for (const bool one_sided : {true, false}) {
    set.one_sided = one_sided;
    const ChangeFilter found = filter_changes(f.cloud, f.values, f.law, set, task);
    CHECK(found.threshold == doctest::Approx(11.345).epsilon(1e-4));  // 1 % at 3 degrees of freedom
    CHECK(found.tested == 600);
    uint64_t changed = 0;
    for (size_t i = 0; i < 600; ++i) {
      const auto some = f.values_of(f.around(i, 16, 0));
      const double distance = chi_square_distance(some, f.law, 4, task).distance;
      CHECK(found.distance[i] == doctest::Approx(distance).scale(1).epsilon(1e-12));
      const bool expected = distance > found.threshold && (!one_sided || f.louder(some));
      CHECK((found.changed[i] != 0) == expected);
      changed += expected;
    }
    CHECK(found.changed_count == changed);
    CHECK(changed > 100);  // a quarter of the points has moved by two sigma
  }
}

TEST_CASE("filter_changes__a_radius_of_thousands_of_points_the_chi_square_of_each_ball") {
  const FilteredCloud f(4000);
  Task task;
  ChiSquareSettings set;
  set.passes = 1;
  set.one_sided = true;
  set.radius_m = 2;
  const ChangeFilter found = filter_changes(f.cloud, f.values, f.law, set, task);
  CHECK(found.tested == 4000);
  const double to_first =
      chi_square_threshold(4, set.error_margin) / chi_square_threshold(32, set.error_margin);
  size_t large = 0, changed = 0;
  for (size_t i = 0; i < 4000; i += 37) {
    const auto some = f.values_of(f.around(i, 0, 2));
    if (some.size() <= 1024) continue;
    ++large;
    const double distance = chi_square_distance(some, f.law, 32, task).distance * to_first;
    CHECK(found.distance[i] == doctest::Approx(distance).scale(1).epsilon(1e-12));
    const bool expected = distance > found.threshold && f.louder(some);
    CHECK((found.changed[i] != 0) == expected);
    changed += expected;
  }
  CHECK(large > 20);
  CHECK(changed > 5);
}

TEST_CASE("filter_changes__radius__each_ball_by_its_own_number_of_classes_on_one_scale") {
  const FilteredCloud f(600);
  Task task;
  ChiSquareSettings set;
  set.passes = 1;
  set.radius_m = 0.8;
  const ChangeFilter found = filter_changes(f.cloud, f.values, f.law, set, task);
  size_t untested = 0;
  for (size_t i = 0; i < 600; ++i) {
    const auto some = f.values_of(f.around(i, 0, 0.8));
    if (some.size() < kFewestTested) {
      CHECK(std::isnan(found.distance[i]));
      CHECK(found.changed[i] == 0);
      ++untested;
      continue;
    }
    const uint32_t classes = classes_for(some.size(), 32);
    const double own = chi_square_distance(some, f.law, classes, task).distance;
    CHECK(found.distance[i] / found.threshold ==
          doctest::Approx(own / chi_square_threshold(classes, set.error_margin)).scale(1));
  }
  CHECK(untested > 0);
  CHECK(found.tested == 600 - untested);
}

TEST_CASE("filter_changes__kolmogorov__the_largest_step_between_the_cumulatives") {
  const FilteredCloud f(400);
  Task task;
  ChiSquareSettings set;
  set.method = ChiSquareSettings::Method::kKolmogorov;
  set.passes = 1;
  const ChangeFilter found = filter_changes(f.cloud, f.values, f.law, set, task);
  CHECK(found.threshold == doctest::Approx(1.9495 / 4).epsilon(1e-3).scale(0));  // 0.1 %, 16 values
  CHECK(found.ceiling == 1);
  for (size_t i = 0; i < 400; i += 3) {
    const auto some = f.values_of(f.around(i, 16, 0));
    double most = 0;
    for (const double v : some) {  // F_n just before and at each value
      double below = 0, upto = 0;
      for (const double w : some) below += w < v, upto += w <= v;
      const double share = 0.5 * std::erfc(-v / (0.002 * std::sqrt(2.0)));
      most = std::max({most, upto / 16 - share, share - below / 16});
    }
    CHECK(found.distance[i] == doctest::Approx(most).epsilon(1e-6).scale(0));
  }
}

TEST_CASE("filter_changes__cuts_that_cannot_be_had_are_told") {
  const FilteredCloud f(100);
  Task task;
  ChiSquareSettings set;
  const auto run = [&] { filter_changes(f.cloud, f.values, f.law, set, task); };
  set.threshold = ChiSquareSettings::Threshold::kGiven;
  CHECK(refuses(run, Status::kInvalidArgument, "cut is 0"));
  set.threshold = ChiSquareSettings::Threshold::kEmpirical;
  CHECK(refuses(run, Status::kInvalidArgument, "no empirical threshold"));
  set.method = ChiSquareSettings::Method::kKolmogorov;
  CHECK(refuses(run, Status::kInvalidArgument, "chi_square"));
  const std::vector<double> few{1, 2, 3, 4, 5, 6, 7, 8};
  CHECK(refuses([&] { filter_changes(cloud_of(random_points(8, 1, 1)), few, f.law, {}, task); },
                Status::kInsufficientData, "8 points"));
}

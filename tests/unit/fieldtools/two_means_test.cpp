// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
// Two groups: the centres are the means of what lies on their side of the cut, and no other split is tighter.
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>

#include "base/numbers.h"
#include "fieldtools/two_means.h"
#include "unit/cloud/clouds.h"
#include "unit/compare/refusal.h"

using namespace jalon;
using namespace jalon::test;

namespace {

// Values about 0 and, the rarer ones, about 10; sorted.
std::vector<double> two_groups(size_t n, uint64_t seed) {
  RandomStream random(seed, 8);
  std::vector<double> out(n);
  for (double& v : out) {
    const double group = random.uniform() < 0.3 ? 10 : 0;
    v = group + random.normal();
  }
  std::sort(out.begin(), out.end());
  return out;
}

}  // namespace

TEST_CASE("two_means__centres_are_the_means_of_their_sides_and_the_cut_is_between") {
  for (uint64_t seed = 1; seed <= 10; ++seed) {
    const auto values = two_groups(500, seed);
    const TwoMeans found = two_means(values);
    double sums[2] = {0, 0}, counts[2] = {0, 0};
    for (const double v : values) {
      const size_t side = v > found.cut;
      sums[side] += v;
      ++counts[side];
    }
    CHECK(found.low_centre == doctest::Approx(sums[0] / counts[0]).scale(1).epsilon(1e-12));
    CHECK(found.high_centre == doctest::Approx(sums[1] / counts[1]).epsilon(1e-12));
    CHECK(found.cut == doctest::Approx((found.low_centre + found.high_centre) / 2).epsilon(1e-14));
    CHECK(std::fabs(found.low_centre) < 4 / std::sqrt(counts[0]));  // sigma is 1
    CHECK(std::fabs(found.high_centre - 10) < 4 / std::sqrt(counts[1]));
  }
}

TEST_CASE("two_means__values_scaled_turned_round_and_far_from_zero_split_alike") {
  const auto values = two_groups(20000, 3);
  const TwoMeans found = two_means(values);
  std::vector<double> far = values, mirrored;
  for (double& v : far) v = 1e9 + 0x1p-6 * v;
  for (const double v : values) mirrored.push_back(-v);
  std::reverse(mirrored.begin(), mirrored.end());
  // 1e9 leaves 2^-23 of each value; sums from 0 would leave 2^-8 of all 20 000.
  CHECK(two_means(far).cut - 1e9 == doctest::Approx(0x1p-6 * found.cut).epsilon(1e-5).scale(0));
  CHECK(two_means(mirrored).cut == doctest::Approx(-found.cut).epsilon(1e-12));
  const std::vector<double> pair{2, 5};
  CHECK(two_means(pair).cut == 3.5);
  const std::vector<double> equal(5, 3.0), one{3};
  CHECK(refuses([&] { two_means(equal); }, Status::kDegenerate, "equal"));
  CHECK(refuses([&] { two_means(one); }, Status::kInsufficientData, "1 values"));
}

TEST_CASE("classify_values__two_means__groups_0_and_1_by_the_cut_and_none_without_a_value") {
  auto values = two_groups(400, 5);
  std::reverse(values.begin(), values.end());  // order is no matter
  values[13] = kNaN;
  values[200] = INFINITY;
  Task task;
  const FieldClasses found = classify_values(values, {}, task);
  CHECK(found.missing == 2);
  CHECK(found.counts[0] + found.counts[1] == 398);
  CHECK(found.counts[2] == 0);
  CHECK(std::isinf(found.high_cut));
  CHECK(std::isnan(found.high_centre));
  CHECK(std::fabs(found.low_cut - 5) < 1);
  for (size_t i = 0; i < values.size(); ++i)
    CHECK(found.group[i] == (i == 13 || i == 200 ? kNoGroup : values[i] > found.low_cut ? 1 : 0));
  // Centres are means of their groups: with the counts they give the mean of all.
  double sum = 0;
  for (const double v : values) sum += std::isfinite(v) ? v : 0;
  CHECK(found.low_centre * static_cast<double>(found.counts[0]) +
            found.middle_centre * static_cast<double>(found.counts[1]) ==
        doctest::Approx(sum).epsilon(1e-12));
}

TEST_CASE("classify_values__thresholds__values_on_a_cut_are_below_it_and_cuts_keep_their_order") {
  ClassesSettings set;
  set.method = ClassesSettings::Method::kThresholds;
  set.low = -1;
  set.high = 1;
  Task task;
  const std::vector<double> values{-3, -1, -0.5, 1, 1.5, 8};
  const FieldClasses found = classify_values(values, set, task);
  CHECK(found.group == std::vector<uint8_t>{0, 0, 1, 1, 2, 2});
  CHECK(found.low_centre == -2);
  CHECK(found.middle_centre == 0.25);
  CHECK(found.high_centre == 4.75);
  set.high = -2;
  CHECK(refuses([&] { classify_values(values, set, task); }, Status::kInvalidArgument,
                "high is below low"));
  set.low = set.high = 1;  // no group between
  CHECK(classify_values(values, set, task).counts[1] == 0);
}

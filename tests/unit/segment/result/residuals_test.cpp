// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "segment/result/residuals.h"

#include <doctest/doctest.h>

#include "base/numbers.h"
#include "base/random.h"

using namespace jalon;

namespace {

Segmentation with_residuals(const std::vector<float>& residuals,
                            const std::vector<uint32_t>& labels) {
  Segmentation s;
  s.residuals = make_column<float>({"residual"}, residuals);
  s.labels = make_column<uint32_t>({"label"}, labels);
  return s;
}

}  // namespace

TEST_CASE("residuals__moments_and_bins_of_a_case_done_by_hand") {
  // -3, -1, 1, 3 mm of segment 1; noise and another segment beside it.
  const auto s =
      with_residuals({-0.003f, 0.5f, -0.001f, kFloatNaN, 0.001f, 0.003f}, {1, 2, 1, 0, 1, 1});
  Task task;
  const Residuals r = bin_residuals(s, 1, 4, task);
  CHECK(r.count == 4);
  CHECK(r.mean_m == doctest::Approx(0).scale(1));
  CHECK(r.sigma_m == doctest::Approx(std::sqrt(20e-6 / 3)).scale(0));
  CHECK(r.skewness == doctest::Approx(0).scale(1));
  CHECK(r.excess_kurtosis == doctest::Approx(164.0 / 4 / 25 - 3).epsilon(1e-4));
  CHECK(r.half_range_m == doctest::Approx(0.015).scale(0));  // four sigma are 10.3 mm
  CHECK(r.bins == std::vector<uint64_t>{0, 2, 2, 0});
  CHECK(bin_residuals(s, 0, 4, task).count == 5);
}

TEST_CASE("residuals__of_nothing_and_of_equal_values") {
  Task task;
  const Residuals none = bin_residuals(with_residuals({kFloatNaN}, {0}), 0, 5, task);
  CHECK(none.count == 0);
  CHECK(none.bins == std::vector<uint64_t>(5, 0));
  CHECK(none.expected(0) == 0);
  const Residuals equal = bin_residuals(with_residuals({0, 0, 0}, {1, 1, 1}), 0, 5, task);
  CHECK(equal.sigma_m == 0);
  CHECK(equal.expected(0) == 0);
  CHECK(equal.bins[2] == 3);
}

TEST_CASE("residuals__normal_noise_fills_the_bins_as_expected_for_any_number_of_threads") {
  RandomStream random(1, 1);
  std::vector<float> values(150000);
  for (float& v : values) v = static_cast<float>(0.001 + 0.005 * random.normal());
  const auto s = with_residuals(values, std::vector<uint32_t>(values.size(), 1));
  Residuals first;
  for (const unsigned threads : {1u, 3u}) {
    Task::Hooks hooks;
    hooks.threads = threads;
    Task task(hooks);
    const Residuals r = bin_residuals(s, 0, 40, task);
    if (threads == 1) first = r;
    CHECK(r.mean_m == first.mean_m);
    CHECK(r.excess_kurtosis == first.excess_kurtosis);
    CHECK(r.bins == first.bins);
  }
  uint64_t sum = first.below + first.above;
  for (const uint64_t n : first.bins) sum += n;
  CHECK(sum == values.size());
  const FieldTable t = residual_bins_table(first);
  double chi_square = 0;
  int filled = 0;
  for (size_t i = 0; i < 40; ++i) {
    const double expected = t.require("expected").number(i);
    if (expected < 50) continue;
    const double difference = t.require("count").number(i) - expected;
    chi_square += difference * difference / expected;
    ++filled;
  }
  CHECK(filled > 15);
  CHECK(chi_square < 3 * filled);
  CHECK(t.require("upper").number(39) == doctest::Approx(first.half_range_m).scale(0));
  CHECK(residual_normal_table(first).require("sigma").number(0) == first.sigma_m);
}

// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
// Histograms against counts and moments of the values one by one, and against the law they were drawn from.
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include "base/numbers.h"
#include "fieldtools/histogram.h"
#include "unit/cloud/clouds.h"
#include "unit/compare/refusal.h"

using namespace jalon;
using namespace jalon::test;

namespace {

// Eighths, so that bins of quarters have exact ends and many values lie on them.
std::vector<double> eighths(size_t n) {
  RandomStream random(1, 4);
  std::vector<double> out(n);
  for (double& v : out) v = static_cast<double>(random.below(33)) / 8 - 2;
  return out;
}

uint64_t all_of(const Histogram& h) {
  return std::accumulate(h.counts.begin(), h.counts.end(), h.below + h.above);
}

}  // namespace

TEST_CASE("field_histogram__bins_hold_their_lower_end_and_the_last_its_upper_end_too") {
  auto values = eighths(2000);  // -2 ... 2
  values.push_back(kNaN);
  HistogramSettings set;
  set.bins = 6;
  set.minimum = -0.5;
  set.maximum = 1;
  Task task;
  const Histogram h = field_histogram(values, nullptr, set, task);
  CHECK(h.values == 2000);
  CHECK(h.missing == 1);
  CHECK(all_of(h) == 2000);
  for (size_t b = 0; b < 6; ++b) {
    const double from = -0.5 + 0.25 * static_cast<double>(b), to = from + 0.25;
    const auto in = std::count_if(values.begin(), values.end(), [&](double v) {
      return v >= from && (v < to || (b == 5 && v == to));
    });
    CHECK(h.counts[b] == static_cast<uint64_t>(in));
  }
  CHECK(h.below == static_cast<uint64_t>(std::count_if(values.begin(), values.end(),
                                                       [](double v) { return v < -0.5; })));
  CHECK(h.expected.empty());
}

TEST_CASE("field_histogram__moments_and_quantiles_are_those_of_the_values_one_by_one") {
  RandomStream random(3, 4);
  std::vector<double> values(999);
  for (double& v : values) v = random.normal();
  Task task;
  const Histogram h = field_histogram(values, nullptr, {}, task);
  double sum = 0, squares = 0;
  for (const double v : values) sum += v, squares += v * v;
  CHECK(h.mean == doctest::Approx(sum / 999).scale(1).epsilon(1e-13));
  CHECK(h.rms == doctest::Approx(std::sqrt(squares / 999)).epsilon(1e-13));
  CHECK(h.rms * h.rms == doctest::Approx(h.mean * h.mean + std::pow(h.standard_deviation, 2)));
  for (const auto& [q, share] : {std::pair{h.median, 0.5}, std::pair{h.p90, 0.9},
                                 std::pair{h.p95, 0.95}, std::pair{h.p99, 0.99}}) {
    const double quantile = q;
    const auto below = static_cast<double>(std::count_if(values.begin(), values.end(),
                                                         [&](double v) { return v < quantile; })),
               upto = static_cast<double>(std::count_if(values.begin(), values.end(),
                                                        [&](double v) { return v <= quantile; }));
    CHECK(below <= share * 999);
    CHECK(upto >= share * 999 - 1);
  }
  CHECK(h.counts.size() == 31);  // the root of 999
  const std::vector<double> four{1, 2, 4, 8};
  CHECK(field_histogram(four, nullptr, {}, task).median == 3);
  CHECK(field_histogram(four, nullptr, {}, task).p90 == doctest::Approx(4 + 0.7 * 4));
}

TEST_CASE("field_histogram__a_law_that_is_true_is_near_and_another_is_far") {
  RandomStream random(2, 4);
  std::vector<double> values(5000);
  for (double& v : values) v = 3 + 0.5 * random.normal();
  NoiseLaw truth, other;
  truth.gauss_mean = other.gauss_mean = 3;
  truth.gauss_sigma = 0.5;
  other.gauss_sigma = 0.6;
  Task task;
  HistogramSettings set;
  set.classes = 20;
  const Histogram h = field_histogram(values, &truth, set, task),
                  far = field_histogram(values, &other, set, task);
  CHECK(h.degrees_of_freedom == 19);
  CHECK(h.chi_square < 55);  // 1 in 40 000 at 19 degrees of freedom
  CHECK(h.p_value > 1e-5);
  CHECK(far.p_value < 1e-12);
  CHECK(h.kolmogorov < 2.3 / std::sqrt(5000.0));  // 1 in 20 000
  CHECK(far.kolmogorov > h.kolmogorov);
  const double expected = std::accumulate(h.expected.begin(), h.expected.end(), 0.0);
  CHECK(expected == doctest::Approx(5000 * (truth.cumulative(h.to) - truth.cumulative(h.from))));
  for (size_t b = 0; b < h.counts.size(); ++b)
    CHECK(std::fabs(static_cast<double>(h.counts[b]) - h.expected[b]) <
          5 * std::sqrt(h.expected[b]) + 5);
}

TEST_CASE("histogram_tables__one_row_a_bin_and_one_for_the_rest") {
  const auto values = eighths(100);
  Task task;
  const NoiseLaw law;
  for (const NoiseLaw* given : {static_cast<const NoiseLaw*>(nullptr), &law}) {
    const Histogram h = field_histogram(values, given, {}, task);
    const FieldTable bins = histogram_bins(h, "mm"), rest = histogram_summary(h, "mm");
    CHECK((bins.find("expected") != nullptr) == (given != nullptr));
    CHECK((rest.find("p_value") != nullptr) == (given != nullptr));
    CHECK(bins.require("from").info().unit == "mm");
    CHECK(bins.require("from").count() == h.counts.size());
    for (size_t b = 0; b + 1 < h.counts.size(); ++b) {
      CHECK(bins.require("to").number(b) == doctest::Approx(bins.require("from").number(b + 1)));
      CHECK(bins.require("count").number(b) == static_cast<double>(h.counts[b]));
    }
    CHECK(bins.require("to").number(h.counts.size() - 1) == doctest::Approx(h.maximum));
    CHECK(rest.require("values").number(0) == 100);
    CHECK(rest.require("median").number(0) == h.median);
  }
}

TEST_CASE("field_histogram__no_value_or_a_range_turned_round_is_refused_and_equal_values_are_not") {
  Task task;
  HistogramSettings set;
  const std::vector<double> none{kNaN, kNaN}, equal(7, -4e9);
  CHECK(refuses([&] { field_histogram(none, nullptr, set, task); }, Status::kInsufficientData,
                "no finite value"));
  const Histogram h = field_histogram(equal, nullptr, set, task);
  CHECK(h.from < -4e9);
  CHECK(h.to > -4e9);
  CHECK(all_of(h) == 7);
  CHECK(h.below + h.above == 0);
  set.minimum = 1;
  set.maximum = 0;
  CHECK(refuses([&] { field_histogram(equal, nullptr, set, task); }, Status::kInvalidArgument,
                "maximum is below minimum"));
}

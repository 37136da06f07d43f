// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "fieldtools/noise_law.h"

#include <doctest/doctest.h>

#include <cmath>
#include <limits>
#include <numbers>

#include "fieldtools/chi_square.h"
#include "fieldtools/histogram.h"
#include "fieldtools/two_means.h"
#include "unit/cloud/clouds.h"

namespace jalon {
namespace {

using namespace test;

NoiseLaw fitted(const std::vector<double>& values, const char* law, bool shift = false,
                unsigned threads_ = 1) {
  Task task(threads(threads_));
  auto set = settings_by<NoiseLawSettings>(noise_law_rows(), {{"law", law}});
  set.shift = shift;
  return fit_noise_law(values, set, task);
}

std::vector<double> weibull_values(size_t n, double shape, double scale, double shift,
                                   uint64_t seed) {
  RandomStream random(seed, 0);
  std::vector<double> out(n);
  for (double& v : out) v = shift + scale * std::pow(-std::log1p(-random.uniform()), 1 / shape);
  return out;
}

TEST_CASE("noise_law__nearest_neighbours_on_a_plane__rayleigh_of_the_density") {
  // S1: N random points on 100 x 100 mm, 10 000 random queries at least 3 mm from the border.
  for (const size_t n : {10000u, 50000u}) {
    RandomStream random(7, n);
    std::vector<Vec3> points(n);
    for (Vec3& p : points) p = {100 * random.uniform(), 100 * random.uniform(), 0};
    const Cloud cloud = cloud_of(points);
    Task task;
    const auto tree = cloud.octree(task);
    std::vector<double> distances(10000);
    for (double& d : distances) {
      Neighbour nearest[1];
      tree->knn({3 + 94 * random.uniform(), 3 + 94 * random.uniform(), 0}, 1, nearest);
      d = std::sqrt(nearest[0].squared_distance);
    }
    const NoiseLaw law = fitted(distances, "weibull");
    const double lambda = static_cast<double>(n) / 1e4,
                 b = 1 / std::sqrt(std::numbers::pi * lambda);
    MESSAGE("FIGURE S1, N = ", n, ": Weibull a = ", law.shape, " (2.00 +- 0.03), b = ", law.scale,
            " mm (", b, ")");
    CHECK(std::fabs(law.shape - 2) < 0.03);
    CHECK(std::fabs(law.scale / b - 1) < 0.015);
    CHECK(std::fabs(law.mean() * 2 * std::sqrt(lambda) - 1) < 0.015);
    const double sigma = std::sqrt((4 - std::numbers::pi) / (4 * std::numbers::pi * lambda));
    CHECK(std::fabs(law.standard_deviation() / sigma - 1) < 0.03);
  }
}

TEST_CASE("noise_law__half_normal__1_263_and_0_855") {
  RandomStream random(3, 0);
  std::vector<double> values(400000);
  for (double& v : values) v = std::fabs(random.normal());
  const NoiseLaw law = fitted(values, "weibull");
  MESSAGE("FIGURE half-normal: Weibull a = ", law.shape, " (1.263), b = ", law.scale, " (0.855)");
  CHECK(std::fabs(law.shape - 1.263) < 0.005);
  CHECK(std::fabs(law.scale - 0.855) < 0.005);
}

TEST_CASE("noise_law__weibull__planted_parameters_within_their_standard_deviations") {
  int inside = 0;
  for (uint64_t seed = 1; seed <= 40; ++seed) {
    const NoiseLaw law = fitted(weibull_values(2000, 1.7, 0.004, 0, seed), "weibull");
    const FieldTable row = noise_law_table(law);
    inside += std::fabs(law.shape - 1.7) < 2 * row.require("shape_sigma").number(0);
    inside += std::fabs(law.scale - 0.004) < 2 * row.require("scale_sigma").number(0);
  }
  MESSAGE("FIGURE Weibull parameters within 2 sigma: ", inside, " of 80 (95 % expected)");
  CHECK(inside >= 71);
}

TEST_CASE("noise_law__shift__found_where_there_is_one") {
  for (uint64_t seed = 1; seed <= 5; ++seed) {
    const NoiseLaw law = fitted(weibull_values(20000, 2.5, 0.01, 0.03, seed), "weibull", true);
    CHECK(std::fabs(law.shift - 0.03) < 3e-4);
    CHECK(std::fabs(law.shape - 2.5) < 0.15);
  }
}

TEST_CASE("noise_law__duplicates_and_missing_values__left_out") {
  std::vector<double> values = weibull_values(5000, 2, 1, 0, 4);
  const NoiseLaw clean = fitted(values, "weibull");
  values.push_back(0);
  values.push_back(std::nan(""));
  values.push_back(std::numeric_limits<double>::infinity());
  const NoiseLaw law = fitted(values, "weibull");
  CHECK(law.shape == clean.shape);
  CHECK(law.scale == clean.scale);
}

TEST_CASE("noise_law__cumulative_density_and_quantile__agree") {
  const std::vector<double> values = weibull_values(20000, 1.5, 2, 0, 9);
  for (const char* kind : {"weibull", "gauss", "empirical"}) {
    const NoiseLaw law = fitted(values, kind);
    for (double p = 0.05; p < 1; p += 0.05) {
      const double x = law.quantile(p);
      CHECK(law.cumulative(x) == doctest::Approx(p).epsilon(1e-9));
      if (law.kind == LawKind::kEmpirical) continue;
      const double h = 1e-5;
      const double slope = (law.cumulative(x + h) - law.cumulative(x - h)) / (2 * h);
      CHECK(law.density(x) == doctest::Approx(slope).epsilon(1e-5).scale(0));
    }
  }
}

TEST_CASE("noise_law__weibull_beats_the_gaussian_on_folded_noise") {
  RandomStream random(5, 0);
  std::vector<double> values(2000);
  for (double& v : values) v = std::fabs(0.003 * random.normal());
  const NoiseLaw weibull = fitted(values, "weibull"), gauss = fitted(values, "gauss");
  MESSAGE("FIGURE chi-square of folded noise: Gauss ", gauss.sample_chi_square, ", Weibull ",
          weibull.sample_chi_square, " (fig 3.9: 4285 and 901)");
  CHECK(gauss.sample_chi_square > 3 * weibull.sample_chi_square);
}

TEST_CASE("noise_law__json__reads_back_the_same_law") {
  const std::vector<double> values = weibull_values(3000, 2, 0.5, 0, 2);
  for (const char* kind : {"weibull", "gauss", "empirical"}) {
    const NoiseLaw law = fitted(values, kind);
    const NoiseLaw back = noise_law_from_json(to_json(law));
    CHECK(to_json(back) == to_json(law));
    CHECK(back.cumulative(0.4) == law.cumulative(0.4));
    CHECK(back.samples == 3000);
  }
  for (const char* text :
       {R"({})", R"([])", R"({"law":"cauchy"})", R"({"law":"gauss","mean":0,"sigma":0})",
        R"({"law":"weibull","shape":-1,"scale":1})", R"({"law":"empirical","quantiles":[2,1]})",
        R"({"law":"empirical","quantiles":[1]})", R"({"law":"gauss","mean":"0","sigma":1})"})
    CHECK(status_of([&] { noise_law_from_json(text); }) == Status::kInvalidArgument);
}

TEST_CASE("noise_law__too_little_to_fit__a_status") {
  const double nan = std::nan("");
  CHECK(status_of([&] {
          fitted({1, 2, 3, 4, 5, 6, 7, 8}, "weibull");
        }) == Status::kInsufficientData);
  CHECK(status_of([&] { fitted(std::vector<double>(50, nan), "gauss"); }) ==
        Status::kInsufficientData);
  for (const char* kind : {"weibull", "gauss", "empirical"})
    CHECK(status_of([&] { fitted(std::vector<double>(50, 3.0), kind); }) == Status::kDegenerate);
  CHECK(status_of([&] { fitted(std::vector<double>(50, -1.0), "weibull"); }) ==
        Status::kDegenerate);
}

TEST_CASE("noise_law__threads__the_same_bits") {
  const std::vector<double> values = weibull_values(100000, 1.7, 0.004, 0.001, 6);
  CHECK(to_json(fitted(values, "weibull", true, 1)) == to_json(fitted(values, "weibull", true, 7)));
  CHECK(to_json(fitted(values, "gauss", false, 1)) == to_json(fitted(values, "gauss", false, 7)));
}

TEST_CASE("histogram__counts_what_lies_in_the_bins_and_what_the_law_expects") {
  Task task;
  const std::vector<double> values = weibull_values(100000, 2, 1, 0, 8);
  HistogramSettings set;
  set.bins = 20;
  set.maximum = 2;
  const NoiseLaw law = fitted(values, "weibull");
  const Histogram h = field_histogram(values, &law, set, task);
  uint64_t sum = h.below + h.above;
  for (const uint64_t c : h.counts) sum += c;
  CHECK(sum == values.size());
  CHECK(h.above > 0);
  for (size_t b = 0; b < 20; ++b) {
    const double from = 0.1 * static_cast<double>(b);
    uint64_t count = 0;
    for (const double v : values) count += v >= from && v < from + 0.1;
    const auto apart = static_cast<int64_t>(count) - static_cast<int64_t>(h.counts[b]);
    CHECK(std::abs(apart) <= 2);  // 0.1 is no binary number
    CHECK(std::fabs(static_cast<double>(count) - h.expected[b]) < 5 * std::sqrt(h.expected[b] + 1));
  }
  CHECK(h.median == doctest::Approx(std::sqrt(std::log(2.0))).epsilon(0.01).scale(0));
  const std::vector<double> equal(5, 7.0);
  const Histogram one = field_histogram(equal, nullptr, HistogramSettings{}, task);
  CHECK(one.values == 5);
  CHECK(one.counts[one.counts.size() / 2] + one.counts[0] == 5);
  CHECK(status_of([&] {
          field_histogram(std::vector<double>(5, std::nan("")), nullptr, set, task);
        }) == Status::kInsufficientData);
}

TEST_CASE("two_means__equals_the_best_of_all_splits") {
  for (uint64_t seed = 1; seed <= 20; ++seed) {
    RandomStream random(seed, 1);
    std::vector<double> v(60);
    for (double& x : v) x = random.uniform() < 0.2 ? 5 + random.normal() : random.normal();
    std::sort(v.begin(), v.end());
    double best = 1e300, cut = 0;
    for (size_t i = 1; i < v.size(); ++i) {
      double m[2] = {0, 0}, within = 0;
      for (size_t j = 0; j < v.size(); ++j) m[j >= i] += v[j];
      m[0] /= static_cast<double>(i);
      m[1] /= static_cast<double>(v.size() - i);
      for (size_t j = 0; j < v.size(); ++j) within += (v[j] - m[j >= i]) * (v[j] - m[j >= i]);
      if (within < best) best = within, cut = 0.5 * (m[0] + m[1]);
    }
    CHECK(two_means(v).cut == doctest::Approx(cut).epsilon(1e-12));
  }
  CHECK(status_of([] { two_means(std::vector<double>(4, 1.0)); }) == Status::kDegenerate);
  CHECK(status_of([] { two_means(std::vector<double>(1, 1.0)); }) == Status::kInsufficientData);
}

TEST_CASE("classes__two_cuts_give_three_groups_and_255_for_no_value") {
  Task task;
  ClassesSettings set;
  set.method = ClassesSettings::Method::kThresholds;
  set.low = 1;
  set.high = 2;
  const std::vector<double> values{0.5, 1, 1.5, 2, 2.5, std::nan("")};
  const FieldClasses out = classify_values(values, set, task);
  CHECK(out.group == std::vector<uint8_t>{0, 0, 1, 1, 2, kNoGroup});
  CHECK(out.missing == 1);
  CHECK(out.middle_centre == 1.75);
}

}  // namespace
}  // namespace jalon

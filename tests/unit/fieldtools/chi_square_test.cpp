// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "fieldtools/chi_square.h"

#include <doctest/doctest.h>

#include <chrono>
#include <cmath>

#include "base/distributions.h"
#include "unit/cloud/clouds.h"

namespace jalon {
namespace {

using namespace test;

NoiseLaw weibull(double shape, double scale) {
  NoiseLaw law;
  law.kind = LawKind::kWeibull;
  law.shape = shape;
  law.scale = scale;
  return law;
}

/// Random points of a plane of 10 x 10 m with noise of the law, and a disc of radius 0.5 m in the middle that stands
/// 5 sigma off.
struct Plate {
  Cloud cloud;
  std::vector<double> values;
  std::vector<uint8_t> truth;
};
Plate plate(size_t n, const NoiseLaw& law, double change, uint64_t seed) {
  RandomStream random(seed, 0);
  std::vector<Vec3> points(n);
  Plate out;
  for (Vec3& p : points) {
    p = {10 * random.uniform(), 10 * random.uniform(), 0};
    const bool moved = change > 0 && std::hypot(p.x - 5, p.y - 5) < 0.5;
    out.truth.push_back(moved);
    out.values.push_back(moved ? change + 0.2 * law.quantile(random.uniform())
                               : law.quantile(random.uniform()));
  }
  out.cloud = cloud_of(points);
  return out;
}

TEST_CASE("chi_square__thresholds__those_of_the_tables") {
  // Quantiles of chi-square: 5, 1 and 0.1 % at 2, 3, 4, 5, 6, 7 and 9 degrees of freedom.
  const uint32_t sizes[] = {9, 16, 25, 36, 49, 64, 100};
  const double table[][3] = {{5.99, 9.21, 13.82},   {7.81, 11.34, 16.27},  {9.49, 13.28, 18.47},
                             {11.07, 15.09, 20.52}, {12.59, 16.81, 22.46}, {14.07, 18.48, 24.32},
                             {16.92, 21.67, 27.88}};
  const double margins[] = {0.05, 0.01, 0.001};
  for (size_t row = 0; row < 7; ++row) {
    const uint32_t k = classes_for(sizes[row], 32);
    for (size_t c = 0; c < 3; ++c) {
      const double s = chi_square_threshold(k, margins[c]);
      CHECK(std::round(100 * s) / 100 == doctest::Approx(table[row][c]).epsilon(1e-9).scale(0));
      CHECK(chi_square_tail(k - 1, s) == doctest::Approx(margins[c]).epsilon(1e-10).scale(0));
    }
  }
  CHECK(kolmogorov_threshold(100, 0, 0.05) == doctest::Approx(0.1358).epsilon(1e-3).scale(0));
  CHECK(kolmogorov_threshold(100, 100, 0.01) ==
        doctest::Approx(1.6276 * std::sqrt(0.02)).epsilon(1e-3).scale(0));
}

TEST_CASE("chi_square__false_alarms_on_pure_noise__as_the_table_says") {
  // 40 000 independent neighbourhoods a row: standard error of a rate r is sqrt(r / 40 000).
  struct Row {
    uint32_t n;
    double rates[3];
  };
  const Row rows[] = {{9, {5.0, 0.31, 0.03}},  {16, {4.5, 0.99, 0.13}}, {25, {4.4, 0.76, 0.09}},
                      {36, {4.6, 0.93, 0.09}}, {49, {4.4, 0.95, 0.09}}, {64, {4.9, 1.1, 0.09}},
                      {100, {4.9, 1.0, 0.08}}};
  const double margins[] = {0.05, 0.01, 0.001};
  const NoiseLaw law = weibull(2, 0.003);
  constexpr size_t kDraws = 40000;
  Task task;
  RandomStream random(11, 0);
  for (const Row& row : rows) {
    const uint32_t k = classes_for(row.n, 32);
    uint64_t alarms[3] = {0, 0, 0}, contradictions = 0;
    std::vector<double> values(row.n);
    for (size_t i = 0; i < kDraws; ++i) {
      for (double& v : values) v = law.quantile(random.uniform());
      const auto found = chi_square_distance(values, law, k, task);
      const double d = found.distance;
      CHECK_FALSE(d > row.n * (k - 1.0) + 1e-9);
      for (size_t m = 0; m < 3; ++m) {
        const bool is_beyond = d > chi_square_threshold(k, margins[m]);
        alarms[m] += is_beyond;
        contradictions += is_beyond != (found.p_value < margins[m]);
      }
    }
    CHECK(contradictions == 0);  // the p-value is that of the threshold's distribution
    double rates[3];
    for (size_t m = 0; m < 3; ++m) {
      rates[m] = 100.0 * static_cast<double>(alarms[m]) / kDraws;
      // Both this and the table are of 40 000 draws.
      const double tolerance = 5 * 100 * std::sqrt(2 * row.rates[m] / 100 / kDraws);
      CHECK(std::fabs(rates[m] - row.rates[m]) < tolerance);
    }
    MESSAGE("FIGURE T2, n = ", row.n, ": false alarms ", rates[0], " / ", rates[1], " / ", rates[2],
            " % (table: ", row.rates[0], " / ", row.rates[1], " / ", row.rates[2], ")");
  }
}

TEST_CASE("chi_square__local_filter__rate_on_pure_noise_and_a_found_disc") {
  const NoiseLaw law = weibull(1.5, 0.003);
  Task task;
  for (const char* method : {"chi_square", "kolmogorov"}) {
    auto set = settings_by<ChiSquareSettings>(chi_square_rows(), {{"method", method}});
    set.error_margin = 0.01;
    set.one_sided = false;
    set.passes = 1;
    const Plate noise = plate(100000, law, 0, 1);
    const ChangeFilter quiet = filter_changes(noise.cloud, noise.values, law, set, task);
    const double rate = static_cast<double>(quiet.changed_count) / 1e5;
    MESSAGE("FIGURE ", std::string(method), ": false alarms at 1 %, 16 neighbours: ", 100 * rate,
            " %");
    CHECK(rate < 0.013);
    set.passes = 2;
    set.one_sided = true;
    const Plate changed = plate(100000, law, 0.015, 2);
    const ChangeFilter found = filter_changes(changed.cloud, changed.values, law, set, task);
    uint64_t hits = 0, planted = 0, alarms = 0;
    for (size_t i = 0; i < changed.truth.size(); ++i) {
      planted += changed.truth[i];
      hits += changed.truth[i] && found.changed[i];
      alarms += !changed.truth[i] && found.changed[i] &&
                std::hypot(changed.cloud.point(i).x - 5, changed.cloud.point(i).y - 5) > 0.75;
    }
    MESSAGE("FIGURE ", std::string(method), ", two passes: ", hits, " of ", planted,
            " changed points, ", alarms, " false of 98000");
    CHECK(hits >= planted * 98 / 100);  // at the rim most neighbours are outside
    CHECK(alarms < 1300);
  }
}

TEST_CASE("chi_square__far_above_the_noise__saturates_and_relaxed_classes_do_not") {
  const NoiseLaw law = weibull(2, 0.003);
  Task task;
  const Plate changed = plate(20000, law, 1.0, 3);
  ChiSquareSettings set;
  set.passes = 1;
  const ChangeFilter saturating = filter_changes(changed.cloud, changed.values, law, set, task);
  set.classes = ChiSquareSettings::Classes::kRelaxed;
  const ChangeFilter relaxed = filter_changes(changed.cloud, changed.values, law, set, task);
  CHECK(saturating.ceiling == 48);
  double most = 0, most_relaxed = 0;
  for (size_t i = 0; i < changed.truth.size(); ++i) {
    most = std::max(most, saturating.distance[i]);
    most_relaxed = std::max(most_relaxed, relaxed.distance[i]);
    const Vec3 p = changed.cloud.point(i);
    if (std::hypot(p.x - 5, p.y - 5) < 0.3) CHECK(relaxed.changed[i] + saturating.changed[i] == 2);
  }
  CHECK(most == 48);
  CHECK(most_relaxed > 1000);
}

TEST_CASE("chi_square__quieter_than_the_law__changed_only_without_the_guard") {
  const NoiseLaw law = weibull(2, 0.003);
  const Plate quiet = plate(5000, weibull(2, 0.0003), 0, 4);
  Task task;
  ChiSquareSettings set;
  CHECK(filter_changes(quiet.cloud, quiet.values, law, set, task).changed_count == 0);
  set.one_sided = false;
  CHECK(filter_changes(quiet.cloud, quiet.values, law, set, task).changed_count == 5000);
}

TEST_CASE("chi_square__thresholds_by_choice") {
  Task task;
  const Plate noise = plate(3000, weibull(2, 0.003), 0, 5);
  NoiseLawSettings fit;
  const NoiseLaw law = fit_noise_law(noise.values, fit, task);
  ChiSquareSettings set;
  set.threshold = ChiSquareSettings::Threshold::kEmpirical;
  CHECK(filter_changes(noise.cloud, noise.values, law, set, task).threshold ==
        law.sample_chi_square);
  set.threshold = ChiSquareSettings::Threshold::kGiven;
  CHECK(status_of([&] { filter_changes(noise.cloud, noise.values, law, set, task); }) ==
        Status::kInvalidArgument);
  set.cut = 20;
  CHECK(filter_changes(noise.cloud, noise.values, law, set, task).threshold == 20);
  set.threshold = ChiSquareSettings::Threshold::kEmpirical;
  CHECK(status_of([&] { filter_changes(noise.cloud, noise.values, weibull(2, 1), set, task); }) ==
        Status::kInvalidArgument);
}

TEST_CASE("chi_square__missing_values__not_tested_and_not_counted") {
  const NoiseLaw law = weibull(2, 0.003);
  Plate half = plate(4000, law, 0, 6);
  std::vector<Vec3> kept;
  std::vector<double> kept_values;
  for (size_t i = 0; i < half.values.size(); ++i) {
    if (i % 3 == 0) {
      half.values[i] = std::nan("");
    } else {
      kept.push_back(half.cloud.point(i));
      kept_values.push_back(half.values[i]);
    }
  }
  Task task;
  const ChiSquareSettings set{};
  const ChangeFilter with = filter_changes(half.cloud, half.values, law, set, task);
  const ChangeFilter without = filter_changes(cloud_of(kept), kept_values, law, set, task);
  size_t at = 0;
  for (size_t i = 0; i < half.values.size(); ++i) {
    if (i % 3 == 0) CHECK(std::isnan(with.distance[i]));
    else CHECK(with.distance[i] == without.distance[at++]);
  }
  CHECK(with.tested == kept.size());
}

TEST_CASE("chi_square__too_little__a_status") {
  const NoiseLaw law = weibull(2, 0.003);
  Task task;
  const ChiSquareSettings set{};
  const Plate few = plate(8, law, 0, 7);
  CHECK(status_of([&] { filter_changes(few.cloud, few.values, law, set, task); }) ==
        Status::kInsufficientData);
  const Plate none = plate(100, law, 0, 7);
  CHECK(status_of([&] {
          filter_changes(none.cloud, std::vector<double>(100, std::nan("")), law, set, task);
        }) == Status::kInsufficientData);
  CHECK(filter_changes(none.cloud, std::vector<double>(100, 1.0), law, set, task).changed_count ==
        100);
}

TEST_CASE("chi_square__second_pass__the_test_of_more_neighbours_on_the_scale_of_the_first") {
  const NoiseLaw law = weibull(1.5, 0.003);
  const Plate p = plate(30000, law, 0.006, 9);
  Task task;
  ChiSquareSettings set;
  set.passes = 1;
  const ChangeFilter first = filter_changes(p.cloud, p.values, law, set, task);
  set.neighbours = 36;
  const ChangeFilter more = filter_changes(p.cloud, p.values, law, set, task);
  const double to_first = first.threshold / more.threshold;
  for (const double band_low : {0.1, 0.9}) {  // in one go, or point by point
    set = {};
    set.band_low = band_low;
    const ChangeFilter both = filter_changes(p.cloud, p.values, law, set, task);
    uint64_t again = 0;
    for (size_t i = 0; i < p.values.size(); ++i) {
      const bool in_band = first.distance[i] >= band_low * first.threshold &&
                           first.distance[i] <= 3 * first.threshold;
      again += in_band;
      CHECK(both.distance[i] == (in_band ? more.distance[i] * to_first : first.distance[i]));
    }
    CHECK(both.second_pass == again);
    CHECK((100 * again < 3 * p.values.size()) == (band_low > 0.5));
  }
}

TEST_CASE("chi_square__threads__the_same_bits") {
  const NoiseLaw law = weibull(1.5, 0.003);
  Plate p = plate(20000, law, 0.006, 8);
  Task one(threads(1)), seven(threads(7));
  ChiSquareSettings set;
  for (const double radius_m : {0.0, 0.15}) {
    for (const double band_low : {0.2, 0.98}) {
      set.radius_m = radius_m;
      set.band_low = band_low;
      const ChangeFilter a = filter_changes(p.cloud, p.values, law, set, one);
      const ChangeFilter b = filter_changes(p.cloud, p.values, law, set, seven);
      CHECK(a.changed == b.changed);
      CHECK(std::memcmp(a.distance.data(), b.distance.data(), 8 * a.distance.size()) == 0);
      CHECK(a.second_pass == b.second_pass);
      CHECK(a.changed_count > 0);
    }
  }
}

}  // namespace
}  // namespace jalon

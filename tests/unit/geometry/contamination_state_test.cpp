// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "geometry/contamination_state.h"

#include <doctest/doctest.h>

#include <cmath>

#include "base/random.h"

using namespace jalon;

namespace {

constexpr double kContaminationStateSigma_m = 0.005, kContaminationStateTolerance_m = 0.025;

std::vector<PlaneSample> clean_samples(size_t n) {
  RandomStream random(5, 9);
  std::vector<PlaneSample> out;
  for (size_t i = 0; i < n; ++i)
    out.push_back({static_cast<float>(2 * random.uniform() - 1),
                   static_cast<float>(random.uniform() - 0.5),
                   static_cast<float>(kContaminationStateSigma_m * random.normal()), 1});
  return out;
}

}  // namespace

TEST_CASE("contamination_state__residual_is_the_height_above_the_corrected_plane") {
  ContaminationState state;
  state.height = 0.5;
  state.slope_u = 2;
  state.slope_v = -1;
  CHECK(state.residual({3, 4, 7, 0}) == 7 - (0.5 + 6 - 4));
}

TEST_CASE("contamination_state__tables_are_those_of_each_zones_shares") {
  using With = ContaminationTable::With;
  ContaminationState state;
  state.sigma_m = kContaminationStateSigma_m;
  state.front = {0.3, 0};
  state.behind = {0, 0.1};
  const auto tables = state.tables(kContaminationStateTolerance_m, With::kLogDensity);
  REQUIRE(tables.size() == kContaminationZones);
  for (size_t z = 0; z < kContaminationZones; ++z) {
    const ContaminationTable one({kContaminationStateSigma_m, kContaminationStateTolerance_m,
                                  state.front[z], state.behind[z]},
                                 With::kLogDensity);
    for (const double r : {-0.02, 0.001, 0.015}) {
      CHECK(tables[z].log_density(r) == one.log_density(r));
      CHECK(tables[z].weights(r).front == one.weights(r).front);
    }
  }
}

TEST_CASE("contamination_covariance__without_foreign_points__is_that_of_least_squares") {
  ContaminationState state;
  state.sigma_m = kContaminationStateSigma_m;
  Task task;
  for (const size_t n : {size_t{900}, size_t{4000}}) {  // by the jackknife, by White's sandwich
    const auto samples = clean_samples(n);
    Symmetric3 c{};
    REQUIRE(contamination_covariance(samples, state, kContaminationStateTolerance_m, task, c));
    // sigma^2 (X^T X)^-1 of evenly spread u and v: n / 3 and n / 12 are the sums of their squares.
    const double s2 = kContaminationStateSigma_m * kContaminationStateSigma_m,
                 count = static_cast<double>(n);
    CHECK(c[0] == doctest::Approx(s2 / (count / 3)).epsilon(0.15).scale(0));
    CHECK(c[3] == doctest::Approx(s2 / (count / 12)).epsilon(0.15).scale(0));
    CHECK(c[5] == doctest::Approx(s2 / count).epsilon(0.15).scale(0));
  }
}

TEST_CASE("contamination_covariance__points_that_do_not_fix_the_plane__false") {
  ContaminationState state;
  state.sigma_m = kContaminationStateSigma_m;
  Task task;
  Symmetric3 c{};
  auto line = clean_samples(200);
  for (PlaneSample& s : line) s.v = 0;
  CHECK_FALSE(contamination_covariance(line, state, kContaminationStateTolerance_m, task, c));
  CHECK_FALSE(contamination_covariance({}, state, kContaminationStateTolerance_m, task, c));
}

TEST_CASE("contamination_covariance__any_number_of_threads__same_bits") {
  ContaminationState state;
  state.sigma_m = kContaminationStateSigma_m;
  state.front = {0, 0.05};
  const auto samples = clean_samples(20000);
  Symmetric3 first{};
  for (const unsigned threads : {1u, 3u}) {
    Task::Hooks hooks;
    hooks.threads = threads;
    Task task(hooks);
    Symmetric3 c{};
    REQUIRE(contamination_covariance(samples, state, kContaminationStateTolerance_m, task, c));
    if (threads == 1) first = c;
    CHECK(c == first);
  }
}

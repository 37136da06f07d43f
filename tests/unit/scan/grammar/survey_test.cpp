// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include <doctest/doctest.h>

#include <set>

#include "scan/grammar/survey.h"
#include "unit/scan/grammar/facades.h"

using namespace jalon;
using namespace jalon::test;
using namespace jalon::grammar;

namespace {

const Plan& town_house() {
  static const Plan plan = planned(FacadeKind::kTownHouse, 3);
  return plan;
}

}  // namespace

TEST_CASE("survey__follows_each_parameter_and_leaves_the_others_to_the_seed") {
  const SceneSurvey own = survey_of(town_house(), {}, 9);
  const SceneSurvey told =
      survey_of(town_house(), {.spacing_m = 0.05, .noise_m = 0.001, .misfit_m = 0.002}, 9);
  CHECK(told.scanner.range_noise_m == 0.001);
  CHECK(told.scanner.misfit_shift_m == 0.002);
  CHECK(told.scanner.dropout == own.scanner.dropout);
  CHECK(told.scanner.surfaces.glass_return_max == own.scanner.surfaces.glass_return_max);
  REQUIRE(told.stations.size() == own.stations.size());
  double distance = 0;
  for (size_t s = 0; s < told.stations.size(); ++s) {
    CHECK(told.stations[s].pose.m == own.stations[s].pose.m);
    distance -= told.stations[s].pose.translation().y / static_cast<double>(told.stations.size());
  }
  CHECK(told.scanner.horizontal_step_rad * distance == doctest::Approx(0.05).scale(0));
  CHECK(told.scanner.vertical_step_rad == told.scanner.horizontal_step_rad);
  for (int64_t n = 1; n <= 4; ++n)
    CHECK(survey_of(town_house(), {.stations = n}, 9).stations.size() == static_cast<size_t>(n));
  CHECK(survey_of(town_house(), {.glass = BySeed::kNo}, 9).scanner.surfaces.glass_return_min == 1);
  CHECK(survey_of(town_house(), {.glass = BySeed::kYes}, 9).scanner.surfaces.glass_return_max <=
        0.5);
  CHECK(has_occluders({.occluders = BySeed::kYes}, 9));
  CHECK_FALSE(has_occluders({.occluders = BySeed::kNo}, 9));
}

TEST_CASE("survey__by_the_seed_stays_within_what_the_parameters_promise") {
  std::set<size_t> counts;
  size_t glass = 0, occluders = 0;
  for (uint64_t seed = 1; seed <= 100; ++seed) {
    const Plan plan = plan_facade({}, seed);
    const SceneSurvey survey = survey_of(plan, {}, seed);
    counts.insert(survey.stations.size());
    glass += has_glass({}, seed);
    occluders += has_occluders({}, seed);
    double distance = 0;
    for (const ScanStation& s : survey.stations) {
      distance -= s.pose.translation().y / static_cast<double>(survey.stations.size());
      CHECK(s.pose.translation().y <= -5);
    }
    const double spacing = survey.scanner.horizontal_step_rad * distance;
    CHECK(spacing >= 0.003 - 1e-12);
    CHECK(spacing <= 0.04 + 1e-12);
    CHECK(survey.scanner.range_noise_m >= 0.002);
    CHECK(survey.scanner.range_noise_m <= 0.008);
    CHECK(survey.scanner.misfit_shift_m <= 0.003);
  }
  CHECK(counts == std::set<size_t>{1, 2, 3, 4});
  CHECK(glass > 70);
  CHECK(glass < 98);
  CHECK(occluders > 55);
  CHECK(occluders < 95);
}

TEST_CASE("survey__has_the_whole_front_in_view_from_every_station") {
  for (uint64_t seed = 1; seed <= 30; ++seed) {
    const Plan plan = plan_facade({}, seed);
    const SceneSurvey survey = survey_of(plan, {}, seed);
    for (const ScanStation& station : survey.stations) {
      const Vec3 eye = station.pose.translation();
      for (const double x : {0.0, plan.width_m})
        for (const double z : {0.0, plan.top_m()}) {
          const double turn = std::atan2(x - eye.x, -eye.y),
                       up = std::atan2(z - eye.z, std::hypot(x - eye.x, eye.y));
          CHECK(turn > survey.scanner.horizontal_from_rad);
          CHECK(turn < survey.scanner.horizontal_to_rad);
          CHECK(up > survey.scanner.vertical_from_rad);
          CHECK(up < survey.scanner.vertical_to_rad);
        }
    }
    CHECK(reach_m(survey) > 7);
  }
}

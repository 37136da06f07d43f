// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "registration/network/approximate.h"

#include <doctest/doctest.h>

#include "base/error.h"
#include "unit/registration/network/made_network.h"

using namespace jalon;
using namespace jalon::test;

namespace {

double worst_place_m(const Survey& survey) {
  double worst = 0;
  for (size_t i = 0; i < survey.points.size(); ++i)
    worst = std::max(worst, norm(survey.points[i].position - nails()[i].place));
  return worst;
}

}  // namespace

TEST_CASE("approximate__a_whole_network_follows_from_two_points") {
  const NetworkSettings settings;
  Survey survey = observed(settings, {});
  place_points(survey, settings);
  CHECK(worst_place_m(survey) < 0.01);  // the Earth's curvature is left out
}

TEST_CASE("approximate__a_free_station_is_placed_by_two_targets_and_directions_alone_intersect") {
  const NetworkSettings settings;
  Survey survey = observed(settings, {});
  // Nail 6 is a free station: nobody sights it. Nail 9 is sighted by directions and zenith angles alone.
  std::erase_if(survey.sightings, [](const SurveySight& s) { return s.target == 6; });
  for (SurveySight& s : survey.sightings)
    if (s.target == 9 || s.setup == 9) s.distance_m = NAN;
  std::erase_if(survey.sightings, [](const SurveySight& s) { return s.setup == 9; });
  place_points(survey, settings);
  CHECK(worst_place_m(survey) < 0.01);
}

TEST_CASE("approximate__a_network_without_coordinates_gets_its_own") {
  const NetworkSettings settings;
  Survey survey = observed(settings, {}, false);
  place_points(survey, settings);
  CHECK(survey.points[0].position == Vec3{});
  const double apart = norm(survey.points[3].position - survey.points[8].position);
  CHECK(apart == doctest::Approx(norm(nails()[3].place - nails()[8].place)).epsilon(1e-4));
}

TEST_CASE("approximate__a_point_that_no_sight_places_is_named") {
  const NetworkSettings settings;
  Survey survey = observed(settings, {});
  survey.points.emplace_back().id = "lost";
  CHECK_THROWS_WITH_AS(place_points(survey, settings), doctest::Contains("point lost"), Error);
}

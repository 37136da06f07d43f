// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "registration/network/network_adjustment.h"

#include <doctest/doctest.h>

#include <Eigen/Dense>
#include <algorithm>
#include <numbers>

#include "base/distributions.h"
#include "base/error.h"
#include "unit/geometry/primitives.h"
#include "unit/registration/network/made_network.h"

using namespace jalon;
using namespace jalon::test;

namespace {

NetworkAdjustment adjusted(Survey survey, const NetworkSettings& settings) {
  Task task;
  return adjust_network(std::move(survey), settings, task);
}

Eigen::Matrix3d covariance_of(const AdjustedPoint& p) {
  return Eigen::Map<const Eigen::Matrix<double, 3, 3, Eigen::RowMajor>>(p.covariance_m2.data());
}

bool is_covered(const AdjustedPoint& p, const Vec3& truth) {
  const Vec3 d = p.position - truth;
  const Eigen::Vector3d e(d.x, d.y, d.z);
  return e.dot(covariance_of(p).llt().solve(e)) < chi_square_quantile(3, 0.95);
}

struct NetworkTally {
  size_t points = 0, covered = 0, accepted = 0, tests = 0, alarms = 0;
};

NetworkTally drawn(const NetworkSettings& settings, uint64_t draws) {
  NetworkTally all;
  for (uint64_t seed = 1; seed <= draws; ++seed) {
    RandomStream random(seed, 7);
    const NetworkAdjustment made = adjusted(observed(settings, {&random}), settings);
    CHECK(made.is_converged);
    for (size_t i = 0; i < made.points.size(); ++i) {
      if (i == 0 || i == 3) continue;
      ++all.points;
      all.covered += is_covered(made.points[i], nails()[i].place);
    }
    all.accepted += made.p_value >= 0.05;
    for (size_t i = 0; i < made.observations.size(); ++i) {
      if (made.kinds[i].kind > ObservationKind::kDistance) continue;
      ++all.tests;
      all.alarms += made.observations[i].is_outlier;
    }
  }
  return all;
}

double share(size_t part, size_t whole) {
  return static_cast<double>(part) / static_cast<double>(whole);
}

}  // namespace

TEST_CASE("network__without_noise_gives_the_true_coordinates_back") {
  const NetworkSettings settings;
  const NetworkAdjustment made = adjusted(observed(settings, {}), settings);
  CHECK(made.is_converged);
  for (size_t i = 0; i < made.points.size(); ++i)
    CHECK(norm(made.points[i].position - nails()[i].place) < 1e-7);
  CHECK(made.weighted_squares < 1e-9);
  CHECK(made.redundancy == static_cast<int>(made.observations.size()) - made.unknowns);
}

TEST_CASE("network__ellipsoids_cover_the_global_test_accepts_and_tests_alarm_as_promised") {
  NetworkSettings settings;
  settings.snooping.significance = 0.01;
  const uint64_t draws = is_full() ? 1000 : 100;
  const NetworkTally all = drawn(settings, draws);
  MESSAGE("FIGURE traverse of 12 stations, "
          << draws << " draws: 95 % ellipsoids cover " << 100 * share(all.covered, all.points)
          << " %, global test accepts " << 100 * share(all.accepted, draws)
          << " % (95), false alarms " << 100 * share(all.alarms, all.tests) << " % (1)");
  // Points of a draw have to do with each other: of 100 draws the share scatters by up to 2 %.
  CHECK(share(all.covered, all.points) > (is_full() ? 0.93 : 0.90));
  CHECK(share(all.covered, all.points) < (is_full() ? 0.97 : 0.99));
  CHECK(share(all.accepted, draws) > (is_full() ? 0.93 : 0.87));
  CHECK(share(all.accepted, draws) < (is_full() ? 0.97 : 1.01));
  CHECK(share(all.alarms, all.tests) > 0.007);
  CHECK(share(all.alarms, all.tests) < 0.013);
}

TEST_CASE("network__a_blunder_of_the_detectable_size_is_found_with_the_power_and_left_out") {
  NetworkSettings settings;
  const size_t draws = is_full() ? 1000 : 150;
  size_t found = 0;
  for (uint64_t seed = 1; seed <= draws; ++seed) {
    RandomStream random(seed, 8);
    Survey survey = observed(settings, {&random});
    const NetworkAdjustment good = adjusted(survey, settings);
    const size_t number = 3 * (seed % survey.sightings.size()) + 2;  // a distance
    REQUIRE(good.kinds[number].kind == ObservationKind::kDistance);
    survey.sightings[good.kinds[number].sighting].distance_m +=
        good.observations[number].detectable;
    found += adjusted(survey, settings).observations[number].is_outlier;
  }
  MESSAGE("FIGURE power of the test of one observation: " << 100 * share(found, draws)
                                                          << " % (80)");
  CHECK(share(found, draws) > (is_full() ? 0.76 : 0.70));
  CHECK(share(found, draws) < (is_full() ? 0.84 : 0.90));
}

TEST_CASE("network__the_worst_outlier_is_left_out_and_the_rest_is_as_without_it") {
  NetworkSettings settings;
  RandomStream random(5, 9);
  Survey survey = observed(settings, {&random});
  survey.sightings[20].distance_m += 0.5;
  settings.reject = true;
  const NetworkAdjustment made = adjusted(survey, settings);
  CHECK(made.rejected == 1);
  size_t number = 0;
  while (made.kinds[number].is_used) ++number;
  CHECK(made.kinds[number].sighting == 20);
  CHECK(made.observations[number].residual == doctest::Approx(-0.5).epsilon(0.05).scale(0));
  survey.sightings[20].distance_m = NAN;
  const NetworkAdjustment without = adjusted(survey, settings);
  for (size_t i = 0; i < made.points.size(); ++i)
    CHECK(norm(made.points[i].position - without.points[i].position) < 1e-9);
}

TEST_CASE("network__a_free_network_keeps_its_shape_its_centre_and_its_bearing") {
  NetworkSettings settings;
  RandomStream random(3, 10);
  const Survey survey = observed(settings, {&random});
  const NetworkAdjustment held = adjusted(survey, settings);
  settings.datum = NetworkDatum::kFree;
  const NetworkAdjustment made = adjusted(survey, settings);
  CHECK(made.defect == 4);
  // The same residuals as any least constraint; two fixed points are two coordinates more than that.
  CHECK(made.redundancy == held.redundancy - 2);
  CHECK(made.weighted_squares < held.weighted_squares);
  // Inner constraints: least trace of all.
  double trace = 0, held_trace = 0;
  for (size_t i = 0; i < made.points.size(); ++i)
    trace += covariance_of(made.points[i]).trace(),
        held_trace += covariance_of(held.points[i]).trace();
  CHECK(trace < held_trace);
  // Of its own, without any coordinates, it has the same shape.
  const NetworkAdjustment own = adjusted(
      [&] {
        Survey bare = survey;
        for (SurveyPoint& p : bare.points)
          p.position = {NAN, NAN, NAN}, p.sigma_m = {NAN, NAN, NAN};
        return bare;
      }(),
      settings);
  CHECK(own.weighted_squares == doctest::Approx(made.weighted_squares).epsilon(1e-3));
  const auto apart = [](const NetworkAdjustment& n) {
    return norm(n.points[1].position - n.points[4].position);
  };
  CHECK(apart(own) == doctest::Approx(apart(made)).epsilon(1e-7));
}

TEST_CASE("network__order_of_sights_a_field_books_decimals_and_a_jitter_hardly_move_it") {
  const NetworkSettings settings;
  RandomStream random(6, 14), tenth(6, 15);
  const Survey survey = observed(settings, {&random});
  const NetworkAdjustment made = adjusted(survey, settings);
  const auto moved_sigmas = [&](const Survey& other) {
    const NetworkAdjustment again = adjusted(other, settings);
    double most = 0;
    for (size_t i = 0; i < made.points.size(); ++i)
      for (int axis = 0; axis < 3; ++axis) {
        const double sigma_m =
            std::sqrt(made.points[i].covariance_m2[4 * static_cast<size_t>(axis)]);
        const double by_m =
            std::abs(again.points[i].position[axis] - made.points[i].position[axis]);
        most = std::max(most, sigma_m > 0 ? by_m / sigma_m : by_m);
      }
    return most;
  };
  Survey reversed = survey, rounded = survey, jittered = survey;
  std::reverse(reversed.sightings.begin(), reversed.sightings.end());
  const auto to_step = [](double v, double step) { return std::round(v / step) * step; };
  constexpr double kTenthOfMilligon_rad = 1e-4 * std::numbers::pi / 200;
  for (SurveySight& s : rounded.sightings) {
    s.direction_rad = to_step(s.direction_rad, kTenthOfMilligon_rad);
    s.zenith_rad = to_step(s.zenith_rad, kTenthOfMilligon_rad);
    s.distance_m = to_step(s.distance_m, 1e-4);
  }
  for (SurveySight& s : jittered.sightings) {
    s.direction_rad += 0.1 * settings.sigma_direction_rad * tenth.normal();
    s.zenith_rad += 0.1 * settings.sigma_zenith_rad * tenth.normal();
    s.distance_m += 0.1 * settings.sigma_distance_m * tenth.normal();
  }
  CHECK(moved_sigmas(reversed) < 1e-6);
  const double by_decimals = moved_sigmas(rounded), by_jitter = moved_sigmas(jittered);
  MESSAGE("FIGURE network: most that moves, in its sigmas: decimals of a field book "
          << by_decimals << ", a jitter of a tenth of the noise " << by_jitter);
  CHECK(by_decimals < 0.1);
  CHECK(by_jitter < 0.3);
}

TEST_CASE("network__weak_points_move_by_what_their_sigmas_allow") {
  const NetworkSettings settings;
  Survey survey = observed(settings, {});
  survey.points[8].position = nails()[8].place + Vec3{0.05, 0, 0};
  survey.points[8].sigma_m = {1e-5, 1e-5, 1e-5};
  const NetworkAdjustment stiff = adjusted(survey, settings);
  CHECK(norm(stiff.points[8].position - survey.points[8].position) < 1e-4);
  CHECK(stiff.p_value < 1e-6);  // the sights contradict it, and it is told
  survey.points[8].sigma_m = {1, 1, 1};
  const NetworkAdjustment soft = adjusted(survey, settings);
  CHECK(norm(soft.points[8].position - nails()[8].place) < 1e-5);
}

TEST_CASE("network__what_nothing_holds_is_named") {
  const NetworkSettings settings;
  Survey survey = observed(settings, {});
  survey.points[3].sigma_m = {NAN, NAN, NAN};
  CHECK_THROWS_WITH_AS(adjusted(survey, settings), doctest::Contains("nothing holds"), Error);
  survey.points[0].sigma_m = {0, 0, NAN};
  survey.points[3].sigma_m = {0, 0, NAN};
  CHECK_THROWS_WITH_AS(adjusted(survey, settings), doctest::Contains("height"), Error);
  CHECK_THROWS_WITH_AS(adjusted({}, settings), doctest::Contains("no"), Error);
}

TEST_CASE("network__an_estimated_sigma0_takes_a_common_factor_of_all_sigmas_away") {
  NetworkSettings settings;
  RandomStream random(11, 12);
  const Survey survey = observed(settings, {&random});
  settings.snooping.sigma0 = UnitWeight::kEstimated;
  const NetworkAdjustment right = adjusted(survey, settings);
  for (double* sigma :
       {&settings.sigma_direction_rad, &settings.sigma_zenith_rad, &settings.sigma_distance_m,
        &settings.sigma_distance_ppm, &settings.sigma_centring_m, &settings.sigma_target_centring_m,
        &settings.sigma_height_m, &settings.sigma_target_height_m})
    *sigma *= 3;
  const NetworkAdjustment wide = adjusted(survey, settings);
  CHECK(wide.sigma0 == doctest::Approx(right.sigma0 / 3).epsilon(1e-6));
  for (size_t i = 0; i < right.points.size(); ++i)
    for (size_t k = 0; k < 9; ++k)
      CHECK(wide.points[i].covariance_m2[k] ==
            doctest::Approx(right.points[i].covariance_m2[k]).epsilon(1e-5).scale(1e-9));
}

TEST_CASE("network__has_the_same_bits_with_any_number_of_threads_and_far_from_the_origin") {
  const NetworkSettings settings;
  RandomStream random(2, 13);
  const Survey survey = observed(settings, {&random});
  Task one(Task::Hooks{.threads = 1});
  const NetworkAdjustment a = adjusted(survey, settings);
  const NetworkAdjustment b = adjust_network(survey, settings, one);
  for (size_t i = 0; i < a.points.size(); ++i) {
    CHECK(a.points[i].position == b.points[i].position);
    CHECK(a.points[i].covariance_m2 == b.points[i].covariance_m2);
  }
  Survey far = survey;
  const Vec3 grid{652000, 6861000, 0};
  for (SurveyPoint& p : far.points) p.position += grid;
  const NetworkAdjustment c = adjusted(far, settings);
  for (size_t i = 0; i < a.points.size(); ++i)
    CHECK(norm(c.points[i].position - grid - a.points[i].position) < 2e-9 * 10);
}

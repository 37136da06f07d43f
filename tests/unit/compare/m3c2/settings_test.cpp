// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0

// Parameters of method "m3c2": what lists must hold, and what the derived values are.
#include "compare/m3c2/settings.h"

#include <doctest/doctest.h>

#include <cmath>

#include "base/numbers.h"
#include "unit/cloud/clouds.h"

using namespace jalon;
using namespace jalon::test;

namespace {

M3c2Settings with_covariance(std::vector<double> numbers) {
  M3c2Settings settings;
  settings.registration_covariance = std::move(numbers);
  return settings;
}

std::vector<double> diagonal36(double value) {
  std::vector<double> out(36, 0.0);
  for (size_t i = 0; i < 6; ++i) out[7 * i] = value;
  return out;
}

}  // namespace

TEST_CASE("m3c2_settings__lists_of_the_wrong_length_are_named") {
  CHECK_NOTHROW(M3c2Settings{}.check());
  for (const auto& [list, name] :
       {std::pair{&M3c2Settings::orientation_direction, "orientation_direction has 2"},
        {&M3c2Settings::viewpoint, "viewpoint has 2"},
        {&M3c2Settings::registration_centre, "registration_centre has 2"}}) {
    M3c2Settings settings;
    settings.*list = {1, 2};
    CHECK(status_of([&] { settings.check(); }) == Status::kInvalidArgument);
    CHECK_THROWS_WITH_AS(settings.check(), doctest::Contains(name), Error);
  }
  CHECK_THROWS_WITH_AS(with_covariance(std::vector<double>(35, 0.0)).check(),
                       doctest::Contains("35"), Error);
}

TEST_CASE("m3c2_settings__a_covariance_is_symmetric_and_has_no_negative_variance") {
  auto numbers = diagonal36(4e-6);
  numbers[6 * 4 + 1] = numbers[6 * 1 + 4] = 1e-6;
  CHECK_NOTHROW(with_covariance(numbers).check());
  numbers[6 * 4 + 1] *= 1 + 1e-12;  // rounding of who computed it
  CHECK_NOTHROW(with_covariance(numbers).check());
  numbers[6 * 4 + 1] = 1.1e-6;
  CHECK_THROWS_WITH_AS(with_covariance(numbers).check(), doctest::Contains("row 4, column 1"),
                       Error);
  numbers = diagonal36(1);
  numbers[7 * 3] = -1e-30;
  CHECK_THROWS_WITH_AS(with_covariance(numbers).check(), doctest::Contains("variance 3"), Error);
  numbers[7 * 3] = kNaN;
  CHECK(status_of([&] { with_covariance(numbers).check(); }) == Status::kInvalidArgument);
}

TEST_CASE("m3c2_settings__radii_ascend_and_the_gap_follows_the_cylinders") {
  M3c2Settings settings;
  settings.normal_radius_m = 0.7;
  CHECK(settings.radii_m() == std::vector<double>{0.7});
  settings.normal_radii_m = {0.5, 0.1, 0.3};
  CHECK(settings.radii_m() == std::vector<double>{0.1, 0.3, 0.5});
  settings.cylinder_radius_m = 0.6;
  CHECK(settings.gap_m() == doctest::Approx(0.2).epsilon(1e-15).scale(0));
  settings.surface_gap_m = 0.07;
  CHECK(settings.gap_m() == 0.07);
  settings.surfaces = M3c2Settings::Surfaces::kAll;
  CHECK(settings.gap_m() == 0);
}

TEST_CASE("m3c2_settings__words_and_a_registration_reach_the_settings_or_leave_all_as_it_was") {
  const auto words = settings_by<M3c2Settings>(m3c2_rows(), {{"core_from", "compared"},
                                                             {"normals", "horizontal"},
                                                             {"normals_from", "core"},
                                                             {"orientation", "point"},
                                                             {"position", "mean"},
                                                             {"surfaces", "all"},
                                                             {"precision_from", "covariances"}});
  CHECK(words.core_from == M3c2Settings::Source::kCompared);
  CHECK(words.normals == M3c2Settings::Normals::kHorizontal);
  CHECK(words.normals_from == M3c2Settings::Source::kCore);
  CHECK(words.orientation == M3c2Settings::Orientation::kPoint);
  CHECK(words.position == M3c2Settings::Position::kMean);
  CHECK(words.surfaces == M3c2Settings::Surfaces::kAll);
  CHECK(words.precision_from == M3c2Settings::PrecisionFrom::kCovariances);

  ParamSet params("comparer m3c2", m3c2_rows());
  CHECK_FALSE(settings_from<M3c2Settings>(params).registration().has_value());
  use_registration_in_m3c2(diagonal36(1e-6), {5, 6, 7}, params);
  const auto registration = settings_from<M3c2Settings>(params).registration();
  REQUIRE(registration.has_value());
  // At its centre a registration turns nothing; 3 m away a turn of 1 mrad is 3 mm.
  CHECK(registration->variance_along({5, 6, 7}, {0, 0, 1}) == doctest::Approx(1e-6).scale(0));
  CHECK(registration->variance_along({8, 6, 7}, {0, 0, 1}) == doctest::Approx(10e-6).scale(0));
  const std::string before = params.to_json();
  CHECK_THROWS_AS(use_registration_in_m3c2(diagonal36(2e-6), {1e10, 0, 0}, params), Error);
  CHECK(params.to_json() == before);
}

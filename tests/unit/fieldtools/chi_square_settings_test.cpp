// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
// The filter's options by name against its settings, and what is outside their ranges.
#include <doctest/doctest.h>

#include <string>

#include "fieldtools/chi_square.h"
#include "unit/cloud/clouds.h"
#include "unit/compare/refusal.h"

using namespace jalon;
using namespace jalon::test;

TEST_CASE("chi_square_settings__the_field_is_named_after_the_method_unless_it_has_a_name") {
  for (const char* method : {"chi_square", "kolmogorov"}) {
    const auto set = settings_by<ChiSquareSettings>(chi_square_rows(), {{"method", method}});
    CHECK(set.distance_field() == method);
    CHECK(set.kolmogorov() == (std::string(method) == "kolmogorov"));
    const auto named =
        settings_by<ChiSquareSettings>(chi_square_rows(), {{"method", method}, {"name", "far"}});
    CHECK(named.distance_field() == "far");
  }
}

TEST_CASE("chi_square_settings__each_option_sets_its_own_member") {
  ParamSet set("chi_square", chi_square_rows());
  set.from_json(R"({"neighbours":20,"radius_m":0.5,"error_margin":0.01,"classes":"relaxed",)"
                R"("threshold":"given","cut":7,"passes":1,"second_neighbours":50,"band_low":0.25,)"
                R"("band_high":4,"one_sided":false,"changed":"moved"})");
  const auto s = settings_from<ChiSquareSettings>(set);
  CHECK(s.neighbours == 20);
  CHECK(s.radius_m == 0.5);
  CHECK(s.error_margin == 0.01);
  CHECK(s.relaxed());
  CHECK(s.threshold == ChiSquareSettings::Threshold::kGiven);
  CHECK(s.cut == 7);
  CHECK(s.passes == 1);
  CHECK(s.second_neighbours == 50);
  CHECK(s.band_low == 0.25);
  CHECK(s.band_high == 4);
  CHECK_FALSE(s.one_sided);
  CHECK(s.changed == "moved");
  CHECK_FALSE(settings_by<ChiSquareSettings>(chi_square_rows(), {}).relaxed());
}

TEST_CASE("chi_square_settings__values_that_no_test_can_take_are_refused_by_name") {
  ParamSet set("chi_square", chi_square_rows());
  const auto refused = [&](const char* name, double value) {
    return refuses([&] { set.set_number(name, value); }, Status::kInvalidArgument, name);
  };
  CHECK(refused("neighbours", kFewestTested - 1.0));
  CHECK(refused("neighbours", 257));  // more than a batch search gives
  CHECK(refused("second_neighbours", kFewestTested - 1.0));
  CHECK(refused("error_margin", 0));
  CHECK(refused("passes", 3));
  CHECK(refused("band_low", 1.5));
  CHECK(refused("band_high", 0.5));
  CHECK_FALSE(refused("neighbours", kFewestTested));
  CHECK(refuses([&] { set.set_text("method", "student"); }, Status::kInvalidArgument, "method"));
  CHECK(refuses([&] { set.set_number("neighbors", 20); }, Status::kNotFound, "neighbours"));
}

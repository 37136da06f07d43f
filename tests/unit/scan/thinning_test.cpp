// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include <doctest/doctest.h>

#include "unit/scan/fixture.h"

using namespace jalon;
using namespace jalon::test;

namespace {

const Options kEverything{{{"horizontal_step_rad", 0.008},
                           {"vertical_step_rad", 0.008},
                           {"dropout", 0.02},
                           {"outliers", 0.02},
                           {"glass_return_min", 0.1},
                           {"glass_return_max", 0.6},
                           {"misfit_shift_m", 0.003},
                           {"misfit_rotation_rad", 1e-4},
                           {"spacing_m", 0.05},
                           {"max_points", 20000},
                           {"stations", 3}},
                          {{"instrument", "gx"}, {"outlier_place", "box"}}};

}  // namespace

TEST_CASE("thinning__keeps_exactly_the_number_asked_for_as_a_random_part_of_the_scan") {
  const Model model = scene("facade");
  const StaticSettings quiet = quiet_settings(0.004);
  const Cloud all = scanned(model, quiet);
  StaticSettings params = quiet;
  params.max_points = 20000;
  const Cloud some = scanned(model, params);
  REQUIRE(all.size() > 40000);
  REQUIRE(some.size() == 20000);
  // Some of the same points in the same order.
  size_t k = 0;
  for (size_t i = 0; i < some.size(); ++i, ++k)
    while (k < all.size() && !(all.point(k) == some.point(i))) ++k;
  CHECK(k <= all.size());
  const double share = 20000 / static_cast<double>(all.size());
  for (size_t s = 0; s < 2; ++s)
    CHECK(is_binomial(some.stations[s].count, all.stations[s].count, share));
  std::map<uint32_t, std::pair<size_t, size_t>> counts;
  for (const uint32_t id : values<uint32_t>(all, "face")) ++counts[id].first;
  for (const uint32_t id : values<uint32_t>(some, "face")) ++counts[id].second;
  for (const auto& [id, n] : counts) CHECK(is_binomial(n.second, n.first, share));
  params.max_points = 1e9;
  CHECK(same_clouds(all, scanned(model, params)));
}

TEST_CASE("thinning__to_a_spacing_gives_the_same_density_near_and_far") {
  const Model model = scene("normal");  // 10 x 10 m
  const ScanStation aside = station_at({1, -4, 2});
  const double spacing = 0.05;
  const Cloud cloud = scanned(model, quiet_settings(0.002, {.spacing_m = spacing}), {&aside, 1});
  // Cells of 1 x 1 m: where the scan is denser than the spacing, Poisson counts of 1 / spacing^2.
  std::map<std::pair<int, int>, size_t> cells;
  for (size_t i = 0; i < cloud.size(); ++i)
    ++cells[{static_cast<int>(cloud.point(i).x), static_cast<int>(cloud.point(i).z)}];
  const double expected = 1 / (spacing * spacing);
  double near = 0, far = 0;
  for (const auto& [cell, n] : cells) {
    CHECK(std::abs(static_cast<double>(n) - expected) < 5 * std::sqrt(expected));
    (cell.first < 5 ? near : far) += static_cast<double>(n) / 50;
  }
  MESSAGE("FIGURE spacing 0.05 m: " << near << " and " << far
                                    << " points/m2 near and far, 400 asked for");
  CHECK(near == doctest::Approx(expected).epsilon(0.02).scale(0));
  CHECK(far == doctest::Approx(expected).epsilon(0.02).scale(0));
}

TEST_CASE("static_scan__with_every_effect_has_the_same_bits_on_any_number_of_threads") {
  const Model model = scene("unwanted");
  const auto params =
      settings_from<StaticSettings>(filled("scanner", static_scanner_rows(), kEverything));
  const Cloud one = scanned(model, params, {}, 1);
  CHECK(one.size() == 20000);
  CHECK(same_clouds(one, scanned(model, params, {}, 2)));
  CHECK(same_clouds(one, scanned(model, params, {}, 7)));
}

TEST_CASE("static_scan__parameters_travel_as_json") {
  const ParamSet params = filled("scanner", static_scanner_rows(), kEverything);
  ParamSet back("scanner", static_scanner_rows());
  CHECK(back.to_json() != params.to_json());
  back.from_json(params.to_json());
  CHECK(back.to_json() == params.to_json());
  const Model model = scene("unwanted");
  CHECK(same_clouds(scanned(model, settings_from<StaticSettings>(params)),
                    scanned(model, settings_from<StaticSettings>(back))));
}

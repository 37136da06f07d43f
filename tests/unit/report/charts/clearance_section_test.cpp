// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "report/charts/clearance_section.h"

#include <doctest/doctest.h>

#include "unit/report/charts/swept_gauge.h"

using namespace jalon;

TEST_CASE("clearance_section__outline_points_and_clearance_to_a_usual_scale") {
  const GaugePath path(swept::way());
  const auto tight = tight_places(swept::tables().places, path, 1, 40);
  const CloudPtr cloud = swept::obstacles();
  const std::string svg = clearance_section(tight[0], 1, path, swept::corners(), cloud.get());
  CHECK(svg.find("Place 1, at 1") != std::string::npos);
  CHECK(svg.find("1 : 50,") != std::string::npos);
  CHECK(svg.find("-0.100 m") != std::string::npos);
  // 1 : 50: a box of 2 x 3 m is 40 x 60 mm; the window begins a metre beside it.
  CHECK(svg.find("M35 95L75 95L75 35L35 35Z") != std::string::npos);
  CHECK(svg.find("h0") != std::string::npos);
}

TEST_CASE("clearance_section__without_gauge_and_cloud_the_place_alone") {
  const GaugePath path(swept::way());
  const auto tight = tight_places(swept::tables().places, path, 1, 40);
  const std::string svg = clearance_section(tight[1], 2, path, {}, nullptr);
  CHECK(svg.find("Place 2") != std::string::npos);
  CHECK(svg.find("h0") == std::string::npos);
  CHECK(svg.find("fill-opacity") == std::string::npos);
}

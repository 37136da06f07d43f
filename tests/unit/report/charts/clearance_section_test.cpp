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
  const std::string svg =
      clearance_section(tight[0], 1, path, swept::corners(), cloud.get(), nullptr);
  CHECK(svg.find("Place 1, at 1") != std::string::npos);
  CHECK(svg.find("1 : 50,") != std::string::npos);
  CHECK(svg.find("-0.100 m") != std::string::npos);
  // 1 : 50: a box of 2 x 3 m is 40 x 60 mm; the window begins a metre beside it.
  CHECK(svg.find("M35 95L75 95L75 35L35 35Z") != std::string::npos);
  CHECK(svg.find("h0") != std::string::npos);
}

TEST_CASE("clearance_section__a_surface_is_drawn_where_it_is_cut") {
  const GaugePath path(swept::way());
  const auto tight = tight_places(swept::tables().places, path, 1, 40);
  PartTriangles wall;  // beside the way, far longer than the window is wide
  wall.vertices = {{-50, -2, -9}, {50, -2, -9}, {50, -2, 9}, {-50, -2, 9}};
  wall.triangles = {{0, 1, 2}, {0, 2, 3}};
  const std::string svg = clearance_section(tight[0], 1, path, swept::corners(), nullptr, &wall);
  // 2 m to the right of the origin, as the gauge's side at 1 m stands at 75 mm; from border to border.
  CHECK(svg.find("M95 ") != std::string::npos);
  CHECK(svg.find(" 35Z") != std::string::npos);
  for (const char* outside : {"L95 -", "M95 -"}) CHECK(svg.find(outside) == std::string::npos);
}

TEST_CASE("clearance_section__without_gauge_and_cloud_the_place_alone") {
  const GaugePath path(swept::way());
  const auto tight = tight_places(swept::tables().places, path, 1, 40);
  const std::string svg = clearance_section(tight[1], 2, path, {}, nullptr, nullptr);
  CHECK(svg.find("Place 2") != std::string::npos);
  CHECK(svg.find("h0") == std::string::npos);
  CHECK(svg.find("fill-opacity") == std::string::npos);
}

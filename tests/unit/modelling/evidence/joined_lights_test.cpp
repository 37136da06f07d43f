// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0

// Lights parted by mullions and transoms, and windows parted by piers.
#include <doctest/doctest.h>

#include <algorithm>

#include "modelling/evidence/joined_lights.h"
#include "unit/modelling/painted_cells.h"

using namespace jalon;
using painted::rectangle;

namespace {

constexpr double kLightCell_m = 0.05;

std::vector<OpeningShape> lights(std::vector<OpeningShape> shapes) {
  return joined_lights(std::move(shapes), kLightCell_m);
}

}  // namespace

TEST_CASE("joined_lights__on_both_sides_of_a_mullion_are_one_window_whatever_their_order") {
  const OpeningShape left = rectangle(10, 22, 10, 40), right = rectangle(24, 36, 11, 39);
  for (const auto& order : {std::vector{left, right}, {right, left}}) {
    const auto out = lights(order);
    REQUIRE(out.size() == 1);
    CHECK(out[0].sizes == rectangle(10, 36, 10, 40).sizes);
  }
}

TEST_CASE("joined_lights__on_both_sides_of_a_pier_stay_two_windows") {
  CHECK(lights({rectangle(10, 30, 10, 40), rectangle(36, 56, 10, 40)}).size() == 2);  // 25 cm
  CHECK(lights({rectangle(10, 30, 10, 40), rectangle(33, 53, 10, 40)}).size() == 1);  // 10 cm
  // As narrow a bar, but too wide for slits beside it.
  CHECK(lights({rectangle(10, 14, 10, 40), rectangle(17, 21, 10, 40)}).size() == 2);
}

TEST_CASE("joined_lights__garages_wider_than_lights_stay_apart_whatever_is_between_them") {
  CHECK(lights({rectangle(10, 60, 0, 44), rectangle(62, 112, 0, 44)}).size() == 2);  // 2.5 m
  CHECK(lights({rectangle(10, 35, 0, 44), rectangle(37, 62, 0, 44)}).size() == 1);   // 1.25 m
}

TEST_CASE("joined_lights__need_the_same_foot_and_head_and_upright_sides") {
  CHECK(lights({rectangle(10, 22, 10, 40), rectangle(24, 36, 14, 40)}).size() == 2);
  CHECK(lights({rectangle(10, 22, 10, 40), rectangle(24, 36, 10, 36)}).size() == 2);
  const OpeningShape arch{ShapeKind::kArch, {24, 36, 10, 40, 6, 0}};
  CHECK(lights({rectangle(10, 22, 10, 40), arch}).size() == 2);
  CHECK(lights({}).empty());
}

TEST_CASE("joined_lights__a_lattice_of_mullions_and_transoms_is_one_window") {
  std::vector<OpeningShape> panes;
  for (const double u : {10.0, 24.0, 38.0})
    for (const double v : {5.0, 27.0}) panes.push_back(rectangle(u, u + 12, v, v + 20));
  std::reverse(panes.begin(), panes.begin() + 3);
  const auto out = lights(panes);
  REQUIRE(out.size() == 1);
  CHECK(out[0].sizes == rectangle(10, 50, 5, 47).sizes);
}

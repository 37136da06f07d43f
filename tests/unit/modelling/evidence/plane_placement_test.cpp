// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0

// Where one plane lies to another.
#include <doctest/doctest.h>

#include "modelling/evidence/plane_placement.h"
#include "unit/modelling/layers.h"

using namespace jalon;
using layers::add_layer;
using layers::cut;
using layers::evidence_of;

namespace {

// 6 m wide and 6 m high, with a window of 1.2 x 1.6 m.
std::vector<Vec3> wall_with_window() {
  std::vector<Vec3> out;
  add_layer(out, 0, 0, 6, 6, 0);
  cut(out, 2, 2, 1.2, 1.6);
  return out;
}

std::vector<Vec3> layer(double left, double foot, double width, double height, double depth_m) {
  std::vector<Vec3> out;
  add_layer(out, left, foot, width, height, depth_m);
  return out;
}

}  // namespace

TEST_CASE("placement_of__panes_is_in_the_opening_and_behind_the_wall") {
  const auto evidence = evidence_of({wall_with_window(), layer(2, 2, 1.2, 1.6, 0.2)});
  const PlanePlacement panes = placement_of(evidence[1], evidence[0]);
  CHECK(panes.in_openings == doctest::Approx(1).epsilon(0.05));
  CHECK(panes.within == doctest::Approx(1).epsilon(0.05));
  CHECK(panes.depth_m == doctest::Approx(0.2).epsilon(0.01));
  CHECK(panes.relief == 0);
  CHECK(panes.behind_wall == 0);
}

TEST_CASE("placement_of__a_panel_is_relief_within_the_border_of_the_wall_and_not_the_other_way") {
  std::vector<Vec3> wall = wall_with_window();
  cut(wall, 4, 1, 1.5, 4);
  const auto evidence = evidence_of({wall, layer(4, 1, 1.5, 4, -0.05)});
  const PlanePlacement panel = placement_of(evidence[1], evidence[0]);
  CHECK(panel.relief > 0.9);
  CHECK(panel.within > 0.9);
  CHECK(panel.depth_m == doctest::Approx(-0.05).epsilon(0.01));
  CHECK(placement_of(evidence[0], evidence[1]).within < 0.05);
}

TEST_CASE(
    "placement_of__a_wall_with_windows_between_wings_fills_no_opening_and_a_shop_front_does") {
  // Two wings with a cornice over what is between them: all of that is framed.
  std::vector<Vec3> wings = layer(0, 0, 24, 7.5, 0);
  cut(wings, 7, 0, 10, 6.9);
  std::vector<Vec3> middle = layer(7, 0, 10, 6.9, 0.45);
  for (const double left : {8.0, 11.0, 14.0})
    for (const double foot : {1.0, 4.2}) cut(middle, left, foot, 1.2, 1.8);
  const auto evidence = evidence_of({wings, middle});
  REQUIRE(evidence[1].has_framed_openings());
  CHECK(placement_of(evidence[1], evidence[0]).in_openings == 0);
  CHECK(evidence[1].role == PlaneRole::kWall);
  // As wide, but no higher than windows are.
  std::vector<Vec3> shop = layer(0, 0, 24, 7.5, 0);
  cut(shop, 7, 0, 10, 3.5);
  std::vector<Vec3> front = layer(7, 0, 10, 3.5, 0.3);
  for (const double left : {8.0, 11.0, 14.0}) cut(front, left, 1, 1.2, 1.8);
  const auto street = evidence_of({shop, front});
  CHECK(placement_of(street[1], street[0]).in_openings > 0.9);
}

TEST_CASE("placement_of__a_room_lies_behind_what_was_measured_of_the_wall") {
  const auto evidence = evidence_of({wall_with_window(), layer(0.5, 0.5, 5, 5, 3)});
  const PlanePlacement room = placement_of(evidence[1], evidence[0]);
  CHECK(room.behind_wall > 0.7);
  CHECK(room.in_openings < 0.2);
}

TEST_CASE("is_broad__of_a_surround_is_false_and_of_a_wall_true") {
  std::vector<Vec3> surround = layer(1.8, 1.8, 1.6, 2, -0.05);
  cut(surround, 2, 2, 1.2, 1.6);
  const auto evidence = evidence_of({wall_with_window(), surround});
  CHECK(is_broad(evidence[0].cells, 0.6));
  CHECK(!is_broad(evidence[1].cells, 0.6));
}

TEST_CASE("tall_share__of_parapets_is_none_and_of_a_wall_all") {
  std::vector<Vec3> parapets = layer(0, 0, 6, 1.1, 0);
  add_layer(parapets, 0, 3, 6, 1.1, 0);
  CHECK(tall_share(evidence_of({parapets})[0].cells) == 0);
  CHECK(tall_share(evidence_of({wall_with_window()})[0].cells) == doctest::Approx(1));
}

TEST_CASE("is_sparse__of_a_few_places_within_a_border_and_not_of_a_wall") {
  std::vector<Vec3> places = layer(0, 5.5, 6, 0.5, 0.2);
  add_layer(places, 0, 0, 0.4, 0.4, 0.2);
  CHECK(is_sparse(evidence_of({places})[0]));
  CHECK(!is_sparse(evidence_of({wall_with_window()})[0]));
}

TEST_CASE(
    "surrounded_share__of_a_panel_in_the_middle_is_all_and_of_what_stands_beside_a_wall_none") {
  std::vector<Vec3> wall = wall_with_window();
  cut(wall, 4, 1, 1.5, 4);
  const auto evidence = evidence_of(
      {wall, layer(4, 1, 1.5, 4, -0.05), layer(6, 0, 4, 6, -0.05), layer(0, 6, 6, 2, 0.1)});
  CHECK(surrounded_share(evidence[1], evidence[0]) == doctest::Approx(1));
  CHECK(surrounded_share(evidence[2], evidence[0]) == 0);
  CHECK(surrounded_share(evidence[3], evidence[0]) == 0);
}

TEST_CASE(
    "is_house_before__holds_for_a_wall_with_windows_in_a_place_of_its_own_and_for_no_surround") {
  std::vector<Vec3> house = wall_with_window(), row = layer(-6, 0, 6, 6, 0.08);
  add_layer(row, 6, 0, 6, 6, 0.08);
  const auto beside = evidence_of({house, row});
  CHECK(is_house_before(beside[0], beside[1]));
  std::vector<Vec3> surround = layer(1.8, 1.8, 1.6, 2, -0.05);
  cut(surround, 2, 2, 1.2, 1.6);
  const auto on_it = evidence_of({house, surround});
  CHECK(!is_house_before(on_it[1], on_it[0]));
}

// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "modelling/facade/opening_features.h"

#include <doctest/doctest.h>

#include <cmath>
#include <utility>
#include <vector>

#include "unit/modelling/street_house.h"

using namespace planned;

namespace {

double of(const OpeningFeatures& features, OpeningFeature which) {
  return features[static_cast<size_t>(which)];
}

}  // namespace

TEST_CASE("opening_features__are_sizes_heights_over_the_ground_depths_and_neighbours") {
  PlannedScene scene = street_house();
  scene.plan.facades[0].walls[0].wall.openings[6].depth_m = kNaN;
  const auto rows = opening_features(scene.plan, scene.plan.facades[0]);
  REQUIRE(rows.size() == 1);
  REQUIRE(rows[0].size() == 8);
  const OpeningFeatures &window = rows[0][1], &door = rows[0][6];
  CHECK(of(window, OpeningFeature::kOne) == 1);
  CHECK(of(window, OpeningFeature::kWidth) == doctest::Approx(std::log(1.2)));
  CHECK(of(window, OpeningFeature::kHeight) == doctest::Approx(std::log(1.5)));
  CHECK(of(window, OpeningFeature::kFoot) == 2);
  CHECK(of(window, OpeningFeature::kOnGround) < 0.01);
  CHECK(of(window, OpeningFeature::kUpstairs) > 0.99);
  CHECK(of(window, OpeningFeature::kDepth) == 0.15);
  CHECK(of(window, OpeningFeature::kNoDepth) == 0);
  CHECK(of(window, OpeningFeature::kSameRow) == doctest::Approx(std::log(3)));
  CHECK(of(window, OpeningFeature::kSameSize) == doctest::Approx(std::log(6)));
  CHECK(of(window, OpeningFeature::kEmpty) == 0.4);
  CHECK(of(window, OpeningFeature::kAtBorder) == 0);
  CHECK(of(door, OpeningFeature::kOnGround) > 0.98);
  CHECK(of(door, OpeningFeature::kNoDepth) == 1);
  CHECK(of(door, OpeningFeature::kShallow) == 0);
  CHECK(of(door, OpeningFeature::kAtBorder) == 1);
  CHECK(of(door, OpeningFeature::kSameRow) == 0);
  CHECK(of(door, OpeningFeature::kSetBack) == 0);
  // A wall that stands 1.5 m back fills what the upper half of the shop front shows.
  PlannedScene arcade = street_house();
  arcade.add_wall({3, 1.35}, {9, 4}, {}, -1.5);
  const auto behind = opening_features(arcade.plan, arcade.plan.facades[0]);
  CHECK(of(behind[0][7], OpeningFeature::kSetBack) == doctest::Approx(0.5));
}

TEST_CASE(
    "opening_features__say_what_stands_over_a_door_of_its_size_and_reaches_down_to_the_floor") {
  // A warehouse: a gateway, a loading door of its size over it, windows beside that, one elsewhere over nothing.
  const auto loading_door = [](double foot_m, double sill_m) {
    PlannedScene scene;
    std::vector<FacadeOpening> openings;
    for (const auto& [low, high] : {std::pair{Vec2{5, 0}, Vec2{6.5, 2.2}},
                                    {Vec2{5, foot_m}, Vec2{6.5, foot_m + 2.2}},
                                    {Vec2{1, sill_m}, Vec2{2, 5.6}},
                                    {Vec2{8, sill_m}, Vec2{9, 5.6}},
                                    {Vec2{8, 6.9}, Vec2{9, 8.3}}})
      openings.push_back(filled(low, high, 0.2, kLeaf));
    scene.add_wall({0, 0}, {12, 9}, openings);
    const auto rows = opening_features(scene.plan, scene.plan.facades[0])[0];
    REQUIRE(rows.size() == 5);
    for (const size_t other : {0, 2, 3, 4})
      CHECK(of(rows[other], OpeningFeature::kOverDoor) < 0.01);
    return of(rows[1], OpeningFeature::kOverDoor);
  };
  CHECK(loading_door(3.4, 4.2) > 0.9);
  // Windows beside it that reach as far down say that it is one of them; by half a sill's height it may be either.
  CHECK(loading_door(3.4, 3.4) == 0);
  CHECK(loading_door(3.4, 3.65) == doctest::Approx(0.5).epsilon(0.1));
}

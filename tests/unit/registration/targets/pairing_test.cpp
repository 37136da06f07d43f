// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0

// Pairs of targets with and without names, against layouts whose symmetries are counted.

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "base/error.h"
#include "registration/targets/pairing.h"
#include "unit/registration/target_scenes.h"

using namespace jalon;
using namespace jalon::test;

namespace {

Pairing paired(const TargetSides& sides, const TargetSettings& settings = {}) {
  Task task;
  return pair_targets(
      {sides.reference, sides.moving, origin_of(sides.reference), origin_of(sides.moving)},
      settings, task);
}

// Noise of the size that targets without a covariance are taken to have.
TargetSides measured_places(const std::vector<Vec3>& places, bool named, uint64_t draw) {
  RandomStream random(171, draw);
  TargetSides out = exact_sides(places, any_motion(random), named);
  for (auto* side : {&out.reference, &out.moving})
    for (Target& target : *side) target.xyz += noise_of(isotropic(0.003), random);
  return out;
}

uint64_t ways_of(const std::vector<Vec3>& places) {
  return paired(measured_places(places, false, 1)).solutions;
}

}  // namespace

TEST_CASE("pair_targets__with_names_need_no_distances") {
  TargetSides sides = measured_places({{0, 0, 0}, {5, 0, 0}, {0, 7, 1}, {3, 3, 3}}, true, 0);
  std::swap(sides.reference[0], sides.reference[2]);
  sides.moving[1].xyz += Vec3{100, 0, 0};  // whatever they say
  const Pairing found = paired(sides);
  CHECK(found.pairs == std::vector<IndexPair>{{2, 0}, {1, 1}, {0, 2}, {3, 3}});
  CHECK(found.solutions == 1);
}

TEST_CASE("pair_targets__without_names_finds_partners_by_their_distances") {
  for (uint64_t draw = 0; draw < 10; ++draw) {
    RandomStream random(172, draw);
    std::vector<Vec3> places;
    for (int i = 0; i < 7; ++i) places.push_back(within(15, random));
    TargetSides sides = measured_places(places, false, draw);
    // Target i of the reference is 6 - i of the moving side; two of either have no partner.
    std::reverse(sides.moving.begin(), sides.moving.end());
    sides.reference[0].xyz += Vec3{0, 40, 0};
    sides.moving[0].xyz += Vec3{-30, 0, 20};
    const Pairing found = paired(sides);
    CHECK(found.solutions == 1);
    CHECK(found.pairs.size() == 5);
    for (const IndexPair& pair : found.pairs) CHECK(pair.reference + pair.moving == 6);
  }
}

TEST_CASE("pair_targets__counts_the_poses_that_a_layout_allows") {
  CHECK(ways_of({{0, 0, 0}, {8, 0, 0}, {3, 5, 0}}) == 1);
  CHECK(ways_of({{0, 0, 0}, {8, 0, 0}, {4, 9, 0}}) == 2);                   // two sides alike
  CHECK(ways_of({{0, 0, 0}, {8, 0, 0}, {4, 4 * std::sqrt(3.0), 0}}) == 6);  // three
  CHECK(ways_of({{0, 0, 0}, {8, 0, 0}, {8, 3, 0}, {0, 3, 0}}) == 4);        // a rectangle
  // Nearly alike is alike until the tolerance tells them apart.
  const std::vector<Vec3> nearly{{0, 0, 0}, {8, 0, 0}, {4.005, 9, 0}};
  CHECK(ways_of(nearly) == 2);
  RandomStream random(173, 0);
  for (const IndexPair& pair : paired(exact_sides(nearly, any_motion(random), false)).pairs)
    CHECK(pair.reference == pair.moving);  // the one that fits best stands
  // Distances the same within four standard deviations, places off by eight.
  const std::vector<Vec3> told_apart{{0, 0, 0}, {8, 0, 0}, {4.02, 9, 0}};
  CHECK(paired(exact_sides(told_apart, any_motion(random), false)).solutions == 1);
  TargetSettings sharp;
  sharp.sigma_m = 1e-5;
  CHECK(paired(exact_sides(nearly, any_motion(random), false), sharp).solutions == 1);
}

TEST_CASE("pair_targets__says_how_many_there_are_and_that_none_fit") {
  const auto refusal = [](const TargetSides& sides) {
    try {
      paired(sides);
    } catch (const Error& error) {
      CHECK(error.status() == Status::kInsufficientData);
      return std::string(error.what());
    }
    return std::string();
  };
  TargetSides sides = measured_places({{0, 0, 0}, {8, 0, 0}, {3, 5, 0}, {1, 1, 4}}, false, 2);
  for (size_t i = 0; i < 4; ++i) sides.moving[i].xyz *= 1.5;
  CHECK(refusal(sides).find("match_tolerance_m") != std::string::npos);
  sides.moving.resize(2);
  CHECK(refusal(sides).find("4 and 2 targets") != std::string::npos);
}

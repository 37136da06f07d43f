// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0

// How far a leaf goes on below a notch of the wall.
#include <doctest/doctest.h>

#include <cmath>

#include "modelling/walls/leaf_foot.h"
#include "unit/modelling/plane_rings.h"

using namespace jalon;

namespace {

constexpr uint32_t kLeaf = 7;

// Points of a leaf every 5 cm between two heights.
void add_leaf(HoleSurvey& notch, float low, float high, uint32_t label = kLeaf) {
  for (float v = low; v <= high; v += 0.05f) notch.points.push_back({0, label, 0.5f, v, -0.1f});
}

// A notch 1 m wide whose feet lie at a height of 1 m.
double foot_of(const HoleSurvey& notch) {
  return leaf_foot(notch, kLeaf, rings::rectangle({0, 1}, {1, 3}));
}

}  // namespace

TEST_CASE("leaf_foot__a_leaf_that_goes_on_behind_a_plinth_ends_at_its_own_foot") {
  HoleSurvey notch;
  add_leaf(notch, 0.4f, 2.9f);
  CHECK(foot_of(notch) == doctest::Approx(0.4).epsilon(0.2).scale(0));
  notch.points.push_back({0, kLeaf, 0.5f, 0.2f, -0.1f});  // a stray
  CHECK(foot_of(notch) > 0.35);
}

TEST_CASE("leaf_foot__the_window_of_the_storey_below_on_the_same_plane_is_another") {
  HoleSurvey notch;
  add_leaf(notch, 1.1f, 2.9f);
  add_leaf(notch, -0.5f, 0.3f);
  CHECK_FALSE(foot_of(notch) < 1);
}

TEST_CASE("leaf_foot__there_is_none_below_feet_that_the_leaf_does_not_reach") {
  HoleSurvey notch;
  add_leaf(notch, 2, 2.9f);
  add_leaf(notch, 0.2f, 0.9f);
  CHECK(std::isinf(foot_of(notch)));
  CHECK(std::isinf(foot_of({})));
  add_leaf(notch, 0.2f, 2.9f, kLeaf + 1);  // of another plane
  CHECK(std::isinf(foot_of(notch)));
}

// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0

// Openings behind surrounds, by the points of these.
#include <doctest/doctest.h>

#include "modelling/evidence/evidence.h"
#include "unit/modelling/layers.h"

using namespace jalon;
using layers::add_layer;
using layers::cut;
using layers::evidence_of;

namespace {

// A wall of 8 x 5 m with a window of 1.2 x 1.6 m at (3, 1.5) in a surround of 0.2 m, 4 cm proud.
std::vector<WallEvidence> behind_a_surround(bool has_surround, unsigned threads = 1) {
  std::vector<Vec3> wall, surround, panes;
  add_layer(wall, 0, 0, 8, 5, 0);
  add_layer(panes, 3, 1.5, 1.2, 1.6, 0.15);
  add_layer(surround, 2.8, 1.3, 1.6, 2.0, -0.04);
  cut(surround, 3, 1.5, 1.2, 1.6);
  if (has_surround) cut(wall, 2.8, 1.3, 1.6, 2.0);
  else cut(wall, 3, 1.5, 1.2, 1.6);
  std::vector<std::vector<Vec3>> parts{wall, panes};
  if (has_surround) parts.push_back(surround);
  return evidence_of(parts, threads);
}

const OpeningCandidate* window_of(const WallEvidence& wall) {
  for (const OpeningCandidate& opening : wall.openings)
    if (opening.is_opening) return &opening;
  return nullptr;
}

}  // namespace

TEST_CASE("settle_openings__the_border_is_that_of_the_surround") {
  const auto evidence = behind_a_surround(true);
  const OpeningCandidate* window = window_of(evidence[0]);
  REQUIRE(window != nullptr);
  CHECK(window->is_settled);
  const RingBox box = window->shape.box();
  const RingBox real{{3, 1.5}, {4.2, 3.1}};
  CHECK(overlap(box, real) > 0.94);  // a spacing of 5 cm about it would leave 0.87
  // Without relief about it the contour tells more.
  const auto bare = behind_a_surround(false);
  REQUIRE(window_of(bare[0]) != nullptr);
  CHECK_FALSE(window_of(bare[0])->is_settled);
}

TEST_CASE("settle_openings__has_the_same_bits_for_any_threads") {
  const auto one = behind_a_surround(true, 1), four = behind_a_surround(true, 4);
  REQUIRE(window_of(one[0]) != nullptr);
  REQUIRE(window_of(four[0]) != nullptr);
  CHECK(window_of(one[0])->shape.sizes == window_of(four[0])->shape.sizes);
}

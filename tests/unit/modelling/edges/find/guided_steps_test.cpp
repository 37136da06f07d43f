// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0

// Short edges across, put onto guides.
#include <doctest/doctest.h>

#include <vector>

#include "modelling/edges/find/guided_steps.h"

using namespace jalon;

namespace {

constexpr double kGuidedStepsSpacing = 0.1;

GuideLines guides_of(const std::vector<EdgeShape>& shapes) {
  return {shapes, {}, {}, kGuidedStepsSpacing};
}

/// A ring round a solid whose lower border has a step between (2, 0) and (2, rise) that no edge joins.
std::vector<EdgeShape> with_a_gap(double rise) {
  return {straight_shape({0, 0}, {2, 0}), straight_shape({2, rise}, {4, rise}),
          straight_shape({4, rise}, {4, 3}), straight_shape({4, 3}, {0, 3}),
          straight_shape({0, 3}, {0, 0})};
}

}  // namespace

TEST_CASE("guided_steps__an_edge_follows_a_guide_of_its_own_sense_and_ends_at_its_neighbours") {
  const EdgeShape a = straight_shape({1, 0}, {1, 2}), b = straight_shape({0, 2}, {0, 0});
  const EdgeShape top = straight_shape({1, 2.05}, {0, 2.05});
  EdgeShape edge = top;
  follow_guide(guides_of({straight_shape({8, 2.2}, {5, 2.2})}), kGuidedStepsSpacing, a, b, edge);
  CHECK(edge.is_guided);
  CHECK(edge.first == Vec2{1, 2.2});
  CHECK(edge.last == Vec2{0, 2.2});
  CHECK(edge.length_m == 1);
  for (const EdgeShape& other :
       {straight_shape({5, 2.2}, {8, 2.2}), straight_shape({8, 2.5}, {5, 2.5})}) {
    edge = top;  // the solid below; too far
    follow_guide(guides_of({other}), kGuidedStepsSpacing, a, b, edge);
    CHECK(!edge.is_guided);
    CHECK(edge.line.point == top.line.point);
  }
}

TEST_CASE("guided_steps__a_missing_step_stands_half_way_or_on_its_guide") {
  std::vector<EdgeShape> ring = with_a_gap(0.5);
  guide_steps({}, kGuidedStepsSpacing, ring);
  REQUIRE(ring.size() == 6);
  CHECK(!ring[1].is_guided);
  CHECK(ring[1].first == Vec2{2, 0});
  CHECK(ring[1].last == Vec2{2, 0.5});
  ring = with_a_gap(0.5);
  guide_steps(guides_of({straight_shape({2.2, 5}, {2.2, 8})}), kGuidedStepsSpacing, ring);
  REQUIRE(ring.size() == 6);
  CHECK(ring[1].is_guided);
  CHECK(ring[1].first == Vec2{2.2, 0});
  ring = with_a_gap(-0.5);  // down
  guide_steps({}, kGuidedStepsSpacing, ring);
  REQUIRE(ring.size() == 6);
  CHECK(ring[1].line.direction == Vec2{0, -1});
  ring = with_a_gap(0.1);  // a spacing: noise
  guide_steps({}, kGuidedStepsSpacing, ring);
  CHECK(ring.size() == 5);
}

TEST_CASE("guided_steps__a_short_slanted_edge_stands_up_on_a_guide_and_a_long_one_stays") {
  const GuideLines guides = guides_of({straight_shape({2.2, 5}, {2.2, 8})});
  std::vector<EdgeShape> ring = with_a_gap(0.5);
  ring.insert(ring.begin() + 1, straight_shape({2.1, 0.05}, {2.3, 0.45}));
  guide_steps(guides, kGuidedStepsSpacing, ring);
  REQUIRE(ring.size() == 6);
  CHECK(ring[1].is_guided);
  CHECK(ring[1].line.direction == Vec2{0, 1});
  CHECK(ring[1].first == Vec2{2.2, 0});
  CHECK(ring[1].last == Vec2{2.2, 0.5});
  ring = with_a_gap(1.6);
  const EdgeShape ramp = straight_shape({1.9, 0.05}, {2.5, 1.55});
  ring.insert(ring.begin() + 1, ramp);
  guide_steps(guides, kGuidedStepsSpacing, ring);
  REQUIRE(ring.size() == 6);
  CHECK(ring[1].line.direction == ramp.line.direction);
}

// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0

// Lines that several edges or a long one lie on.
#include <doctest/doctest.h>

#include <cmath>
#include <vector>

#include "modelling/edges/find/guide_lines.h"

using namespace jalon;

namespace {

constexpr double kGuideLinesSpacing = 0.1;

std::vector<double> places(const GuideLines& guides, const Vec2& p, double reach_m) {
  std::vector<double> out;
  guides.visit(p, reach_m, [&](const EdgeLine& line) { out.push_back(line.distance({0, 0})); });
  return out;
}

}  // namespace

TEST_CASE("guide_lines__short_edges_in_one_line_guide_and_one_alone_does_not") {
  std::vector<EdgeShape> shapes;
  for (int i = 0; i < 4; ++i)
    shapes.push_back(straight_shape({3.0 * i, 0.01 * (i % 2)}, {3.0 * i + 0.4, 0.01 * (i % 2)}));
  shapes.push_back(straight_shape({0, 5}, {0.4, 5}));
  const GuideLines guides(shapes, {}, {}, kGuideLinesSpacing);
  CHECK(places(guides, {20, 0.1}, 0.2).size() == 1);
  CHECK(places(guides, {0, 5}, 0.2).empty());
}

TEST_CASE("guide_lines__another_planes_line_guides_where_the_contour_has_points_on_it") {
  const std::vector<EdgeLine> joints{{{0, 2}, {1, 0}}, {{0, 9}, {1, 0}}};
  const std::vector<std::vector<Vec2>> chains{
      {{0, 0}, {4, 0}, {4, 2}, {3.9, 2.01}, {3.8, 1.98}, {0, 1}}};
  const GuideLines guides({}, joints, chains, kGuideLinesSpacing);
  CHECK(places(guides, {1, 2}, 0.2).size() == 2);  // either way along
  CHECK(places(guides, {1, 9}, 0.2).empty());
}

TEST_CASE("guide_lines__lie_at_the_mean_of_their_edges_by_length_one_for_each_way") {
  const std::vector<EdgeShape> shapes{
      straight_shape({2.00, 0}, {2.00, 3}), straight_shape({2.04, 4}, {2.04, 5}),
      straight_shape({2.02, 9}, {2.02, 5}),  // the solid on the other side
      straight_shape({0, 6}, {9, 6.5})};     // slanted: no guide
  const GuideLines guides(shapes, {}, {}, kGuideLinesSpacing);
  std::vector<double> up, down;
  guides.visit({2.1, 50}, 0.2, [&](const EdgeLine& line) {
    CHECK(line.direction.u == 0);
    (line.direction.v > 0 ? up : down).push_back(line.point.u);
  });
  REQUIRE(up.size() == 1);
  REQUIRE(down.size() == 1);
  CHECK(up[0] == doctest::Approx((3 * 2.00 + 1 * 2.04) / 4));
  CHECK(down[0] == doctest::Approx(2.02));
  CHECK(places(guides, {2.1, 50}, 0.05).empty());
  CHECK(!guides.empty());
  CHECK(GuideLines{}.empty());
  CHECK(GuideLines({}, {}, {}, kGuideLinesSpacing).empty());
}

// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0

// A closed chain cut into straight parts and arcs.
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "modelling/edges/find/chain_parts.h"
#include "modelling/edges/find/edge_shape.h"
#include "modelling/edges/find/guided_steps.h"
#include "unit/modelling/edges/find/chain_fixtures.h"

using namespace chains;

namespace {

constexpr double kSpacing = 0.1;

}  // namespace

TEST_CASE("split_chain__finds_lines_and_the_arc_of_a_round_head_wherever_the_chain_starts") {
  const auto chain = round_headed(0.02, 1);
  for (const size_t start : {size_t{0}, size_t{40}, size_t{222}, chain.size() - 3}) {
    CAPTURE(start);
    const auto turned = started_at(chain, start);
    const auto parts = split_chain(turned, {0.02, true});
    REQUIRE(parts.size() == 4);
    check_closed(parts, chain.size());
    int arcs = 0;
    for (const ChainPart& part : parts) {
      CHECK(!part.is_guided);
      if (part.is_arc) {
        ++arcs;
        CHECK(part.turn == 1);
        CHECK(norm(part.circle.centre - Vec2{1.5, 2.5}) < 0.02);
        CHECK(part.circle.radius == doctest::Approx(1.5).epsilon(0.01));
      } else {
        const Vec2 chord =
            turned[(part.first + part.count - 1) % turned.size()] - turned[part.first];
        CHECK(dot(part.line.direction, chord) > 0.99 * norm(chord));
      }
    }
    CHECK(arcs == 1);
  }
}

TEST_CASE("split_chain__of_lines_only_has_no_arcs_and_the_other_way_round_arcs_turn_back") {
  auto chain = round_headed(0.02, 2);
  for (const ChainPart& part : split_chain(chain, {0.02, false})) CHECK(!part.is_arc);
  std::reverse(chain.begin(), chain.end());
  const auto parts = split_chain(chain, {0.02, true});
  CHECK(std::count_if(parts.begin(), parts.end(),
                      [](const ChainPart& p) { return p.is_arc && p.turn == -1; }) == 1);
}

TEST_CASE("split_chain__a_whole_circle_is_two_arcs_and_a_triangle_of_points_three_lines") {
  std::vector<Vec2> circle;
  for (int i = 0; i < 200; ++i) {
    const double a = 2 * std::numbers::pi * i / 200;
    circle.push_back({7 + std::cos(a), std::sin(a)});
  }
  const auto parts = split_chain(circle, {0.03, true});
  REQUIRE(parts.size() == 2);
  check_closed(parts, circle.size());
  for (const ChainPart& part : parts) {
    CHECK(part.is_arc);
    CHECK(part.circle.radius == doctest::Approx(1));
  }
  const std::vector<Vec2> triangle{{0, 0}, {1, 0}, {0, 1}};
  const auto lines = split_chain(triangle, {0.02, true});
  check_closed(lines, 3);
  for (const ChainPart& part : lines) CHECK(!part.is_arc);
}

// A window 16 spacings high in few rows: the triangulation cuts both corners of its left side, four spacings each.
TEST_CASE("split_chain__a_side_with_both_corners_cut_is_no_arc_but_a_round_side_well_seen_is") {
  std::vector<Vec2> window;
  for (int k = 0; k < 10; ++k) window.push_back({10 - 0.99 * k, 16 + 0.3 * (k % 2)});
  window.insert(window.end(), {{0.3, 14.2}, {-0.4, 12.6}});
  for (int k = 0; k < 5; ++k) window.push_back({-0.9 - 0.4 * (k % 2), 11.2 - 1.5 * k});
  window.insert(window.end(), {{-0.2, 3.6}, {0.5, 1.9}});
  for (int k = 0; k < 10; ++k) window.push_back({1.2 + 0.98 * k, -0.3 * (k % 2)});
  for (int k = 0; k < 15; ++k) window.push_back({11 + 0.3 * (k % 2), 0.5 + k});
  for (const ChainPart& part : split_chain(window, {1, true})) CHECK(!part.is_arc);

  std::vector<Vec2> round_side;  // 40 spacings across
  for (int k = 0; k < 40; ++k) round_side.push_back({40.0 - k, 40 + 0.3 * (k % 2)});
  for (int k = 0; k < 63; ++k) {
    const double a = std::numbers::pi * (0.5 + k / 63.0), radius = 20 + 0.3 * (k % 2);
    round_side.push_back({radius * std::cos(a), 20 + radius * std::sin(a)});
  }
  for (int k = 0; k < 40; ++k) round_side.push_back({k + 0.0, -0.3 * (k % 2)});
  for (int k = 0; k < 40; ++k) round_side.push_back({40 + 0.3 * (k % 2), k + 0.0});
  const auto parts = split_chain(round_side, {1, true});
  const auto arc = std::find_if(parts.begin(), parts.end(), [](auto& p) { return p.is_arc; });
  REQUIRE(arc != parts.end());
  CHECK(arc->circle.radius == doctest::Approx(20).epsilon(0.05));
}

TEST_CASE("split_chain__a_stub_of_few_points_is_drawn_by_its_guides") {
  // A band 4 m long with a post's stub on it, 0.4 x 0.5 m, its corners cut by the triangulation.
  std::vector<EdgeShape> lines{
      straight_shape({8, 0}, {2.2, 0}), straight_shape({2.2, -9}, {2.2, 0}),
      straight_shape({1.8, 0}, {1.8, -9}), straight_shape({8, 0.5}, {0, 0.5})};
  const GuideLines guides(lines, {}, {}, kSpacing);
  std::vector<Vec2> chain;
  for (int k = 0; k <= 40; ++k) chain.push_back({0.1 * k, -1 + 0.02 * (k % 3)});
  for (int k = 0; k < 10; ++k) chain.push_back({4 - 0.03 * (k % 2), -0.95 + 0.1 * k});
  for (int k = 0; k < 15; ++k) chain.push_back({4 - 0.1 * k, -0.04 - 0.03 * (k % 2)});
  for (const Vec2& p : {Vec2{2.17, 0.25}, Vec2{2.15, 0.36}, Vec2{2.02, 0.46}, Vec2{1.9, 0.43},
                        Vec2{1.83, 0.3}, Vec2{1.86, 0.2}})
    chain.push_back(p);
  for (int k = 0; k < 15; ++k) chain.push_back({1.55 - 0.1 * k, -0.04 - 0.03 * (k % 2)});
  for (int k = 0; k < 8; ++k) chain.push_back({0.03 * (k % 2), -0.1 - 0.1 * k});
  const auto free = split_chain(chain, {kSpacing, true});
  const auto guided = split_chain(chain, {kSpacing, true, &guides, 0.035, 0.6});
  std::vector<EdgeShape> ring;
  for (const ChainPart& part : guided) ring.push_back(shape_of(chain, part, kSpacing, 0.035, 0.05));
  guide_steps(guides, kSpacing, ring);
  int left = 0, top = 0, right = 0;
  for (const EdgeShape& s : ring) {
    const Vec2 at = s.at(s.length_m / 2, 0);
    if (!s.is_guided) continue;
    right += std::fabs(at.u - 2.2) < 1e-9;
    top += std::fabs(at.v - 0.5) < 1e-9;
    left += std::fabs(at.u - 1.8) < 1e-9;
  }
  CHECK(right == 1);
  CHECK(top == 1);
  CHECK(left == 1);
  for (const ChainPart& part : free) CHECK(!part.is_guided);
}

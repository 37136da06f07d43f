// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0

// A closed chain cut into lines by RANSAC and the curves between them.
#include "modelling/edges/find/ransac_parts.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "unit/modelling/edges/find/chain_fixtures.h"

using namespace chains;

TEST_CASE("ransac_parts__three_sides_and_a_round_head_wherever_the_chain_starts") {
  const auto chain = round_headed(0.02, 1);
  for (const size_t start : {size_t{0}, size_t{40}, size_t{222}, chain.size() - 3})
    for (uint64_t seed = 1; seed <= 5; ++seed) {
      CAPTURE(start);
      CAPTURE(seed);
      const auto parts = ransac_parts(started_at(chain, start), {.spacing_m = 0.02, .seed = seed});
      check_closed(parts, chain.size());
      size_t arcs = 0;
      double straight_m = 0;
      for (const ChainPart& part : parts) {
        if (part.is_arc) {
          ++arcs;
          CHECK(part.turn == 1);
          CHECK(part.circle.radius == doctest::Approx(1.497).epsilon(0.01));
          CHECK(norm(part.circle.centre - Vec2{1.5, 2.5}) < 0.03);
        } else if (part.count > 20) {
          straight_m += 0.02 * static_cast<double>(part.count);
          CHECK(std::min(std::fabs(part.line.direction.u), std::fabs(part.line.direction.v)) <
                0.02);
        }
      }
      CHECK(arcs == 1);
      CHECK(straight_m ==
            doctest::Approx(8).epsilon(0.08));  // 3 + 2.5 + 2.5 and what the head lends
    }
}

TEST_CASE("ransac_parts__one_line_through_a_row_of_sills_is_cut_at_its_gaps") {
  // Teeth 1 m wide, 0.5 m apart and 0.3 m deep: their upper edges lie on one line, so do the lower ones.
  std::vector<Vec2> chain;
  const auto walk = [&](const Vec2& to) {
    const Vec2 from = chain.back();
    const auto steps = static_cast<int>(std::round(norm(to - from) / 0.02));
    for (int k = 1; k <= steps; ++k) chain.push_back(from + (to - from) * (k / double(steps)));
  };
  chain.push_back({0, 0});
  walk({5.5, 0});
  for (int tooth = 3; tooth >= 0; --tooth) {
    walk({1.5 * tooth + 1, chain.back().v});
    walk({1.5 * tooth + 1, 2});
    walk({1.5 * tooth, 2});
    if (tooth > 0) walk({1.5 * tooth, 1.7});
  }
  walk({0, 0});
  chain.pop_back();
  const auto long_parts = [&](double gap_m) {
    const auto parts = ransac_parts(chain, {.spacing_m = 0.02, .gap_m = gap_m});
    check_closed(parts, chain.size());
    size_t tops = 0;
    for (const ChainPart& part : parts)
      if (!part.is_arc && part.count >= 40 && std::fabs(part.line.point.v - 2) < 0.01 &&
          std::fabs(part.line.direction.u) > 0.99)
        ++tops;
    return tops;
  };
  CHECK(long_parts(0.2) == 4);
  CHECK(long_parts(0) == 4);   // five spacings
  CHECK(long_parts(10) == 1);  // a gap wider than all takes the teeth for one edge
}

TEST_CASE("ransac_parts__without_arcs_all_is_straight_and_a_circle_is_two_arcs") {
  const auto chain = round_headed(0.02, 2);
  const auto parts = ransac_parts(chain, {.spacing_m = 0.02, .arcs = false});
  check_closed(parts, chain.size());
  CHECK(parts.size() > 5);
  for (const ChainPart& part : parts) CHECK(!part.is_arc);
  std::vector<Vec2> circle;
  for (int k = 0; k < 300; ++k)
    circle.push_back({std::cos(k * std::numbers::pi / 150), std::sin(k * std::numbers::pi / 150)});
  const auto halves = ransac_parts(circle, {.spacing_m = 0.02});
  check_closed(halves, circle.size());
  REQUIRE(halves.size() == 2);
  for (const ChainPart& half : halves) {
    CHECK(half.is_arc);
    CHECK(half.circle.radius == doctest::Approx(1));
  }
}

TEST_CASE("ransac_parts__same_seed_same_parts_and_few_points_are_a_polygon") {
  const auto chain = round_headed(0.02, 4);
  const auto a = ransac_parts(chain, {.spacing_m = 0.02, .seed = 9}),
             b = ransac_parts(chain, {.spacing_m = 0.02, .seed = 9});
  REQUIRE(a.size() == b.size());
  for (size_t i = 0; i < a.size(); ++i) {
    CHECK(a[i].first == b[i].first);
    CHECK(a[i].count == b[i].count);
    CHECK(a[i].line.direction == b[i].line.direction);
  }
  const std::vector<Vec2> triangle{{0, 0}, {1, 0}, {0, 1}};
  const auto sides = ransac_parts(triangle, {.spacing_m = 0.1});
  check_closed(sides, 3);
  CHECK(sides.size() == 3);
}

// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "report/charts/section_cut.h"

#include <doctest/doctest.h>

#include <algorithm>

using namespace jalon;

namespace {

// A square of 2 m in the plane x = 1, as two triangles, and one that lies in the plane z = 0.
PartTriangles upright_square() {
  PartTriangles out;
  out.vertices = {{1, -1, -1}, {1, 1, -1}, {1, 1, 1}, {1, -1, 1}, {3, 0, 0}, {4, 0, 0}, {3, 1, 0}};
  out.triangles = {{0, 1, 2}, {0, 2, 3}, {4, 5, 6}};
  return out;
}

}  // namespace

TEST_CASE("section_cut__a_square_across_the_plane_is_cut_from_side_to_side") {
  for (const double back : {0.0, 0.5}) {
    const auto lines = section_cut(upright_square(), Transform{}, back);
    REQUIRE(lines.size() == 2);
    double low = 9, high = -9, length = 0;
    for (const auto& line : lines) {
      for (const Vec2& p : line) {
        CHECK(p.u == 1);
        low = std::min(low, p.v), high = std::max(high, p.v);
      }
      length += std::abs(line[1].v - line[0].v);
    }
    CHECK(low == doctest::Approx(-1));
    CHECK(high == doctest::Approx(1));
    CHECK(length == doctest::Approx(2));
  }
}

TEST_CASE("section_cut__of_a_line_the_part_within_a_box_is_kept") {
  const Vec2 low{0, 0}, high{2, 1};
  const auto across = clipped_to(low, high, {Vec2{-1, 0.5}, Vec2{3, 0.5}});
  REQUIRE(across);
  CHECK((*across)[0].u == doctest::Approx(0));
  CHECK((*across)[1].u == doctest::Approx(2));
  const auto inside = clipped_to(low, high, {Vec2{0.5, 0.5}, Vec2{1, 0.75}});
  REQUIRE(inside);
  CHECK((*inside)[1].v == 0.75);
  CHECK(!clipped_to(low, high, {Vec2{-1, 2}, Vec2{3, 2}}));
  CHECK(!clipped_to(low, high, {Vec2{-1, 0.9}, Vec2{0.5, 2.4}}));
}

TEST_CASE("section_cut__beside_the_surface_there_is_nothing") {
  CHECK(section_cut(upright_square(), Transform{}, 2).empty());
  CHECK(section_cut(upright_square(), Transform{}, -1.5).empty());
}

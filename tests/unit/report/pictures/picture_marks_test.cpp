// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
// Outlines and numbers against the points that they are of.
#include <doctest/doctest.h>

#include "report/pictures/picture_marks.h"
#include "unit/report/drawn.h"

using namespace jalon;

namespace {

Vec2 as_it_is(const Vec3& p) { return {p.x, p.y}; }

std::string marked(const std::vector<PictureMark>& marks) {
  return drawn::svg_of([&](SvgWriter& svg) {
    svg.open("svg", {{"viewBox", "0 0 100 60"}});
    draw_picture_marks(svg, marks, as_it_is, {0, 0, 100, 60});
    svg.close();
  });
}

std::vector<Vec3> square(double x, double y, double side) {
  return {{x, y, 0},
          {x + side, y, 0},
          {x + side, y + side, 0},
          {x, y + side, 0},
          {x + side / 2, y + side / 3, 0}};
}

}  // namespace

TEST_CASE("picture_marks__outline_is_the_hull_of_the_points") {
  const std::string svg = marked({{"1", square(20, 30, 10)}});
  CHECK(markup::well_formed(svg));
  const auto paths = drawn::elements(svg, "path");
  REQUIRE(paths.size() == 1);
  const auto corners = drawn::corners(paths[0].attribute("d"));
  REQUIRE(corners.size() == 4);
  for (const Vec2& p : corners) {
    CHECK((p.u == 20 || p.u == 30));
    CHECK((p.v == 30 || p.v == 40));
  }
}

TEST_CASE("picture_marks__a_single_point_has_an_outline_that_can_be_seen") {
  const std::string svg = marked({{"1", {{50, 30, 0}}}});
  const auto corners = drawn::corners(drawn::elements(svg, "path").at(0).attribute("d"));
  REQUIRE(corners.size() == 4);
  CHECK(corners[1].u - corners[0].u > 1);
  CHECK(markup::well_formed(marked({{"1", {}}})));
  CHECK(drawn::elements(marked({{"1", {}}}), "path").empty());
}

TEST_CASE("picture_marks__numbers_stand_within_the_picture_and_on_nothing") {
  // Four beside each other and one in the upper right corner.
  std::vector<PictureMark> marks;
  for (int k = 0; k < 4; ++k) marks.push_back({std::to_string(k + 1), square(20 + 12 * k, 30, 4)});
  marks.push_back({"5", square(95, 0.5, 4)});
  const std::string svg = marked(marks);
  std::vector<Box_mm> boxes;
  for (const markup::Tag& tag : drawn::elements(svg, "rect"))
    boxes.push_back({drawn::number(tag, "x"), drawn::number(tag, "y"), drawn::number(tag, "width"),
                     drawn::number(tag, "height")});
  REQUIRE(boxes.size() == 5);
  for (size_t a = 0; a < boxes.size(); ++a) {
    CHECK(boxes[a].x >= 0);
    CHECK(boxes[a].right() <= 100);
    CHECK(boxes[a].y >= 0);
    for (size_t b = a + 1; b < boxes.size(); ++b) {
      const bool apart = boxes[a].right() <= boxes[b].x || boxes[b].right() <= boxes[a].x ||
                         boxes[a].bottom() <= boxes[b].y || boxes[b].bottom() <= boxes[a].y;
      CHECK(apart);
    }
  }
}

// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "report/pictures/facade_section.h"

#include <doctest/doctest.h>

using namespace jalon;

namespace {

// Two walls of two strips each, 8 m before and behind the x axis; the points of the second stand 0.5 m before it.
struct Walls {
  StripScene scene;
  JointAdjustment adjustment;

  Walls() {
    scene.blocks = 1, scene.facades = 2;
    for (uint32_t s = 0; s < 4; ++s) {
      const double side = s < 2 ? 1 : -1, from = 5.0 * (s % 2), to = from + 5, y = 8 * side;
      scene.strips.push_back({0, s / 2, {0, -side}, -8});
      scene.corners.insert(scene.corners.end(), {{from, y, 0}, {to, y, 0}, {to, y, 3}});
      scene.face_of.push_back(s), scene.strip_of_face.push_back(s);
      scene.block_of_face.push_back(0);
      for (const double x : {from + 1, from + 4}) add({x, y + (s < 2 ? 0 : 0.5), 1}, s);
    }
    adjustment.trajectory.times_s = {0, 1};
    adjustment.trajectory.by_m = {{0, 0}, {0, 0}};
    adjustment.strip_points = {2, 2, 2, 2};
    adjustment.strip_distances_m = {0.01, -0.01, 0.5, 0.5};
    adjustment.model = {{{0, 0}}, {0, 0.5}, {0, 0, 0, 0}};
  }
  void add(const Vec3& at, uint32_t strip) {
    JointPoints& points = adjustment.points;
    points.index.push_back(static_cast<uint32_t>(points.index.size()));
    points.at.push_back(at), points.places.push_back({0, 0.5});
    adjustment.matches.push_back({strip, MatchState::kMatched, 0});
    adjustment.weights.push_back(1);
  }
};

size_t times(const std::string& text, const std::string& part) {
  size_t n = 0;
  for (size_t at = 0; (at = text.find(part, at)) != std::string::npos; ++at) ++n;
  return n;
}

}  // namespace

TEST_CASE("farthest_facade__is_the_one_whose_points_stand_off_it") {
  Walls walls;
  CHECK(farthest_facade(walls.scene, walls.adjustment) == 1);
  walls.adjustment.strip_points = {2, 2, 0, 0};
  CHECK(farthest_facade(walls.scene, walls.adjustment) == 0);
  walls.adjustment.strip_points = {0, 0, 0, 0};
  CHECK_FALSE(farthest_facade(walls.scene, walls.adjustment));
}

TEST_CASE("facade_section__has_its_strips_and_points_as_given_and_adjusted") {
  const Walls walls;
  const std::string svg = facade_section(walls.scene, walls.adjustment, 1);
  CHECK(times(svg, "<circle") == 8);
  CHECK(times(svg, "#c0392b") == 4);
  CHECK(times(svg, "#1e8449") == 4);
  CHECK(times(svg, "#1f5fa8") == 2);
  CHECK(svg.find("as given") < svg.find("adjusted"));
}

// A wall that points leave by centimetres is drawn out of scale across, and says so.
TEST_CASE("facade_section__of_small_offsets__enlarges_them_and_says_by_how_much") {
  const Walls walls;
  CHECK(facade_section(walls.scene, walls.adjustment, 0).find("Out of it (m), x ") !=
        std::string::npos);
}

// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0

// Openings and shadows.
#include <doctest/doctest.h>

#include <cmath>

#include "modelling/walls/openings.h"
#include "unit/modelling/plane_rings.h"
#include "unit/modelling/walls.h"

using namespace walls;

namespace {

/// A wall of 6 x 3 m with a hole of 1 x 1 m at (1, 1) and a triangular one at (3, 1), and what lies in them.
struct Scene {
  std::vector<WallHole> holes{2};
  Segmentation segmentation;
  FacadeWall wall;
  std::vector<int32_t> opening_of;

  explicit Scene(const std::vector<std::vector<Vec3>>& content) {
    holes[0].outline = rings::rectangle({1, 1}, {2, 2});
    holes[1].outline = rings::ring_of({{3, 1}, {4, 1}, {3, 2}});
    std::vector<std::vector<Vec3>> parts(1);
    for (double u = 0.025; u < 6; u += 0.05)
      for (double v = 0.025; v < 3; v += 0.05) {
        const bool in_first =
            u > 1 && u < 2 && v > 1 && v<2, in_second = u> 3 && v > 1 && u - 3 + v - 1 < 1;
        if (!in_first && !in_second) parts[0].push_back({u, 0, v});
      }
    parts.insert(parts.end(), content.begin(), content.end());
    segmentation = segmentation_of(parts);
    const VectorPlane plane = rings::wall_of({{rings::rectangle({0, 0}, {6, 3}), {}}}, 0.05);
    wall.label = 1;
    wall.frame = plane.frame;
    wall.spacing_m = 0.05;
    wall.outlines = {plane.faces[0].outline};
    Task task;
    const SurveyedWall walls[] = {{&plane, holes, 0.002}};
    auto surveys = survey_walls(segmentation, walls, {}, task);
    opening_of = judge_holes(segmentation, holes, surveys[0], {}, wall, task);
  }
};

std::vector<Vec3> patch(double u0, double y) {
  std::vector<Vec3> out;
  for (double u = u0 + 0.025; u < u0 + 1; u += 0.05)
    for (double v = 1.025; v < 2; v += 0.05) out.push_back({u, y, v});
  return out;
}

}  // namespace

TEST_CASE("judge_holes__a_pane_behind_makes_a_window_with_its_depth_whatever_the_shape") {
  const Scene scene({patch(1, 0.2), patch(3, 0.3)});
  CHECK(scene.opening_of == std::vector<int32_t>{0, 1});
  REQUIRE(scene.wall.openings.size() == 2);
  const FacadeOpening& window = scene.wall.openings[0];
  CHECK(window.evidence == Evidence::kSeenBehind);
  CHECK(window.kind == OpeningKind::kWindow);
  CHECK(window.depth_m == doctest::Approx(0.2));
  CHECK(window.joinery_label == 2);
  CHECK(window.coverage > 0.9);
  CHECK(window.residual_m < 0.02);
  CHECK(scene.wall.openings[1].depth_m == doctest::Approx(0.3));
  CHECK(scene.wall.openings[1].joinery_label == 3);
  CHECK(scene.wall.shadows.empty());
  CHECK(scene.wall.map.at({1.5, 1.5}) == WallCell::kThrough);
}

TEST_CASE("judge_holes__without_any_evidence_the_shape_decides") {
  const Scene scene({});
  CHECK(scene.opening_of == std::vector<int32_t>{0, -1});
  REQUIRE(scene.wall.openings.size() == 1);
  CHECK(scene.wall.openings[0].evidence == Evidence::kShape);
  CHECK(std::isnan(scene.wall.openings[0].depth_m));
  REQUIRE(scene.wall.shadows.size() == 1);
  CHECK(scene.wall.shadows[0].outline.corners == scene.holes[1].outline.corners);
}

TEST_CASE("judge_holes__what_something_in_front_hides_is_a_shadow_and_a_flush_leaf_an_opening") {
  const Scene hidden({patch(1, -3)});
  CHECK(hidden.opening_of == std::vector<int32_t>{-1, -1});
  CHECK(hidden.wall.shadows.size() == 2);
  const Scene flush({patch(1, 0.01)});
  REQUIRE(flush.opening_of[0] == 0);
  CHECK(flush.wall.openings[0].evidence == Evidence::kMeasured);
  CHECK(flush.wall.openings[0].depth_m == doctest::Approx(0.01));
}

TEST_CASE("judge_holes__a_shutter_hangs_close_before_the_wall_and_what_stands_off_it_hides_it") {
  const Scene shutter({patch(1, -0.06)});
  REQUIRE(shutter.opening_of[0] == 0);
  CHECK(shutter.wall.openings[0].evidence == Evidence::kMeasured);
  const Scene canopy({patch(1, -0.23)});
  CHECK(canopy.opening_of == std::vector<int32_t>{-1, -1});
  CHECK(canopy.wall.shadows.size() == 2);
}

TEST_CASE("judge_holes__reveals_are_evidence_and_what_stands_before_the_joinery_is_told") {
  std::vector<Vec3> reveal;
  for (double y = 0.04; y < 0.2; y += 0.02)
    for (double v = 1.05; v < 2; v += 0.1) reveal.push_back({1.01, y, v});
  std::vector<Vec3> parapet;
  for (const Vec3& p : patch(1, 0.08))
    if (p.z < 1.3) parapet.push_back(p);
  const Scene scene({patch(1, 0.2), reveal, parapet});
  REQUIRE(scene.opening_of[0] == 0);
  const FacadeOpening& window = scene.wall.openings[0];
  CHECK(window.evidence == Evidence::kRevealed);
  CHECK(window.joinery_label == 2);
  CHECK(window.standing_labels == std::vector<uint32_t>{4});
}

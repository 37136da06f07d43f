// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0

// What becomes of the planes and holes of a wall that is known, from the points behind and before it.
#include "modelling/facade/plan.h"

#include <doctest/doctest.h>

#include <cmath>

#include "unit/modelling/planned_scene.h"
#include "unit/modelling/walls.h"

using namespace planned;

namespace {

constexpr double kStep_m = 0.05;

/// Points every 5 cm of a rectangle on the plane y, but not in the holes.
std::vector<Vec3> points_on(const walls::Rectangle& r, double y,
                            const std::vector<walls::Rectangle>& holes = {}) {
  std::vector<Vec3> out;
  for (double x = r.left + kStep_m / 2; x < r.right; x += kStep_m)
    for (double z = r.bottom + kStep_m / 2; z < r.top; z += kStep_m) {
      bool is_hole = false;
      for (const walls::Rectangle& h : holes) is_hole |= h.contains(x, z);
      if (!is_hole) out.push_back({x, y, z});
    }
  return out;
}

VectorPlane plane_with(VectorFace face, double y, uint32_t label) {
  VectorPlane plane = wall_of({std::move(face)}, kStep_m, -y);
  plane.label = label;
  return plane;
}

VectorRing ring_round(const walls::Rectangle& r) {
  return rectangle({r.left, r.bottom}, {r.right, r.top});
}

const walls::Rectangle kWall{0, 0, 10, 4}, kWindow{2, 1, 3.2, 2.5}, kDark{6, 1, 7, 2},
    kBox{5.9, 0.9, 7.1, 2.1};

/// A wall with a window whose pane lies 0.2 m behind, and a hole that a box 2 m in front hides.
FacadePlan window_and_shadow() {
  const Segmentation segmentation = walls::segmentation_of(
      {points_on(kWall, 0, {kWindow, kDark}), points_on(kWindow, 0.2), points_on(kBox, -2)});
  VectorFace face{ring_round(kWall), {reversed(ring_round(kWindow)), reversed(ring_round(kDark))}};
  Task task;
  return plan_facades(
      segmentation,
      {plane_with(std::move(face), 0, 1), plane_with({ring_round(kWindow), {}}, 0.2, 2),
       plane_with({ring_round(kBox), {}}, -2, 3)},
      {}, task);
}

}  // namespace

TEST_CASE("facade_plan__tells_a_window_from_a_shadow") {
  const FacadePlan plan = window_and_shadow();
  REQUIRE(plan.facades.size() == 1);
  REQUIRE(plan.facades[0].walls.size() == 1);
  const PlannedWall& wall = plan.facades[0].walls[0];
  CHECK(wall.plane == 0);
  CHECK(wall.wall.label == 1);
  REQUIRE(wall.wall.openings.size() == 1);
  const FacadeOpening& window = wall.wall.openings[0];
  CHECK(window.kind == OpeningKind::kWindow);
  CHECK(window.joinery_label == 2);
  CHECK(window.depth_m ==
        doctest::Approx(0.2).epsilon(1e-6).scale(0));  // points in single precision
  CHECK(signed_area(window.outline) == doctest::Approx(kWindow.area()));
  REQUIRE(wall.wall.shadows.size() == 1);
  CHECK(signed_area(wall.wall.shadows[0].outline) == doctest::Approx(kDark.area()));
  // The face has both holes.
  CHECK_FALSE(wall.wall.shadows[0].is_filled);
  REQUIRE(plan.planes[0].faces.size() == 1);
  REQUIRE(plan.planes[0].faces[0].openings.size() == 2);
  CHECK(area(plan.planes[0].faces[0]) ==
        doctest::Approx(kWall.area() - kWindow.area() - kDark.area()));
}

TEST_CASE("facade_plan__parts_of_their_own_are_neither_walls_nor_what_fills_openings") {
  const FacadePlan plan = window_and_shadow();
  CHECK(plan.facades[0].group.walls == std::vector<size_t>{0});
  CHECK(plan.facades[0].elements == std::vector<size_t>{2});
  CHECK(plan.shared.empty());
  // Without any wall all planes are such parts.
  Task task;
  const Segmentation box = walls::segmentation_of({points_on(kBox, -2)});
  const FacadePlan alone = plan_facades(box, {plane_with({ring_round(kBox), {}}, -2, 1)}, {}, task);
  REQUIRE(alone.facades.size() == 1);
  CHECK(alone.facades[0].walls.empty());
  CHECK(alone.facades[0].elements == std::vector<size_t>{0});
}

TEST_CASE("facade_plan__a_door_is_a_notch_of_the_outline_and_a_hidden_one_is_closed_where_asked") {
  const walls::Rectangle door{4, 0, 5.2, 2.2};
  VectorFace face{
      ring_of({{0, 0}, {4, 0}, {4, 2.2}, {5.2, 2.2}, {5.2, 0}, {10, 0}, {10, 4}, {0, 4}}), {}};
  for (const bool hidden : {false, true}) {
    const Segmentation segmentation =
        walls::segmentation_of({points_on(kWall, 0, {door}), points_on(door, hidden ? -1.5 : 0.3)});
    Task task;
    PlanSetting setting;
    setting.fill.fill = WallFill::kOutline;
    const FacadePlan plan = plan_facades(
        segmentation,
        {plane_with(face, 0, 1), plane_with({ring_round(door), {}}, hidden ? -1.5 : 0.3, 2)},
        setting, task);
    REQUIRE(plan.facades.size() == 1);
    const FacadeWall& wall = plan.facades[0].walls[0].wall;
    CHECK(wall.openings.size() == (hidden ? 0 : 1));
    CHECK(wall.shadows.size() == (hidden ? 1 : 0));
    CHECK(plan.facades[0].elements.size() == (hidden ? 1 : 0));
    CHECK(area(plan.planes[0].faces[0]) ==
          doctest::Approx(kWall.area() - (hidden ? 0 : door.area())));
    CHECK(signed_area(wall.outlines[0]) == area(plan.planes[0].faces[0]));
    if (hidden) continue;
    CHECK(wall.openings[0].kind == OpeningKind::kDoor);
    CHECK(wall.openings[0].is_notch);
    CHECK(wall.openings[0].depth_m == doctest::Approx(0.3).epsilon(1e-6).scale(0));
  }
}

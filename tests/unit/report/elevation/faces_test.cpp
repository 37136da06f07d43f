// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
// Faces of scenes made by hand: kinds by their turn, depths from the main plane, groups, limits, boxes.
#include <doctest/doctest.h>

#include <atomic>
#include <cmath>
#include <numbers>
#include <vector>

#include "base/random.h"
#include "report/elevation/faces.h"
#include "unit/compare/refusal.h"
#include "unit/report/named_facade.h"

using namespace jalon;

namespace {

using Kind = DrawnFace::Kind;

uint32_t add_part(Model& m, const char* part_class, uint64_t parent = kNoParent) {
  m.parts.push_back(named_facade::part("", part_class, parent));
  return static_cast<uint32_t>(m.parts.size() - 1);
}

// An upright rectangle about (x, y), turned about Z by this angle from facing the eye.
void add_upright(Model& m, uint32_t part, double x, double y, double angle, double width = 2,
                 double height = 3) {
  const Vec3 along = Vec3{std::cos(angle), std::sin(angle), 0} * (width / 2), at{x, y, 0},
             normal{std::sin(angle), -std::cos(angle), 0}, up{0, 0, height};
  named_facade::add(m, part, {normal, dot(normal, at)},
                    {{at - along, at + along, at + along + up, at - along + up}}, {},
                    width * height, static_cast<uint32_t>(m.faces.size()));
}

ElevationFaces faces_seen(const Model& m, const ViewLimits& limits = {},
                          const ElevationView& view = {}) {
  Task task;
  return elevation_faces(m, view, limits, task);
}

}  // namespace

TEST_CASE("faces__are_fronts_slanted_or_edges_by_their_turn_and_class") {
  RandomStream random(1, 0);
  const ViewLimits limits;
  for (int trial = 0; trial < 200; ++trial) {
    const double angle = std::numbers::pi * (random.uniform() - 0.5), off = std::fabs(angle);
    CAPTURE(angle);
    Model m;
    add_upright(m, add_part(m, "wall"), 0, 0, 0, 20, 20);
    add_upright(m, add_part(m, "element"), 5, 0, angle);
    // Two degrees from the line of sight everything is a line; and before that what stands square to the facade.
    const Kind wanted = off <= limits.front_angle_rad                             ? Kind::kFront
                        : off > std::numbers::pi / 2 - 2 * std::numbers::pi / 180 ? Kind::kEdgeOn
                                                                                  : Kind::kSlanted;
    const auto kind = [&] {
      for (const DrawnFace& face : faces_seen(m).faces)
        if (face.face == 1) return face.kind;
      return Kind::kFront;
    };
    if (std::fabs(off - (std::numbers::pi / 2 - 0.035)) > 0.001) CHECK(kind() == wanted);
    m.faces[1].face_class = static_cast<uint8_t>(Orientation::kVertical);
    CHECK(kind() == (wanted == Kind::kFront ? Kind::kFront : Kind::kEdgeOn));
  }
}

TEST_CASE("faces__depths_count_from_the_largest_wall_and_the_farthest_come_first") {
  Model m;
  const uint32_t wall = add_part(m, "wall"), element = add_part(m, "element");
  add_upright(m, wall, 0, 5, 0, 8);
  add_upright(m, wall, 9, 4, 0, 6);       // a smaller one
  add_upright(m, element, 0, 3, 0, 30);   // larger, but no wall
  add_upright(m, element, 0, 15.1, 0);    // beyond 10 m behind
  add_upright(m, element, 0, 14.9, 0.2);  // turned about its middle
  add_upright(m, element, 0, 0.9, 0);     // more than 3 m before the nearest wall
  const ElevationFaces seen = faces_seen(m);
  const double wanted[] = {9.9, 0, -1, -2};
  REQUIRE(seen.faces.size() == 4);
  for (size_t i = 0; i < 4; ++i) CHECK(seen.faces[i].depth_m == doctest::Approx(wanted[i]));
  CHECK(seen.main_sigma_m == m.faces[0].sigma_m);
  ViewLimits wide;
  wide.behind_m = 11;
  wide.element_reach_m = 6;
  CHECK(faces_seen(m, wide).faces.size() == 6);
  wide.in_front_m = 1.5;
  CHECK(faces_seen(m, wide).faces.size() == 4);
}

TEST_CASE("faces__of_one_plane_stand_as_in_the_model_with_missing_data_last_at_any_angle") {
  constexpr double kX = 652000, kY = 6861000;
  for (int turn = 0; turn < 100; ++turn) {
    CAPTURE(turn);
    const double angle = 0.06 * turn, c = std::cos(angle), s = std::sin(angle);
    Model m;
    const uint32_t wall = add_part(m, "wall"), missing = add_part(m, "no_data", wall);
    const auto add_along = [&](uint32_t part, double along, double width) {
      add_upright(m, part, kX + along * c, kY + along * s, angle, width);
    };
    add_along(missing, 0.7, 0.3);
    add_along(wall, 0, 8);
    add_along(missing, -1.3, 0.3);
    add_along(wall, 5.1, 2);
    add_along(wall, -5.7, 2);
    ElevationView view;
    view.T_view_world.m = {c, s, 0, -c * kX - s * kY, -s, c, 0, s * kX - c * kY, 0, 0, 1, 0};
    std::vector<size_t> order;
    for (const DrawnFace& face : faces_seen(m, {}, view).faces) order.push_back(face.face);
    CHECK(order == std::vector<size_t>{1, 3, 4, 0, 2});
  }
}

TEST_CASE("faces__groups_hold_faces_of_about_one_depth_and_are_no_more_than_colours") {
  RandomStream random(3, 0);
  for (int trial = 0; trial < 50; ++trial) {
    CAPTURE(trial);
    Model m;
    add_upright(m, add_part(m, "wall"), 0, 0, 0, 50, 50);
    const uint32_t element = add_part(m, "element");
    for (uint64_t n = random.below(40); n > 0; --n)
      add_upright(m, element, 0, -2 + 5 * random.uniform(), 0);
    const ElevationFaces seen = faces_seen(m);
    REQUIRE(seen.groups.size() <= kMaxDepthGroups);
    std::vector<size_t> counts(seen.groups.size());
    for (const DrawnFace& face : seen.faces) {
      const DepthGroup& group = seen.groups[face.group];
      CHECK(face.depth_m >= group.from_m);
      CHECK(face.depth_m <= group.to_m);
      ++counts[face.group];
      if (face.face == 0) CHECK(group.side == 0);
    }
    for (size_t i = 0; i < seen.groups.size(); ++i) {
      CHECK(counts[i] == seen.groups[i].faces);
      if (i == 0) continue;
      const DepthGroup &a = seen.groups[i - 1], &b = seen.groups[i];
      CHECK(a.to_m < b.from_m);
      CHECK(a.side <= b.side);
      // Ranks grow outward from the main plane, on both sides from 0.
      if (a.side == b.side) CHECK(b.rank + (a.side < 0 ? 1 : 0) == a.rank + (a.side < 0 ? 0 : 1));
      else CHECK(((a.side < 0 ? a.rank : 0) == 0 && (b.side > 0 ? b.rank : 0) == 0));
    }
  }
}

TEST_CASE(
    "faces__of_one_plane_are_one_colour_although_rounding_lays_them_on_both_sides_of_a_step") {
  constexpr double kRounding = 4e-7;
  // Half a step from the main plane, on both its sides, and a whole step behind another plane.
  for (const double depth : {-0.01, 0.01, 0.52}) {
    CAPTURE(depth);
    Model m;
    add_upright(m, add_part(m, "wall"), 0, 0, 0, 50, 50);
    const uint32_t element = add_part(m, "element");
    add_upright(m, element, 3, 0.5, 0);
    add_upright(m, element, 0, depth - kRounding, 0);
    add_upright(m, element, 6, depth + kRounding, 0);
    const ElevationFaces seen = faces_seen(m);
    std::vector<size_t> groups(5);
    for (const DrawnFace& face : seen.faces) groups[face.face] = face.group;
    CHECK(groups[2] == groups[3]);
  }
}

TEST_CASE("faces__the_box_the_ground_and_the_lower_left_corner_in_the_world") {
  named_facade::Setting s;
  s.shift = {652000, 6861000, 137};
  Model m = named_facade::make(s);
  ElevationView view;
  view.T_view_world.m = {1, 0, 0, -652000, 0, 1, 0, -6861000, 0, 0, 1, -137};
  const ElevationFaces seen = faces_seen(m, {}, view);
  CHECK(!seen.empty);
  CHECK(seen.low.u == doctest::Approx(-0.2));  // the cornice
  CHECK(seen.wall_low.u == doctest::Approx(0));
  CHECK(seen.wall_high.u == doctest::Approx(15));
  CHECK(seen.low.v == doctest::Approx(137));  // heights stay those of the world
  CHECK(seen.ground_m == doctest::Approx(137));
  CHECK(norm(seen.corner_world - s.shift) < 1e-9);
  // Ground below the foot of the wall is the level; a river far below is not.
  for (const double below : {1.0, 30.0}) {
    Model lower = m;
    for (const Face& face : lower.faces)
      for (uint64_t i = 0; face.part == 3 && i < 4; ++i)
        lower.vertices[lower.corners[lower.rings[face.first_ring].first + i]].z -= below;
    CHECK(faces_seen(lower, {}, view).ground_m == doctest::Approx(below == 1 ? 136 : 137));
  }
  CHECK(faces_seen({}).empty);
  std::atomic<bool> cancel = true;
  Task::Hooks hooks;
  hooks.cancel = &cancel;
  Task task(hooks);
  const auto draw = [&] { elevation_faces(m, view, {}, task); };
  CHECK(test::refuses(draw, Status::kCancelled, ""));
}

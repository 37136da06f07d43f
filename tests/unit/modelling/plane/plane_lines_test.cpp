// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0

// Which edges of faces run along the lines in which planes meet.
#include <doctest/doctest.h>

#include <cmath>

#include "modelling/plane/plane_lines.h"
#include "unit/modelling/plane_rings.h"

using namespace rings;

namespace {

/// A wall on the plane y = 0 whose lower edge ends so far above a floor on z = 0 before it.
std::vector<VectorPlane> wall_on_floor(double above_m, double before_m = 0.02) {
  VectorPlane wall = wall_of({{rectangle({0, above_m}, {4, 3}), {}}}, 0.02);
  VectorPlane floor = wall_of({{rectangle({0, -5}, {4, -before_m}), {}}}, 0.02);
  floor.frame = {{}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, 0};
  return {wall, floor};
}

}  // namespace

TEST_CASE("plane_lines__both_planes_edges_at_a_corner_are_found_with_the_line_of_both") {
  Task task;
  const auto joints = find_joints(wall_on_floor(0.03), {}, task);
  REQUIRE(joints.size() == 2);
  CHECK(joints[0].plane == 0);
  CHECK(joints[0].edge == 0);  // the lower one
  CHECK(joints[0].distance_m == doctest::Approx(0.03));
  CHECK(joints[0].reach_m == doctest::Approx(0.04));  // two spacings
  CHECK(joints[1].plane == 1);
  CHECK(joints[1].edge == 2);  // the one towards the wall
  CHECK(joints[1].distance_m == doctest::Approx(0.02));
  for (const EdgeJoint& joint : joints) {
    CHECK(joint.other_plane == 1 - joint.plane);
    CHECK(std::fabs(joint.line.d.x) == doctest::Approx(1));
    CHECK(std::hypot(joint.line.p.y, joint.line.p.z) < 1e-12);
    CHECK(joint.line.p == joints[0].line.p);
  }
}

TEST_CASE("plane_lines__an_edge_out_of_reach_or_beside_the_other_face_has_no_joint") {
  Task task;
  CHECK(find_joints(wall_on_floor(0.05, 0.06), {}, task).empty());
  CHECK(find_joints(wall_on_floor(0.05, 0.06), {true, 0.1}, task).size() == 2);
  auto planes = wall_on_floor(0.01);
  for (Vec2& p : planes[1].faces[0].outline.corners) p.u += 10;
  CHECK(find_joints(planes, {}, task).empty());
  planes = wall_on_floor(0.01);
  planes[0].faces[0].outline.edges[0].sagitta_m = 0.01;  // arcs stay where they are
  const auto joints = find_joints(planes, {}, task);
  REQUIRE(joints.size() == 1);
  CHECK(joints[0].plane == 1);
}

TEST_CASE("plane_lines__planes_flat_to_each_other_have_no_line_and_an_edge_takes_the_nearest") {
  Task task;
  std::vector<VectorPlane> flat = wall_on_floor(0.01);
  const double c = std::cos(0.2), s = std::sin(0.2);
  flat[1].frame = {{}, {1, 0, 0}, {0, -s, c}, {0, -c, -s}, 0};  // 11 degrees from the wall
  CHECK(find_joints(flat, {}, task).empty());
  // A second floor 2 cm above the first: nearer to the wall's edge.
  std::vector<VectorPlane> three = wall_on_floor(0.03);
  three.push_back(three[1]);
  three[2].frame.height = 0.02;
  const auto joints = find_joints(three, {}, task);
  REQUIRE(!joints.empty());
  CHECK(joints[0].plane == 0);
  CHECK(joints[0].other_plane == 2);
  CHECK(joints[0].distance_m == doctest::Approx(0.01));
  for (size_t i = 1; i < joints.size(); ++i) CHECK(joints[i].plane > joints[i - 1].plane);
}

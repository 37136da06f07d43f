// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
// Which planes a pass takes and how it shapes them, against planes turned by known angles.
#include <doctest/doctest.h>

#include <cmath>

#include "unit/segment/made_scene.h"

using namespace jalon;
using namespace jalon::test;

namespace {

constexpr double kPassTolerance_rad = 0.0174533, kDrawReach_rad = 0.26;

OrientationPass pass_of(Orientation wanted) {
  return {wanted, FacadeAxes::of({0.6, 0.8, 0}), kPassTolerance_rad, kDrawReach_rad};
}

// The axis turned by an angle about a direction across it.
Vec3 turned(const Vec3& axis, double by_rad) {
  return std::cos(by_rad) * axis + std::sin(by_rad) * normalized(cross(axis, Vec3{0.2, -0.1, 0.7}));
}

constexpr Orientation kWithAxis[] = {Orientation::kParallel, Orientation::kVertical,
                                     Orientation::kHorizontal};

}  // namespace

TEST_CASE("orientation_pass__shape_turns_a_near_plane_onto_the_axis_about_the_foot_of_the_point") {
  const Vec3 about{1, 2, 3};
  for (const Orientation wanted : kWithAxis) {
    const OrientationPass pass = pass_of(wanted);
    const Vec3 axis = pass.axes.axis(wanted);
    for (const double side : {-1.0, 1.0}) {
      Plane plane{side * turned(axis, 0.9 * kDrawReach_rad), 0};
      plane.offset = dot(plane.normal, about) - 0.01;  // the point lies 1 cm before it
      const Vec3 foot = about - 0.01 * plane.normal;
      REQUIRE(pass.shape(plane, about));
      CHECK(norm(plane.normal - axis) < 1e-12);
      CHECK(std::fabs(plane.distance(foot)) < 1e-12);
      Plane far{side * turned(axis, 1.1 * kDrawReach_rad), 0.5};
      CHECK_FALSE(pass.shape(far, about));
    }
  }
}

TEST_CASE("orientation_pass__planes_of_no_class_and_inclined_ones_stay_as_they_are") {
  for (const Orientation wanted : {Orientation::kNone, Orientation::kInclined}) {
    const OrientationPass pass = pass_of(wanted);
    Plane plane{normalized(Vec3{1, 1, 1}), 0.25};
    const Plane before = plane;
    REQUIRE(pass.shape(plane, {1, 2, 3}));
    CHECK(plane.normal == before.normal);
    CHECK(plane.offset == before.offset);
    CHECK(pass.accepts(plane.normal));
    Plane level{{0, 0, 1}, 0};
    CHECK(pass.shape(level, {1, 2, 3}) == (wanted == Orientation::kNone));
    CHECK(pass.accepts({0, 0, 1}) == (wanted == Orientation::kNone));
  }
}

TEST_CASE("orientation_pass__accepts_three_tolerances_about_the_axis_and_no_other_class") {
  for (const Orientation wanted : kWithAxis) {
    const OrientationPass pass = pass_of(wanted);
    for (const Orientation other : kWithAxis) {
      const Vec3 axis = pass.axes.axis(other);
      CHECK(pass.accepts(turned(axis, 2.9 * kPassTolerance_rad)) == (other == wanted));
      CHECK(pass.accepts(-turned(axis, 2.9 * kPassTolerance_rad)) == (other == wanted));
      CHECK_FALSE(pass.accepts(turned(axis, 3.1 * kPassTolerance_rad)));
    }
  }
}

TEST_CASE("orientation_passes__one_for_all_or_one_a_class_in_the_order_asked_for") {
  Scene scene;
  RandomStream random(1, 28);
  scene.rectangle(1, {0, 0, 0}, {2.4, 1.8, 0}, {0, 0, 2}, 4000, 0.003, random);
  MadeScene made(scene.points);
  const auto all = orientation_passes(made.scene, made.task);
  REQUIRE(all.size() == 1);
  CHECK(all[0].wanted == Orientation::kNone);
  CHECK_FALSE(made.scene.axes.has_value());
  made.scene.order = orientation_order("horizontal inclined parallel");
  const auto passes = orientation_passes(made.scene, made.task);
  REQUIRE(passes.size() == 3);
  CHECK(passes[0].wanted == Orientation::kHorizontal);
  CHECK(passes[1].wanted == Orientation::kInclined);
  CHECK(passes[2].wanted == Orientation::kParallel);
  REQUIRE(made.scene.axes.has_value());
  for (const OrientationPass& pass : passes) {
    CHECK(pass.tolerance_rad == made.scene.settings.orientation_tolerance_rad);
    // The only wall; normals of cells of 0.1 m are 1 degree off, their mean 0.02.
    CHECK(std::fabs(dot(pass.axes.across, Vec3{-0.6, 0.8, 0})) > std::cos(0.003));
  }
}

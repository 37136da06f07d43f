// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include <doctest/doctest.h>

#include <cmath>
#include <string>

#include "unit/scan/scenes/built.h"

using namespace jalon;
using namespace jalon::test;

// The room, the box and the strips against volumes, and against what rays meet.

TEST_CASE("scene_room__is_closed_and_looks_inward") {
  const Model room = built(build_room);
  CHECK(open_edge_m(room) == 0);
  CHECK(std::abs(shell_of(room, {}).volume_m3 + 6 * 5 * 2.8) < kRounding_m);
  RandomStream random(1, 0);
  for (int k = 0; k < 300; ++k) {
    const Vec3 eye{6 * random.uniform(), 5 * random.uniform(), 2.8 * random.uniform()};
    const Vec3 d = normalized({random.normal(), random.normal(), random.normal()});
    const Hit hit = first_hit(room, eye, d);
    REQUIRE(std::isfinite(hit.distance));
    REQUIRE(hit.is_front);
    // What looks up is floor, what looks down ceiling, the rest wall.
    const Vec3 p = eye + d * hit.distance;
    const std::string met = class_of(room, hit.triangle);
    REQUIRE((met == "floor") == (p.z < kRounding_m));
    REQUIRE((met == "ceiling") == (p.z > 2.8 - kRounding_m));
  }
}

TEST_CASE("scene_box__closes_the_hole_that_the_ground_leaves_for_it") {
  const Model model = built(build_box);
  // Ground and box are one surface: only the ground's rim of 4 x 20 m is open.
  CHECK(std::abs(open_edge_m(model) - 80) < kRounding_m);
  CHECK(std::abs(shell_of(model, ids_of(model, "ground")).area_m2 - (400 - 4.2 * 1.8)) <
        kRounding_m);
  // Over the plane of the ground it holds the box's volume.
  CHECK(std::abs(shell_of(model, {}).volume_m3 - 4.2 * 1.8 * 1.5) < kRounding_m);
  CHECK(norm(shell_of(model, {}).vector_area - Vec3{0, 0, 400}) < kRounding_m);
  CHECK(top_z(model, 2.09, 0.89) == doctest::Approx(1.5));
  CHECK(std::abs(top_z(model, 2.11, 0)) < kRounding_m);
  CHECK(std::abs(top_z(model, 0, -0.91)) < kRounding_m);
  CHECK(std::isinf(top_z(model, 10.01, 0)));
}

TEST_CASE("scene_bow__bends_about_an_axis_6_m_behind_it_and_looks_outward") {
  const Model model = built(build_bow);
  for (const double degrees : {-65.0, -30.0, 0.0, 30.0, 65.0}) {
    CAPTURE(degrees);
    const double angle = degrees * 3.141592653589793 / 180;
    const double x = 6 * std::sin(angle), y = 6 - 6 * std::cos(angle);
    for (const double z : {0.1, 4.0, 7.9}) CHECK(std::abs(front_y(model, x, z) - y) < 1e-3);
    const Hit hit = first_hit(model, {x, -20, 4}, {0, 1, 0});
    CHECK(hit.is_front);
  }
  CHECK(std::isinf(front_y(model, 0, 8.01)));
  CHECK(std::isinf(front_y(model, 5.7, 4)));  // 6 sin 70 degrees = 5.64
  CHECK(std::abs(top_z(model, 3, -3)) < kRounding_m);
}

TEST_CASE("scene_strips__stand_side_by_side_each_10_cm_behind_the_one_before") {
  const Model model = built(build_strips);
  CHECK(parts_named(model, "wall").size() == 6);
  CHECK(std::abs(shell_of(model, {}).area_m2 - 9 * 8) < kRounding_m);  // none covers another
  for (int k = 0; k < 6; ++k)
    for (const double u : {0.001, 0.75, 1.499})
      for (const double z : {0.01, 7.99})
        CHECK(std::abs(front_y(model, 1.5 * k + u, z) - 0.1 * k) < kRounding_m);
  CHECK(std::isinf(front_y(model, 9.01, 4)));
  CHECK(std::isinf(front_y(model, 4, 8.01)));
  const Shell shell = shell_of(model, {});
  CHECK(norm(shell.vector_area - Vec3{0, -72, 0}) < kRounding_m);  // all look along -Y
}

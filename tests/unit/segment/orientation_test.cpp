// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "segment/orientation.h"

#include <doctest/doctest.h>

#include <cmath>

#include "base/error.h"

using namespace jalon;

TEST_CASE("orientation_order__words_in_their_order_and_nothing_else") {
  const OrientationOrder order = orientation_order("  vertical, inclined;parallel ");
  REQUIRE(order.count == 3);
  CHECK(order.classes[0] == Orientation::kVertical);
  CHECK(order.classes[1] == Orientation::kInclined);
  CHECK(order.classes[2] == Orientation::kParallel);
  CHECK(orientation_order("").count == 0);
  CHECK(orientation_order(" ,; ").count == 0);
  CHECK(orientation_order("horizontal vertical parallel inclined").count == 4);
  for (const char* text : {"upright", "vertical vertical", "Vertical", "vertical horizontal none",
                           "horizontal vertical parallel inclined vertical"}) {
    CAPTURE(text);
    try {
      orientation_order(text);
      FAIL_CHECK("taken");
    } catch (const Error& error) {
      CHECK(error.status() == Status::kInvalidArgument);
    }
  }
}

TEST_CASE("facade_axes__horizontal_and_at_right_angles_whatever_leans") {
  for (const Vec3& normal : {Vec3{0, 1, 0}, Vec3{-0.6, 0.8, 0.1}, Vec3{3, 4, -1}}) {
    const FacadeAxes axes = FacadeAxes::of(normal);
    CHECK(axes.across.z == 0);
    CHECK(axes.along.z == 0);
    CHECK(norm(axes.across) == doctest::Approx(1));
    CHECK(dot(axes.across, axes.along) == doctest::Approx(0));
    CHECK(norm(cross(axes.across, axes.along) - Vec3{0, 0, 1}) < 1e-12);
    CHECK(dot(axes.across, normal) == doctest::Approx(std::hypot(normal.x, normal.y)));
  }
}

TEST_CASE("classify__within_the_tolerance_of_an_axis_in_either_sense_else_inclined") {
  const FacadeAxes axes = FacadeAxes::of({0.6, 0.8, 0});
  constexpr double kTolerance_rad = 0.0174533;
  for (const Orientation orientation :
       {Orientation::kParallel, Orientation::kVertical, Orientation::kHorizontal}) {
    const Vec3 axis = axes.axis(orientation);
    const Vec3 side = normalized(cross(axis, Vec3{0.3, -0.2, 0.4}));
    const auto turned = [&](double by_rad) {
      return std::cos(by_rad) * axis + std::sin(by_rad) * side;
    };
    CHECK(axes.classify(turned(0.9 * kTolerance_rad), kTolerance_rad) == orientation);
    CHECK(axes.classify(-turned(0.9 * kTolerance_rad), kTolerance_rad) == orientation);
    CHECK(axes.classify(turned(1.1 * kTolerance_rad), kTolerance_rad) == Orientation::kInclined);
  }
  CHECK(axes.classify(normalized(Vec3{1, 1, 1}), kTolerance_rad) == Orientation::kInclined);
  CHECK_THROWS_AS(axes.axis(Orientation::kInclined), Error);
  CHECK_THROWS_AS(axes.axis(Orientation::kNone), Error);
}

// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include <doctest/doctest.h>

#include <numeric>

#include "unit/cloud/clouds.h"

namespace jalon {
namespace {

using namespace test;

size_t ones(const std::vector<uint8_t>& mask) {
  return static_cast<size_t>(std::accumulate(mask.begin(), mask.end(), 0));
}

TEST_CASE("inside_box__closed_and_in_its_own_frame") {
  Task task;
  const Cloud cloud = cloud_of({{0, 0, 0}, {1, 1, 1}, {2, 0, 0}, {0.5, 1.0000001, 0.5}});
  const Box3 unit{{0, 0, 0}, {1, 1, 1}};
  CHECK(inside_box(cloud, unit, Transform(), task) == std::vector<uint8_t>{1, 1, 0, 0});
  // A quarter turn about z: world (x, y) = (1, -1) has box coordinates (1, 1).
  const Transform T_box_world{{0, -1, 0, 0, 1, 0, 0, 0, 0, 0, 1, 0}};
  CHECK(inside_box(cloud_of({{1, -1, 0}, {1, 1, 0}}), unit, T_box_world, task) ==
        std::vector<uint8_t>{1, 0});
}

TEST_CASE("inside_prism__an_L_swept_along_w") {
  Task task;
  const std::vector<Vec2> shape{{0, 0}, {2, 0}, {2, 1}, {1, 1}, {1, 2}, {0, 2}};
  const Cloud cloud =
      cloud_of({{0.5, 1.5, 0}, {1.5, 1.5, 0}, {1, 1.5, 1}, {0.5, 0.5, 1.1}, {1.5, 0.5, 0.5}});
  CHECK(inside_prism(cloud, shape, 0, 1, Transform(), task) == std::vector<uint8_t>{1, 0, 1, 0, 1});
  CHECK(status_of([&] {
          inside_prism(cloud, std::vector<Vec2>{{0, 0}, {1, 1}}, 0, 1, Transform(), task);
        }) == Status::kInvalidArgument);
}

TEST_CASE("inside_cylinder__share_of_a_box__is_pi_over_4") {
  Task task;
  const size_t n = 200000;
  const Cloud cloud = cloud_of(shifted(random_points(n, 2, 11), kFar));
  const auto mask = inside_cylinder(cloud, kFar + Vec3{1, 1, 0}, kFar + Vec3{1, 1, 2}, 1, task);
  const double share = static_cast<double>(ones(mask)) / static_cast<double>(n);
  CHECK(share == doctest::Approx(std::numbers::pi / 4).epsilon(0.01).scale(0));
  // Slanted axis: the ends are cut square to it.
  const Cloud three = cloud_of({{1, 1, 0}, {2, 2, 0}, {1, 1.4, 0}, {2.1, 2.1, 0}, {-0.1, -0.1, 0}});
  CHECK(inside_cylinder(three, {0, 0, 0}, {2, 2, 0}, 0.2, task) ==
        std::vector<uint8_t>{1, 1, 0, 0, 0});
  CHECK(status_of([&] {
          inside_cylinder(three, {0, 0, 0}, {0, 0, 0}, 1, task);
        }) == Status::kInvalidArgument);
  CHECK(status_of([&] {
          inside_cylinder(three, {0, 0, 0}, {0, 0, 1}, -1, task);
        }) == Status::kInvalidArgument);
}

}  // namespace
}  // namespace jalon

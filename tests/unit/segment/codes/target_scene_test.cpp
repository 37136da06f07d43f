// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "segment/codes/target_scene.h"

#include <doctest/doctest.h>

#include "unit/segment/codes/target_house.h"

using namespace jalon;
using namespace jalon::test;

TEST_CASE("target_scene__a_patch_has_the_free_points_within_its_radius_and_a_plane") {
  const TargetHouse house;
  const CloudPtr cloud = cloud_of(house.points);
  CodedObjects objects;
  const TargetCodeSettings settings;
  Task task;
  TargetScene scene(*cloud, objects, settings, task);
  CodedPoint target;
  target.position = {1.5, 0.12, 0.5};
  const std::vector<uint32_t> patch = patch_of(scene, target, false);
  CHECK(patch.size() > 15);
  for (const uint32_t i : patch) CHECK(norm(scene.local(i) - target.position) <= 0.05);
  const auto plane = plane_of(scene, patch);
  REQUIRE(plane.has_value());
  CHECK(std::fabs(plane->normal.y) == doctest::Approx(1));
  scene.owner[patch[0]] = 1;
  CHECK(patch_of(scene, target, false).size() == patch.size() - 1);
  CHECK(patch_of(scene, target, true).size() == patch.size());
  CHECK(!plane_of(scene, {patch[0], patch[1]}).has_value());
  CHECK(free_points(
            scene, [](const Vec3&) { return true; }, task)
            .size() == cloud->size() - 1);
  const auto is_patch = [&](const Vec3& p) { return norm(p - target.position) <= 0.05; };
  CHECK(free_about(scene, {1.5, 0.12}, 0.05, is_patch).size() == patch.size() - 1);
}

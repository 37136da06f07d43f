// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include <doctest/doctest.h>

#include <numbers>

#include "base/error.h"
#include "scan/builder/scene_frame.h"

using namespace jalon;

TEST_CASE("scene_frame__adds_the_turns_and_the_shifts_of_scene_and_caller") {
  SceneSettings settings;
  CHECK(scene_frame(settings).point({1, 2, 3}) == Vec3{1, 2, 3});
  settings.rotation_rad = std::numbers::pi / 6;
  settings.shift_m = {10, 20, 30};
  const Transform T = scene_frame(settings, std::numbers::pi / 3, {1, 2, 3});
  CHECK(norm(T.point({1, 0, 0}) - Vec3{11, 23, 33}) < 1e-12);
  CHECK(norm(T.direction({0, 1, 0}) - Vec3{-1, 0, 0}) < 1e-12);
  settings.shift_m = {1, 2};
  CHECK_THROWS_AS(scene_frame(settings), Error);
}

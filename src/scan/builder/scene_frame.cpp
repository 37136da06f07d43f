// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "scan/builder/scene_frame.h"

#include <cmath>

#include "base/error.h"

namespace jalon {

Transform scene_frame(const SceneSettings& settings, double angle_rad, const Vec3& own_shift) {
  const double angle = settings.rotation_rad + angle_rad;
  const auto& shift = settings.shift_m;
  if (shift.size() != 3) fail(Status::kInvalidArgument, "shift_m takes three numbers");
  Transform T_world_scene;
  if (angle != 0) {
    const double c = std::cos(angle), s = std::sin(angle);
    T_world_scene.m = {c, -s, 0, 0, s, c, 0, 0, 0, 0, 1, 0};
  }
  for (int a = 0; a < 3; ++a)
    T_world_scene.m[static_cast<size_t>(4 * a + 3)] = own_shift[a] + shift[static_cast<size_t>(a)];
  return T_world_scene;
}

}  // namespace jalon

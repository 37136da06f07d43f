// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "scan/scene.h"

namespace jalon {

/// T_world_scene: the turn and the shift that a scene has of its own, and those asked for. Throws kInvalidArgument
/// unless the shift has three numbers.
Transform scene_frame(const SceneSettings& settings, double angle_rad = 0, const Vec3& shift = {});

}  // namespace jalon

// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "registration/joint/strip_scene.h"

namespace jalon {

/// Where points and walls do not come together: what may be wrong, as the end of an error's line, by where the walls
/// stand in plan and how far they reach. "" where neither is plain to see.
std::string apart_hint(const std::vector<Vec3>& points, const StripScene& scene);

}  // namespace jalon

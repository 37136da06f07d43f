// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "cloud/cloud.h"
#include "compare/landslide/settings.h"
#include "compare/volumes/volume_grid.h"

namespace jalon {

/// The cells that both epochs of a slope share: across the direction asked for, else upward, or across the ground as a
/// whole where that is steeper than 45 degrees, then with level columns.
VolumeGrid ground_grid(const Cloud& reference, const Cloud& compared,
                       const LandslideSettings& settings, Task& task);
/// Axes of a grid along this direction, of any length: u level where the direction is not upright.
VolumeGrid ground_axes(const Vec3& direction);

}  // namespace jalon

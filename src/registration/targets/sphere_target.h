// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "registration/targets/measure.h"

namespace jalon {

/// 1. Start by random draws around the place; 2. the points around the sphere, wherever the place was; 3. adjustment
/// with Tukey's biweight, with or without the radius, and what noise along the rays does to it taken off; 4. refused
/// when the points show too small a cap: a wall touches any sphere.
MeasuredTarget measure_sphere(const Cloud& cloud, const Octree& tree, const Vec3& place,
                              const MeasuringSettings& setting, Task& task);

}  // namespace jalon

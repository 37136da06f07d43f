// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "registration/targets/measure.h"

namespace jalon {

/// 1. Start by random draws around the place.
/// 2. The points around the sphere, wherever the place was.
/// 3. Adjustment with Tukey's biweight, with or without the radius, and what noise along the rays
///    does to it taken off.
/// 4. Refused when the points show too small a cap: a wall touches any sphere.
///
/// Before: a finite place. After: a centre relative to the place where status is kOk, else only how
/// many points there were; the radius as given, of sigma 0, where it is known. Same bits for the
/// same seed.
MeasuredTarget measure_sphere(const Cloud& cloud, const Octree& tree, const Vec3& place,
                              const MeasuringSettings& setting, Task& task);

}  // namespace jalon

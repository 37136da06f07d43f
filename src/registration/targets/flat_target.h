// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "registration/targets/measure.h"

namespace jalon {

/// 1. Plane through the points around the place, by random draws and Tukey's biweight.
/// 2. Centre in the plane from the pattern that the intensities show, or of the plate.
/// 3. Covariance: of the pattern across, of the plane along its normal.
///
/// Before: a finite place, size_m above 0. After: a centre relative to the place where status is
/// kOk, else only how many points there were. Same bits for the same seed.
MeasuredTarget measure_flat(const Cloud& cloud, const Octree& tree, const Vec3& place,
                            const MeasuringSettings& setting, Task& task);

}  // namespace jalon

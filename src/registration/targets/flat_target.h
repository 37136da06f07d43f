// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "registration/targets/measure.h"

namespace jalon {

/// 1. Plane through the points around the place, by random draws and Tukey's biweight; 2. centre in the plane from the
/// pattern that the intensities show, or of the plate; 3. covariance: of the pattern across, of the plane along its
/// normal.
MeasuredTarget measure_flat(const Cloud& cloud, const Octree& tree, const Vec3& place,
                            const MeasuringSettings& setting, Task& task);

}  // namespace jalon

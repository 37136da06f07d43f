// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "base/task.h"
#include "cloud/cloud.h"
#include "model/model.h"
#include "model/trajectory/ellipsoids.h"

namespace jalon {

/// Ellipsoids of the points' field "covariance" (6 numbers a point: xx, xy, xz, yy, yz, zz, or 9
/// row-major; m2), one every so many points, as a mesh; a triangle's id is its point's index.
/// Error(kNotFound) without the field. Points whose covariance is not finite are passed over.
Model cloud_ellipsoids(const Cloud& cloud, const EllipsoidSettings& settings, Task& task);

}  // namespace jalon

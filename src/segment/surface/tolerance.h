// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "base/task.h"
#include "cloud/cloud.h"
#include "segment/ransac_settings.h"
#include "spatial/octree/octree.h"

namespace jalon {

/// Half-thickness that keeps this share of the points of a plane whose noise is sigma: sqrt(F^-1(probability)) sigma, F
/// the chi-square distribution (Boulaassal 2010, 3.19; Hartley & Zisserman 2003, 4.7.1). One degree of freedom is that
/// of the distance to a plane; 3.21 takes two.
double tolerance_of_sigma(double sigma_m, double probability, int dof);

/// Standard deviation of the points across their surfaces: the median over a sample of the cloud of the spread about
/// the least-squares plane of the k nearest points, k large enough that the noise does not turn the plane.
double estimate_sigma(const Cloud& cloud, const Octree& tree, Task& task);

/// What a run works with, as tolerance_from says.
struct Tolerance {
  double distance_tolerance_m = 0, sigma_m = 0;
};
Tolerance tolerance_of(const Cloud& cloud, const Octree& tree, const RansacSettings& settings,
                       Task& task);

}  // namespace jalon

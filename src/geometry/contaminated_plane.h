// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <vector>

#include "base/task.h"
#include "geometry/plane.h"

namespace jalon {

/// A point seen from a plane: u and v along its axes from its centroid, d across.
struct PlaneSample {
  float u, v, d;
  uint32_t zone;  ///< 0: near the border, where other surfaces meet this one; 1: away from it
};

/// Settles a plane among points of which some, mostly near its border, belong to surfaces that meet it: maximum
/// likelihood of a normal distribution with one-sided even ones (see Contamination), the shares of each zone by their
/// own, as MLESAC mixes its outliers (Torr & Zisserman 2000). Zones of a few points are joined. Where all points are
/// the plane's own this is least squares. fit: the start, from which the samples are taken; its
/// plane, axes, centroid and covariance are replaced,
/// the covariance by that of an estimate under noise that differs from point to point (White 1982, theorem 3.2).
/// False, and fit as it was, when the points do not tell the plane from what meets it.
bool settle_contaminated_plane(std::vector<PlaneSample>& samples, double tolerance_m, Task& task,
                               PlaneFit& fit);

}  // namespace jalon

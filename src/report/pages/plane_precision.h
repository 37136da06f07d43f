// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "base/task.h"
#include "report/names/notes.h"
#include "segment/labels/propagated_planes.h"
#include "segment/segmentation.h"

namespace jalon {

/// What a report tells of a plane's precision, from its least-squares adjustment.
struct PlanePrecision {
  double sigma_normal_rad = 0;  ///< in the direction in which the normal is least certain
  double sigma_offset_m = 0;    ///< of the plane's place at the middle of its points
};
PlanePrecision plane_precision(const PlaneFit& fit);

/// What the scanner's precision makes of the planes, one a segment; empty when the notes do not tell it. Throws
/// kInvalidArgument when a point has no station.
std::vector<PropagatedPlane> scanner_planes(const Segmentation& segmentation, const Notes& notes,
                                            Task& task);

}  // namespace jalon

// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "base/task.h"
#include "segment/segmentation.h"

namespace jalon {

/// The same segmentation with the pieces of each wall (piers, bands between shop fronts, what canopies part) as one
/// segment: upright planes whose points lie on the plane of a larger one, whatever gap lies between them.
///
/// tolerance_m: this near to a plane, or within four of its sigmas, points lie on it. After: labels, orientations and
/// residuals as given but for the pieces, whose points carry the label of the largest piece; it keeps its fit, and
/// number of points and area are those of all. The others stay as segments without points and plane, so that labels
/// keep their meaning. The order of the points plays no part but in which of them are looked at. O(upright planes^2).
Segmentation with_whole_walls(const Segmentation& segmentation, double tolerance_m, Task& task);

}  // namespace jalon

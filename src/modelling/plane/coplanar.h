// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <vector>

#include "base/task.h"
#include "segment/segmentation.h"

namespace jalon {

/// Of each segment the label of the one that it is a piece of, by index; its own where it is none. Pieces of a wall
/// (piers, bands between shop fronts, what canopies part) are upright planes whose points lie on the plane of a larger
/// one, whatever gap lies between them.
///
/// tolerance_m: this near to a plane, or within four of its sigmas, points lie on it. The order of the points plays no
/// part but in which of them are looked at. O(upright planes^2).
std::vector<uint32_t> whole_walls(const Segmentation& segmentation, double tolerance_m, Task& task);

/// The same segmentation with the pieces of each wall as one segment.
///
/// whole: by index the label of the segment that each one is a piece of, which is a piece of itself. After: labels,
/// orientations and residuals as given but for the pieces, whose points carry the label of what they are pieces of; it
/// keeps its fit, and number of points and area are those of all. The others stay as segments without points and
/// plane, so that labels keep their meaning.
Segmentation joined_pieces(const Segmentation& segmentation, const std::vector<uint32_t>& whole,
                           Task& task);

}  // namespace jalon

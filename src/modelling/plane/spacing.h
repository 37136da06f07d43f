// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>

#include "base/task.h"
#include "geometry/vec.h"

namespace jalon {

/// Typical spacing: sqrt of the area a point, from the distance of the 8th neighbour of up to 1000 sampled points; the
/// upper quartile of them, so that the sparser parts of the segment count. 0 for fewer than 9 points or when all are
/// equal.
double typical_spacing(std::span<const Vec2> points, Task& task);

/// The nearest of lengths that stand an eighth of an octave apart (9 %). A typical spacing comes from a sample: of the
/// same points jittered by a tenth of a millimetre, or parted otherwise, it differs by half a per cent, and over a wall
/// of 170 cells that is a cell. Rasters and limits taken from such a length are the same for clouds that are the same.
double stepped_length(double length_m);

}  // namespace jalon

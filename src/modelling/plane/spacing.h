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

}  // namespace jalon

// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "base/field.h"
#include "base/task.h"
#include "spatial/octree/octree.h"

namespace jalon {

/// Directed Hausdorff distance (Girardeau-Montaut 2006, 2.2): the largest distance of a point of from to its nearest
/// one of to. Both must have points.
double directed_hausdorff(const Octree& from, const Octree& to, Task& task);
/// Adds "hausdorff_forward" (from the compared points to the reference), "hausdorff_reverse" and the larger of both,
/// "hausdorff" (2.3).
void add_hausdorff(const Octree& reference, const Octree& compared, Task& task,
                   FieldTable& summary);

}  // namespace jalon

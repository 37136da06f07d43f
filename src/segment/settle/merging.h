// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "segment/ransac/extraction.h"

namespace jalon {

/// Joins surfaces that one plane fits as well as their own and that come within merge_gap_m of each other, so that a
/// wall comes out once.
void merge_coplanar(const SegmentScene& scene, std::vector<Surface>& surfaces, Task& task);

/// Joins surfaces that lie one over the other within the tolerance, once the points are shared out: those that noise
/// put farthest off a small plane may have made a second one. True when there were such.
bool merge_layers(const SegmentScene& scene, std::vector<Surface>& surfaces, Task& task);

}  // namespace jalon

// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "segment/extraction.h"

namespace jalon {

/// Joins surfaces that one plane fits as well as their own and that come within merge_gap_m of each other, so that a
/// wall comes out once.
void merge_coplanar(const SegmentScene& scene, std::vector<Surface>& surfaces, Task& task);

}  // namespace jalon

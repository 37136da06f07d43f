// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <utility>
#include <vector>

#include "compare/changes/change_objects.h"

namespace jalon {

/// Labels of two regions of an epoch, the lesser first.
using RegionPair = std::pair<uint32_t, uint32_t>;

/// Regions of an epoch that are parts of one surface: side by side in a station's view, nothing unchanged between, and
/// in one plane: that of the points about most places where they meet, or that of one of the regions, when it is flat
/// and more points of the other lie in it than chance would leave there. A surface that rays graze has metres between
/// one row of points and the next, more than any distance that connects points elsewhere; for the scanner they are
/// neighbours. Ascending; none without stations. O(points of the cloud).
std::vector<RegionPair> parts_of_one_surface(const Epoch& epoch, Task& task);

}  // namespace jalon

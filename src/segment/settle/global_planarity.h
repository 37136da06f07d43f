// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "segment/ransac/extraction.h"

namespace jalon {

/// Parts surfaces that hold several planes (under-segmentation) and shares their points out among those, in turns of
/// assignment and fit. Surfaces of one plane and its noise stay as they are; a bent one becomes several. Without a
/// surface to part nothing changes, no bit.
void refine_global_planarity(SegmentScene& scene, std::vector<Surface>& surfaces, Task& task);

}  // namespace jalon

// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "segment/ransac/extraction.h"

namespace jalon {

/// Once the points are shared out: what held two surfaces of one plane together may have gone to a plane that crosses
/// them, as the strip of a front along the soffits of its windows. Parts farther from the others than connectivity and
/// merging bridge become surfaces of their own, at the end of the list; those too small for a segment are set free.
/// True when there were such.
bool split_surfaces(SegmentScene& scene, std::vector<Surface>& surfaces, Task& task);

}  // namespace jalon

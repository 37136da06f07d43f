// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "segment/ransac/extraction.h"

namespace jalon {

/// Drops planes that a line of points spans where the points around it lie in another plane, and sets their points
/// free. A beam of a spinning head draws such lines: the level one lies in one plane whatever walls it meets, and where
/// it is dense its neighbours are all its own. A strip wider than noise stays where the cloud itself is not of lines.
/// Of each plane some tens of points are asked.
void drop_planes_of_lines(SegmentScene& scene, std::vector<Surface>& surfaces, Task& task);

}  // namespace jalon

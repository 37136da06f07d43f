// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "segment/hough_settings.h"
#include "segment/ransac/extraction.h"

namespace jalon {

/// Planes from the accumulator's peaks, the highest first: the voters of a peak give a plane by least squares, which is
/// followed over the points as those of "ransac" are; its voters are taken back. Then the points left vote anew, until
/// a round gives none. Their points are marked in scene.owner with 1, 2 ...
std::vector<Surface> surfaces_of_peaks(RansacScene& scene, const HoughSettings& settings,
                                       Task& task);

}  // namespace jalon

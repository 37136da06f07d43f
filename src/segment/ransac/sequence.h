// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "segment/ransac/extraction.h"

namespace jalon {

/// Planes one after the other, the best first, until the probability of having missed one of min_points falls below 1
/// - probability (Boulaassal 2010, 3.4.4; Schnabel et al. 2007, 4). Surface s owns the points with scene.owner = s +
/// 1.
std::vector<Surface> extract_sequence(RansacScene& scene, Task& task);

}  // namespace jalon

// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "cloud/cloud.h"

namespace jalon {

/// How much each point looks like one of a vertical wall, 0 ... 1: planarity times verticality in the neighbourhood
/// that is most of one kind, the one of least entropy of (linearity, planarity, sphericity) among the 10, 14, 20, 28,
/// 40, 56 and 80 nearest (Demantke et al. 2011; Monnier 2014 takes what is above 0.8). 0 where there are fewer points
/// than 10 or all lie on a line. Wants points spread about as densely along the drive as across: thin them first.
/// O(n log n), parallel.
struct FacadeScore {
  float score = 0;
  Vec2 normal;  ///< level part of the neighbourhood's, of either sign, unit; 0 where there is none
};
std::vector<FacadeScore> facade_scores(const Cloud& cloud, Task& task);

}  // namespace jalon

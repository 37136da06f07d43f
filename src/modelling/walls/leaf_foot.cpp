// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "modelling/walls/leaf_foot.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <vector>

namespace jalon {

namespace {

// Stiles go on from head to foot, so that a leaf's points never stop for long; a step or a wheel hides less than this.
constexpr double kGoesOn_m = 0.3;
constexpr double kLeafStrays = 0.02;  // of its points, lower than its foot

}  // namespace

double leaf_foot(const HoleSurvey& notch, uint32_t label, const VectorRing& outline) {
  const double border_v = std::min(outline.corners[0].v, outline.corners[1].v);
  std::vector<double> heights;
  for (const HolePoint& p : notch.points)
    if (p.label == label) heights.push_back(p.v);
  std::sort(heights.begin(), heights.end(), std::greater<>());
  // From the feet down; what is above them may be glass.
  auto last = std::upper_bound(heights.begin(), heights.end(), border_v, std::greater<>());
  if (last == heights.begin() || *(last - 1) > border_v + kGoesOn_m) return INFINITY;
  double foot = border_v;
  for (; last != heights.end() && foot - *last <= kGoesOn_m; ++last) foot = *last;
  const auto strays =
      static_cast<ptrdiff_t>(kLeafStrays * static_cast<double>(last - heights.begin()));
  return *(last - 1 - strays);
}

}  // namespace jalon

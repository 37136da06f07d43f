// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "segment/surface/near_most.h"

#include <algorithm>
#include <vector>

#include "spatial/quantile.h"

namespace jalon {

namespace {

// Tukey 1977: what lies beyond the outer fences is far out.
constexpr double kQuartile = 0.25, kOuterFences = 3;

}  // namespace

Box3 box_near_most(std::span<const Vec3> points) {
  Box3 box;
  double widest = 0;  // a floor with most points has quartiles of its noise
  std::vector<double> values(points.size());
  for (int k = 0; k < 3; ++k) {
    for (size_t i = 0; i < points.size(); ++i) values[i] = points[i][k];
    box.min[k] = quantile_of(values, kQuartile);
    box.max[k] = quantile_of(values, 1 - kQuartile);
    widest = std::max(widest, box.max[k] - box.min[k]);
  }
  for (int k = 0; k < 3; ++k) {
    box.min[k] -= kOuterFences * widest;
    box.max[k] += kOuterFences * widest;
  }
  return box;
}

}  // namespace jalon

// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "segment/surface/plane_kernel.h"

#include <cmath>

#include "segment/surface/plane_kernel.inc"

namespace jalon {

uint32_t count_block_baseline(const PointColumns& points, const PlaneTest& test) {
  return count_block(points, test);
}

uint32_t mark_block(const PointColumns& points, const PlaneTest& t,
                    uint32_t mask[kBlockPoints / 32]) {
  uint32_t sum = 0;
  for (size_t word = 0; word < kBlockPoints / 32; ++word) {
    uint32_t bits = 0;
    for (size_t k = 0; k < 32; ++k) {
      const size_t i = 32 * word + k;
      const float distance =
          points.x[i] * t.nx + points.y[i] * t.ny + points.z[i] * t.nz - t.offset;
      const float cosine = points.nx[i] * t.nx + points.ny[i] * t.ny + points.nz[i] * t.nz;
      const bool inlier = std::fabs(distance) <= t.tolerance && !(std::fabs(cosine) < t.min_cosine);
      bits |= static_cast<uint32_t>(inlier) << k;
      sum += inlier;
    }
    mask[word] = bits;
  }
  return sum;
}

}  // namespace jalon

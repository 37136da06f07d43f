// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "segment/ransac/curved_kernel.h"

#include "segment/ransac/curved_kernel.inc"

namespace jalon {

uint32_t count_curved_baseline(const PointColumns& points, const CurvedTest& test) {
  return count_curved(points, test);
}

uint32_t mark_curved(const PointColumns& points, const CurvedTest& t,
                     uint32_t mask[kBlockPoints / 32]) {
  uint32_t sum = 0;
  for (size_t word = 0; word < kBlockPoints / 32; ++word) {
    uint32_t bits = 0;
    for (size_t k = 0; k < 32; ++k) {
      const size_t i = 32 * word + k;
      float x = points.x[i] - t.cx, y = points.y[i] - t.cy, z = points.z[i] - t.cz;
      const float along = x * t.ax + y * t.ay + z * t.az;
      x -= along * t.ax;
      y -= along * t.ay;
      z -= along * t.az;
      const float squared = x * x + y * y + z * z;
      const float cosine = points.nx[i] * x + points.ny[i] * y + points.nz[i] * z;
      const bool inlier =
          squared >= t.inner2 && squared <= t.outer2 && !(cosine * cosine < t.cosine2 * squared);
      bits |= static_cast<uint32_t>(inlier) << k;
      sum += inlier;
    }
    mask[word] = bits;
  }
  return sum;
}

}  // namespace jalon

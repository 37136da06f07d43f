// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include <doctest/doctest.h>

#include <bit>
#include <cmath>

#include "base/random.h"
#include "base/simd.h"
#include "segment/ransac/curved_kernel.h"
#include "unit/segment/point_block.h"

using namespace jalon;

namespace {

// The definition, in double precision; `near` tells when single precision may decide otherwise.
bool inlier(const PointColumns& points, const CurvedTest& t, size_t i, bool& near) {
  double d[3] = {double{points.x[i]} - t.cx, double{points.y[i]} - t.cy,
                 double{points.z[i]} - t.cz};
  const double along = d[0] * t.ax + d[1] * t.ay + d[2] * t.az;
  d[0] -= along * t.ax, d[1] -= along * t.ay, d[2] -= along * t.az;
  const double squared = d[0] * d[0] + d[1] * d[1] + d[2] * d[2];
  const double cosine = points.nx[i] * d[0] + points.ny[i] * d[1] + points.nz[i] * d[2];
  constexpr double kClose = 1e-5;
  near = std::fabs(squared - t.inner2) < kClose || std::fabs(squared - t.outer2) < kClose ||
         std::fabs(cosine * cosine - t.cosine2 * squared) < kClose;
  return squared >= t.inner2 && squared <= t.outer2 && !(cosine * cosine < t.cosine2 * squared);
}

}  // namespace

TEST_CASE("curved_kernel__all_forms__agree_with_the_definition_point_by_point") {
  RandomStream random(6, 0);
  uint32_t counted = 0;
  for (int round = 0; round < 200; ++round) {
    const test::PointBlock block(random);
    const PointColumns points = block.points();
    const bool sphere = round % 2 == 0;
    const CurvedTest test{0.1f,
                          -0.2f,
                          0.3f,
                          sphere ? 0 : 0.6f,
                          sphere ? 0 : -0.48f,
                          sphere ? 0 : 0.64f,
                          0.25f,
                          0.64f,
                          round % 3 ? 0.2f : 0.0f};
    uint32_t mask[kBlockPoints / 32];
    const uint32_t marked = mark_curved(points, test, mask);
    CHECK(count_curved_baseline(points, test) == marked);
    if (use_avx2()) CHECK(count_curved_avx2(points, test) == marked);
    uint32_t bits = 0;
    for (size_t i = 0; i < kBlockPoints; ++i) {
      const bool set = (mask[i / 32] >> (i % 32) & 1) != 0;
      bits += set;
      bool near = false;
      const bool expected = inlier(points, test, i, near);
      if (!near) CHECK(set == expected);
    }
    CHECK(bits == marked);
    CHECK((mask[0] & 1) == 0);
    counted += marked;
  }
  CHECK(counted > 1000);
}

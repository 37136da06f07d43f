// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include <doctest/doctest.h>

#include <bit>
#include <cmath>

#include "base/random.h"
#include "base/simd.h"
#include "segment/surface/plane_kernel.h"
#include "unit/segment/point_block.h"

using namespace jalon;

TEST_CASE("all forms of the counting loop agree with the definition, point by point") {
  RandomStream random(5, 0);
  for (int round = 0; round < 200; ++round) {
    const test::PointBlock block(random);
    const PointColumns points = block.points();
    const PlaneTest test{0.6f, -0.48f, 0.64f, 0.1f, 0.3f, round % 2 ? 0.5f : 0.0f};
    uint32_t expected = 0;
    for (size_t i = 0; i < kBlockPoints; ++i) {
      const float d =
          points.x[i] * test.nx + points.y[i] * test.ny + points.z[i] * test.nz - test.offset;
      const float c = points.nx[i] * test.nx + points.ny[i] * test.ny + points.nz[i] * test.nz;
      expected +=
          std::fabs(d) <= test.tolerance && (std::isnan(c) || std::fabs(c) >= test.min_cosine);
    }
    uint32_t mask[kBlockPoints / 32];
    CHECK(count_block_baseline(points, test) == expected);
    if (use_avx2()) CHECK(count_block_avx2(points, test) == expected);
    CHECK(mark_block(points, test, mask) == expected);
    uint32_t bits = 0;
    for (const uint32_t word : mask) bits += static_cast<uint32_t>(std::popcount(word));
    CHECK(bits == expected);
    CHECK((mask[0] & 1) == 0);
  }
}

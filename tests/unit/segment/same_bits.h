// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <doctest/doctest.h>

#include <bit>
#include <cmath>
#include <cstring>
#include <vector>

#include "segment/segmentation.h"

namespace jalon::test {

inline bool same_bytes(const ColumnPtr& a, const ColumnPtr& b) {
  return a->bytes() == b->bytes() && std::memcmp(a->raw(), b->raw(), a->bytes()) == 0;
}

/// Same labels, residuals and fits, bit by bit; world coordinates (centroid, offset) are left out when shifted.
inline void check_same(const Segmentation& a, const Segmentation& b, bool shifted) {
  CHECK(same_bytes(a.labels, b.labels));
  CHECK(same_bytes(a.residuals, b.residuals));
  CHECK(same_bytes(a.orientations, b.orientations));
  REQUIRE(a.segments.size() == b.segments.size());
  for (size_t i = 0; i < a.segments.size(); ++i) {
    const Segment &s = a.segments[i], &t = b.segments[i];
    CHECK(s.fit.plane.normal == t.fit.plane.normal);
    CHECK(s.fit.axis_u == t.fit.axis_u);
    CHECK(s.fit.sigma == t.fit.sigma);
    CHECK(s.area_m2 == t.area_m2);
    CHECK(std::bit_cast<uint64_t>(s.length_u_m) ==
          std::bit_cast<uint64_t>(t.length_u_m));  // NaN for spheres
    if (shifted) continue;
    CHECK(s.fit.centroid == t.fit.centroid);
    CHECK(s.fit.plane.offset == t.fit.plane.offset);
    CHECK(s.fit.covariance == t.fit.covariance);
  }
}

/// Coordinates that a shift by whole metres leaves exact.
inline std::vector<Vec3> snapped(std::vector<Vec3> points) {
  for (Vec3& p : points)
    for (int k = 0; k < 3; ++k) p[k] = std::round(p[k] * 0x1p20) * 0x1p-20;
  return points;
}

}  // namespace jalon::test

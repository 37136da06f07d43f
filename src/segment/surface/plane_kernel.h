// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>

namespace jalon {

/// Points of the counting loops, component by component. A removed point has x = NaN and is near no plane; a point
/// without a normal has a NaN normal and is consistent with every plane.
struct PointColumns {
  const float *x, *y, *z, *nx, *ny, *nz;
};

/// A plane with its inlier test: |n . p - offset| <= tolerance and not |n . normal| < min_cosine.
struct PlaneTest {
  float nx, ny, nz, offset, tolerance, min_cosine;
};

constexpr size_t kBlockPoints =
    128;  ///< points that share a bounding box; a multiple of every vector length

/// Number of inliers in one block. All forms do the same single-precision operations in the same order.
uint32_t count_block_baseline(const PointColumns& points, const PlaneTest& test);
uint32_t count_block_avx2(const PointColumns& points, const PlaneTest& test);
/// The same; bit i % 32 of mask[i / 32] tells whether point i is an inlier.
uint32_t mark_block(const PointColumns& points, const PlaneTest& test,
                    uint32_t mask[kBlockPoints / 32]);

}  // namespace jalon

// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "segment/surface/plane_kernel.h"

namespace jalon {

/// A sphere (axis 0) or a cylinder with its inlier test. With d from the centre or the axis to the point: inner2 <= d
/// . d <= outer2, the squares of radius -+ tolerance, and not (n . d)^2 < cosine2 d . d.
struct CurvedTest {
  float cx, cy, cz, ax, ay, az, inner2, outer2, cosine2;
};

/// Number of inliers in one block. All forms do the same single-precision operations in the same order.
uint32_t count_curved_baseline(const PointColumns& points, const CurvedTest& test);
uint32_t count_curved_avx2(const PointColumns& points, const CurvedTest& test);
/// The same; bit i % 32 of mask[i / 32] tells whether point i is an inlier.
uint32_t mark_curved(const PointColumns& points, const CurvedTest& test,
                     uint32_t mask[kBlockPoints / 32]);

}  // namespace jalon

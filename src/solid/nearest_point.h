// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "geometry/vec.h"

namespace jalon {

/// The point of a triangle (any, also without area) that is nearest to p: its foot where that lies
/// inside, else the nearest of its three edges (Ericson 2005, Real-Time Collision Detection, 5.1).
Vec3 nearest_on_triangle(const Vec3& p, const Vec3& a, const Vec3& b, const Vec3& c);

}  // namespace jalon

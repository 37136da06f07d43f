// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>

#include "geometry/vec.h"

namespace jalon {

/// The axis that a direction is nearest to, of either sign: 0, 1 or 2; the first of equally near ones.
inline int nearest_axis(const Vec3& direction) {
  const double x = std::abs(direction.x), y = std::abs(direction.y), z = std::abs(direction.z);
  return x >= y && x >= z ? 0 : y >= z ? 1 : 2;
}

}  // namespace jalon

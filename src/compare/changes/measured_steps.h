// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>

#include "compare/comparison.h"

namespace jalon {

/// From the foot of a point's distance to the point: told by the columns difference_x, _y, _z, by the nearest point of
/// the reference, by the normal of an M3C2 core point; else the distance is laid along a direction of the caller's.
class MeasuredSteps {
 public:
  /// reference: of the comparison, may be null. Both must outlive this.
  MeasuredSteps(const Comparison& comparison, const Cloud* reference);
  /// NaN for a point without a distance.
  Vec3 of(uint32_t point, const Vec3& otherwise_along) const;

 private:
  const Comparison& comparison_;
  const Cloud* reference_;
  std::span<const double> distance_;
  std::array<std::span<const double>, 3> difference_;  ///< empty ones where the comparison has none
  std::span<const uint32_t> nearest_;
  std::span<const double> normal_;
};

}  // namespace jalon

// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <string_view>

#include "geometry/vec.h"

namespace jalon {

/// Orientation classes relative to the main facade (Boulaassal 2010, 3.4.5.2); the numbers of jalon/segmenter.h.
enum class Orientation : uint8_t {
  kNone = 0,
  kParallel = 1,
  kVertical = 2,
  kHorizontal = 3,
  kInclined = 4
};

/// Classes in the order in which their planes are extracted.
struct OrientationOrder {
  std::array<Orientation, 4> classes{};
  uint32_t count = 0;
};
/// From "vertical horizontal inclined parallel" or any part or permutation of it; "" is an empty order. Throws
/// kInvalidArgument on another or a repeated word.
OrientationOrder orientation_order(std::string_view text);

/// The horizontal directions across and along the main facade.
struct FacadeAxes {
  Vec3 across{0, 1, 0}, along{-1, 0, 0};

  /// From the facade's normal, which need not be quite horizontal.
  static FacadeAxes of(const Vec3& normal);
  /// Class of a plane by its normal: parallel, vertical, horizontal when within the tolerance, else inclined
  /// (3.22-3.25).
  Orientation classify(const Vec3& normal, double tolerance_rad) const;
  /// The direction that normals of the class have; not for kInclined and kNone.
  Vec3 axis(Orientation orientation) const;
};

}  // namespace jalon

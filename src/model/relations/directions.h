// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>

#include "geometry/vec.h"
#include "model/model.h"

namespace jalon {

/// Axes of somebody who stands before a facade and looks at it.
struct ViewAxes {
  Vec3 right{1, 0, 0}, up{0, 1, 0}, out{0, 0, 1};

  /// Right, up and out of the facade.
  Vec3 seen(const Vec3& p) const { return {dot(p, right), dot(p, up), dot(p, out)}; }
};

/// Those of an upright plane that looks along `normal`: up is up, and out is level.
ViewAxes axes_before(const Vec3& normal);

/// Where something lies from something else; the numbers of jalon/model.h.
enum DirectionBit : uint8_t {
  kLeft = 1,
  kRight = 2,
  kBelow = 4,
  kAbove = 8,
  kBehind = 16,
  kBefore = 32
};

/// Bits of the directions in which the whole of `other` lies beyond the whole of `from`, by their boxes in facade axes
/// (projection-based directions, Frank 1996). Boxes that reach into each other by no more than tolerance are apart.
uint8_t directions(const Box3& from, const Box3& other, double tolerance);

}  // namespace jalon

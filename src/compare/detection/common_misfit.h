// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>

#include "base/task.h"
#include "geometry/vec.h"

namespace jalon {

/// How far the other epoch's surface lies off one, along its normal, and how well that is known.
struct SurfaceOffset {
  Vec3 place, normal;
  double offset_m = 0, sigma_m = 0;
};

/// A small rigid motion of all of one epoch.
struct CommonMisfit {
  Vec3 about, shift_m, turn_rad;
  /// What it makes of the offset of a surface there.
  double offset_m(const Vec3& place, const Vec3& normal) const {
    return dot(normal, shift_m + cross(turn_rad, place - about));
  }
};

/// The rigid motion that explains most of what the surfaces are off by: least absolute deviations in units of each
/// one's sigma, so that the well known ones tell it, however many rough ones there are, and what really changed has no
/// more say than any other (Koenker & Bassett 1978). None where it explains no more than noise lets one: by the
/// likelihood ratio of Koenker & Machado (1999).
CommonMisfit common_misfit(std::span<const SurfaceOffset> surfaces, Task& task);

}  // namespace jalon

// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <vector>

namespace jalon {

/// A point whose ray meets a strip.
struct MetPoint {
  uint32_t number = 0;    ///< the caller's
  double distance_m = 0;  ///< of the strip's plane, positive in front
  double height_m = 0;
  /// How much the beam climbs for each metre that it comes nearer to the plane.
  double climb = 0;
  bool is_accepted = true;  ///< else it only tells where beams went through
};

/// The points that stand on the strip's wall, among those that are accepted: of the surfaces that they stand on, one
/// behind the other, the one with most points that no beams pass over. A thing before a wall (a van, a hoarding) ends
/// below the eaves, and beams that go over it cross its plane within the strip; a wall fills its strip up to the top.
/// Empty where beams pass over all of them: what is seen is no wall. O(n log n).
std::vector<MetPoint> points_of_wall(std::vector<MetPoint> points);

}  // namespace jalon

// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <vector>

#include "base/task.h"
#include "solid/surface.h"

namespace jalon {

/// A triangle of the first surface and the nearest one of the second.
struct NearTriangle {
  uint32_t first = 0, second = 0;
  double distance_m = 0;  ///< 0 where they meet
  Vec3 first_point, second_point;
};

struct PairClearance {
  NearTriangle least;
  std::vector<NearTriangle>
      near;            ///< triangles of the first within the margin of the second, by index
  bool meet = false;   ///< the surfaces meet, or one lies in the other
  double depth_m = 0;  ///< how deep a point of either lies in the other; NaN: neither is closed
  Vec3 deepest, deepest_foot;  ///< that point, and the nearest point of the other's surface
};

struct PairSettings {
  double margin_m = 0;
  double depth_tolerance_m = 0.005;  ///< of the depth in a closed surface that is not convex
};

/// Two surfaces, each of at least one triangle. Throws kUnsupported in a library built without FCL. Parallel.
PairClearance clearance_of_surfaces(const PartSurface& first, const PartSurface& second,
                                    const PairSettings& settings, Task& task);

}  // namespace jalon

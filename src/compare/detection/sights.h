// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <vector>

#include "compare/visibility/depth_map.h"

namespace jalon {

/// What the stations of a cloud say of a place.
enum class PlaceSight : uint8_t {
  kUnknown,  ///< nothing was measured all about that direction, or an edge passes there
  kSurface,  ///< a surface was measured about there
  kThrough,  ///< beams went through the place and met something behind it
  kHidden,   ///< beams met something in front of it
};

/// Depth maps of all stations of a cloud, each cell with the nearest of its points (Girardeau-Montaut 2006, 2.3.3).
/// A station speaks by all nine cells about a direction, which must agree: at the edge of what it saw nothing is told.
class Sights {
 public:
  /// Every point must belong to a station with a pose; see has_all_stations. The cloud outlives this. O(n + cells).
  Sights(const Cloud& cloud, Task& task);
  /// normal: of the surface at the place, of either sign; margin_m: across it, what is still the surface.
  /// A surface seen by one station counts before a place looked through by another, that before a hidden one.
  PlaceSight look(const Vec3& place, const Vec3& normal, double margin_m) const;

 private:
  PlaceSight look(const DepthMap& map, const Vec3& station, const Vec3& place, const Vec3& normal,
                  double margin_m) const;
  const Cloud* cloud_;
  std::vector<DepthMap> maps_;
  std::vector<Vec3> places_;
};

}  // namespace jalon

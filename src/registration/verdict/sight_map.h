// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "base/task.h"
#include "geometry/vec.h"

namespace jalon {

/// What a station says of a place.
enum class Sighted : uint8_t {
  kUnknown,  ///< too little was measured that way
  kSurface,  ///< a surface about there
  kThrough,  ///< its beams went through the place and met something behind it
  kHidden,   ///< its beams met something in front
};

/// Ranges of what a station measured, on the six faces of a cube about it: rays never cross, so the direction orders
/// all that it saw (Girardeau-Montaut 2006, 2.3.3). Each cell keeps the nearest and the farthest of its points.
///
/// It answers by all nine cells about a direction, which must agree: at the edge of a surface nothing is told.
class SightMap {
 public:
  /// xyz: 3 a point; less origin they are in the frame of the station. most_edge: cells along a face at most, no finer
  /// than the station is known. O(points).
  static SightMap build(std::span<const double> xyz, const Vec3& origin, const Vec3& station,
                        int most_edge, Task& task);

  const Vec3& station() const { return station_; }
  /// normal: of the surface at the place, of either sign: one that slants spans ranges within a cell. margin_m: what
  /// noise alone may differ by.
  Sighted look(const Vec3& place, const Vec3& normal, double margin_m) const;
  /// Of one of its own points, whether the station could see it: what it measured all about the point lies nearer
  /// when not. kUnknown where it measured too little about the point; else kSurface or kHidden.
  Sighted look_at_own(const Vec3& place, const Vec3& normal, double margin_m) const;

 private:
  struct Cell {
    float nearest_m, farthest_m;  ///< an empty one: infinity and 0
    bool is_measured() const { return farthest_m > 0; }
  };
  struct Place {
    int face, column, row;
  };
  struct Window;  // the cells about a direction
  void fill(std::span<const double> xyz, const Vec3& origin, size_t stride, Task& task);
  Place place_of(const Vec3& direction) const;
  size_t index(const Place& at) const {
    return static_cast<size_t>((at.face * edge_ + at.row) * edge_ + at.column);
  }
  Window window(const Vec3& direction) const;
  double margin(const Vec3& direction, double range, const Vec3& normal, double margin_m) const;

  Vec3 station_;
  int edge_ = 1;  ///< of a face, cells
  std::vector<Cell> cells_;
};

}  // namespace jalon

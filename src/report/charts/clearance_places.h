// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <vector>

#include "base/field.h"
#include "geometry/vec.h"

namespace jalon {

/// A gauge's way through a scene: its poses, and how far along it each one stands.
class GaugePath {
 public:
  explicit GaugePath(std::vector<Transform> poses);

  const std::vector<Transform>& poses() const { return poses_; }
  double length_m() const { return chainage_.back(); }
  /// parameter: number of the pose passed + share of the way to the next.
  double chainage_m(double parameter) const;
  /// T_section_world at this time: x to the right of an eye that looks along the travel, y up, z back along the travel;
  /// its origin is the gauge's.
  Transform section(double parameter) const;
  /// T_section_gauge at this time.
  Transform section_of_gauge(double parameter) const;

 private:
  struct Step {
    size_t from, to;  ///< poses
    double share;
  };
  Step step(double parameter) const;

  std::vector<Transform> poses_;
  std::vector<double> chainage_;  ///< of each pose, metres
};

/// Where the gauge is tight: one place stands for all obstacles near it.
struct TightPlace {
  size_t row = 0;  ///< of the table of places
  double parameter = 0, chainage_m = 0, clearance_m = 0;
  Vec3 obstacle;          ///< in the world
  Vec3 in_section;        ///< the same in the section's frame: to the right, up, back
  Vec3 gauge_in_section;  ///< the nearest point of the gauge
};

/// The tightest obstacles, each at least apart_m from the tighter ones, at most so many; tightest first. places: what
/// jalon_gauge_sweep gives. O(rows (log rows + most)).
std::vector<TightPlace> tight_places(const FieldTable& places, const GaugePath& path,
                                     double apart_m, size_t most);

}  // namespace jalon

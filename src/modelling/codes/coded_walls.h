// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

#include "modelling/codes/shared_faces.h"

namespace jalon {

/// An upright wall: it stands on the line from a to b, outside at its right.
struct CodedWall {
  Vec2 a, b;
  double low_m = 0, high_m = 0;

  double length_m() const { return norm(b - a); }
  Vec2 along() const { return (b - a) * (1 / length_m()); }
  Vec2 inward() const { return {-along().v, along().u}; }
  Vec3 point(double s, double z) const { return {a.u + along().u * s, a.v + along().v * s, z}; }
};

/// A window or door at its frame.
struct CodedOpening {
  std::string name, part_class;
  uint32_t id = 0;
  Corners border;  ///< upright, in either order
};

/// An opening in its wall: the hole straight before the frame, corner for corner.
struct WallOpening {
  const CodedOpening* opening = nullptr;
  Corners frame, hole;                                     ///< anticlockwise seen from outside
  double left_m = 0, right_m = 0, foot_m = 0, head_m = 0;  ///< of the hole, along the wall and up
  double depth_m = 0;      ///< of the frame behind the wall, the mean of its corners
  bool is_flush = false;   ///< the frame stands in the wall's own plane
  bool has_notch = false;  ///< it reaches the foot of its wall: a notch, no hole
};

/// The opening in this wall, or nothing: it stands up to 1 m from it and about parallel, its hole lies within the wall.
std::optional<WallOpening> opening_in(const CodedWall& wall, const CodedOpening& opening);
/// Whether two openings of a wall share a place of it.
bool overlap(const WallOpening& a, const WallOpening& b);

/// Adds the wall's face with its holes and notches, and of each opening a part with its frame (joinery) and its
/// reveals. Returns the corners of the foot from a to b, which walk round the floors of notches. openings: apart from
/// each other.
Corners add_coded_wall(SharedFaces& faces, const CodedWall& wall, uint32_t part, uint32_t id,
                       std::vector<WallOpening> openings);

}  // namespace jalon

// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "modelling/plane/vector_plane.h"

namespace jalon {

/// A place where a wall's face is interrupted: a hole of it, or a notch that comes in from its lower border (a door
/// that reaches the ground).
struct WallHole {
  VectorRing
      outline;  ///< anticlockwise; of a notch it starts at its left foot, and its first edge closes it
  uint32_t piece = 0;  ///< index of the wall's face
  bool is_notch = false;
  bool ends_at_sill = false;  ///< its first edge is the upper edge of a sill (sills.h)
  bool is_bay = false;        ///< a notch between two pieces (bays.h): no face has its outline
  bool is_evident = false;    ///< a bay that the evidence tells for an opening (evident_holes.h)
};

struct NotchSetting {
  double min_height_m = 1.5;
  double min_width_m = 0.4, max_width_m = 6;  ///< full widths
};

/// Holes in the order of faces and openings, then the notches of each face from left to right.
/// After: all outlines anticlockwise; wall is as it was.
std::vector<WallHole> holes_of(const VectorPlane& wall, const NotchSetting& setting);

/// Takes a hole's ring from the face, or the notch from its outline: the corners between its feet
/// go. Before: hole is of this face and still in it.
void close_hole(VectorFace& face, const WallHole& hole);

}  // namespace jalon

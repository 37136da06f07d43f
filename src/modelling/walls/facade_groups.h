// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "geometry/vec.h"
#include "modelling/plane/vector_plane.h"
#include "modelling/walls/holes.h"

namespace jalon {

struct GroupSetting {
  double min_wall_area_m2 = 4;  ///< of a wall's largest face, its openings not taken off
  double min_wall_width_m =
      1;  ///< of that face (full): narrower ones are sides of posts and reveals
  double min_facade_share =
      0.05;  ///< of the largest wall's gross area: a lone smaller one is no facade (a car's side)
  double min_facade_height_m = 2;  ///< of that wall's face: less than a storey is none either
  double facade_depth_m =
      2.5;                  ///< walls this far before or behind the main one belong to its facade
  double facade_gap_m = 3;  ///< and this far beside it
  NotchSetting notch;       ///< what a wall's lower border has beside its holes
};

/// Upright frame of a facade: along = to the right for an eye in front of it, outward = towards the eye.
struct FacadeFrame {
  Vec3 origin, along{1, 0, 0}, outward{0, -1, 0};
  /// (along, outward, up) from the origin, which lies on the main wall.
  Vec3 local(const Vec3& p) const {
    const Vec3 d = p - origin;
    return {dot(d, along), dot(d, outward), d.z};
  }
};

/// What the evidence says of a plane.
struct WallClaim {
  bool is_none = false;    ///< a pane, a surround, a room's wall
  bool is_recess = false;  ///< a wall, although it lies in the openings of another: a loggia's
  bool is_windowed =
      false;  ///< it frames openings of its own: a bay window hides a wall, a parapet fills its bay
  double gross_m2 = 0;     ///< within its border, openings included; 0: nothing is known
  double measured_m2 = 0;  ///< of that
};

/// One facade: parallel walls near each other, and the other planes nearest to them. Indices of the planes given.
struct FacadeGroup {
  FacadeFrame frame;
  std::vector<size_t> walls;   ///< the main wall first, then by falling gross area
  std::vector<size_t> others;  ///< ascending
  Box3 box;                    ///< of the walls, in the frame's coordinates
};

/// Facades by falling area of their main walls. Without any wall: one group that holds all planes.
/// Walls are upright planes with a large face that does not lie in the holes of a wall before it (a pane, a parapet in
/// its bay). Ranked by gross area, so that a lattice of posts and string courses comes before the panes in its bays.
/// O(planes x facades) and the point-in-polygon tests of parallel planes.
/// claims: what is known of the planes from their evidence, one a plane, or empty; it counts in place of the area and
/// width of the largest face.
std::vector<FacadeGroup> group_facades(const std::vector<VectorPlane>& planes,
                                       const GroupSetting& setting,
                                       std::span<const WallClaim> claims = {});

/// Corners of the plane's outlines in 3D, arcs by their end points.
std::vector<Vec3> outline_corners(const VectorPlane& plane);

}  // namespace jalon

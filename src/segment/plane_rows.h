// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "base/setting_rows.h"
#include "segment/surface_settings.h"

namespace jalon {

// The rows that all methods for planes by images, triangles, profiles, cells and votes have; the origins of their
// defaults are those of "ransac".

/// What makes a plane one: tolerance and least size.
constexpr auto plane_least_rows(const char* method) {
  return setting_rows(
      number_row<&SurfaceSettings::distance_tolerance_m>(
          "distance_tolerance_m", 1e-5, 10, "m", method,
          "Largest distance of a point from its plane: a half-thickness, about 3 sigma of the "
          "scan."),
      number_row<&SurfaceSettings::min_area_m2>(
          "min_area_m2", 0, 1e9, "m2", method,
          "Smallest area of a segment, counted in occupied raster pixels."),
      integer_row<&SurfaceSettings::min_points>("min_points", 3, 4e9, "points", method,
                                                "Fewest points of a segment."));
}

/// The raster that counts areas.
constexpr auto plane_pixel_rows(const char* method) {
  return setting_rows(number_row<&SurfaceSettings::pixel_m>(
      "pixel_m", 0, 100, "m", method,
      "Edge of a raster pixel for area and re-assignment; 0 = twice the point spacing of the "
      "segment."));
}

/// Of the refinement that all methods have.
inline constexpr const char* kGlobalPlanarityHelp =
    "Parts segments that hold several planes, where the tolerance is wider than their steps; a "
    "bent surface becomes several planes (Yu et al. 2008).";

/// What is done with the planes once they are found.
constexpr auto plane_ending_rows(const char* method) {
  return setting_rows(
      number_row<&SurfaceSettings::merge_gap_m>(
          "merge_gap_m", 0, 1e4, "m", method,
          "Widest gap between coplanar pieces joined at the end; more joins repeated panels "
          "and panes; 0 = none."),
      bool_row<&SurfaceSettings::global_planarity>("global_planarity", method,
                                                   kGlobalPlanarityHelp),
      number_row<&SurfaceSettings::orientation_tolerance_rad>(
          "orientation_tolerance_rad", 1e-4, 0.785398, "rad", method,
          "Largest angle to the facade's axes for the orientation classes; 0.0175 = 1 degree."),
      bool_row<&SurfaceSettings::facade_frame>(
          "facade_frame", method,
          "Turns the main facade parallel to OXZ in the facade frame; off: the frame is the "
          "identity."));
}

}  // namespace jalon

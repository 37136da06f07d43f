// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>

namespace jalon {

/// Where the normals of the consistency test come from: cells of the octree, the field "normal", or
/// there is no test.
enum class NormalSource { kCells, kField, kNone };
/// What is looked for.
enum class Primitives { kPlanes, kPlanesAndSpheres, kPlanesAndCylinders, kAll };

/// What makes points one surface: what the steps read that all methods share. Its rows stand in the
/// table of each method (names, help, ranges); the initialisers here are the defaults of "ransac".
struct SurfaceSettings {
  double distance_tolerance_m = 0.025;  ///< half-thickness
  double min_area_m2 = 0.05;
  uint32_t min_points = 50;
  bool connectivity = true;
  double pixel_m = 0;  ///< 0 = 2 x spacing of the segment
  double gap_m = 0.5;
  double strip_width_m = 0;  ///< narrower parts of a surface are not its own; 0 = keep them
  double merge_gap_m = 0.5;
  NormalSource normals = NormalSource::kCells;
  double normal_tolerance_rad = 0.436332;
  double least_radius_m = 1;  ///< surfaces curved more tightly are no planes; 0 = they are
  Primitives primitives = Primitives::kPlanes;
  double min_radius_m = 0.03;  ///< of spheres and cylinders
  double max_radius_m = 0;     ///< 0 = as wide as the cloud
  bool reassign = true;
  bool global_planarity = false;  ///< surfaces that hold several planes are parted at the end
  double orientation_tolerance_rad = 0.0174533;
  bool facade_frame = true;

  bool spheres() const {
    return primitives == Primitives::kPlanesAndSpheres || primitives == Primitives::kAll;
  }
  bool cylinders() const {
    return primitives == Primitives::kPlanesAndCylinders || primitives == Primitives::kAll;
  }
  bool curved() const { return spheres() || cylinders(); }
  bool uses_normals() const { return normals != NormalSource::kNone; }
};

}  // namespace jalon

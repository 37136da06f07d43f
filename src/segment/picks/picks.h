// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>

#include "segment/segmentation.h"

namespace jalon {

/// The parameters of operation "pick": what a pick is grown with.
struct PickSettings {
  PrimitiveSetting primitive{.tolerance_m = 0.02, .min_radius_m = 0.001, .max_radius_m = 100};
  double min_area_m2 = 0.01;
  uint64_t min_points = 4;
  double gap_m = 0.2;
  double pixel_m = 0;  ///< 0 = twice the point spacing around the picks
  uint32_t k = 24;     ///< neighbours of a seed's plane, of a pick's normal
  double orientation_tolerance_rad = 0.0174533;
};
std::span<const ParamRow> pick_rows();

/// A segmentation of the cloud without segments, to pick from.
Segmentation empty_segmentation(const CloudPtr& cloud, Task& task);

/// The segmentation with one segment more, grown from picks among the points of label 0 (Boulaassal 2010, 5.5.2). Of a
/// plane: 1 pick is a seed, 3 and more bound it. Sphere: 2 picks with normals of the points around, or 4 and more.
/// Cylinder: 2 picks with normals, or 3 and more of a vertical one.
Segmentation with_pick(const Segmentation& before, PrimitiveType type, std::span<const Vec3> picks,
                       const PickSettings& settings, Task& task);

/// The points of label 0, with their fields.
Cloud remaining_points(const Segmentation& segmentation, Task& task);

/// The parameter file of Boulaassal 2010, 5.5.2: a row a segment, its type code first; plane:
/// normal, offset; sphere: centre,
/// radius; cylinder: axis point, direction, radius.
std::string primitive_text(const Segmentation& segmentation);

}  // namespace jalon

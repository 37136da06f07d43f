// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "base/field.h"
#include "base/task.h"
#include "model/model.h"

namespace jalon {

/// Field "segment" of points that belong to no true plane.
constexpr uint32_t kNoSegment = 0;

/// A connected group of coplanar triangles.
struct TruePlane {
  Plane plane;  ///< that of its largest face, and its side
  double area_m2 = 0;
  uint32_t face = 0;  ///< id of its largest face
  uint32_t part = 0;  ///< part of that face
};

/// What a perfect segmentation of a scan of the model would find.
struct Truth {
  std::vector<TruePlane>
      planes;  ///< of the segments 1, 2 ..., in the order of the model's triangles
  std::vector<uint32_t> triangle_segments;  ///< segment of each triangle; kNoSegment without one
};

/// Groups the triangles that lie in one plane (0.001 degrees, 0.1 mm) and share an edge or touch, and numbers the
/// groups of at least this area. In a model with faces, triangles whose id is no face's are curved surfaces and belong
/// to none; in a bare mesh all triangles count. The model must be valid. O(n log n) for n triangles; patches that
/// share no vertices are compared through a grid.
Truth find_truth(const Model& model, double min_area_m2, Task& task);

/// One row a true plane, shifted: "segment", "face", "part" (uint32), "normal" (float64 x 3), "offset", "area"
/// (float64) and "count" (uint64): how often its number is among the labels.
FieldTable truth_table(const Truth& truth, const Vec3& shift, std::span<const uint32_t> labels,
                       Task& task);

}  // namespace jalon

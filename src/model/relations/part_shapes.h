// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "base/task.h"
#include "model/relations/directions.h"
#include "model/relations/placed_face.h"

namespace jalon {

/// A part with all that is below it, as somebody before its facade sees it.
struct PartShape {
  uint32_t part = 0;
  uint64_t facade = kNoParent;  ///< the part of that class it is or stands under, if any
  ViewAxes axes;                ///< of that facade, or of the model
  std::vector<PlacedFace> faces;
  std::vector<PolygonWithHoles> region;  ///< of its faces and openings in the facade's plane
  Box3 box;                              ///< right, up, out
};

/// The parts that have faces, fill an opening or stand above such parts, in their order; not those that stand above
/// facades. A wall's region holds its openings, for these stand under it. The axes of a facade are those of its largest
/// upright face, of a wall where it has one; without any facade all parts share those of the model's. Axes start at
/// `origin`.
std::vector<PartShape> part_shapes(const Model& model, const Vec3& origin, double chord_error_m,
                                   Task& task);

}  // namespace jalon

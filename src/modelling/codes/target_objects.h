// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "base/task.h"
#include "modelling/codes/coded_walls.h"
#include "segment/codes/notes_reader.h"
#include "segment/segmentation.h"

namespace jalon {

/// What the points of an object say of it where its codes say no shape: that of a target. Relative to an origin.
struct MeasuredShape {
  std::vector<CodedWall> rectangles;  ///< upright, outside at their right: of windows one each
  std::vector<Vec3> axis;             ///< of a gutter
  double radius_m = 0;
};

/// Shapes of the objects about targets, in the notes' order; empty for the others and for those without a plane.
/// Rectangles are parallel to the plane of the object's points, at the front of their own, and reach as far as these
/// would without the strays among them (one in a hundred at each end); windows are apart where no point lies for gap_m
/// along their facade. Gutters are upright: a circle fitted in plan.
std::vector<MeasuredShape> target_shapes(const Segmentation& segmentation, const CodedNotes& notes,
                                         const Vec3& origin, double gap_m, Task& task);

}  // namespace jalon

// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>

#include "spatial/octree/view.h"

// The vector loops of ShapeSearch. Each is compiled for the baseline and for AVX2, with the same bits.

namespace jalon {

/// A ball or a cylinder in grid units. Limits are widened by the caller so that rounding loses no point.
struct GridShape {
  int32_t base[3];  ///< the grid point nearest to the centre
  float offset
      [3];  ///< from the middle of base's cell, where its points are taken to lie, to the centre
  float axis[3];      ///< unit; not read for a ball
  float half_length;  ///< of the cylinder; not read for a ball
  float radius;
  bool is_ball;
};

/// Points taken out of a tree, in curve order; the arrays have room for capacity.
struct ShapePoints {
  int32_t *x, *y, *z;
  uint32_t* position;  ///< in the tree's order
  size_t capacity, count;
};

/// Takes the points that may lie in the shape. False when there is no room for all of them: capacity must exceed their
/// number by 32.
bool gather_shape_baseline(const OctreeView& tree, const GridShape& shape, ShapePoints& out);
bool gather_shape_avx2(const OctreeView& tree, const GridShape& shape, ShapePoints& out);
/// The positions of those of them that may lie in another shape, in the same order, to out, which has room for 32 more
/// than there are points. Returns how many. The arrays are readable for 32 elements behind the points.
size_t filter_shape_baseline(const ShapePoints& points, const GridShape& shape, uint32_t* out);
size_t filter_shape_avx2(const ShapePoints& points, const GridShape& shape, uint32_t* out);

}  // namespace jalon

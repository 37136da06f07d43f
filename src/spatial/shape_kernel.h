// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>

#include "spatial/octree_view.h"

// The vector loops of ShapeSearch. Each is compiled for the baseline and for AVX2, with the same bits.

namespace jalon {

/// A ball or a cylinder in grid units. Limits are widened by the caller so that rounding loses no point.
struct GridShape {
  int32_t base[3];      ///< the grid point nearest to the centre
  float offset[3];      ///< from the middle of base's cell, where its points are taken to lie, to the centre
  float axis[3];        ///< unit; not read for a ball
  float half_length;    ///< of the cylinder; not read for a ball
  float radius;
  bool is_ball;
};

/// Writes the sorted positions of the points that may lie in the shape to out, in ascending order, and sets count.
/// False when there is no room for all of them: capacity must exceed their number by 32.
bool gather_shape_baseline(const OctreeView& tree, const GridShape& shape, uint32_t* out, size_t capacity,
                           size_t& count);
bool gather_shape_avx2(const OctreeView& tree, const GridShape& shape, uint32_t* out, size_t capacity, size_t& count);

}  // namespace jalon

// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "spatial/neighbours/shape_kernel.h"
#include "spatial/neighbours/shape_kernel.inc"

namespace jalon {

bool gather_shape_baseline(const OctreeView& tree, const GridShape& shape, ShapePoints& out) {
  return gather_shape(tree, shape, out);
}
size_t filter_shape_baseline(const ShapePoints& points, const GridShape& shape, uint32_t* out) {
  return filter_shape(points, shape, out);
}

}  // namespace jalon

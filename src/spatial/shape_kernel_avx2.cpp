// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "spatial/shape_kernel.h"
#include "spatial/shape_kernel.inc"

namespace jalon {

bool gather_shape_avx2(const OctreeView& tree, const GridShape& shape, uint32_t* out, size_t capacity,
                     size_t& count) {
  return gather_shape(tree, shape, out, capacity, count);
}

}  // namespace jalon

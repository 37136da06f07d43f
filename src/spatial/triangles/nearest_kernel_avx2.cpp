// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "spatial/triangles/nearest_kernel.h"
#include "spatial/triangles/nearest_kernel.inc"

namespace jalon {

void nearest_triangles_avx2(const TriangleBlocks& tree, const double* points, size_t count,
                            NearestOfBlocks* out) {
  nearest_all(tree, points, count, out);
}

void leaf_distances_avx2(const TriangleBlock& block, const double* point,
                         double (&squared)[triangle_tree::kWidth]) {
  distances_of_leaf(block, point, squared);
}

}  // namespace jalon

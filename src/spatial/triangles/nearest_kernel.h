// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>

#include "spatial/triangles/nodes.h"

// The vector loops of the nearest triangle. Compiled for the baseline and for AVX2, with the same bits.

namespace jalon {

/// The triangles of a leaf. Places behind the last repeat it.
struct TriangleBlock {
  const double* corners;  ///< of its triangles, each once: x, y, z relative to the tree's origin
  /// Where among them those of each triangle begin, 0, 3, 6 ...; a triangle's in ascending order of coordinates.
  uint8_t a[triangle_tree::kWidth], b[triangle_tree::kWidth], c[triangle_tree::kWidth];
  uint32_t triangle[triangle_tree::kWidth];  ///< caller's number
  uint32_t count;                            ///< of them
  uint32_t
      turned;  ///< bit i: triangle i runs clockwise where its corners in their order run anticlockwise
};

struct TriangleBlocks {
  const triangle_tree::Node* nodes;
  const TriangleBlock* blocks;
  const uint32_t* least;  ///< least number of a triangle in child i of node n: [4 n + i]
};

/// The best so far: squared distance, caller's number and place (4 x block + lane) of the triangle, and the height
/// above its plane (any unit; corners anticlockwise in their order) where the point is above its face, else 0.
struct NearestOfBlocks {
  double squared;
  uint32_t triangle;
  uint32_t place;
  double height;
};
constexpr uint32_t kNoTriangle = ~uint32_t{0};

/// The nearest triangle of each of count points (3 doubles each, relative to the tree's origin), of those no farther
/// than out[i].squared on entry; kNoTriangle where there is none. Ties go to the least number. Points that
/// follow each other should lie near each other: the answer of one bounds the search of the next.
void nearest_triangles_baseline(const TriangleBlocks& tree, const double* points, size_t count,
                                NearestOfBlocks* out);
void nearest_triangles_avx2(const TriangleBlocks& tree, const double* points, size_t count,
                            NearestOfBlocks* out);

/// Squared distances of a point from the triangles of a leaf, those behind the last repeated; the same bits.
void leaf_distances_baseline(const TriangleBlock& block, const double* point,
                             double (&squared)[triangle_tree::kWidth]);
void leaf_distances_avx2(const TriangleBlock& block, const double* point,
                         double (&squared)[triangle_tree::kWidth]);

}  // namespace jalon

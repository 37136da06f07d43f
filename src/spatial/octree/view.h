// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>

namespace jalon {

constexpr size_t kBoxes = 8;  ///< boxes a block: one AVX2 register, two SSE ones

/// Closed boxes of eight neighbours in the order of the curve, in grid units. Unused places are empty (lo > hi).
struct alignas(64) BoxBlock {
  int32_t lo[3][kBoxes];
  int32_t hi[3][kBoxes];
};

/// What the vector loops see of an octree: plain pointers, so that files compiled for other processors share no inline
/// code.
struct OctreeView {
  const int32_t *x, *y, *z;    ///< readable for 64 bytes behind the end
  const uint32_t* leaf_first;  ///< leaf i holds the points leaf_first[i] ... leaf_first[i + 1] - 1
  /// By level, leaves first; block b of level i + 1 bounds the blocks 8 b ... 8 b + 7 of level i
  const BoxBlock* blocks[12];
  int top;  ///< the level of one block
};

}  // namespace jalon

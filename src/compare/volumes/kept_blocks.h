// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace jalon {

/// Along one axis of a grid: blocks of cells, of which those far from all points are left out, so that a grid over two
/// places far from each other costs what they hold and not what lies between. Made without blocks it keeps all.
class KeptBlocks {
 public:
  /// Cells of a block. A block with points keeps the one before and the one behind it: what looks at no more cells than
  /// that around a point misses none. A multiple of the side of the blocks by which a landslide's errors are told, so
  /// that these stay the same.
  static constexpr uint32_t kBlock = 64;

  KeptBlocks() = default;
  /// has_points: not 0 for the blocks with some. The first and the last one, which may be short, stay.
  explicit KeptBlocks(std::span<const uint8_t> has_points);

  static size_t blocks_of(uint32_t cells) { return (size_t{cells} + kBlock - 1) / kBlock; }
  /// Cells that are left out.
  uint32_t left_out() const { return left_out_; }
  /// Number among the kept of a cell that is kept.
  uint32_t kept_of(uint32_t cell) const {
    return place_.empty() ? cell : place_[cell / kBlock] * kBlock + cell % kBlock;
  }
  /// The reverse.
  uint32_t cell_of(uint32_t kept) const {
    return block_.empty() ? kept : block_[kept / kBlock] * kBlock + kept % kBlock;
  }

 private:
  std::vector<uint32_t> place_;  ///< of each block among the kept
  std::vector<uint32_t> block_;  ///< of each kept one among all
  uint32_t left_out_ = 0;
};

}  // namespace jalon

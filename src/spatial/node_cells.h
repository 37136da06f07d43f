// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <compare>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "base/task.h"
#include "geometry/vec.h"

namespace jalon {

/// A square cell of a slice.
struct NodeCell {
  int64_t column, row;
  auto operator<=>(const NodeCell&) const = default;
};

/// The cell of a place; those very far away share one.
NodeCell cell_at(const Vec2& p, double cell_m);

/// Indices of the cells in the order of these, equal ones in their own.
std::vector<uint32_t> order_of_cells(std::span<const NodeCell> cells, Task& task);

/// Which node stands in a cell: open addressing, half full.
class NodeTable {
 public:
  static constexpr uint32_t kNoNode = 0xffffffffu;

  explicit NodeTable(std::span<const NodeCell> cells);
  uint32_t at(const NodeCell& cell) const {
    size_t slot = slot_of(cell);
    while (slots_[slot] != kNoNode && cells_[slots_[slot]] != cell) slot = next(slot);
    return slots_[slot];
  }

 private:
  size_t next(size_t slot) const { return (slot + 1) & (slots_.size() - 1); }
  // Odd multipliers spread neighbours (Knuth 1998, 6.4); the high bits of the sum are the mixed ones.
  size_t slot_of(const NodeCell& cell) const {
    const uint64_t mixed = static_cast<uint64_t>(cell.column) * 0x9e3779b97f4a7c15ull +
                           static_cast<uint64_t>(cell.row) * 0xc2b2ae3d27d4eb4full;
    return static_cast<size_t>(mixed >> 32) & (slots_.size() - 1);
  }
  std::span<const NodeCell> cells_;
  std::vector<uint32_t> slots_;
};

/// A bit a cell of those about the nodes, column by column, margin cells about them: whether a node stands there. A
/// walk looks at many more cells than have nodes.
class NodeBits {
 public:
  static constexpr int64_t kMostMargin = 28;           // twice that and one are bits of one word
  static constexpr uint64_t kMostCellsPerNode = 1024;  // 128 B: what a walk costs anyhow

  /// margin: how far from the cells window() will look.
  NodeBits(std::span<const NodeCell> cells, int64_t margin);
  /// False where the cells are too many: then nothing is known of them.
  bool known() const { return !words_.empty(); }
  void clear(const NodeCell& cell) {
    const uint64_t bit = place(cell, 0, 0);
    words_[bit / 64] &= ~(uint64_t{1} << bit % 64);
  }
  /// Rows - reach ... reach of a column near a node's cell, the lowest first.
  uint64_t window(const NodeCell& cell, int64_t columns, int64_t reach) const {
    const uint64_t bit = place(cell, columns, -reach), shift = bit % 64;
    const uint64_t low = words_[bit / 64] >> shift;
    const uint64_t high = shift == 0 ? 0 : words_[bit / 64 + 1] << (64 - shift);
    return (low | high) & ((uint64_t{1} << (2 * reach + 1)) - 1);
  }

 private:
  uint64_t place(const NodeCell& cell, int64_t columns, int64_t rows) const {
    return static_cast<uint64_t>(cell.column + columns - low_.column) * rows_ +
           static_cast<uint64_t>(cell.row + rows - low_.row);
  }
  void set(const NodeCell& cell) {
    const uint64_t bit = place(cell, 0, 0);
    words_[bit / 64] |= uint64_t{1} << bit % 64;
  }
  NodeCell low_{0, 0};
  uint64_t rows_ = 0;
  std::vector<uint64_t> words_;
};

}  // namespace jalon

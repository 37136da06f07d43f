// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cstdint>
#include <span>
#include <vector>

namespace jalon {

/// Columns [c0, c1) and rows [r0, r1) of a map of cells.
struct CellBox {
  uint32_t c0 = 0, r0 = 0, c1 = 0, r1 = 0;
  uint32_t width() const { return c1 - c0; }
  uint32_t height() const { return r1 - r0; }
};

/// What these cells of a map reach over; nothing of none.
inline CellBox cell_box_of(std::span<const uint32_t> cells, uint32_t columns) {
  if (cells.empty()) return {};
  CellBox out{~uint32_t{0}, ~uint32_t{0}, 0, 0};
  for (const uint32_t k : cells) {
    const uint32_t c = k % columns, r = k / columns;
    out = {std::min(out.c0, c), std::min(out.r0, r), std::max(out.c1, c + 1),
           std::max(out.r1, r + 1)};
  }
  return out;
}

/// Connected parts of sets of cells, row by row, neighbours by a side.
class CellRegions {
 public:
  CellRegions(uint32_t columns, uint32_t rows)
      : columns_(columns), rows_(rows), marks_(static_cast<size_t>(columns) * rows, 0) {}

  /// The parts of these cells, by their first cell in the order given. O(cells given).
  std::vector<std::vector<uint32_t>> of(std::span<const uint32_t> cells) {
    for (const uint32_t k : cells) marks_[k] = 1;
    std::vector<std::vector<uint32_t>> out;
    std::vector<uint32_t> stack;
    for (const uint32_t seed : cells) {
      if (marks_[seed] == 0) continue;
      std::vector<uint32_t>& region = out.emplace_back();
      marks_[seed] = 0;
      stack.assign(1, seed);
      while (!stack.empty()) {
        const uint32_t k = stack.back(), c = k % columns_, r = k / columns_;
        stack.pop_back();
        region.push_back(k);
        const auto join = [&](bool is_there, uint32_t other) {
          if (!is_there || marks_[other] == 0) return;
          marks_[other] = 0;
          stack.push_back(other);
        };
        join(c > 0, k - 1);
        join(c + 1 < columns_, k + 1);
        join(r > 0, k - columns_);
        join(r + 1 < rows_, k + columns_);
      }
    }
    return out;
  }

 private:
  uint32_t columns_, rows_;
  std::vector<uint8_t> marks_;
};

}  // namespace jalon

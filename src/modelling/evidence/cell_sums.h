// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace jalon {

/// Sums of a number a cell over upright boxes in constant time (Crow 1984: summed-area table).
template <class T>
class CellSums {
 public:
  CellSums() = default;
  /// value(k) of the cell k, row by row.
  template <class F>
  CellSums(uint32_t columns, uint32_t rows, F&& value) : stride_(size_t{columns} + 1) {
    sums_.assign(stride_ * (size_t{rows} + 1), T{});
    size_t k = 0;
    for (uint32_t r = 0; r < rows; ++r) {
      T along{};
      for (uint32_t c = 0; c < columns; ++c, ++k) {
        along += value(k);
        sums_[(r + size_t{1}) * stride_ + c + 1] = sums_[r * stride_ + c + 1] + along;
      }
    }
  }
  /// Of the columns [c0, c1) and rows [r0, r1).
  T of(uint32_t c0, uint32_t r0, uint32_t c1, uint32_t r1) const {
    return sums_[r1 * stride_ + c1] - sums_[r1 * stride_ + c0] - sums_[r0 * stride_ + c1] +
           sums_[r0 * stride_ + c0];
  }

 private:
  size_t stride_ = 0;
  std::vector<T> sums_;
};

}  // namespace jalon

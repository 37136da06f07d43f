// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "compare/visibility/depth_cells.h"

#include <algorithm>

namespace jalon {

DepthCells::DepthCells(uint32_t columns, uint32_t rows)
    : across_((columns + kSide - 1) / kSide),
      up_((rows + kSide - 1) / kSide),
      tile_of_(size_t{across_} * up_, 0),
      tiles_(1) {}

DepthCells::Place DepthCells::at(uint32_t column, uint32_t row) {
  uint32_t& number = tile_of_[tile(column, row)];
  if (number == 0) {
    number = static_cast<uint32_t>(tiles_.size());
    tiles_.emplace_back();
  }
  Tile& found = tiles_[number];
  return {found.cells[inside(column, row)], found.counts[inside(column, row)]};
}

std::vector<DepthCells::Corner> DepthCells::tiles_and_around(bool is_closed) const {
  std::vector<uint8_t> wanted(tile_of_.size(), 0);
  for (uint32_t row = 0; row < up_; ++row)
    for (uint32_t column = 0; column < across_; ++column) {
      if (tile_of_[size_t{row} * across_ + column] == 0) continue;
      for (int k = 0; k < 9; ++k) {
        const int64_t r = int64_t{row} + k / 3 - 1;
        int64_t c = int64_t{column} + k % 3 - 1;
        if (is_closed) c = (c + across_) % across_;
        if (r >= 0 && r < up_ && c >= 0 && c < across_)
          wanted[static_cast<size_t>(r) * across_ + static_cast<size_t>(c)] = 1;
      }
    }
  std::vector<Corner> out;
  for (size_t t = 0; t < wanted.size(); ++t)
    if (wanted[t] != 0)
      out.push_back(
          {static_cast<uint32_t>(t % across_) * kSide, static_cast<uint32_t>(t / across_) * kSide});
  return out;
}

}  // namespace jalon

// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "compare/visibility/depth_angles.h"
#include "spatial/octree/octree.h"

namespace jalon {

/// What a cell of a depth map keeps.
struct DepthCell {
  float range_m = 0;
  float u = 0.5f, v = 0.5f;   ///< of the point in the cell, 0 ... 1
  uint32_t point = kNoPoint;  ///< the nearest one, an index of the cloud
};

/// The cells of an angular grid, kept in tiles of which only those exist that hold something: a single point far aside
/// widens the grid a hundredfold and fills one cell of it.
class DepthCells {
 public:
  static constexpr uint32_t kSide = 16;  ///< cells along a tile
  static constexpr size_t kTileCells = size_t{kSide} * kSide;

  DepthCells() = default;
  DepthCells(uint32_t columns, uint32_t rows);

  const DepthCell& cell(uint32_t column, uint32_t row) const {
    return tiles_[tile_of_[tile(column, row)]].cells[inside(column, row)];
  }
  uint32_t count(uint32_t column, uint32_t row) const {  ///< points of the cell
    return tiles_[tile_of_[tile(column, row)]].counts[inside(column, row)];
  }
  struct Place {
    DepthCell& cell;
    uint32_t& count;
  };
  /// A cell to be written. Valid until the next.
  Place at(uint32_t column, uint32_t row);

  /// First column and row of a tile.
  struct Corner {
    uint32_t column, row;
  };
  /// The tiles that hold something and those around them, row by row; across the seam of a closed grid as well.
  std::vector<Corner> tiles_and_around(bool is_closed) const;

  /// How many tiles exist.
  size_t tiles() const { return tiles_.empty() ? 0 : tiles_.size() - 1; }

 private:
  struct Tile {
    std::array<DepthCell, kTileCells> cells;
    std::array<uint32_t, kTileCells> counts{};
  };
  size_t tile(uint32_t column, uint32_t row) const {
    return size_t{row / kSide} * across_ + column / kSide;
  }
  static size_t inside(uint32_t column, uint32_t row) {
    return size_t{row % kSide} * kSide + column % kSide;
  }

  uint32_t across_ = 0, up_ = 0;   // tiles
  std::vector<uint32_t> tile_of_;  // number of the tile in tiles_; 0: the empty one
  std::vector<Tile> tiles_;        // the first stands for all that do not exist
};

}  // namespace jalon

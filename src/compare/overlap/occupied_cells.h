// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <functional>
#include <unordered_set>
#include <vector>

#include "cloud/cloud.h"

namespace jalon {

/// A cube of a grid from the origin of coordinates.
struct GridCell {
  int64_t x = 0, y = 0, z = 0;
  bool operator==(const GridCell&) const = default;
  auto operator<=>(const GridCell&) const = default;
};

GridCell cell_of(const Vec3& p, double edge_m);

struct GridCellHash {
  size_t operator()(const GridCell& c) const {
    constexpr uint64_t kOdd[] = {0x9E3779B97F4A7C15ull, 0xC2B2AE3D27D4EB4Full,
                                 0x165667B19E3779F9ull};  // of xxHash: spread the bits
    const uint64_t h = static_cast<uint64_t>(c.x) * kOdd[0] ^ static_cast<uint64_t>(c.y) * kOdd[1] ^
                       static_cast<uint64_t>(c.z) * kOdd[2];
    return static_cast<size_t>(h ^ (h >> 29));
  }
};

/// At most kMostSampled points of a cloud, evenly of their order.
std::vector<Vec3> sampled_points(const Cloud& cloud);

/// The cells that hold points.
class OccupiedCells {
 public:
  OccupiedCells(const std::vector<Vec3>& points, double edge_m);
  size_t size() const { return cells_.size(); }
  /// Whether the cell of a place or one that touches it holds points.
  bool are_about(const Vec3& place) const;
  /// The share of these cells about which the other's are; 0 without cells.
  double share_in(const OccupiedCells& other) const;
  /// Of so many of the cells, their middles moved by a function.
  template <class F>
  double share_of_moved(size_t most, const OccupiedCells& other, F&& moved) const {
    const size_t step = cells_.size() / most + 1;
    size_t tried = 0, met = 0;
    for (size_t k = 0; k < cells_.size(); k += step, ++tried)
      met += other.are_about(moved(middle(cells_[k]))) ? 1 : 0;
    return tried == 0 ? 0 : static_cast<double>(met) / static_cast<double>(tried);
  }

 private:
  Vec3 middle(const GridCell& c) const;
  double edge_m_;
  std::vector<GridCell> cells_;  // ascending: the same order everywhere
  std::unordered_set<GridCell, GridCellHash> known_;
};

}  // namespace jalon

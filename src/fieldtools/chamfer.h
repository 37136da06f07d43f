// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "base/params.h"
#include "cloud/cloud.h"

namespace jalon {

/// A full grid of cells around some points. Cells count from the lowest point, less a margin of whole cells, so that
/// shifts by whole metres change nothing.
struct DistanceGrid {
  Vec3 lowest;  ///< lower corner of the cell that has the number margin on each axis
  double cell_m = 1;
  uint32_t margin = 1;
  std::array<uint32_t, 3> size{};  ///< cells along x, y, z

  uint64_t cells() const { return uint64_t{size[0]} * size[1] * size[2]; }
  uint64_t index(uint32_t x, uint32_t y, uint32_t z) const {
    return (uint64_t{z} * size[1] + y) * size[0] + x;
  }
  /// In cells from the lower corner of the grid.
  Vec3 place(const Vec3& p) const {
    const Vec3 d = (p - lowest) / cell_m;
    return {d.x + margin, d.y + margin, d.z + margin};
  }
};

/// Distance (m) of every cell's centre from points: a distance transform of the cells that they occupy.
struct DistanceMap {
  DistanceGrid grid;
  std::vector<float> distance_m;
};

/// The Chamfer <3, 4, 5> transform: two raster passes with 3 for faces, 4 for edges, 5 for corners, divided by 3
/// (Girardeau-Montaut 2006, annex C.2; Borgefors 1984). 0 in occupied cells; up to 11 % off the Euclidean distance
/// between cells.
std::vector<float> chamfer_distances(const DistanceGrid& grid, std::span<const uint64_t> occupied,
                                     Task& task);
/// The same by fast marching (|grad T| = 1) from the occupied cells, which start with the distance of their centre from
/// the nearest of their own points.
std::vector<float> marched_distances(const DistanceGrid& grid, std::span<const uint64_t> occupied,
                                     std::span<const float> starts, Task& task);

struct DistanceMapSettings {
  enum class Method { kChamfer, kFastMarching } method = Method::kChamfer;
  double cell_m = 0;          ///< 0: some two million cells
  double max_distance_m = 0;  ///< 0: all
  std::string name = "map_distance";
};
std::span<const ParamRow> distance_map_rows();
/// The map of the reference's distances over both clouds' boxes; see jalon/field_tools.h.
DistanceMap distance_map(const Cloud& reference, const Box3& box,
                         const DistanceMapSettings& settings, Task& task);
/// The compared cloud with the field of the map's distances.
Cloud with_map_distance(const Cloud& compared, const Cloud& reference,
                        const DistanceMapSettings& settings, Task& task);
/// The centres of the map's cells as points with the field "distance".
Cloud distance_map_cloud(const Cloud& reference, const DistanceMapSettings& settings, Task& task);

}  // namespace jalon

// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <span>

#include "cloud/cloud.h"
#include "compare/visibility/depth_angles.h"
#include "compare/visibility/depth_cells.h"
#include "compare/visibility/depth_steps.h"
#include "compare/visibility/settings.h"

namespace jalon {

/// Range image of one station from one optical centre (Girardeau-Montaut 2006, 2.3.3): rays never cross, so the two
/// angles order all that the station saw.
///
/// A cell keeps the range of its point and where in the cell that lay. Between cells the surface goes on: inverse
/// range is linear in the angles on a plane, nearly, and the gentler of the slopes to the two neighbours on either
/// side follows a surface and stops at its edge (the minmod limiter of Roe 1986). So ground under grazing rays, where
/// one cell spans metres, hides nothing of itself.
class DepthMap {
 public:
  enum class Fill : uint8_t { kEmpty, kMeasured, kFilled };
  using Cell = DepthCell;

  /// From the points of a station with a pose; centre_m: of the optics in the scanner's frame. Errors: kLimit above
  /// 2^28 cells. O(n), whatever lies between the points.
  static DepthMap build(const Cloud& cloud, const Station& station, const Vec3& centre_m,
                        const DepthSettings& settings, Task& task);

  const AngularGrid& grid() const { return grid_; }
  const Cell& cell(uint32_t column, uint32_t row) const { return cells_.cell(column, row); }
  const Cell& cell(const AngularGrid::Place& place) const { return cell(place.column, place.row); }
  /// Points of the cell.
  uint32_t count(uint32_t column, uint32_t row) const { return cells_.count(column, row); }
  Fill fill(uint32_t column, uint32_t row) const {
    return cell(column, row).range_m == 0 ? Fill::kEmpty
           : count(column, row) > 0       ? Fill::kMeasured
                                          : Fill::kFilled;
  }

  /// How many tiles of cells exist: what the map costs.
  size_t tiles() const { return cells_.tiles(); }

  /// A point of the world from the optical centre.
  Sighting sighting(const Vec3& p) const { return sighting_of(axes_.direction(p - centre_)); }
  void sight(std::span<const double> xyz, SightingBlock& out) const {
    jalon::sight(xyz, centre_, axes_, out);
  }
  /// Range of the surface in this direction; 0 for an empty cell.
  double surface_range_m(const AngularGrid::Place& place) const;
  /// Distance between the station's points there, to the farthest of the four next, as on a surface that goes on from
  /// cell to cell: that of the cells' points by the factor that cells are wider than steps. Under grazing rays it is
  /// the way along them; at an edge in depth, which the cells do not tell from a wall that is looked along, as much
  /// of the way across the edge. 0 for an empty cell.
  double spacing_m(const AngularGrid::Place& place) const;

 private:
  void accumulate(std::span<const Seen> seen, uint64_t first, CellRule rule, Task& task);
  void fill_holes(int passes, Task& task);
  /// What an empty cell gets from its neighbours; 0: nothing.
  float hole_range_m(uint32_t column, uint32_t row) const;
  const Cell* neighbour(const AngularGrid::Place& place, int columns, int rows) const;

  Vec3 centre_;     ///< of the optics, in the world
  Transform axes_;  ///< the world's directions to the scanner's
  AngularGrid grid_;
  double cell_factor_ = 1;
  DepthCells cells_;
};

}  // namespace jalon

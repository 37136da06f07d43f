// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cstdint>
#include <span>
#include <vector>

#include "base/task.h"
#include "modelling/plane/plane_frame.h"
#include "modelling/plane/ring_tools.h"
#include "segment/segmentation.h"

namespace jalon {

/// What the cloud shows at a place of a wall's plane.
enum class WallState : uint8_t {
  kEmpty = 0,  ///< nothing: no point on the plane, behind it, or before it
  kOn = 1,     ///< a point on the plane: measured
  kStrip =
      2,  ///< such points in a strip too narrow for a pier, or of another surface: frames and leaves flush with
          ///< the wall, reveals
  kThrough = 3,  ///< seen through: a point behind the plane
  kProud = 4,    ///< a point little before the plane: sills, signs, balconies
  kHidden = 5,   ///< something stands before it
  kRelief =
      6,  ///< a point a hand's breadth before the plane: surrounds, panels, closed shutters on the wall; pilasters
  kDeep = 7,     ///< far behind the plane only: arcades, gateways, rooms
  kOutside = 8,  ///< beyond the wall's border
};

inline bool is_wall(WallState state) {
  return state == WallState::kOn || state == WallState::kRelief;
}

struct CellSetting {
  double on_m = 0.03;     ///< nearer to the plane, or within four sigmas of it, is on it
  double behind_m = 1.0;  ///< points up to this far behind the plane were seen through it
  double deep_m = 8.0;    ///< and up to this far: a room's, an arcade's depth
  double relief_m = 0.1;  ///< what covers a wall stands up to this far before it
  double proud_m = 0.25;  ///< what is fixed to a wall stands up to this far before it
  double before_m = 4.0;  ///< what hides a wall stands up to this far before it
};

/// A wall's plane as cells, row by row from below.
struct WallCells {
  PlaneFrame frame;
  double spacing_m = 0;  ///< typical, of the wall's points
  double on_m = 0;       ///< half-thickness of what lies on the plane
  Vec2 origin;
  double cell_m = 0;
  uint32_t columns = 0, rows = 0;
  std::vector<WallState> states;
  /// Where the wall's points stand back a little in a rectangle: blinds (set_back.h). In the frame's coordinates.
  std::vector<RingBox> set_back;

  bool empty() const { return states.empty(); }
  WallState at(uint32_t column, uint32_t row) const {
    return states[static_cast<size_t>(row) * columns + column];
  }
  bool is_set_back(const Vec2& p) const {
    return std::any_of(set_back.begin(), set_back.end(),
                       [&](const RingBox& box) { return box.holds(p); });
  }
};

/// A plane to look at: the frame it is drawn in, and its points.
struct CellSource {
  PlaneFrame frame;
  std::span<const uint32_t> points;  ///< of the cloud
  double sigma_m = 0;
  uint32_t label = 0;  ///< of these points
};

/// The states of the cells of all planes, by one pass over the cloud. Where the station of a point is known the ray
/// from it says which cell it passed; otherwise the points lie straight behind and before theirs. A point of another
/// segment within the plane's thickness is not the wall's: clearly behind or before its middle on a parallel one (a
/// leaf almost flush with the wall, a thin surround) it counts as behind or as relief, else as flush.
///
/// Cells are 2.2 spacings wide (a cell of a wall without a point of it is one in a hundred, of points at random), and
/// wider where there would be more than four million. After: one a source, in their order; empty for a source of fewer
/// than nine points. The same bits for any number of threads. O(points x planes).
std::vector<WallCells> wall_cells(const Segmentation& segmentation,
                                  std::span<const CellSource> sources, const CellSetting& setting,
                                  Task& task);

}  // namespace jalon

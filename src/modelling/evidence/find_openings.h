// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "base/task.h"
#include "modelling/evidence/joined_lights.h"
#include "modelling/evidence/opening_shape.h"
#include "modelling/evidence/wall_cells.h"

namespace jalon {

/// How many cells of a region have which state.
struct StateCounts {
  std::array<uint32_t, 9> cells{};
  uint32_t of(WallState state) const { return cells[static_cast<size_t>(state)]; }
  uint32_t all() const;
  double share(WallState state) const;
};

/// A place of the wall's plane where no wall was measured, of a form that openings have.
struct OpeningCandidate {
  OpeningShape shape;  ///< in the plane's coordinates, m
  StateCounts inside;
  double bordered = 0;  ///< share of its border along which the wall was measured
  double framed = 0;  ///< share of its border, less the wall's foot, beyond which the wall is broad
  double jambs = 0;   ///< the same share of its steep sides alone
  double relief = 0;  ///< share of that along which relief covers the wall
  bool is_opening = false;     ///< else nothing tells an opening from what was not looked at
  bool is_narrow = false;      ///< two cells across: what a contour closes over
  bool is_open_above = false;  ///< no wall over its head
  bool ends_at_wall = false;   ///< it would be one, but another wall begins there (plane_roles.h)
  bool is_settled =
      false;  ///< relief covers the wall about it: its shape is fitted to points (point_fit.h)
};

/// Of the border of an opening that relief covers the wall along: there the wall's own points end elsewhere.
constexpr double kReliefShare = 0.25;

/// Of the border of an opening that is framed: what a bay between two piers has at least.
constexpr double kFramedShare = 0.5;
/// Of its steep sides: a wall that goes on along one of them only ends there, and the next one begins.
constexpr double kBothJambs = 0.6;

/// Whether the wall goes on beside a place on both sides.
inline bool is_framed(const OpeningCandidate& opening) {
  return opening.framed >= kFramedShare && opening.jambs >= kBothJambs;
}

/// Of the border of what is enclosed, empty openings among it.
constexpr double kEnclosedShare = 0.95;
/// Longer side of an opening of which its border alone tells.
constexpr double kLargestWindow_m = 5;

/// A surround encloses a window as the broad wall does, beside a narrow pier too. Larger places have none: they are the
/// house next door, whose neighbour's plinth and cornice go round it.
inline bool is_enclosed(const OpeningCandidate& opening) {
  const RingBox box = opening.shape.box();
  return opening.framed >= kFramedShare ||
         (opening.bordered >= kEnclosedShare && opening.relief >= kReliefShare &&
          std::max(box.width(), box.height()) <= kLargestWindow_m);
}

struct OpeningSearch {
  double least_width_m = 0.12;  ///< of what is drawn as an opening
  bool by_cells = false;        ///< by decomposed_openings() (cell_decomposition.h) instead
  double edge_length_m = 0.6;   ///< of the ends of the wall in one line that part it into cells
  double wall_share = 0.5;      ///< of such a cell: with less it is an opening
};

/// What the cells show in and about a shape, which is in cells; whether it is an opening is not told.
OpeningCandidate looked_at(const WallCells& cells, const OpeningShape& shape);

/// Openings of a wall by comparing explanations of its cells.
/// 1. Connected cells that are not wall: boxes of the greatest score, one after the other, until what is left is small.
/// 2. About each the shape that explains the cells best (shape_fit.h).
/// 3. Of shapes that lie over each other one stays: an opening before what is not known, then the better one; lights of
///    one window become one (joined_lights.h).
/// 4. Seen through, deep with a jamb and no level strip, or empty with the wall measured all round it: an opening; the
/// others are not known.
///
/// points: of the wall. After: from left to right; shapes do not overlap by more than a fifth.
std::vector<OpeningCandidate> find_openings(const WallCells& cells, const OpeningSearch& setting,
                                            Task& task, const WallPoints& points = {});

}  // namespace jalon

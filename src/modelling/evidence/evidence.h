// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <vector>

#include "base/task.h"
#include "modelling/edges/join/vectorise.h"
#include "modelling/evidence/find_openings.h"
#include "modelling/evidence/wall_cells.h"

namespace jalon {

/// What a plane before or behind a larger one, parallel to it, is to that.
enum class PlaneRole : uint8_t {
  kWall,  ///< a wall of its own, also where it stands back in a loggia
  kRelief,  ///< it covers the larger one a hand's breadth before it, or in strips: surrounds, panels, cornices
  kFilling,  ///< it lies in openings: panes, leaves, shutters
  kInside,   ///< a room's wall, seen at a slant through openings and so also behind what is wall
};

/// What the cloud shows of a plane that may be a wall.
struct WallEvidence {
  WallCells cells;
  std::vector<OpeningCandidate> openings;
  double gross_m2 = 0, measured_m2 = 0;  ///< of what is within its border; of what was measured
  PlaneRole role = PlaneRole::kWall;
  bool is_recess =
      false;  ///< the sides of another wall's openings lead to it: a loggia's back wall
  bool empty() const { return cells.empty(); }
  bool has_framed_openings() const {
    return std::any_of(openings.begin(), openings.end(),
                       [](const auto& o) { return o.is_opening && o.framed >= kFramedShare; });
  }
  bool is_wall() const { return !empty() && role == PlaneRole::kWall; }
  /// The contour of its points shows the same openings: they are drawn by it, and judged by what lies in them.
  bool is_plain = false;
  bool is_drawn() const { return is_wall() && !is_plain; }
};

struct EvidenceSetting {
  CellSetting cells;
  OpeningSearch openings;
  double least_area_m2 = 1;  ///< of planes that are looked at
};

/// Evidence for every upright plane of the segmentation, out[s] of segments[s]; empty for the others. The same bits for
/// any number of threads.
std::vector<WallEvidence> gather_evidence(const Segmentation& segmentation,
                                          const EvidenceSetting& setting, Task& task);

/// Its two steps, for a segmentation that changes: cells and openings of the planes among these segments; and what all
/// planes are to each other.
void look_at_planes(const Segmentation& segmentation, std::span<const size_t> segments,
                    const EvidenceSetting& setting, std::vector<WallEvidence>& out, Task& task);
void tell_planes(const Segmentation& segmentation, const EvidenceSetting& setting,
                 std::vector<WallEvidence>& out, Task& task);

/// Two walls side by side, one up to relief_m before the other: what was measured of the front one is no relief of the
/// other, which ends there, and the openings that the front one frames are its own. Panels stand before the wall that
/// goes on all along them. Before: planes are told.
void end_behind_walls(std::vector<WallEvidence>& all, double relief_m, Task& task);

/// Draws the walls by their evidence and other planes as they are; a wall whose contour has the openings of its
/// evidence, each and no other (but narrow ones, which it may have closed over), as it is too, and sets is_plain. The
/// evidence must outlive it.
ContourMaker contours_by(std::vector<WallEvidence>& evidence);

}  // namespace jalon

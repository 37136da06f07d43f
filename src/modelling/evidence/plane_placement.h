// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "modelling/evidence/evidence.h"

namespace jalon {

inline constexpr double kSameWay = 0.985;    ///< cosine of 10 degrees: of parallel planes
inline constexpr double kWithinShare = 0.7;  ///< of a plane, within the border of another
inline constexpr double kBroad_m = 0.6;      ///< less than a pier between two windows
inline constexpr double kTallShare = 0.5;

/// Where the measured cells of a plane lie to a wall, as shares of them.
struct PlanePlacement {
  double in_openings = 0;  ///< framed ones alone where the plane has such openings itself
  double behind_wall = 0;  ///< straight behind or before what was measured, away from its borders
  double within = 0;       ///< the wall's border
  double relief = 0;       ///< before what the wall counts as covered
  double depth_m = 0;      ///< behind the wall, in the mean
};

/// O(cells, 20 000 at most, x openings).
PlanePlacement placement_of(const WallEvidence& plane, const WallEvidence& wall);

/// Share of the measured cells of a plane that have measured places of the wall to the left and right, above and below.
double surrounded_share(const WallEvidence& plane, const WallEvidence& wall);

/// Away from the borders of what was measured.
bool is_well_inside(const WallCells& cells, uint32_t column, uint32_t row);

/// Whether a place before a plane lies in an opening of the wall. Walls have windows; gates and shutters, which may be
/// as large, have none: a plane with openings of its own fills framed openings only, any other fills what it lies in.
bool is_in_opening(const WallEvidence& wall, const Vec2& at, bool only_framed);

/// Whether somewhere a square of this side is measured: walls are broad somewhere, surrounds and cornices nowhere.
bool is_broad(const WallCells& cells, double side_m);

/// Share of the measured cells in connected pieces as tall as a storey's wall: parapets of balconies are not.
double tall_share(const WallCells& cells);

/// Hardly measured, of what its border encloses: panes here and there.
bool is_sparse(const WallEvidence& plane);

/// Whether a plane that lies so to a wall lies before it as what covers one does.
bool is_cover_at(const PlanePlacement& placement, const WallEvidence& plane,
                 const CellSetting& setting);

/// Whether a plane is the wall of a house that stands forward by as much as things are fixed to walls: broad and tall,
/// with windows of its own, and nothing of the other wall in its place. What covers a wall leaves that in sight in
/// between.
bool is_house_before(const WallEvidence& plane, const WallEvidence& wall);

/// Two explanations of a plane in pieces between windows that it does not frame, before a wall that goes on all about
/// it: panels of that, or a second wall over it with the same windows once more. The first one needs one wall. Where
/// the one wall goes on beside the other alone these are two houses.
bool is_laid_on(const WallEvidence& plane, const WallEvidence& wall, const CellSetting& setting);

inline double area_of(const OpeningCandidate& opening, const WallCells& cells) {
  return opening.inside.all() * cells.cell_m * cells.cell_m;
}

inline double ratio_of(size_t part, size_t all) {
  return all > 0 ? static_cast<double>(part) / static_cast<double>(all) : 0;
}

}  // namespace jalon

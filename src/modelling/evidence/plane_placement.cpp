// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "modelling/evidence/plane_placement.h"

#include <algorithm>
#include <cmath>

#include "modelling/evidence/cell_regions.h"
#include "modelling/evidence/cell_sums.h"
#include "modelling/evidence/places.h"

namespace jalon {

namespace {

constexpr double kSparseShare = 0.2;  // measured, of what its border encloses: panes here and there
constexpr double kBroadShare = 0.7;
constexpr double kTall_m = 2;        // parapets are no taller than 1.3 m
constexpr uint32_t kWellInside = 2;  // cells from a wall cell to others: away from its borders
constexpr double kCoverShare = 0.6;  // of pilasters: cells of the wall that they are relief of
constexpr double kMostlyFramed = 0.5;
constexpr double kSharedShare = 0.2;  // of a house's place: panes in the plane of the next one

// First and last of some cells of each line; first > last: none.
struct MeasuredReach {
  std::vector<uint32_t> first, last;
  explicit MeasuredReach(size_t lines) : first(lines, ~uint32_t{0}), last(lines, 0) {}
  void add(size_t line, uint32_t at) {
    first[line] = std::min(first[line], at);
    last[line] = std::max(last[line], at);
  }
  bool holds(size_t line, uint32_t at) const { return first[line] < at && at < last[line]; }
};

bool has_openings(const WallEvidence& plane) {
  return std::any_of(plane.openings.begin(), plane.openings.end(),
                     [](const OpeningCandidate& opening) { return opening.is_opening; });
}

// Whether a plane goes on beside most of its windows on both sides. Panels between those of a wall lie over and under
// them, or beside them on one side.
bool frames_its_windows(const WallEvidence& plane) {
  double framed_m2 = 0, all_m2 = 0;
  for (const OpeningCandidate& opening : plane.openings) {
    if (!opening.is_opening) continue;
    all_m2 += area_of(opening, plane.cells);
    if (is_framed(opening)) framed_m2 += area_of(opening, plane.cells);
  }
  return all_m2 > 0 && framed_m2 >= kMostlyFramed * all_m2;
}

// A plane with windows of its own fills nothing that is both wider and higher than windows are: it is a wall set back.
bool is_window_frame(const OpeningCandidate& opening) {
  const RingBox box = opening.shape.box();
  return is_enclosed(opening) && std::min(box.width(), box.height()) <= kLargestWindow_m;
}

}  // namespace

bool is_well_inside(const WallCells& cells, uint32_t c, uint32_t r) {
  const uint32_t k = kWellInside;
  if (c < k || r < k || c + k >= cells.columns || r + k >= cells.rows) return false;
  for (const auto& [dc, dr] : {std::pair{0u, k}, {2 * k, k}, {k, 0u}, {k, 2 * k}, {k, k}})
    if (cells.at(c + dc - k, r + dr - k) != WallState::kOn) return false;
  return true;
}

// A cell with a point of the wall ends an opening: frames stand in its rim.
bool is_in_opening(const WallEvidence& wall, const Vec2& at, bool only_framed) {
  const double rim_m = wall.cells.cell_m;
  return std::any_of(wall.openings.begin(), wall.openings.end(), [&](const auto& opening) {
    return opening.is_opening && (!only_framed || is_window_frame(opening)) &&
           opening.shape.box().grown(rim_m).holds(at) && opening.shape.grown(rim_m).holds(at);
  });
}

PlanePlacement placement_of(const WallEvidence& plane, const WallEvidence& wall) {
  const bool is_windowed = plane.has_framed_openings();
  size_t on = 0, openings = 0, behind = 0, within = 0, relief = 0;
  double depths = 0;
  for_measured(plane.cells, [&](const Vec3& p) {
    const Foot foot(wall.cells, p);
    ++on;
    depths += foot.depth_m;
    if (!foot.is_on_map) return;
    within += wall.cells.at(foot.column, foot.row) != WallState::kOutside;
    relief += wall.cells.at(foot.column, foot.row) == WallState::kRelief;
    behind += is_well_inside(wall.cells, foot.column, foot.row);
    openings += is_in_opening(wall, foot.at, is_windowed);
  });
  if (on == 0) return {};
  return {ratio_of(openings, on), ratio_of(behind, on), ratio_of(within, on), ratio_of(relief, on),
          depths / static_cast<double>(on)};
}

double surrounded_share(const WallEvidence& plane, const WallEvidence& wall) {
  const WallCells& cells = wall.cells;
  MeasuredReach rows(cells.rows), columns(cells.columns);
  for (uint32_t r = 0; r < cells.rows; ++r)
    for (uint32_t c = 0; c < cells.columns; ++c)
      if (cells.at(c, r) == WallState::kOn) {
        rows.add(r, c);
        columns.add(c, r);
      }
  size_t on = 0, within = 0;
  for_measured(plane.cells, [&](const Vec3& p) {
    const Foot foot(cells, p);
    ++on;
    within +=
        foot.is_on_map && rows.holds(foot.row, foot.column) && columns.holds(foot.column, foot.row);
  });
  return ratio_of(within, on);
}

bool is_broad(const WallCells& cells, double side_m) {
  const auto side = static_cast<uint32_t>(std::ceil(side_m / cells.cell_m));
  const CellSums<int32_t> on(cells.columns, cells.rows, [&](size_t k) {
    return static_cast<int32_t>(cells.states[k] == WallState::kOn);
  });
  const auto least = static_cast<int32_t>(kBroadShare * side * side);
  for (uint32_t r = 0; r + side <= cells.rows; ++r)
    for (uint32_t c = 0; c + side <= cells.columns; ++c)
      if (on.of(c, r, c + side, r + side) >= least) return true;
  return false;
}

double tall_share(const WallCells& cells) {
  std::vector<uint32_t> on;
  for (size_t k = 0; k < cells.states.size(); ++k)
    if (cells.states[k] == WallState::kOn) on.push_back(static_cast<uint32_t>(k));
  CellRegions regions(cells.columns, cells.rows);
  size_t tall = 0;
  for (const std::vector<uint32_t>& region : regions.of(on)) {
    const auto [low, high] = std::minmax_element(region.begin(), region.end());
    const uint32_t rows = *high / cells.columns - *low / cells.columns + 1;
    if (rows * cells.cell_m >= kTall_m) tall += region.size();
  }
  return ratio_of(tall, on.size());
}

bool is_sparse(const WallEvidence& plane) {
  return plane.measured_m2 < kSparseShare * plane.gross_m2;
}

bool is_cover_at(const PlanePlacement& p, const WallEvidence& plane, const CellSetting& setting) {
  if (p.within < kWithinShare || p.depth_m >= -plane.cells.on_m / 2) return false;
  return p.depth_m >= -setting.relief_m ||
         (p.depth_m >= -setting.proud_m && p.relief >= kCoverShare);
}

bool is_house_before(const WallEvidence& plane, const WallEvidence& wall) {
  return frames_its_windows(plane) && is_broad(plane.cells, kBroad_m) &&
         tall_share(plane.cells) >= kTallShare &&
         placement_of(wall, plane).within * wall.measured_m2 < kSharedShare * plane.gross_m2;
}

bool is_laid_on(const WallEvidence& plane, const WallEvidence& wall, const CellSetting& setting) {
  return has_openings(plane) && !frames_its_windows(plane) && wall.is_wall() &&
         wall.has_framed_openings() &&
         dot(wall.cells.frame.normal, plane.cells.frame.normal) >= kSameWay &&
         is_cover_at(placement_of(plane, wall), plane, setting) &&
         surrounded_share(plane, wall) >= kWithinShare;
}

}  // namespace jalon

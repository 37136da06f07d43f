// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "modelling/evidence/evidence.h"

#include <algorithm>
#include <cmath>

#include "base/parallel.h"
#include "modelling/evidence/cell_regions.h"
#include "modelling/evidence/cell_sums.h"
#include "modelling/evidence/contour_holes.h"
#include "modelling/evidence/drawn_contour.h"
#include "modelling/plane/segment_frame.h"
#include "segment/labels/label_groups.h"
#include "segment/upright.h"

namespace jalon {

namespace {

constexpr double kSameWay = 0.985;     // cosine of 10 degrees
constexpr double kFillingShare = 0.6;  // of a plane's cells in the openings of another
constexpr double kSparseShare = 0.2;  // measured, of what its border encloses: panes here and there
constexpr double kFillingDepth_m = 0.6;  // panes and leaves stand no deeper, loggias do
constexpr double kRoomDepth_m = 12;      // rooms are no deeper
// Of a room's wall: straight behind the front's measured wall, and within its border.
constexpr double kBehindWallShare = 0.08, kWithinShare = 0.7;
constexpr double kShopFrontShare =
    0.15;  // of the area behind an arcade: a room's wall has no shop fronts
constexpr double kBroad_m = 0.6, kBroadShare = 0.7;  // less than a pier between two windows
constexpr double kTall_m = 2, kTallShare = 0.5;      // parapets are no taller than 1.3 m
constexpr double kCornice_m = 0.6;                   // strips of a wall stand no farther before it
constexpr uint32_t kWellInside = 2;  // cells from a wall cell to others: away from its borders
constexpr size_t kLookedAtCells = 20000;

// Where the cells of a plane lie to a wall before it, as shares of its measured ones.
struct Placement {
  double in_openings = 0, behind_wall = 0, within = 0, depth_m = 0;
};

bool is_well_inside(const WallCells& cells, uint32_t c, uint32_t r) {
  const uint32_t k = kWellInside;
  if (c < k || r < k || c + k >= cells.columns || r + k >= cells.rows) return false;
  for (const auto& [dc, dr] : {std::pair{0u, k}, {2 * k, k}, {k, 0u}, {k, 2 * k}, {k, k}})
    if (cells.at(c + dc - k, r + dr - k) != WallState::kOn) return false;
  return true;
}

Placement placement_of(const WallCells& cells, const WallEvidence& wall) {
  Placement out;
  size_t on = 0, openings = 0, behind = 0, within = 0;
  double depths = 0;
  const WallCells& front = wall.cells;
  const size_t step = std::max<size_t>(1, cells.states.size() / kLookedAtCells);
  for (size_t k = 0; k < cells.states.size(); k += step) {
    if (cells.states[k] != WallState::kOn) continue;
    const Vec3 p = cells.frame.lift(
        cells.origin + Vec2{(static_cast<double>(k % cells.columns) + 0.5) * cells.cell_m,
                            (static_cast<double>(k / cells.columns) + 0.5) * cells.cell_m});
    ++on;
    depths += front.frame.height - dot(p - front.frame.origin, front.frame.normal);
    const Vec2 q = front.frame.project(p);
    const double c = (q.u - front.origin.u) / front.cell_m,
                 r = (q.v - front.origin.v) / front.cell_m;
    if (!(c >= 0 && r >= 0 && c < front.columns && r < front.rows)) continue;
    const auto column = static_cast<uint32_t>(c), row = static_cast<uint32_t>(r);
    within += front.at(column, row) != WallState::kOutside;
    behind += is_well_inside(front, column, row);
    openings += std::any_of(wall.openings.begin(), wall.openings.end(), [&](const auto& opening) {
      return opening.is_opening && opening.shape.holds(q);
    });
  }
  if (on == 0) return out;
  const auto all = static_cast<double>(on);
  out.in_openings = static_cast<double>(openings) / all;
  out.behind_wall = static_cast<double>(behind) / all;
  out.within = static_cast<double>(within) / all;
  out.depth_m = depths / all;
  return out;
}

// Whether somewhere a square of this side is measured: walls are broad somewhere, surrounds and cornices nowhere.
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

// Share of the measured cells in connected pieces as tall as a storey's wall: parapets of balconies are not.
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
  return on.empty() ? 0 : static_cast<double>(tall) / static_cast<double>(on.size());
}

// Area of the openings that things were seen through.
double seen_through_m2(const WallEvidence& plane) {
  double sum = 0;
  for (const OpeningCandidate& opening : plane.openings)
    if (opening.is_opening && opening.inside.of(WallState::kThrough) > 0)
      sum += opening.inside.all() * plane.cells.cell_m * plane.cells.cell_m;
  return sum;
}

PlaneRole role_of(const Placement& p, const WallEvidence& plane, const CellSetting& setting) {
  const WallCells& cells = plane.cells;
  const double on_m = cells.on_m / 2;
  if (p.within < kWithinShare) return PlaneRole::kWall;
  const bool is_sparse = plane.measured_m2 < kSparseShare * plane.gross_m2;
  if (p.depth_m < -on_m) {
    const bool is_cover = p.depth_m >= -setting.relief_m;
    const bool is_strip = p.depth_m >= -kCornice_m && !is_broad(cells, kBroad_m);
    return is_cover || is_strip || is_sparse || tall_share(cells) < kTallShare ? PlaneRole::kRelief
                                                                               : PlaneRole::kWall;
  }
  if (p.depth_m <= on_m || p.depth_m > kRoomDepth_m) return PlaneRole::kWall;
  if ((p.in_openings >= kFillingShare || is_sparse) && p.depth_m <= kFillingDepth_m)
    return PlaneRole::kFilling;
  const bool is_room = p.behind_wall >= kBehindWallShare &&
                       seen_through_m2(plane) < kShopFrontShare * plane.gross_m2;
  return is_room ? PlaneRole::kInside : PlaneRole::kWall;
}

// Of planes by falling area within their borders: so that a lattice of posts comes before the panes in its bays.
void tell_roles(std::vector<WallEvidence>& all, const CellSetting& setting, Task& task) {
  std::vector<size_t> order;
  for (size_t s = 0; s < all.size(); ++s)
    if (!all[s].empty()) order.push_back(s);
  std::stable_sort(order.begin(), order.end(),
                   [&](size_t a, size_t b) { return all[a].gross_m2 > all[b].gross_m2; });
  for (size_t k = 0; k < order.size(); ++k) {
    WallEvidence& plane = all[order[k]];
    for (size_t w = 0; w < k && plane.is_wall(); ++w) {
      const WallEvidence& wall = all[order[w]];
      if (!wall.is_wall() ||
          std::fabs(dot(wall.cells.frame.normal, plane.cells.frame.normal)) < kSameWay)
        continue;
      task.checkpoint(0);
      plane.role = role_of(placement_of(plane.cells, wall), plane, setting);
    }
  }
}

std::vector<OpeningShape> shapes_of(std::span<const OpeningCandidate> candidates) {
  std::vector<OpeningShape> out;
  for (const OpeningCandidate& candidate : candidates)
    if (candidate.is_opening) out.push_back(candidate.shape);
  return out;
}

}  // namespace

std::vector<WallEvidence> gather_evidence(const Segmentation& segmentation,
                                          const EvidenceSetting& setting, Task& task) {
  const auto& segments = segmentation.segments;
  std::vector<WallEvidence> out(segments.size());
  // 1. Planes to look at.
  const LabelGroups groups(segmentation.labels->values<uint32_t>(), segments.size(), task);
  std::vector<size_t> walls;
  std::vector<CellSource> sources;
  for (size_t s = 0; s < segments.size(); ++s) {
    const Segment& segment = segments[s];
    const auto indices = groups.of(static_cast<uint32_t>(s + 1));
    if (!segment.has_plane() || segment.area_m2 < setting.least_area_m2 || indices.empty() ||
        std::fabs(segment.fit.plane.normal.z) > kWallSine)
      continue;
    walls.push_back(s);
    sources.push_back(
        {segment_frame(segmentation, segment, indices), indices, segment.fit.sigma, segment.label});
  }
  // 2. One look at the cloud.
  std::vector<WallCells> cells = wall_cells(segmentation, sources, setting.cells, task);
  // 3. Openings.
  parallel_for(task, walls.size(), 1, [&](size_t begin, size_t end) {
    for (size_t w = begin; w < end; ++w) {
      WallEvidence& evidence = out[walls[w]];
      evidence.cells = std::move(cells[w]);
      if (evidence.empty()) continue;
      evidence.openings = find_openings(evidence.cells, setting.openings, task);
      const auto area_of = [&](auto&& counts) {
        const auto& states = evidence.cells.states;
        return static_cast<double>(std::count_if(states.begin(), states.end(), counts)) *
               evidence.cells.cell_m * evidence.cells.cell_m;
      };
      evidence.gross_m2 = area_of([](WallState s) { return s != WallState::kOutside; });
      evidence.measured_m2 = area_of([](WallState s) { return s == WallState::kOn; });
    }
  });
  // 4. Surrounds, panes, leaves and rooms.
  tell_roles(out, setting.cells, task);
  return out;
}

ContourMaker contours_by(std::vector<WallEvidence>& evidence) {
  return [&evidence](size_t segment, std::span<const Vec2> points, const ContourSetting& setting,
                     const ForeignTest& foreign, Task& task) {
    WallEvidence& wall = evidence[segment];
    Contour plain = extract_contour(points, setting, task, foreign);
    wall.is_plain = wall.is_wall() && shows(plain, shapes_of(wall.openings));
    if (!wall.is_drawn()) return plain;
    return drawn_contour(points, wall.openings, plain, wall.cells, setting, foreign, task);
  };
}

}  // namespace jalon

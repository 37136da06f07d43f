// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "compare/landslide/surveyed_cells.h"

#include <cmath>

#include "base/numbers.h"
#include "base/parallel.h"
#include "compare/detection/found_stations.h"
#include "compare/landslide/cell_map.h"
#include "compare/visibility/visibility.h"
#include "geometry/polygon2.h"

namespace jalon {

namespace {

constexpr size_t kSightGrain = 256;
constexpr int kRelaxations = 30;  // holes of some ten cells across come to rest

std::vector<uint8_t> inside_outline(const VolumeGrid& grid, const std::vector<Vec3>& corners) {
  std::vector<Vec2> ring;
  for (const Vec3& corner : corners) {
    const Vec3 p = grid.project(corner);
    ring.push_back({p.x, p.y});
  }
  std::vector<uint8_t> out(grid.cells(), 0);
  for (size_t cell = 0; cell < out.size(); ++cell) {
    const Vec3 p = grid.project(grid.place(cell, 0));
    out[cell] = contains(ring, {p.x, p.y}) ? 1 : 0;
  }
  return out;
}

// All but what can be reached from the border of the grid over cells without points.
std::vector<uint8_t> with_points_or_enclosed(const VolumeGrid& grid, const GroundHeights& before,
                                             const GroundHeights& after) {
  std::vector<uint8_t> out(grid.cells(), 1);
  std::vector<size_t> open;
  const auto leave = [&](size_t cell) {
    if (out[cell] == 0 || before.points[cell] > 0 || after.points[cell] > 0) return;
    out[cell] = 0;
    open.push_back(cell);
  };
  for (size_t c = 0; c < grid.columns; ++c) {
    leave(c);
    leave((size_t{grid.rows} - 1) * grid.columns + c);
  }
  for (size_t r = 0; r < grid.rows; ++r) {
    leave(r * grid.columns);
    leave((r + 1) * grid.columns - 1);
  }
  while (!open.empty()) {
    const size_t cell = open.back();
    open.pop_back();
    for_each_around(grid, cell, leave, true);
  }
  return out;
}

/// Filled cells, those inside first, then those by so many steps from one of them.
struct FilledCells {
  std::vector<size_t> cells;
  std::vector<size_t> ends;  ///< of the cells within 0, 1, 2 ... steps
};

// As far as the value of one gets to a cell inside: a step a relaxation, and through filled cells alone.
FilledCells filled_near(const VolumeGrid& grid, const std::vector<size_t>& filled,
                        const std::vector<uint8_t>& is_inside) {
  FilledCells out;
  std::vector<uint8_t> waits(grid.cells(), 0);
  for (const size_t cell : filled) {
    waits[cell] = is_inside[cell] == 0 ? 1 : 0;
    if (is_inside[cell] != 0) out.cells.push_back(cell);
  }
  size_t begin = 0;
  for (int step = 0; step < kRelaxations; ++step) {
    const size_t end = out.cells.size();
    out.ends.push_back(end);
    for (; begin < end; ++begin)
      for_each_around(grid, out.cells[begin], [&](size_t other) {
        if (waits[other] == 0) return;
        waits[other] = 0;
        out.cells.push_back(other);
      });
  }
  return out;
}

// Cells that were filled become the mean of those around, over and over: the membrane between the measured ones. Those
// outside only as long as one inside still hears of it.
void relax_places(const VolumeGrid& grid, const FilledCells& filled, std::vector<double>& place_m,
                  Task& task) {
  std::vector<double> next(filled.cells.size());
  for (int sweep = 0; sweep < kRelaxations; ++sweep) {
    task.checkpoint(0);
    const size_t count = filled.ends[static_cast<size_t>(kRelaxations - 1 - sweep)];
    for (size_t k = 0; k < count; ++k) {
      double sum = 0, n = 0;
      for_each_around(grid, filled.cells[k], [&](size_t other) {
        sum += place_m[other];
        n += 1;
      });
      next[k] = sum / n;
    }
    for (size_t k = 0; k < count; ++k) place_m[filled.cells[k]] = next[k];
  }
}

// Ring by ring, each cell the mean of those around that are known.
void fill_places(const VolumeGrid& grid, const std::vector<uint8_t>& is_inside,
                 std::vector<double>& place_m, Task& task) {
  std::vector<size_t> filled;
  std::vector<size_t> ring;
  const auto is_known = [&](size_t cell) { return place_m[cell] == place_m[cell]; };
  const auto has_known_neighbour = [&](size_t cell) {
    bool known = false;
    for_each_around(grid, cell, [&](size_t other) { known = known || is_known(other); });
    return known;
  };
  for (size_t cell = 0; cell < place_m.size(); ++cell)
    if (!is_known(cell) && has_known_neighbour(cell)) ring.push_back(cell);
  std::vector<uint8_t> is_listed(place_m.size(), 0);
  while (!ring.empty()) {
    task.checkpoint(0);
    std::vector<double> heights;
    for (const size_t cell : ring) {
      double sum = 0, n = 0;
      for_each_around(grid, cell, [&](size_t other) {
        if (!is_known(other)) return;
        sum += place_m[other];
        n += 1;
      });
      heights.push_back(sum / n);
    }
    for (size_t k = 0; k < ring.size(); ++k) place_m[ring[k]] = heights[k];
    filled.insert(filled.end(), ring.begin(), ring.end());
    std::vector<size_t> next;
    for (const size_t cell : ring)
      for_each_around(grid, cell, [&](size_t other) {
        if (is_known(other) || is_listed[other] != 0) return;
        is_listed[other] = 1;
        next.push_back(other);
      });
    ring = std::move(next);
  }
  relax_places(grid, filled_near(grid, filled, is_inside), place_m, task);
}

// What became of an epoch's cells without ground.
void tell_why(const VolumeGrid& grid, const GroundHeights& heights, const CloudPtr& cloud,
              const LandslideSettings& settings, const SurveyedCells& cells,
              std::vector<CompareStatus>& out, Task& task) {
  out.assign(grid.cells(), CompareStatus::kCompared);
  std::vector<size_t> missing;
  for (size_t cell = 0; cell < out.size(); ++cell) {
    if (cells.is_inside[cell] == 0 || !std::isnan(heights.height[cell])) continue;
    out[cell] =
        heights.points[cell] > 0 ? CompareStatus::kTooFewPoints : CompareStatus::kNothingNear;
    if (heights.points[cell] == 0) missing.push_back(cell);
  }
  if (missing.empty() || settings.stations == LandslideSettings::Stations::kNone) return;
  const CloudPtr placed = with_found_stations(cloud, task);
  if (!has_all_stations(*placed)) return;
  DepthSettings depth;
  depth.max_range_m = settings.max_range_m;
  const VisibilityTest test(*placed, depth, task);
  parallel_for(task, missing.size(), kSightGrain, [&](size_t begin, size_t end) {
    for (size_t k = begin; k < end; ++k) {
      const size_t cell = missing[k];
      if (std::isnan(cells.place_m[cell])) continue;
      const Visibility seen = test.label(grid.place(cell, cells.place_m[cell]));
      if (seen != Visibility::kVisible) out[cell] = static_cast<CompareStatus>(seen);
    }
  });
}

}  // namespace

SurveyedCells surveyed_cells(const VolumeGrid& grid, const GroundHeights& before,
                             const GroundHeights& after, const CloudPtr& reference,
                             const CloudPtr& compared, const LandslideSettings& settings,
                             Task& task) {
  SurveyedCells out;
  out.is_inside = settings.outline.empty() ? with_points_or_enclosed(grid, before, after)
                                           : inside_outline(grid, settings.corners());
  out.place_m.resize(grid.cells());
  for (size_t cell = 0; cell < grid.cells(); ++cell)
    out.place_m[cell] = std::isnan(after.height[cell]) ? before.height[cell] : after.height[cell];
  fill_places(grid, out.is_inside, out.place_m, task);
  {
    const ProgressSpan span(task, 0, 0.5, "what the reference's scanners saw");
    tell_why(grid, before, reference, settings, out, out.reference, task);
  }
  const ProgressSpan span(task, 0.5, 1, "what the compared scanners saw");
  tell_why(grid, after, compared, settings, out, out.compared, task);
  return out;
}

}  // namespace jalon

// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "compare/visibility/depth_map.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "base/error.h"
#include "base/numbers.h"
#include "base/parallel.h"

namespace jalon {

namespace {

constexpr size_t kDepthMapGrain = 1 << 14;     // points a chunk: about 1 ms
constexpr size_t kDepthMapPerCheck = 1 << 18;  // points of the serial passes
constexpr uint64_t kMaxCells = uint64_t{1} << 28;

/// The grid over the field. Outermost points lie half a step inside, as on a scanner's lattice.
AngularGrid grid_over(const AngularField& field, const AngularSteps& steps, double cell_factor) {
  AngularGrid grid;
  grid.horizontal_step_rad = steps.horizontal_rad * cell_factor;
  grid.vertical_step_rad = steps.vertical_rad * cell_factor;
  const double across =
      (field.horizontal_extent_rad + steps.horizontal_rad) / grid.horizontal_step_rad;
  const double up = (field.vertical_extent_rad + steps.vertical_rad) / grid.vertical_step_rad;
  if (!(across * up < static_cast<double>(kMaxCells)))
    fail(Status::kLimit, "a depth map of more than 2^28 cells: take larger angular steps");
  // The last half step may be cut: an estimated step a little too small must not give an empty border.
  const double spare = 0.25 / cell_factor;
  grid.columns = static_cast<uint32_t>(std::max(1.0, std::ceil(across - spare)));
  grid.rows = static_cast<uint32_t>(std::max(1.0, std::ceil(up - spare)));
  grid.vertical_from_rad = field.vertical_from_rad - steps.vertical_rad / 2;
  grid.horizontal_from_rad = field.horizontal_from_rad - steps.horizontal_rad / 2;
  if (field.is_closed || grid.columns * grid.horizontal_step_rad >= 2 * std::numbers::pi) {
    grid.is_closed = true;
    grid.horizontal_from_rad = field.horizontal_from_rad;
    grid.columns = std::max(
        1u, static_cast<uint32_t>(std::lround(2 * std::numbers::pi / grid.horizontal_step_rad)));
    grid.horizontal_step_rad = 2 * std::numbers::pi / grid.columns;
  }
  if (grid.horizontal_from_rad < -std::numbers::pi)
    grid.horizontal_from_rad += 2 * std::numbers::pi;
  return grid;
}

/// Slope of inverse range between the points of two cells that lie this far apart, in cells. NaN without a second
/// point, or with one too close for a slope.
double slope(const DepthMap::Cell& from, const DepthMap::Cell* to, double apart) {
  constexpr double kLeastApart = 0.4;
  if (to == nullptr || std::abs(apart) < kLeastApart) return kNaN;
  return (1 / double{to->range_m} - 1 / double{from.range_m}) / apart;
}

/// Of two slopes of one sign the gentler, else none (Roe 1986); next to an empty cell the only one.
double limited(double a, double b) {
  if (std::isnan(a)) return std::isnan(b) ? 0 : b;
  if (std::isnan(b)) return a;
  if (a * b <= 0) return 0;
  return std::abs(a) < std::abs(b) ? a : b;
}

}  // namespace

DepthMap DepthMap::build(const Cloud& cloud, const Station& station, const Vec3& centre_m,
                         const DepthSettings& settings, Task& task) {
  DepthMap map;
  map.centre_ = station.pose.point(centre_m);
  map.axes_ = inverse(station.pose);

  // 1. The points as the station sees them.
  std::vector<Seen> seen(station.count);
  {
    const ProgressSpan span(task, 0, 0.4, "depth map");
    parallel_for(task, seen.size(), kDepthMapGrain, [&](size_t begin, size_t end) {
      SightingBlock block;
      for (size_t first = begin; first < end; first += SightingBlock::kPoints) {
        const size_t n = std::min(end - first, SightingBlock::kPoints);
        map.sight(cloud.xyz().subspan(3 * (station.first + first), 3 * n), block);
        for (size_t i = 0; i < n; ++i)
          seen[first + i] = {static_cast<float>(block.horizontal_rad[i]),
                             static_cast<float>(block.vertical_rad[i]),
                             static_cast<float>(block.range_m[i])};
      }
    });
  }
  if (seen.empty()) return map;

  // 2. Field, steps, grid.
  AngularField field;
  {
    const ProgressSpan span(task, 0.4, 0.5);
    field = angular_field(seen, task);
  }
  AngularSteps steps{settings.horizontal_step_rad, settings.vertical_step_rad};
  if (!(steps.horizontal_rad > 0 && steps.vertical_rad > 0)) {
    const ProgressSpan span(task, 0.5, 0.6);
    const AngularSteps found = angular_steps(seen, field, task);
    if (!(steps.horizontal_rad > 0)) steps.horizontal_rad = found.horizontal_rad;
    if (!(steps.vertical_rad > 0)) steps.vertical_rad = found.vertical_rad;
  }
  map.grid_ = grid_over(field, steps, settings.cell_factor);
  map.cell_factor_ = settings.cell_factor;

  // 3. One range a cell; holes from their neighbours.
  const ProgressSpan span(task, 0.6, 1);
  map.accumulate(seen, station.first, settings.rule, task);
  map.fill_holes(settings.fill_passes, task);
  return map;
}

void DepthMap::accumulate(std::span<const Seen> seen, uint64_t first, CellRule rule, Task& task) {
  cells_ = DepthCells(grid_.columns, grid_.rows);
  for (size_t i = 0; i < seen.size(); ++i) {
    if (i % kDepthMapPerCheck == 0)
      task.checkpoint(0.8 * static_cast<double>(i) / static_cast<double>(seen.size()));
    AngularGrid::Place place;
    const float range = seen[i].range_m;
    // A point in the optical centre has no direction.
    if (!(range > 0) || !grid_.locate({seen[i].horizontal_rad, seen[i].vertical_rad, range}, place))
      continue;
    const auto [cell, count] = cells_.at(place.column, place.row);
    const auto u = static_cast<float>(place.u), v = static_cast<float>(place.v);
    const auto n = static_cast<float>(++count);
    if (cell.point == kNoPoint || range < seen[cell.point - first].range_m)
      cell.point = static_cast<uint32_t>(first + i);
    if (rule == CellRule::kMean) {
      cell.range_m += (range - cell.range_m) / n;
      cell.u += (u - cell.u) / n;
      cell.v += (v - cell.v) / n;
    } else if (n == 1 ||
               (rule == CellRule::kNearest ? range < cell.range_m : range > cell.range_m)) {
      cell = {range, u, v, cell.point};
    }
  }
}

const DepthMap::Cell* DepthMap::neighbour(const AngularGrid::Place& place, int columns,
                                          int rows) const {
  const int64_t row = int64_t{place.row} + rows;
  int64_t column = int64_t{place.column} + columns;
  if (grid_.is_closed) column = (column + grid_.columns) % grid_.columns;
  if (row < 0 || row >= grid_.rows || column < 0 || column >= grid_.columns) return nullptr;
  const Cell& found = cell(static_cast<uint32_t>(column), static_cast<uint32_t>(row));
  return found.range_m > 0 ? &found : nullptr;
}

float DepthMap::hole_range_m(uint32_t column, uint32_t row) const {
  constexpr int kLeastNeighbours = 4;  // of eight: the sky stays open
  if (cell(column, row).range_m > 0) return 0;
  int n = 0;
  double sum = 0;
  for (int k = 0; k < 9; ++k)
    if (const Cell* next = k == 4 ? nullptr : neighbour({column, row}, k % 3 - 1, k / 3 - 1)) {
      ++n;
      sum += double{next->range_m};
    }
  return n >= kLeastNeighbours ? static_cast<float>(sum / n) : 0;
}

void DepthMap::fill_holes(int passes, Task& task) {
  constexpr size_t kTilesAtOnce = 16;  // about 1 ms
  constexpr uint32_t kSide = DepthCells::kSide;
  struct Hole {
    uint32_t column, row;
    float range_m;
  };
  for (int pass = 0; pass < passes; ++pass) {
    task.checkpoint(0.8 + 0.2 * pass / passes);
    const std::vector<DepthCells::Corner> tiles = cells_.tiles_and_around(grid_.is_closed);
    std::vector<std::vector<Hole>> found(tiles.size());
    parallel_for(task, tiles.size(), kTilesAtOnce, [&](size_t begin, size_t end) {
      for (size_t t = begin; t < end; ++t)
        for (uint32_t row = tiles[t].row; row < std::min(grid_.rows, tiles[t].row + kSide); ++row)
          for (uint32_t column = tiles[t].column;
               column < std::min(grid_.columns, tiles[t].column + kSide); ++column)
            if (const float range_m = hole_range_m(column, row); range_m > 0)
              found[t].push_back({column, row, range_m});
    });
    for (const auto& holes : found)
      for (const Hole& hole : holes) cells_.at(hole.column, hole.row).cell.range_m = hole.range_m;
  }
}

double DepthMap::surface_range_m(const AngularGrid::Place& place) const {
  const Cell& cell = this->cell(place);
  if (!(cell.range_m > 0)) return 0;
  const Cell *left = neighbour(place, -1, 0), *right = neighbour(place, 1, 0);
  const Cell *below = neighbour(place, 0, -1), *above = neighbour(place, 0, 1);
  const double across =
      limited(slope(cell, left, left != nullptr ? double{left->u} - cell.u - 1 : 0),
              slope(cell, right, right != nullptr ? double{right->u} - cell.u + 1 : 0));
  const double up =
      limited(slope(cell, below, below != nullptr ? double{below->v} - cell.v - 1 : 0),
              slope(cell, above, above != nullptr ? double{above->v} - cell.v + 1 : 0));
  // A surface does not run away to more than twice its range within a cell.
  const double here = 1 / double{cell.range_m};
  return 1 / std::max(here + across * (place.u - cell.u) + up * (place.v - cell.v), here / 2);
}

double DepthMap::spacing_m(const AngularGrid::Place& place) const {
  const Cell& cell = this->cell(place);
  if (!(cell.range_m > 0)) return 0;
  const double across = cell.range_m * grid_.horizontal_step_rad,
               up = cell.range_m * grid_.vertical_step_rad;
  double widest = std::max(across, up);
  const auto widen = [&](const Cell* other, double aside) {
    if (other != nullptr)
      widest = std::max(widest, std::hypot(aside, double{other->range_m} - cell.range_m));
  };
  widen(neighbour(place, -1, 0), across);
  widen(neighbour(place, 1, 0), across);
  widen(neighbour(place, 0, -1), up);
  widen(neighbour(place, 0, 1), up);
  return widest / cell_factor_;
}

}  // namespace jalon

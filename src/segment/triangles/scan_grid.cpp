// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "segment/triangles/scan_grid.h"

#include <algorithm>
#include <atomic>
#include <cmath>

#include "base/parallel.h"

namespace jalon {

namespace {

constexpr size_t kGridPointsPerChunk = 1 << 15;
constexpr double kMostPlacesPerPoint = 8;  // a sky of seven eighths; thinned clouds have more
constexpr double kMostGridSide = 0x1p31;
constexpr double kLeastOrganised = 0.5;  // of the points: the others are shared out at the end

struct PointSpan {
  size_t first, count;
};

std::vector<PointSpan> spans_of(const Cloud& cloud) {
  if (cloud.stations.empty()) return {{0, cloud.size()}};
  std::vector<PointSpan> spans;
  for (const Station& station : cloud.stations)
    if (station.count > 0) spans.push_back({station.first, station.count});
  return spans;
}

// Rows and columns that points have, as they are counted by whatever made them.
struct GridExtent {
  double first_row = INFINITY, last_row = -INFINITY, first_column = INFINITY,
         last_column = -INFINITY;
  uint64_t points = 0;

  void add(double row, double column) { *this += GridExtent{row, row, column, column, 1}; }
  GridExtent& operator+=(const GridExtent& b) {
    first_row = std::min(first_row, b.first_row);
    last_row = std::max(last_row, b.last_row);
    first_column = std::min(first_column, b.first_column);
    last_column = std::max(last_column, b.last_column);
    points += b.points;
    return *this;
  }
  double rows() const { return last_row - first_row + 1; }
  double columns() const { return last_column - first_column + 1; }
  bool is_filled() const {
    return points > 0 && rows() < kMostGridSide && columns() < kMostGridSide &&
           rows() * columns() <= kMostPlacesPerPoint * static_cast<double>(points);
  }
};

// The two fields; a point has a place where both are numbers.
struct GridFields {
  const Column *rows, *columns;
  explicit GridFields(const Cloud& cloud)
      : rows(cloud.fields.find("row")), columns(cloud.fields.find("column")) {}
  bool known() const { return rows != nullptr && columns != nullptr; }
  bool place_of(size_t point, double& row, double& column) const {
    row = std::floor(rows->number(point));
    column = std::floor(columns->number(point));
    return std::isfinite(row) && std::isfinite(column);
  }
};

GridExtent extent_of(const GridFields& fields, const PointSpan& span, Task& task) {
  return parallel_reduce(task, span.count, kGridPointsPerChunk, GridExtent{},
                         [&](size_t begin, size_t end) {
                           GridExtent part;
                           double row = 0, column = 0;
                           for (size_t i = begin; i < end; ++i)
                             if (fields.place_of(span.first + i, row, column))
                               part.add(row, column);
                           return part;
                         });
}

// The place goes to the first point of the cloud, whichever thread comes first.
void put(uint32_t& place, uint32_t position, std::span<const uint32_t> order) {
  std::atomic_ref<uint32_t> there(place);
  uint32_t seen = there.load(std::memory_order_relaxed);
  while ((seen == kNoPoint || order[position] < order[seen]) &&
         !there.compare_exchange_weak(seen, position, std::memory_order_relaxed)) {
  }
}

}  // namespace

bool is_organised(const Cloud& cloud, Task& task) {
  const GridFields fields(cloud);
  if (!fields.known()) return false;
  double placed = 0;
  for (const PointSpan& span : spans_of(cloud)) {
    const GridExtent extent = extent_of(fields, span, task);
    if (extent.is_filled()) placed += static_cast<double>(extent.points);
  }
  return placed >= kLeastOrganised * static_cast<double>(cloud.size());
}

std::vector<ScanGrid> scan_grids(const Cloud& cloud, const Octree& tree,
                                 std::span<const uint32_t> owner, Task& task) {
  const GridFields fields(cloud);
  const std::vector<PointSpan> spans = spans_of(cloud);
  std::vector<GridExtent> extents;
  std::vector<ScanGrid> grids;
  for (const PointSpan& span : spans) {
    const GridExtent extent = extents.emplace_back(extent_of(fields, span, task));
    ScanGrid& grid = grids.emplace_back();
    if (!extent.is_filled()) continue;
    grid.rows = static_cast<uint32_t>(extent.rows());
    grid.columns = static_cast<uint32_t>(extent.columns());
    grid.points = Buffer<uint32_t>(size_t{grid.rows} * grid.columns);
    std::fill(grid.points.begin(), grid.points.end(), kNoPoint);
  }
  const auto order = tree.order();
  parallel_for(task, tree.size(), kGridPointsPerChunk, [&](size_t begin, size_t end) {
    double row = 0, column = 0;
    for (size_t i = begin; i < end; ++i) {
      if (owner[i] != 0) continue;
      const size_t point = order[i];
      const auto after = std::upper_bound(spans.begin(), spans.end(), point,
                                          [](size_t p, const PointSpan& s) { return p < s.first; });
      if (after == spans.begin()) continue;
      const auto s = static_cast<size_t>(after - spans.begin() - 1);
      if (point - spans[s].first >= spans[s].count || grids[s].points.empty() ||
          !fields.place_of(point, row, column))
        continue;
      const auto r = static_cast<size_t>(row - extents[s].first_row);
      const auto c = static_cast<size_t>(column - extents[s].first_column);
      put(grids[s].points[r * grids[s].columns + c], static_cast<uint32_t>(i), order);
    }
  });
  return grids;
}

}  // namespace jalon

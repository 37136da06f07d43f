// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "compare/volumes/volume_grid.h"

#include <algorithm>
#include <cmath>

#include "base/error.h"
#include "base/numbers.h"
#include "base/parallel.h"
#include "compare/volumes/grid_points.h"
#include "geometry/symmetric_eigen.h"
#include "model/polygon_triangles.h"

namespace jalon {

namespace {

constexpr size_t kMostCells = size_t{1} << 25;  // 1.3 GB of two states' heights
constexpr size_t kVolumeGridCellGrain = 4096;
constexpr uint32_t kManyPoints = 256;  // of a chunk of cells with less, no one waits for the end
constexpr size_t kMarkGrain = 1 << 15;
// Cells a point, up to which a grid stays whole. A survey has a few points in most cells of its rectangle.
constexpr size_t kFewCellsPerPoint = 4;
constexpr uint32_t kEnoughAround = 5;  // of eight cells, so that an empty one is surrounded

struct HeightSum {
  double mean = kNaN, squares = 0;  ///< squares of the differences from the mean
};

HeightSum mean_of(const GridPoints& points, size_t cell) {
  HeightSum out;
  double sum = 0;
  points.for_each(cell, [&](const Vec3& p) { sum += p.z; });
  out.mean = sum / points.count(cell);
  points.for_each(cell, [&](const Vec3& p) { out.squares += (p.z - out.mean) * (p.z - out.mean); });
  return out;
}

double median_of(const GridPoints& points, size_t cell, std::vector<double>& heights) {
  heights.clear();
  points.for_each(cell, [&](const Vec3& p) { heights.push_back(p.z); });
  const auto middle = heights.begin() + static_cast<std::ptrdiff_t>(heights.size() / 2);
  std::nth_element(heights.begin(), middle, heights.end());
  if (heights.size() % 2 != 0) return *middle;
  return (*middle + *std::max_element(heights.begin(), middle)) / 2;
}

/// Sums for height = a + b x + c y about a cell's centre, in cells.
struct PlaneSums {
  double n = 0, x = 0, y = 0, z = 0, xx = 0, xy = 0, yy = 0, xz = 0, yz = 0;
  double least = std::numeric_limits<double>::infinity(), most = -least;

  void add(double px, double py, double pz) {
    n += 1;
    x += px;
    y += py;
    z += pz;
    xx += px * px;
    xy += px * py;
    yy += py * py;
    xz += px * pz;
    yz += py * pz;
    least = std::min(least, pz);
    most = std::max(most, pz);
  }
  /// a, within the heights seen; NaN where the points do not fix a plane.
  double at_centre() const {
    constexpr double kSpread = 1e-3;  // cells squared: less is a line
    const double cxx = xx / n - x * x / (n * n), cyy = yy / n - y * y / (n * n),
                 cxy = xy / n - x * y / (n * n);
    const double determinant = cxx * cyy - cxy * cxy;
    if (!(n >= 3) || !(determinant > kSpread * (cxx + cyy))) return kNaN;
    const double cxz = xz / n - x * z / (n * n), cyz = yz / n - y * z / (n * n);
    const double b = (cyy * cxz - cxy * cyz) / determinant,
                 c = (cxx * cyz - cxy * cxz) / determinant;
    return std::clamp((z - b * x - c * y) / n, least, most);
  }
};

double interpolated(const GridPoints& points, const VolumeGrid& grid, size_t cell) {
  const auto column = static_cast<int64_t>(cell % grid.columns),
             row = static_cast<int64_t>(cell / grid.columns);
  const double centre_u = grid.first_u + (grid.column_of(cell) + 0.5) * grid.cell_m;
  const double centre_v = grid.first_v + (grid.row_of(cell) + 0.5) * grid.cell_m;
  PlaneSums sums;
  uint32_t around = 0;
  double base = kNaN;  // heights are summed about the first
  for (int64_t r = std::max<int64_t>(0, row - 1); r <= std::min<int64_t>(grid.rows - 1, row + 1);
       ++r)
    for (int64_t c = std::max<int64_t>(0, column - 1);
         c <= std::min<int64_t>(grid.columns - 1, column + 1); ++c) {
      const size_t other = static_cast<size_t>(r) * grid.columns + static_cast<size_t>(c);
      around += other != cell && points.count(other) > 0 ? 1 : 0;
      points.for_each(other, [&](const Vec3& p) {
        if (std::isnan(base)) base = p.z;
        sums.add((p.x - centre_u) / grid.cell_m, (p.y - centre_v) / grid.cell_m, p.z - base);
      });
    }
  if (points.count(cell) == 0 && around < kEnoughAround) return kNaN;
  return base + sums.at_centre();
}

}  // namespace

size_t VolumeGrid::cell_of(const Vec3& p) const {
  const auto index = [&](double at, double first, uint32_t count, const KeptBlocks& kept) {
    const double i = std::floor((at - first) / cell_m);
    const double last = static_cast<double>(count + kept.left_out() - 1);
    return static_cast<size_t>(kept.kept_of(static_cast<uint32_t>(std::clamp(i, 0.0, last))));
  };
  return index(p.y, first_v, rows, kept_rows) * columns +
         index(p.x, first_u, columns, kept_columns);
}

Vec3 VolumeGrid::place(size_t cell, double height) const {
  const double at_u = first_u + (column_of(cell) + 0.5) * cell_m;
  const double at_v = first_v + (row_of(cell) + 0.5) * cell_m;
  return origin + (u * at_u + v * at_v + up * height);
}

VolumeGrid volume_axes(const Box3& first, const Box3& second, std::span<const double> direction) {
  if (direction.size() != 3) fail(Status::kInvalidArgument, "direction takes three numbers");
  const Vec3 along{direction[0], direction[1], direction[2]};
  if (!is_finite(along) || !(norm(along) > 0))
    fail(Status::kInvalidArgument, "direction must not be zero");
  VolumeGrid grid;
  grid.up = normalized(along);
  const PlaneAxes axes = axes_of(grid.up);
  grid.u = axes.u;
  grid.v = axes.v;
  for (int a = 0; a < 3; ++a) grid.origin[a] = std::floor(std::min(first.min[a], second.min[a]));
  return grid;
}

VolumeGrid grid_over(VolumeGrid grid, const Box3& projected, double cell_m) {
  grid.cell_m = cell_m;
  const double u0 = std::floor(projected.min.x / cell_m), v0 = std::floor(projected.min.y / cell_m);
  const double columns = std::floor(projected.max.x / cell_m) - u0 + 1;
  const double rows = std::floor(projected.max.y / cell_m) - v0 + 1;
  if (!(columns * rows <= static_cast<double>(kMostCells)))
    fail(Status::kLimit, "the grid would have more than 2^25 cells: take a larger cell_m");
  grid.first_u = u0 * cell_m;
  grid.first_v = v0 * cell_m;
  grid.columns = static_cast<uint32_t>(columns);
  grid.rows = static_cast<uint32_t>(rows);
  return grid;
}

VolumeGrid without_empty_blocks(VolumeGrid grid, const Cloud& first, const Cloud& second,
                                Task& task) {
  if (grid.cells() <= kFewCellsPerPoint * (first.size() + second.size())) return grid;
  std::vector<uint8_t> columns(KeptBlocks::blocks_of(grid.columns), 0),
      rows(KeptBlocks::blocks_of(grid.rows), 0);
  for (const Cloud* cloud : {&first, &second})
    for (size_t i = 0; i < cloud->size(); ++i) {
      if (i % kMarkGrain == 0) task.checkpoint(0);
      const size_t cell = grid.cell_of(grid.project(cloud->point(i)));
      columns[cell % grid.columns / KeptBlocks::kBlock] = 1;
      rows[cell / grid.columns / KeptBlocks::kBlock] = 1;
    }
  grid.kept_columns = KeptBlocks(columns);
  grid.kept_rows = KeptBlocks(rows);
  grid.columns -= grid.kept_columns.left_out();
  grid.rows -= grid.kept_rows.left_out();
  return grid;
}

CellHeights cloud_heights(const Cloud& cloud, const VolumeGrid& grid, CellValue value, Task& task) {
  const GridPoints points(cloud, grid, task);
  CellHeights out(grid.cells());
  parallel_for(task, grid.cells(), kVolumeGridCellGrain, [&](size_t begin, size_t end) {
    std::vector<double> heights;
    for (size_t cell = begin; cell < end; ++cell) {
      const uint32_t count = points.count(cell);
      if (count >= kManyPoints) task.checkpoint(0);  // a few cells may hold all points
      HeightSum sum;
      if (count > 0) sum = mean_of(points, cell);
      out.points[cell] = count;
      out.variance[cell] = count > 1 ? sum.squares / (count - 1.0) / count : 0;
      out.height[cell] = sum.mean;
      if (value == CellValue::kMedian && count > 0)
        out.height[cell] = median_of(points, cell, heights);
      if (value != CellValue::kInterpolated) continue;
      const double height = interpolated(points, grid, cell);
      if (!std::isnan(height)) out.height[cell] = height;
    }
  });
  return out;
}

}  // namespace jalon

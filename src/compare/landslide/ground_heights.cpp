// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "compare/landslide/ground_heights.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "base/numbers.h"
#include "base/parallel.h"
#include "compare/volumes/grid_points.h"

namespace jalon {

namespace {

constexpr size_t kHeightGrain = 1024;
constexpr uint32_t kManyInCell = 256;  // of a chunk of cells with less, no one waits for the end
constexpr uint32_t kSide = 3, kParts = kSide * kSide;  // parts of a cell
// Nearly half: what is seen of less of a cell in a shadow's border says little of the rest, which may lie deeper.
constexpr double kFewestParts = 4;
// A micrometre: files tell no finer, and points without any scatter are none the better for it.
constexpr double kLeastVariance_m2 = 1e-12;

/// One part of a cell: its points relative to the cell's middle, heights to the grid's origin.
struct GroundPart {
  double n = 0;
  Vec3 sum;
  Vec3 mean() const { return sum / n; }
};
using GroundParts = std::array<GroundPart, kParts>;

/// Sums over the means of parts, about a cell's middle, for height = a + b x + c y.
struct SlopeSums {
  double n = 0, x = 0, y = 0, z = 0, xx = 0, xy = 0, yy = 0, xz = 0, yz = 0, zz = 0;

  void add(const Vec3& p) {
    n += 1;
    x += p.x;
    y += p.y;
    z += p.z;
    xx += p.x * p.x;
    xy += p.x * p.y;
    yy += p.y * p.y;
    xz += p.x * p.z;
    yz += p.y * p.z;
    zz += p.z * p.z;
  }
};

struct LocalSlope {
  double along_u = 0, along_v = 0;
  double roughness2 = 0;      ///< variance of the means of parts about the plane
  double slope_variance = 0;  ///< of either component
  double at(const Vec3& p) const { return along_u * p.x + along_v * p.y; }
};

LocalSlope slope_of(const SlopeSums& s) {
  constexpr double kFewest = 4;     // parts: one more than the plane has unknowns
  constexpr double kSpread = 1e-6;  // of the spread squared: less is a line
  LocalSlope out;
  const double n = s.n;
  const double xx = s.xx - s.x * s.x / n, yy = s.yy - s.y * s.y / n, xy = s.xy - s.x * s.y / n;
  const double xz = s.xz - s.x * s.z / n, yz = s.yz - s.y * s.z / n, zz = s.zz - s.z * s.z / n;
  const double determinant = xx * yy - xy * xy;
  if (n >= kFewest && determinant > kSpread * (xx + yy) * (xx + yy)) {
    out.along_u = (yy * xz - xy * yz) / determinant;
    out.along_v = (xx * yz - xy * xz) / determinant;
    const double rest = zz - out.along_u * xz - out.along_v * yz;
    out.roughness2 = std::max(0.0, rest) / (n - 3);
    out.slope_variance = out.roughness2 * (xx + yy) / (2 * determinant);
    return out;
  }
  out.roughness2 = n > 1 ? std::max(0.0, zz) / (n - 1) : 0;
  return out;
}

class GroundMeasurer {
 public:
  GroundMeasurer(const GridPoints& points, const VolumeGrid& grid, uint32_t min_points)
      : points_(points), grid_(grid), min_points_(min_points) {}

  void measure(size_t cell, GroundHeights& out) const {
    out.points[cell] = points_.count(cell);
    out.height[cell] = kNaN;
    out.variance[cell] = out.gap_sigma[cell] = 0;
    if (out.points[cell] < min_points_) return;
    double base = kNaN;  // heights are summed about the first
    const GroundParts parts = parts_of(cell, cell, base);
    double m = 0;
    for (const GroundPart& part : parts) m += part.n > 0 ? 1 : 0;
    if (m < kFewestParts) return;
    const LocalSlope slope = slope_around(cell, base);
    Vec3 middle;  // of the parts' means
    double height = 0, inverse_counts = 0;
    for (const GroundPart& part : parts) {
      if (part.n == 0) continue;
      const Vec3 p = part.mean();
      middle += p / m;
      height += (p.z - slope.at(p)) / m;
      inverse_counts += 1 / part.n;
    }
    const double gradient2 = gradient_between(parts, slope);
    double aside_parts2 = 0;  // of the parts' means from their middles
    for (size_t k = 0; k < kParts; ++k)
      if (parts[k].n > 0) aside_parts2 += squared_aside(parts[k].mean(), k);
    const double empty = 1 - m / kParts;
    out.gap_sigma[cell] = empty * std::sqrt(slope.roughness2 * (1 + 1 / m));
    const double aside2 = middle.x * middle.x + middle.y * middle.y;
    out.height[cell] = base + height;
    out.variance[cell] = kLeastVariance_m2 + empty * slope.roughness2 / m +
                         scatter_within(cell, parts, slope, base) * inverse_counts / (m * m) +
                         gradient2 * aside_parts2 / (m * m) + slope.slope_variance * aside2;
  }

 private:
  Vec3 middle_of(size_t cell) const {
    return {grid_.first_u + (grid_.column_of(cell) + 0.5) * grid_.cell_m,
            grid_.first_v + (grid_.row_of(cell) + 0.5) * grid_.cell_m, 0};
  }
  // p: relative to the middle of the cell.
  size_t part_of(const Vec3& p) const {
    const auto place = [&](double at) {
      const double i = std::floor((at / grid_.cell_m + 0.5) * kSide);
      return static_cast<size_t>(std::clamp(i, 0.0, kSide - 1.0));
    };
    return place(p.y) * kSide + place(p.x);
  }
  // Of a cell, told from the middle of another; base: of heights, set by the first point where it is not known.
  GroundParts parts_of(size_t cell, size_t told_from, double& base) const {
    GroundParts out;
    const Vec3 own = middle_of(cell), from = middle_of(told_from);
    points_.for_each(cell, [&](const Vec3& p) {
      if (std::isnan(base)) base = p.z;
      GroundPart& part = out[part_of(p - own)];
      part.n += 1;
      part.sum += Vec3{p.x - from.x, p.y - from.y, p.z - base};
    });
    return out;
  }
  LocalSlope slope_around(size_t cell, double base) const {
    const auto column = static_cast<int64_t>(cell % grid_.columns),
               row = static_cast<int64_t>(cell / grid_.columns);
    SlopeSums sums;
    for (int64_t r = std::max<int64_t>(0, row - 1); r <= std::min<int64_t>(grid_.rows - 1, row + 1);
         ++r)
      for (int64_t c = std::max<int64_t>(0, column - 1);
           c <= std::min<int64_t>(grid_.columns - 1, column + 1); ++c) {
        const size_t other = static_cast<size_t>(r) * grid_.columns + static_cast<size_t>(c);
        for (const GroundPart& part : parts_of(other, cell, base))
          if (part.n > 0) sums.add(part.mean());
      }
    return slope_of(sums);
  }
  // Of the mean of a part from its middle, in plan.
  double squared_aside(const Vec3& mean, size_t part) const {
    const double side = grid_.cell_m / kSide;
    const double x = mean.x - (static_cast<double>(part % kSide) - 1) * side,
                 y = mean.y - (static_cast<double>(part / kSide) - 1) * side;
    return x * x + y * y;
  }
  // Square of the slope that the roughness adds to the plane's, along either axis, by neighbouring parts.
  double gradient_between(const GroundParts& parts, const LocalSlope& slope) const {
    const double side = grid_.cell_m / kSide;
    double squares = 0, pairs = 0;
    const auto add = [&](size_t a, size_t b) {
      if (parts[a].n == 0 || parts[b].n == 0) return;
      const Vec3 p = parts[a].mean(), q = parts[b].mean();
      const double step = (p.z - slope.at(p) - q.z + slope.at(q)) / side;
      squares += step * step;
      pairs += 1;
    };
    for (size_t k = 0; k < kParts; ++k) {
      if (k % kSide + 1 < kSide) add(k, k + 1);
      if (k + kSide < kParts) add(k, k + kSide);
    }
    return pairs > 0 ? squares / pairs : slope.roughness2 / (side * side);
  }
  // Variance of a point about the mean of its part, the slope taken out; the roughness where no part has two.
  double scatter_within(size_t cell, const GroundParts& parts, const LocalSlope& slope,
                        double base) const {
    std::array<double, kParts> means{};
    double freedom = 0;
    for (size_t k = 0; k < kParts; ++k) {
      if (parts[k].n == 0) continue;
      const Vec3 p = parts[k].mean();
      means[k] = p.z - slope.at(p);
      freedom += parts[k].n - 1;
    }
    if (freedom < 1) return slope.roughness2;
    const Vec3 own = middle_of(cell);
    double squares = 0;
    points_.for_each(cell, [&](const Vec3& p) {
      const Vec3 d{p.x - own.x, p.y - own.y, p.z - base};
      const double rest = d.z - slope.at(d) - means[part_of(d)];
      squares += rest * rest;
    });
    return squares / freedom;
  }

  const GridPoints& points_;
  const VolumeGrid& grid_;
  const uint32_t min_points_;
};

}  // namespace

GroundHeights ground_heights(const Cloud& cloud, const VolumeGrid& grid, uint32_t min_points,
                             Task& task) {
  const GridPoints points(cloud, grid, task);
  const GroundMeasurer measurer(points, grid, min_points);
  GroundHeights out(grid.cells());
  parallel_for(task, grid.cells(), kHeightGrain, [&](size_t begin, size_t end) {
    for (size_t cell = begin; cell < end; ++cell) {
      if (points.count(cell) >= kManyInCell) task.checkpoint(0);  // a few may hold all points
      measurer.measure(cell, out);
    }
  });
  return out;
}

}  // namespace jalon

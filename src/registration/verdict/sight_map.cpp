// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "registration/verdict/sight_map.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "geometry/nearest_axis.h"

namespace jalon {

namespace {

constexpr int kFaces = 6;
constexpr int kCoarseEdge = 16, kLeastEdge = 8;
constexpr size_t kCoarsePoints = 1 << 14;  // enough to tell which of the coarse cells were measured
// Of a measured cell, on average: with fewer many are empty by chance, with more the edges of things take up the view.
constexpr double kPointsPerCell = 4;
constexpr int kLeastMeasured = 5;      // of the nine cells about a direction
constexpr double kLeastCosine = 0.05;  // of incidence: flatter rays are held for this one
constexpr size_t kPointsPerCheck = 1 << 16;

}  // namespace

struct SightMap::Window {
  int measured = 0;        ///< cells
  bool is_centre = false;  ///< the middle one is
  float nearest_m = std::numeric_limits<float>::infinity();
  float farthest_m = 0;
  float farthest_first_m = 0;  ///< of the nearest points of the cells but the middle one
};

SightMap::Place SightMap::place_of(const Vec3& d) const {
  const int axis = nearest_axis(d);
  const double depth = d[axis], a = axis == 0 ? d.y : d.x, b = axis == 2 ? d.y : d.z;
  const double scale = depth == 0 ? 0 : 0.5 / std::abs(depth);
  const auto cell = [&](double u) {
    return std::clamp(static_cast<int>((0.5 + u * scale) * edge_), 0, edge_ - 1);
  };
  return {2 * axis + (depth < 0 ? 1 : 0), cell(a), cell(b)};
}

void SightMap::fill(std::span<const double> xyz, const Vec3& origin, size_t stride, Task& task) {
  cells_.assign(static_cast<size_t>(kFaces * edge_ * edge_),
                {std::numeric_limits<float>::infinity(), 0});
  size_t done = 0;
  for (size_t i = 0; i + 2 < xyz.size(); i += 3 * stride) {
    if (done++ % kPointsPerCheck == 0) task.checkpoint(0);
    const Vec3 d = Vec3{xyz[i], xyz[i + 1], xyz[i + 2]} - origin - station_;
    const float range = static_cast<float>(norm(d));
    if (!(range > 0)) continue;
    Cell& cell = cells_[index(place_of(d))];
    cell.nearest_m = std::min(cell.nearest_m, range);
    cell.farthest_m = std::max(cell.farthest_m, range);
  }
}

SightMap SightMap::build(std::span<const double> xyz, const Vec3& origin, const Vec3& station,
                         int most_edge, Task& task) {
  SightMap out;
  out.station_ = station;
  const size_t points = xyz.size() / 3;
  // 1. How much of the view was measured at all.
  out.edge_ = kCoarseEdge;
  out.fill(xyz, origin, points / kCoarsePoints + 1, task);
  const auto measured = std::ranges::count_if(out.cells_, &Cell::is_measured);
  const double share = static_cast<double>(std::max<ptrdiff_t>(1, measured)) /
                       static_cast<double>(out.cells_.size());
  // 2. Cells of some points each.
  const double edge = std::sqrt(static_cast<double>(points) / (kPointsPerCell * kFaces * share));
  out.edge_ = std::clamp(static_cast<int>(edge), kLeastEdge, most_edge);
  out.fill(xyz, origin, 1, task);
  return out;
}

SightMap::Window SightMap::window(const Vec3& direction) const {
  const Place at = place_of(direction);
  Window out;
  for (int row = std::max(0, at.row - 1); row <= std::min(edge_ - 1, at.row + 1); ++row)
    for (int column = std::max(0, at.column - 1); column <= std::min(edge_ - 1, at.column + 1);
         ++column) {
      const Cell& cell = cells_[index({at.face, column, row})];
      if (!cell.is_measured()) continue;
      const bool is_centre = row == at.row && column == at.column;
      ++out.measured;
      out.is_centre = out.is_centre || is_centre;
      out.nearest_m = std::min(out.nearest_m, cell.nearest_m);
      out.farthest_m = std::max(out.farthest_m, cell.farthest_m);
      if (!is_centre) out.farthest_first_m = std::max(out.farthest_first_m, cell.nearest_m);
    }
  return out;
}

// With the ranges that a surface of this slant spans in a cell.
double SightMap::margin(const Vec3& direction, double range, const Vec3& normal,
                        double margin_m) const {
  const double cosine = std::abs(dot(normal, direction)) / range;
  const double slant =
      std::sqrt(std::max(0.0, 1 - cosine * cosine)) / std::max(cosine, kLeastCosine);
  return margin_m + range * slant * 2 / edge_;
}

Sighted SightMap::look(const Vec3& place, const Vec3& normal, double margin_m) const {
  const Vec3 d = place - station_;
  const double range = norm(d);
  if (!(range > 0)) return Sighted::kUnknown;
  const Window around = window(d);
  if (!around.is_centre || around.measured < kLeastMeasured) return Sighted::kUnknown;
  const double most = margin(d, range, normal, margin_m);
  if (around.nearest_m > range + most) return Sighted::kThrough;
  if (around.farthest_m < range - most) return Sighted::kHidden;
  return Sighted::kSurface;
}

Sighted SightMap::look_at_own(const Vec3& place, const Vec3& normal, double margin_m) const {
  const Vec3 d = place - station_;
  const double range = norm(d);
  if (!(range > 0)) return Sighted::kUnknown;
  const Window around = window(d);
  if (around.measured - (around.is_centre ? 1 : 0) < kLeastMeasured) return Sighted::kUnknown;
  const double most = margin(d, range, normal, margin_m);
  return around.farthest_first_m < range - most ? Sighted::kHidden : Sighted::kSurface;
}

}  // namespace jalon

// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "compare/overlap/occupied_cells.h"

#include <algorithm>
#include <cmath>

namespace jalon {

namespace {

constexpr size_t kMostSampled = 50000;  // 100 x 100 cells of a few surfaces, some points each
constexpr double kFarthest = 9e15;      // cells: what a double holds whole

int64_t whole(double v) {
  return static_cast<int64_t>(std::floor(std::clamp(v, -kFarthest, kFarthest)));
}

}  // namespace

GridCell cell_of(const Vec3& p, double edge_m) {
  return {whole(p.x / edge_m), whole(p.y / edge_m), whole(p.z / edge_m)};
}

std::vector<Vec3> sampled_points(const Cloud& cloud) {
  std::vector<Vec3> out;
  const size_t step = cloud.size() / kMostSampled + 1;
  out.reserve(cloud.size() / step + 1);
  for (size_t i = 0; i < cloud.size(); i += step) out.push_back(cloud.point(i));
  return out;
}

OccupiedCells::OccupiedCells(const std::vector<Vec3>& points, double edge_m) : edge_m_(edge_m) {
  for (const Vec3& p : points) known_.insert(cell_of(p, edge_m));
  cells_.assign(known_.begin(), known_.end());
  std::ranges::sort(cells_);
}

bool OccupiedCells::are_about(const Vec3& place) const {
  const GridCell at = cell_of(place, edge_m_);
  if (known_.contains(at)) return true;
  for (int64_t x = -1; x <= 1; ++x)
    for (int64_t y = -1; y <= 1; ++y)
      for (int64_t z = -1; z <= 1; ++z)
        if (known_.contains({at.x + x, at.y + y, at.z + z})) return true;
  return false;
}

double OccupiedCells::share_in(const OccupiedCells& other) const {
  return share_of_moved(cells_.size() + 1, other, [](const Vec3& p) { return p; });
}

Vec3 OccupiedCells::middle(const GridCell& c) const {
  return Vec3{static_cast<double>(c.x) + 0.5, static_cast<double>(c.y) + 0.5,
              static_cast<double>(c.z) + 0.5} *
         edge_m_;
}

}  // namespace jalon

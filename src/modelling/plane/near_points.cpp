// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "modelling/plane/near_points.h"

#include <algorithm>
#include <cmath>

#include "base/serial.h"
#include "spatial/octree/morton.h"

namespace jalon {

namespace {

// Octree cells of about the reach: larger ones bring points that are of no use, smaller ones more look-ups.
constexpr double kCellsPerReach = 0.75;
constexpr size_t kCellsPerLook = 16;  // of a cloud of millions each may hold hundreds of points
constexpr size_t kCodesBeforeSort = 1 << 20, kCodesPerLook = 1 << 17;

int level_for(const Cube& cube, double edge_m) {
  int level = 0;
  while (level < kMaxLevel && cube.edge * std::ldexp(1.0, -level) > edge_m) ++level;
  return level;
}

// The offset of a plane far from the origin has lost bits that no result may hang on.
double to_micrometres(double height_m) { return std::round(height_m * 0x1p20) * 0x1p-20; }

// Codes of the cells that a box in the plane about p, of this depth, can meet.
void add_cells(const Cube& cube, int level, const PlaneFrame& frame, const Vec2& p, double reach_m,
               double depth_m, std::vector<uint64_t>& codes) {
  const double edge = cube.edge * std::ldexp(1.0, -level), count = std::ldexp(1.0, level);
  const Vec3 centre = frame.lift(p) - cube.origin;
  std::array<uint32_t, 3> low, high;
  for (int k = 0; k < 3; ++k) {
    const double half = reach_m * (std::fabs(frame.axis_u[k]) + std::fabs(frame.axis_v[k])) +
                        depth_m * std::fabs(frame.normal[k]);
    const double from = std::floor((centre[k] - half) / edge),
                 to = std::floor((centre[k] + half) / edge);
    if (to < 0 || from >= count) return;
    low[static_cast<size_t>(k)] = static_cast<uint32_t>(std::max(from, 0.0));
    high[static_cast<size_t>(k)] = static_cast<uint32_t>(std::min(to, count - 1));
  }
  for (uint32_t x = low[0]; x <= high[0]; ++x)
    for (uint32_t y = low[1]; y <= high[1]; ++y)
      for (uint32_t z = low[2]; z <= high[2]; ++z) codes.push_back(morton_code(x, y, z));
}

// Ascending, each once; there may be tens of millions.
void leave_one_of_each(std::vector<uint64_t>& codes, Task& task) {
  serial_sort(task, codes.begin(), codes.end());
  codes.erase(std::unique(codes.begin(), codes.end()), codes.end());
}

// Cells along the rings, ascending, each once.
std::vector<uint64_t> cells_along(const Octree& tree, int level, const PlaneFrame& frame,
                                  std::span<const std::vector<Vec2>> rings,
                                  const NearSetting& setting, Task& task) {
  const double edge = tree.cube().edge * std::ldexp(1.0, -level);
  std::vector<uint64_t> codes;
  size_t next_look = 0;
  size_t most = kCodesBeforeSort;  // twice what is left of them, or each corner would sort them all
  for (const auto& ring : rings)
    for (size_t i = 0; i < ring.size(); ++i) {
      const Vec2 a = ring[i], step = ring[(i + 1) % ring.size()] - a;
      const double pieces = std::max(1.0, std::ceil(norm(step) / edge));
      const double half = norm(step) / pieces / 2;
      for (double k = 0; k < pieces; ++k) {
        if (codes.size() >= next_look) {  // a long edge may have millions
          task.checkpoint(0);
          next_look = codes.size() + kCodesPerLook;
        }
        add_cells(tree.cube(), level, frame, a + step * ((k + 0.5) / pieces),
                  setting.reach_m + half, setting.depth_m, codes);
      }
      if (codes.size() <= most) continue;
      leave_one_of_each(codes, task);
      most = std::max(most, 2 * codes.size());
      next_look = codes.size();
    }
  leave_one_of_each(codes, task);
  return codes;
}

}  // namespace

NearPoints points_near(const Segmentation& segmentation, const Octree& tree,
                       const PlaneFrame& frame, std::span<const std::vector<Vec2>> rings,
                       std::span<const uint8_t> planes_parallel, const NearSetting& setting,
                       Task& task) {
  const Cloud& cloud = *segmentation.cloud;
  const auto labels = segmentation.labels->values<uint32_t>();
  const auto order = tree.order();
  const int level = level_for(tree.cube(), setting.reach_m / kCellsPerReach);
  NearPoints out;
  const auto take = [&](uint64_t code) {
    const Octree::Cell cell = tree.cell(level, code);
    for (size_t k = cell.first; k < cell.first + cell.count; ++k) {
      const uint32_t i = order[k];
      const Vec3 p = cloud.point(i);
      const double height = to_micrometres(dot(p - frame.origin, frame.normal) - frame.height);
      if (std::fabs(height) > setting.depth_m) continue;
      out.points.push_back(frame.project(p));
      out.heights_m.push_back(static_cast<float>(height));
      const bool is_other = labels[i] != 0 && planes_parallel[labels[i] - 1] != 0;
      out.on_plane.push_back(std::fabs(height) <= setting.window_m && !is_other);
    }
  };
  const std::vector<uint64_t> codes = cells_along(tree, level, frame, rings, setting, task);
  serial_for(task, codes.size(), kCellsPerLook, [&](size_t begin, size_t end) {
    for (size_t i = begin; i < end; ++i) take(codes[i]);
  });
  out.sort(setting.reach_m, task);
  return out;
}

}  // namespace jalon

// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "spatial/voxels/components.h"

#include <algorithm>
#include <cmath>
#include <compare>
#include <numeric>

#include "base/parallel.h"
#include "spatial/union_find.h"
#include "spatial/voxels/voxel_grid.h"

namespace jalon {

namespace {

constexpr size_t kCellGrain = 1 << 14;

/// Cell numbers, compared in the order of the grid's cells.
struct CellNumber {
  int64_t z, y, x;
  auto operator<=>(const CellNumber&) const = default;
  CellNumber operator+(const CellNumber& b) const { return {z + b.z, y + b.y, x + b.x}; }
};

std::vector<CellNumber> cell_numbers_of(const VoxelGrid& grid, std::span<const double> xyz,
                                        const Vec3& origin, double cell_m, Task& task) {
  std::vector<CellNumber> cells(grid.size());
  parallel_for(task, grid.size(), kCellGrain, [&](size_t begin, size_t end) {
    for (size_t v = begin; v < end; ++v) {
      const double* p = xyz.data() + 3 * size_t{grid.order[grid.first[v]]};
      const auto number = [&](double coordinate, double from) {
        return static_cast<int64_t>(std::floor((coordinate - from) / cell_m));
      };
      cells[v] = {number(p[2], origin.z), number(p[1], origin.y), number(p[0], origin.x)};
    }
  });
  return cells;
}

/// Half of the neighbours, those that come later in cell order; the other half finds itself.
std::vector<CellNumber> forward_steps(Connectivity3 connectivity) {
  const int64_t most = connectivity == Connectivity3::k6    ? 1
                       : connectivity == Connectivity3::k18 ? 2
                                                            : 3;
  std::vector<CellNumber> steps;
  for (int64_t z = 0; z <= 1; ++z)
    for (int64_t y = -1; y <= 1; ++y)
      for (int64_t x = -1; x <= 1; ++x) {
        const CellNumber step{z, y, x};
        if (step > CellNumber{0, 0, 0} && std::abs(z) + std::abs(y) + std::abs(x) <= most)
          steps.push_back(step);
      }
  return steps;
}

/// The neighbours of ascending cells in one direction ascend too: two fingers walk the list once.
void join_along(const std::vector<CellNumber>& cells, const CellNumber& step, UnionFind& sets,
                Task& task) {
  size_t j = 0;
  for (size_t i = 0; i < cells.size(); ++i) {
    if (i % kCellGrain == 0)
      task.checkpoint(static_cast<double>(i) / static_cast<double>(cells.size()));
    const CellNumber wanted = cells[i] + step;
    while (j < cells.size() && cells[j] < wanted) ++j;
    if (j == cells.size()) return;
    if (cells[j] == wanted) sets.join(static_cast<uint32_t>(i), static_cast<uint32_t>(j));
  }
}

struct Component {
  uint64_t points = 0;
  uint32_t first_point = 0xffffffffu;
};

/// Label of every cell.
std::vector<uint32_t> number_components(const VoxelGrid& grid, UnionFind& sets, uint64_t min_points,
                                        std::vector<uint64_t>& point_counts) {
  std::vector<uint32_t> label(
      grid.size());  // the number of its component in order of cells at first
  std::vector<Component> components;
  for (uint32_t v = 0; v < grid.size(); ++v) {
    const uint32_t root = sets.find(v);  // the component's first cell, so already numbered
    if (root == v) {
      label[v] = static_cast<uint32_t>(components.size());
      components.emplace_back();
    }
    label[v] = label[root];
    Component& own = components[label[v]];
    own.points += grid.first[v + 1] - grid.first[v];
    own.first_point = std::min(own.first_point, grid.order[grid.first[v]]);
  }
  std::vector<uint32_t> order(components.size());
  std::iota(order.begin(), order.end(), 0u);
  std::sort(order.begin(), order.end(), [&](uint32_t a, uint32_t b) {
    const Component &p = components[a], &q = components[b];
    return p.points != q.points ? p.points > q.points : p.first_point < q.first_point;
  });
  std::vector<uint32_t> rank(components.size(), 0);
  point_counts.assign(1, 0);
  for (const uint32_t c : order) {
    if (components[c].points < min_points) {
      point_counts[0] += components[c].points;
      continue;
    }
    rank[c] = static_cast<uint32_t>(point_counts.size());
    point_counts.push_back(components[c].points);
  }
  for (uint32_t& l : label) l = rank[l];
  return label;
}

}  // namespace

Components connected_components(std::span<const double> xyz, const Vec3& origin, double cell_m,
                                Connectivity3 connectivity, uint64_t min_points, Task& task) {
  Components out;
  out.labels.resize(xyz.size() / 3);
  out.point_counts.assign(1, 0);
  if (xyz.empty()) return out;
  // 1. The occupied cells, in order.
  VoxelGrid grid;
  std::vector<CellNumber> cells;
  {
    ProgressSpan span(task, 0, 0.5);
    grid = voxel_lists(xyz, origin, cell_m, task);
    cells = cell_numbers_of(grid, xyz, origin, cell_m, task);
  }
  // 2. Join neighbours.
  UnionFind sets(grid.size());
  const auto steps = forward_steps(connectivity);
  for (size_t s = 0; s < steps.size(); ++s) {
    ProgressSpan span(task, 0.5 + 0.4 * static_cast<double>(s) / static_cast<double>(steps.size()),
                      0.5 + 0.4 * static_cast<double>(s + 1) / static_cast<double>(steps.size()));
    join_along(cells, steps[s], sets, task);
  }
  // 3. Number the components by size and hand the numbers to the points.
  ProgressSpan span(task, 0.9, 1);
  const std::vector<uint32_t> label = number_components(grid, sets, min_points, out.point_counts);
  parallel_for(task, grid.size(), kCellGrain, [&](size_t begin, size_t end) {
    for (size_t v = begin; v < end; ++v)
      for (uint32_t i = grid.first[v]; i < grid.first[v + 1]; ++i)
        out.labels[grid.order[i]] = label[v];
  });
  return out;
}

}  // namespace jalon

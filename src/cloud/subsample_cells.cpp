// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "cloud/subsample_cells.h"

#include <cmath>
#include <limits>

#include "base/parallel.h"
#include "cloud/select.h"
#include "spatial/octree/morton.h"
#include "spatial/voxels/voxel_grid.h"

namespace jalon {

namespace {

constexpr size_t kCellGrain = 1 << 13;

/// Of the points of one cell the one nearest to a place; ties to the smaller index. Members ascend
/// or not: the answer is the same.
uint32_t nearest_to(const Cloud& cloud, std::span<const uint32_t> members, const Vec3& place) {
  uint32_t best = members.front();
  double least = std::numeric_limits<double>::infinity();
  for (const uint32_t i : members) {
    const double d = squared_norm(cloud.point(i) - place);
    if (d < least || (d == least && i < best)) {
      least = d;
      best = i;
    }
  }
  return best;
}

/// What each cell gives: the point whose fields it takes, and the new coordinates (unused for kNearest).
struct Representatives {
  std::vector<uint32_t> points;
  Buffer<double> centroids;  // 3 a cell; empty = the points themselves
};

/// Puts the cells into the order of their points and makes the cloud.
Cloud assemble(const Cloud& cloud, const Representatives& cells, Task& task) {
  std::vector<uint8_t> mask(cloud.size(), 0);
  for (const uint32_t i : cells.points) mask[i] = 1;
  const std::vector<uint64_t> indices = indices_of(mask, 1, task);
  Cloud out = select_kept(cloud, indices, task);
  if (cells.centroids.empty() || indices.size() == cloud.size()) return out;
  Buffer<uint32_t> cell_of(cloud.size());  // only read where written
  for (size_t c = 0; c < cells.points.size(); ++c)
    cell_of[cells.points[c]] = static_cast<uint32_t>(c);
  Buffer<double> xyz(3 * indices.size());
  parallel_for(task, indices.size(), kCellGrain, [&](size_t begin, size_t end) {
    for (size_t i = begin; i < end; ++i) {
      const double* from = cells.centroids.data() + 3 * size_t{cell_of[indices[i]]};
      for (size_t c = 0; c < 3; ++c) xyz[3 * i + c] = from[c];
    }
  });
  Cloud moved = make_cloud(std::move(xyz));
  moved.fields = std::move(out.fields);
  moved.stations = std::move(out.stations);
  moved.crs = out.crs;
  moved.attachments = out.attachments;
  return moved;
}

Vec3 centroid_of(const Cloud& cloud, std::span<const uint32_t> members, const Vec3& origin) {
  Vec3 sum;
  for (const uint32_t i : members) sum += cloud.point(i) - origin;
  return origin + sum / static_cast<double>(members.size());
}

/// Without fields and stations nothing has to be taken from the points.
Cloud bare_centroids(const Cloud& cloud, const Box3& box, double cell_m, Task& task) {
  Buffer<double> xyz = voxel_centroids(cloud.xyz(), box, enclosing_cube(box).origin, cell_m, task);
  // Every point alone in its cell: share the points and their index
  if (xyz.size() == cloud.xyz().size()) return cloud;
  Cloud out = make_cloud(std::move(xyz));
  out.crs = cloud.crs;
  out.attachments = cloud.attachments;
  return out;
}

}  // namespace

Cloud one_per_voxel(const Cloud& cloud, double cell_m, Keep keep, Task& task) {
  const Box3 box = bounds(cloud, task);
  if (keep == Keep::kCentroid && cloud.fields.size() == 0 && cloud.stations.empty())
    return bare_centroids(cloud, box, cell_m, task);
  const Vec3 origin = enclosing_cube(box).origin;
  VoxelGrid grid;
  {
    ProgressSpan span(task, 0, 0.6, "voxel grid");
    grid = voxel_grid(cloud.xyz(), origin, cell_m, task);
  }
  Representatives cells{std::vector<uint32_t>(grid.size()), Buffer<double>()};
  {
    ProgressSpan span(task, 0.6, 0.8, "voxel grid");
    parallel_for(task, grid.size(), kCellGrain, [&](size_t begin, size_t end) {
      for (size_t v = begin; v < end; ++v) {
        const std::span members(grid.order.data() + grid.first[v],
                                grid.first[v + 1] - grid.first[v]);
        const double* g = grid.centroids.data() + 3 * v;
        Vec3 place{g[0], g[1], g[2]};
        if (keep == Keep::kNearest) {
          const Vec3 p = cloud.point(members.front()) - origin;
          place = origin + Vec3{std::floor(p.x / cell_m) + 0.5, std::floor(p.y / cell_m) + 0.5,
                                std::floor(p.z / cell_m) + 0.5} *
                               cell_m;
        }
        cells.points[v] = nearest_to(cloud, members, place);
      }
    });
  }
  if (keep == Keep::kCentroid) cells.centroids = std::move(grid.centroids);
  ProgressSpan span(task, 0.8, 1, "copying");
  return assemble(cloud, cells, task);
}

Cloud one_per_octree_cell(const Cloud& cloud, int level, uint64_t max_cells, Keep keep,
                          Task& task) {
  std::shared_ptr<const Octree> tree;
  {
    ProgressSpan span(task, 0, 0.5, "index");
    tree = cloud.octree(task);
  }
  ProgressSpan span(task, 0.5, 1, "sampling");
  if (level < 0) {
    const auto counts = tree->cell_counts(task);
    level = 0;
    while (level < kMaxLevel && counts[static_cast<size_t>(level) + 1] <= max_cells) ++level;
  }
  const auto octree_cells = tree->cells(level, task);
  const double edge = std::ldexp(tree->cube().edge, -level);
  const Vec3 origin = tree->cube().origin;
  const auto order = tree->order();
  Representatives cells{std::vector<uint32_t>(octree_cells.size()),
                        Buffer<double>(keep == Keep::kCentroid ? 3 * octree_cells.size() : 0)};
  parallel_for(task, octree_cells.size(), kCellGrain, [&](size_t begin, size_t end) {
    for (size_t c = begin; c < end; ++c) {
      const auto& cell = octree_cells[c];
      const auto members = order.subspan(cell.first, cell.count);
      const CellNumbers number = cell_numbers(cell.code);
      Vec3 place = origin + Vec3{number.p + 0.5, number.q + 0.5, number.r + 0.5} * edge;
      if (keep == Keep::kCentroid) {
        place = centroid_of(cloud, members, origin);
        for (int i = 0; i < 3; ++i) cells.centroids[3 * c + static_cast<size_t>(i)] = place[i];
      }
      cells.points[c] = nearest_to(cloud, members, place);
    }
  });
  return assemble(cloud, cells, task);
}

}  // namespace jalon

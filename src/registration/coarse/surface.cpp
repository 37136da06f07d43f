// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "registration/coarse/surface.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "base/error.h"
#include "base/parallel.h"
#include "geometry/plane.h"
#include "spatial/voxels/voxel_grid.h"

namespace jalon {

namespace {

constexpr size_t kCellSample = 400'000;  // points that the size of a cell is found from
constexpr double kPointsPerCell = 3;     // on average, at the least
constexpr int kCellTurns = 6;
constexpr double kSparse =
    0.03;  // of the points in the cell of the median point: less is an outlier
constexpr double kNormalReach = 2.2;  // cells: about 15 neighbours on a plane
constexpr size_t kSurfaceLeastNeighbours = 4;
constexpr double kFlatVariation = 0.02;  // above, a place is curved or broken
constexpr size_t kSurfaceGrain = 256;

Buffer<double> even_sample(const Cloud& cloud) {
  const size_t step = cloud.size() / kCellSample + 1, n = (cloud.size() + step - 1) / step;
  Buffer<double> out(3 * n);
  for (size_t i = 0; i < n; ++i)
    for (size_t k = 0; k < 3; ++k) out[3 * i + k] = cloud.xyz()[3 * i * step + k];
  return out;
}

// The fewest points of a cell that is not one of outliers: by the cell that the median point lies in.
uint32_t least_count(const VoxelGrid& grid) {
  std::vector<uint32_t> counts(grid.size());
  for (size_t v = 0; v < counts.size(); ++v) counts[v] = grid.first[v + 1] - grid.first[v];
  std::sort(counts.begin(), counts.end());
  const uint64_t half = grid.order.size() / 2;
  uint64_t points = 0;
  for (const uint32_t count : counts) {
    points += count;
    if (points > half)
      return std::max<uint32_t>(1, static_cast<uint32_t>(std::lround(kSparse * count)));
  }
  return 1;
}

size_t cells_of(std::span<const double> xyz, const Vec3& origin, double cell_m, Task& task) {
  const VoxelGrid grid = voxel_grid(xyz, origin, cell_m, task);
  const uint32_t least = least_count(grid);
  size_t n = 0;
  for (size_t v = 0; v < grid.size(); ++v) n += grid.first[v + 1] - grid.first[v] >= least;
  return n;
}

double cell_of(const Cloud& cloud, size_t target, Task& task) {
  const Box3 box = bounds(cloud, task);
  const Vec3 origin = enclosing_cube(box).origin;
  const Buffer<double> xyz = even_sample(cloud);
  const double diagonal = norm(box.max - box.min);
  if (!(diagonal > 0)) return 0;
  const double wanted =
      std::min(static_cast<double>(target), static_cast<double>(xyz.size() / 3) / kPointsPerCell);
  double cell = diagonal / std::sqrt(wanted);
  // The cells of a surface are inversely as the square of their edge.
  for (int turn = 0; turn < kCellTurns; ++turn) {
    const auto n = static_cast<double>(cells_of(xyz, origin, cell, task));
    const double factor = std::sqrt(n / wanted);
    cell *= std::clamp(factor, 0.25, 4.0);
    if (std::abs(factor - 1) < 0.03) break;
  }
  return cell;
}

struct CellShape {
  Vec3 centre;
  Symmetric3 spread;  // covariance of the points of the cell
};

CellShape shape_of(const Cloud& cloud, const VoxelGrid& grid, size_t v, const Vec3& origin) {
  Moments moments;
  for (size_t k = grid.first[v]; k < grid.first[v + 1]; ++k)
    moments.add(cloud.point(grid.order[k]) - origin);
  return {moments.centroid(), moments.covariance()};
}

// The plane through the cells around a point, all with the same say: dense places would pull it to themselves.
void fit_plane(CoarseSurface& s, const std::vector<CellShape>& shapes, size_t i,
               std::vector<Neighbour>& near) {
  s.tree->radius(s.points[i], kNormalReach * s.cell_m, near);
  s.variation[i] = 1;
  if (near.size() < kSurfaceLeastNeighbours) return;
  Moments moments;
  moments.reference = s.points[i];
  Symmetric3 within{};
  for (const Neighbour& n : near) {
    moments.add(s.points[n.index]);
    for (size_t k = 0; k < 6; ++k) within[k] += shapes[n.index].spread[k];
  }
  Symmetric3 covariance = moments.covariance();
  for (size_t k = 0; k < 6; ++k) covariance[k] += within[k] / static_cast<double>(near.size());
  const Eigen3 e = symmetric_eigen(covariance);
  constexpr double kLine =
      0.02;  // of the largest spread: what is narrower is a line, with no normal
  if (!(e.values[1] > kLine * e.values[2])) return;
  s.normals[i] = e.vectors[0];
  s.scatter_m2[i] = std::max(0.0, e.values[0]);
  s.variation[i] = std::max(0.0, e.values[0]) / (e.values[0] + e.values[1] + e.values[2]);
}

void measure_extent(CoarseSurface& s) {
  Vec3 sum;
  for (const Vec3& p : s.points) sum += p;
  s.centroid = sum / static_cast<double>(s.size());
  double squares = 0;
  for (const Vec3& p : s.points) squares += squared_norm(p - s.centroid);
  s.extent_m = std::sqrt(squares / static_cast<double>(s.size()));
}

}  // namespace

double coarse_cell(const Cloud& reference, const Cloud& moving, size_t target, Task& task) {
  const double of_reference = cell_of(reference, target, task),
               of_moving = cell_of(moving, target, task);
  if (!(of_reference > 0 && of_moving > 0)) return 0;
  // The finer of the two would ask more of the other than it has.
  return std::max(of_reference, of_moving);
}

CoarseSurface coarse_surface(const Cloud& cloud, double cell_m, Task& task) {
  CoarseSurface s;
  s.cell_m = cell_m;
  s.origin = enclosing_cube(bounds(cloud, task)).origin;
  const VoxelGrid grid = voxel_grid(cloud.xyz(), s.origin, cell_m, task);
  const uint32_t least = least_count(grid);
  std::vector<uint32_t> kept;
  for (uint32_t v = 0; v < grid.size(); ++v)
    if (grid.first[v + 1] - grid.first[v] >= least) kept.push_back(v);
  std::vector<CellShape> shapes(kept.size());
  parallel_for(task, kept.size(), kSurfaceGrain, [&](size_t begin, size_t end) {
    for (size_t i = begin; i < end; ++i) shapes[i] = shape_of(cloud, grid, kept[i], s.origin);
  });
  s.xyz = Buffer<double>(3 * kept.size());
  Box3 box;
  for (size_t i = 0; i < kept.size(); ++i) {
    s.points.push_back(shapes[i].centre);
    box.add(shapes[i].centre);
    for (int k = 0; k < 3; ++k) s.xyz[3 * i + static_cast<size_t>(k)] = shapes[i].centre[k];
  }
  s.normals.resize(kept.size());
  s.variation.resize(kept.size());
  s.scatter_m2.resize(kept.size());
  s.tree = Octree::build(s.xyz, enclosing_cube(box), task);
  parallel_for(task, kept.size(), kSurfaceGrain, [&](size_t begin, size_t end) {
    std::vector<Neighbour> near;
    for (size_t i = begin; i < end; ++i) fit_plane(s, shapes, i, near);
  });
  measure_extent(s);
  balance_weights(s);
  return s;
}

void balance_weights(CoarseSurface& s) {
  // 1. The axis frame of the scene, so that the classes turn with it: bins of a fixed frame would weigh a cloud
  // otherwise than its turned copy.
  Symmetric3 facing{};
  for (const Vec3& n : s.normals) {
    facing[0] += n.x * n.x, facing[1] += n.x * n.y, facing[2] += n.x * n.z;
    facing[3] += n.y * n.y, facing[4] += n.y * n.z, facing[5] += n.z * n.z;
  }
  const Eigen3 frame = symmetric_eigen(facing);
  // 2. Classes: curved or broken; flat, by the nearest axis of that frame.
  std::array<double, 4> counts{};
  const auto class_of = [&](size_t i) -> size_t {
    if (s.variation[i] > kFlatVariation) return 3;
    size_t best = 0;
    for (size_t k = 1; k < 3; ++k)
      if (std::abs(dot(s.normals[i], frame.vectors[k])) >
          std::abs(dot(s.normals[i], frame.vectors[best])))
        best = k;
    return best;
  };
  for (size_t i = 0; i < s.size(); ++i) counts[class_of(i)] += 1;
  // 3. Each flat class counts one, the rest three; few points of a class do not outweigh many of another.
  constexpr double kMostGain = 5;
  const double even = static_cast<double>(s.size()) / 4;
  s.weights.resize(s.size());
  for (size_t i = 0; i < s.size(); ++i) {
    const size_t c = class_of(i);
    s.weights[i] = std::min(kMostGain, even / counts[c]);
  }
}

}  // namespace jalon

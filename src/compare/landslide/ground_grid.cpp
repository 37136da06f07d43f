// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "compare/landslide/ground_grid.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "base/error.h"
#include "base/parallel.h"
#include "cloud/operations.h"
#include "cloud/statistics.h"
#include "geometry/plane.h"

namespace jalon {

namespace {

constexpr size_t kGroundGrain = 1 << 15;
constexpr double kSteep = 0.70710678118654752;  // cosine of 45 degrees
constexpr double kUprightNormal = 0.9999;       // upward, to half a degree
// The ground as a whole, whatever the scanners' density: by cells of so much of its extent.
constexpr double kWholeShare = 0.01;
constexpr double kEnoughCells = 0.85;  // of those with points, that should be measured
constexpr int kCellSteps = 8;          // of 1, 2, 5 that are tried: a factor of 500

// Across the ground as a whole, toward the scanner where one is told, else upward.
Vec3 ground_normal(const Cloud& cloud, Task& task) {
  const Box3 box = bounds(cloud, task);
  const double extent = norm(box.max - box.min);
  if (!(extent > 0)) return {0, 0, 1};
  const Cloud thin =
      subsampled(cloud, {.cell_m = kWholeShare * extent, .keep = Keep::kCentroid}, task);
  Moments moments;
  moments.reference = thin.point(0);
  for (size_t i = 0; i < thin.size(); ++i) moments.add(thin.point(i));
  PlaneFit fit;
  if (!fit_plane(moments, fit)) return {0, 0, 1};
  Vec3 normal = fit.plane.normal;
  double side = normal.z;
  for (const Station& station : cloud.stations)
    if (station.has_pose) {
      side = dot(normal, station.pose.point({}) - fit.centroid);
      break;
    }
  if (side < 0) normal = -normal;
  return std::abs(normal.z) > kSteep ? Vec3{0, 0, 1} : normal;
}

Box3 projected_box(const Cloud& cloud, const VolumeGrid& grid, Task& task) {
  return parallel_reduce(task, cloud.size(), kGroundGrain, Box3{}, [&](size_t begin, size_t end) {
    Box3 box;
    for (size_t i = begin; i < end; ++i) box.add(grid.project(cloud.point(i)));
    return box;
  });
}

// Share of the cells with points that have enough.
double measured_share(const Cloud& cloud, const VolumeGrid& grid, uint32_t enough, Task& task) {
  std::vector<uint32_t> counts(grid.cells(), 0);
  for (size_t i = 0; i < cloud.size(); ++i) {
    if (i % kGroundGrain == 0) task.checkpoint(0);
    ++counts[grid.cell_of(grid.project(cloud.point(i)))];
  }
  uint64_t occupied = 0, measured = 0;
  for (const uint32_t n : counts) {
    occupied += n > 0 ? 1 : 0;
    measured += n >= enough ? 1 : 0;
  }
  return static_cast<double>(measured) / static_cast<double>(std::max<uint64_t>(1, occupied));
}

// 1, 2, 5 x 10^k: the largest not above the size, then one after the other.
double round_size(double size, int step) {
  constexpr std::array<double, 3> kSizes = {1, 2, 5};
  int power = static_cast<int>(std::floor(std::log10(size)));
  const double lead = size / std::pow(10.0, power);
  int place = (lead >= 5 ? 2 : lead >= 2 ? 1 : 0) + step;
  power += place / 3;
  place %= 3;
  return kSizes[static_cast<size_t>(place)] * std::pow(10.0, power);
}

double automatic_cell(const Cloud& reference, const Cloud& compared, const VolumeGrid& axes,
                      const Box3& box, uint32_t enough, Task& task) {
  const double area = (box.max.x - box.min.x) * (box.max.y - box.min.y);
  const auto points = static_cast<double>(std::min(reference.size(), compared.size()));
  // What an even density would need.
  const double least = std::sqrt(area * static_cast<double>(enough) / points);
  if (!(least > 0)) return 1;  // points on a line, or one point
  for (int step = 0; step < kCellSteps; ++step) {
    const double cell_m = round_size(least, step);
    const VolumeGrid grid =
        without_empty_blocks(grid_over(axes, box, cell_m), reference, compared, task);
    if (measured_share(reference, grid, enough, task) >= kEnoughCells &&
        measured_share(compared, grid, enough, task) >= kEnoughCells)
      return cell_m;
  }
  return round_size(least, kCellSteps);
}

}  // namespace

VolumeGrid ground_axes(const Vec3& direction) {
  if (!is_finite(direction) || !(norm(direction) > 0))
    fail(Status::kInvalidArgument, "direction must not be zero");
  VolumeGrid grid;
  grid.up = normalized(direction);
  if (std::abs(grid.up.z) < kUprightNormal) {
    grid.u = normalized(cross({0, 0, 1}, grid.up));
    grid.v = cross(grid.up, grid.u);
    return grid;
  }
  grid.u = normalized(Vec3{1, 0, 0} - grid.up * grid.up.x);
  grid.v = cross(grid.up, grid.u);
  return grid;
}

VolumeGrid ground_grid(const Cloud& reference, const Cloud& compared,
                       const LandslideSettings& settings, Task& task) {
  const std::vector<double>& asked = settings.direction;
  VolumeGrid axes = ground_axes(asked.empty() ? ground_normal(reference, task)
                                              : Vec3{asked[0], asked[1], asked[2]});
  const Box3 first = bounds(reference, task), second = bounds(compared, task);
  for (int a = 0; a < 3; ++a) axes.origin[a] = std::floor(std::min(first.min[a], second.min[a]));
  Box3 box = projected_box(reference, axes, task);
  box += projected_box(compared, axes, task);
  const double cell_m = settings.cell_m > 0 ? settings.cell_m
                                            : automatic_cell(reference, compared, axes, box,
                                                             settings.min_points, task);
  for (const Vec3& corner : settings.corners()) box.add(axes.project(corner));
  const VolumeGrid grid = grid_over(axes, box, cell_m);
  // All cells of an outline are told of.
  return settings.outline.empty() ? without_empty_blocks(grid, reference, compared, task) : grid;
}

}  // namespace jalon

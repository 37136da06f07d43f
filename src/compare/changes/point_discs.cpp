// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "compare/changes/point_discs.h"

#include <algorithm>
#include <cmath>

#include "base/parallel.h"
#include "geometry/plane.h"

namespace jalon {

namespace {

// Neighbours whose distance tells the density: with 8, scan lines four times as far apart as their points give half as
// much again.
constexpr uint32_t kDensityNeighbours = 16;
// Neighbours all on one side mark a border, where half the disc is empty: their centroid lies 4 / (3 pi) radii away.
// Below a quarter of the radius it is chance.
constexpr double kBorderOffset = 4 / (3 * std::numbers::pi);
constexpr double kChanceOffset = 0.25;
// Of the area, what this gives inside a surface: 0.976 for points at random places (chance takes some for a border),
// 0.982 for a square lattice (whose 16th neighbour lies sqrt(5) off: 5 pi / 16).
constexpr double kPointDiscsInsideShare = 0.979;
// Cells of two to four times the radius of a point's disc connect what one surface holds; where a scanner looked
// along a surface its points are farther apart in one direction, so the upper end and the sparser points count.
constexpr double kCellFactor = 4;
constexpr double kCellQuantile = 0.9;

// Radius from the k nearest others, nearest first.
double disc_radius(const Cloud& cloud, const Vec3& p, std::span<const Neighbour> others) {
  const double farthest = others.back().squared_distance;
  Vec3 offset;
  for (const Neighbour& other : others) offset += cloud.point(other.index) - p;
  const auto k = static_cast<double>(others.size());
  const double share = farthest > 0 ? norm(offset) / (k * std::sqrt(farthest)) : 0;
  const double beside =
      std::clamp((share - kChanceOffset) / (kBorderOffset - kChanceOffset), 0.0, 1.0);
  // pi d^2 / k = 1 / density in the mean, on a plane.
  return std::sqrt(farthest / (k * kPointDiscsInsideShare) * (1 - 0.5 * beside));
}

Vec3 disc_normal(const Cloud& cloud, const Vec3& p, std::span<const Neighbour> around) {
  Moments moments;
  moments.reference = p;
  for (const Neighbour& n : around) moments.add(cloud.point(n.index));
  PlaneFit fit;
  return fit_plane(moments, fit) ? fit.plane.normal : Vec3{};
}

}  // namespace

std::vector<PointDisc> point_discs(const Cloud& cloud, std::span<const uint64_t> rows, Task& task) {
  std::vector<PointDisc> discs(rows.size());
  if (cloud.size() < 2) return discs;
  const auto tree = cloud.octree(task);
  const uint32_t k = static_cast<uint32_t>(std::min<size_t>(kDensityNeighbours, cloud.size() - 1));
  parallel_for(task, rows.size(), 1 << 10, [&](size_t begin, size_t end) {
    std::array<Neighbour, kDensityNeighbours + 1> found;
    for (size_t i = begin; i < end; ++i) {
      const Vec3 p = cloud.point(rows[i]);
      tree->knn(p, k + 1, found);
      discs[i].radius_m = static_cast<float>(disc_radius(cloud, p, {found.data() + 1, k}));
      const Vec3 normal = disc_normal(cloud, p, {found.data(), k + 1});
      for (int c = 0; c < 3; ++c)
        discs[i].across[static_cast<size_t>(c)] = static_cast<float>(normal[c]);
    }
  });
  return discs;
}

double radius_quantile(const std::vector<PointDisc>& discs, double share) {
  if (discs.empty()) return 0;
  std::vector<float> radii(discs.size());
  std::transform(discs.begin(), discs.end(), radii.begin(),
                 [](const PointDisc& d) { return d.radius_m; });
  const auto at =
      radii.begin() + static_cast<std::ptrdiff_t>(share * static_cast<double>(radii.size() - 1));
  std::nth_element(radii.begin(), at, radii.end());
  return double{*at};
}

double joining_distance(const std::vector<PointDisc>& discs) {
  return std::max(kCellFactor * radius_quantile(discs, kCellQuantile), 1e-6);
}

}  // namespace jalon

// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "compare/detection/surface_cores.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "geometry/plane.h"
#include "spatial/neighbours/knn_of_some.h"

namespace jalon {

namespace {

// Of a plane: its height is known to sigma / 5.7, and the scatter to 13 %.
constexpr uint32_t kCorePoints = 32;
// Neighbourhoods overlap by half, so that none of a change's edge is lost between two.
constexpr size_t kCoreStride = 16;
// Scatter over radius: less on a plane with noise and on a gentle curve, more across edges and in leaves.
constexpr double kSmooth = 0.15;
constexpr double kNoiseQuantile =
    0.75;  // surfaces that rays graze scatter less than the range does

// Least squares of the heights over the plane, by the squares of the distances from the centroid.
void measure_curving(const Cloud& cloud, std::span<const uint32_t> points, const Vec3& centroid,
                     SurfaceCore& core) {
  double products = 0, squares = 0, heights2 = 0;
  for (const uint32_t neighbour : points) {
    const Vec3 d = cloud.point(neighbour) - centroid;
    const double height = dot(core.normal, d), u = dot(core.axis_u, d), v = dot(core.axis_v, d);
    const double more = u * u + v * v - core.spread2();
    products += height * more;
    squares += more * more;
    heights2 += height * height;
  }
  constexpr uint32_t kCurvingUnknowns = 4;  // the plane's and this one
  if (core.count <= kCurvingUnknowns || !(squares > 0)) return;
  const double curving = products / squares;
  const double rest2 =
      std::max(0.0, heights2 - curving * products) / (core.count - kCurvingUnknowns);
  core.curving_per_m = static_cast<float>(curving);
  core.curving_sigma_per_m = static_cast<float>(std::sqrt(rest2 / squares));
}

// Does the slope across the longer axis hang on one point? Of a row with a point of another surface beside it, whose
// plane turns about the row as that point has it (leverage: Belsley, Kuh & Welsch 1980, 2.1).
bool hangs_on_one(const Cloud& cloud, std::span<const uint32_t> points, const Vec3& centroid,
                  const SurfaceCore& core) {
  constexpr double kMostLeverage = 0.5;  // of 32 points about a place the farthest has 0.15
  double most2 = 0;
  for (const uint32_t neighbour : points) {
    const double v = dot(core.axis_v, cloud.point(neighbour) - centroid);
    most2 = std::max(most2, v * v);
  }
  return most2 > kMostLeverage * core.spread_v2 * core.count;
}

// points: the nearest of a point, itself among them.
SurfaceCore core_at(const Cloud& cloud, uint32_t point, std::span<const uint32_t> points,
                    const Vec3& origin) {
  const Vec3 place = cloud.point(point);
  const size_t n = points.size();
  SurfaceCore out;
  out.point = point;
  out.count = static_cast<uint32_t>(n);
  out.radius_m = norm(cloud.point(points.back()) - place);
  Moments moments;
  moments.reference = place;
  for (const uint32_t neighbour : points) moments.add(cloud.point(neighbour));
  out.centroid = moments.centroid() - origin;
  const Eigen3 axes = symmetric_eigen(moments.covariance());
  // Points on a line span no plane.
  constexpr double kLine = 1e-6;
  if (n < 4 || !(axes.values[1] > kLine * axes.values[2])) {
    out.count = 0;
    return out;
  }
  const auto count = static_cast<double>(n);
  out.normal = axes.vectors[0];
  out.axis_v = axes.vectors[1];
  out.axis_u = axes.vectors[2];
  out.sigma_m = std::sqrt(std::max(0.0, axes.values[0]) * count / (count - 3));
  out.spread_v2 = axes.values[1];
  out.spread_u2 = axes.values[2];
  if (n == kCorePoints && hangs_on_one(cloud, points, moments.centroid(), out)) out.count = 0;
  measure_curving(cloud, points, moments.centroid(), out);
  return out;
}

}  // namespace

double SurfaceCore::aside2(const Vec3& p) const {
  const Vec3 d = p - centroid;
  const double u = dot(d, axis_u), v = dot(d, axis_v);
  return u * u / spread_u2 + v * v / spread_v2;
}

SurfaceCores::SurfaceCores(const Cloud& cloud, const Vec3& origin, Task& task) : origin_(origin) {
  points_ = cloud.octree(task);
  const size_t n = (cloud.size() + kCoreStride - 1) / kCoreStride;
  cores_.resize(n);
  xyz_ = Buffer<double>(3 * n);
  const auto order = points_->order();
  auto add_cores = [&](const SomeNearest& of) {
    std::array<uint32_t, kCorePoints> near;
    for (size_t i = 0; i < of.count; ++i) {
      const uint32_t* found = of.neighbours + i * kCorePoints;
      size_t count = 0;
      while (count < kCorePoints && found[count] != kNoPoint) {
        near[count] = order[found[count]];
        ++count;
      }
      const size_t k = of.number + i;
      const uint32_t point = order[of.positions[i]];
      cores_[k] = core_at(cloud, point, std::span(near).first(count), origin);
      const Vec3 p = cloud.point(point);
      for (int c = 0; c < 3; ++c) xyz_.data()[3 * k + static_cast<size_t>(c)] = p[c];
    }
  };
  for_each_nearest_of_some(*points_, {kCoreStride / 2, kCoreStride, n}, kCorePoints, task,
                           add_cores);
  Box3 box;
  for (size_t k = 0; k < n; ++k)
    box.add({xyz_.data()[3 * k], xyz_.data()[3 * k + 1], xyz_.data()[3 * k + 2]});
  tree_ = Octree::build(xyz_, enclosing_cube(box), task);
  measure_noise();
}

size_t SurfaceCores::nearest(const Vec3& place, uint32_t k, std::span<Neighbour> out) const {
  return tree_->knn(place + origin_, static_cast<uint32_t>(std::min<size_t>(k, cores_.size())),
                    out);
}

void SurfaceCores::measure_noise() {
  std::vector<double> sigmas;
  for (const SurfaceCore& core : cores_)
    if (core.has_plane() && core.sigma_m <= kSmooth * core.radius_m) sigmas.push_back(core.sigma_m);
  if (sigmas.empty()) return;
  const auto at = sigmas.begin() + static_cast<std::ptrdiff_t>(
                                       kNoiseQuantile * static_cast<double>(sigmas.size() - 1));
  std::nth_element(sigmas.begin(), at, sigmas.end());
  noise_m_ = *at;
}

}  // namespace jalon

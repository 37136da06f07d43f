// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0

// Hidden points and the points that hide them: a surface that has receded keeps its shape (annex E, 4.1.2).
#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <limits>

#include "base/error.h"
#include "base/numbers.h"
#include "compare/visibility/recovery.h"
#include "spatial/voxels/components.h"

namespace jalon {

namespace {

constexpr size_t kFitPoints = 2000;  // of a zone, evenly chosen: a fit of six numbers needs no more
constexpr int kFitSteps = 30;

/// Before the search for point i of a zone, which may hold most of the cloud.
void check_cancel(size_t i, const Task& task) {
  constexpr size_t kSearchesPerCheck = 512;  // about 1 ms
  if (i % kSearchesPerCheck == 0 && task.cancelled()) throw Error(Status::kCancelled, "cancelled");
}

/// The points of one zone or of its occluders, relative to whole metres.
struct PointSet {
  std::vector<double> xyz;
  size_t size() const { return xyz.size() / 3; }
  Vec3 point(size_t i) const { return {xyz[3 * i], xyz[3 * i + 1], xyz[3 * i + 2]}; }
  void add(const Vec3& p) { xyz.insert(xyz.end(), {p.x, p.y, p.z}); }
  Box3 box() const {
    Box3 box;
    for (size_t i = 0; i < size(); ++i) box.add(point(i));
    return box;
  }
};

Neighbour nearest_in(const Octree& tree, const Vec3& p) {
  std::array<Neighbour, 1> found{};
  tree.knn(p, 1, found);
  return found[0];
}

/// Root mean square distance of the points from their next one.
double spacing_of(const PointSet& points, const Octree& tree, const Task& task) {
  if (points.size() < 2) return 0;
  double sum = 0;
  std::array<Neighbour, 2> found{};
  for (size_t i = 0; i < points.size(); ++i) {
    check_cancel(i, task);
    tree.knn(points.point(i), 2, found);
    sum += found[1].squared_distance;
  }
  return std::sqrt(sum / static_cast<double>(points.size()));
}

/// The rigid motion that brings a onto b, pair by pair, in least squares (Kabsch 1976).
Transform rigid_fit(std::span<const Vec3> a, std::span<const Vec3> b) {
  Vec3 ca, cb;
  for (size_t i = 0; i < a.size(); ++i) ca += a[i], cb += b[i];
  ca = ca / static_cast<double>(a.size());
  cb = cb / static_cast<double>(a.size());
  Eigen::Matrix3d cross_covariance = Eigen::Matrix3d::Zero();
  for (size_t i = 0; i < a.size(); ++i) {
    const Vec3 p = a[i] - ca, q = b[i] - cb;
    cross_covariance += Eigen::Vector3d(q.x, q.y, q.z) * Eigen::RowVector3d(p.x, p.y, p.z);
  }
  const Eigen::JacobiSVD<Eigen::Matrix3d> svd(cross_covariance,
                                              Eigen::ComputeFullU | Eigen::ComputeFullV);
  Eigen::Vector3d signs(1, 1, 1);
  if ((svd.matrixU() * svd.matrixV().transpose()).determinant() < 0) signs[2] = -1;
  const Eigen::Matrix3d r = svd.matrixU() * signs.asDiagonal() * svd.matrixV().transpose();
  Transform t;
  for (size_t i = 0; i < 3; ++i)
    for (size_t j = 0; j < 3; ++j)
      t.m[4 * i + j] = r(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(j));
  const Vec3 turned = t.direction(ca);
  for (int i = 0; i < 3; ++i) t.m[static_cast<size_t>(4 * i + 3)] = cb[i] - turned[i];
  return t;
}

/// What is left between the zone and the occluders after a rigid fit, from centre on centre (ICP of Besl & McKay 1992).
double fit_residual(const PointSet& zone, const PointSet& occluders, const Octree& tree,
                    const Task& task) {
  std::vector<Vec3> moving;
  const size_t stride = zone.size() / kFitPoints + 1;
  for (size_t i = 0; i < zone.size(); i += stride) moving.push_back(zone.point(i));
  Vec3 from, to;
  for (const Vec3& p : moving) from += p;
  for (size_t i = 0; i < occluders.size(); ++i) to += occluders.point(i);
  const Vec3 shift =
      to / static_cast<double>(occluders.size()) - from / static_cast<double>(moving.size());
  for (Vec3& p : moving) p += shift;

  double rms = std::numeric_limits<double>::infinity();
  std::vector<Vec3> targets(moving.size());
  for (int step = 0; step < kFitSteps; ++step) {
    double sum = 0;
    for (size_t i = 0; i < moving.size(); ++i) {
      check_cancel(i, task);
      const Neighbour found = nearest_in(tree, moving[i]);
      sum += found.squared_distance;
      targets[i] = occluders.point(found.index);
    }
    const double now = std::sqrt(sum / static_cast<double>(moving.size()));
    constexpr double kLeastGain = 1e-4;
    if (!(now < rms * (1 - kLeastGain))) break;
    rms = now;
    const Transform t = rigid_fit(moving, targets);
    for (Vec3& p : moving) p = t.point(p);
  }
  return rms;
}

/// One zone: members are positions in the list of points.
void match_zone(const Cloud& reference, const Cloud& compared, std::span<const uint64_t> points,
                std::span<const uint32_t> members, std::span<const uint32_t> hiders,
                OccluderMatch& out, Task& task) {
  std::vector<uint32_t> distinct;
  for (const uint32_t k : members)
    if (hiders[k] != kNoPoint) distinct.push_back(hiders[k]);
  std::sort(distinct.begin(), distinct.end());
  distinct.erase(std::unique(distinct.begin(), distinct.end()), distinct.end());
  if (distinct.empty()) return;
  Vec3 origin = reference.point(distinct[0]);
  for (int a = 0; a < 3; ++a) origin[a] = std::floor(origin[a]);
  PointSet zone, occluders;
  for (const uint32_t i : distinct) occluders.add(reference.point(i) - origin);
  for (const uint32_t k : members) zone.add(compared.point(points[k]) - origin);
  const auto tree = Octree::build(occluders.xyz, enclosing_cube(occluders.box()), task);
  const double residual = fit_residual(zone, occluders, *tree, task),
               spacing = spacing_of(occluders, *tree, task);
  for (size_t j = 0; j < members.size(); ++j) {
    check_cancel(j, task);
    out.distances[members[j]] = std::sqrt(nearest_in(*tree, zone.point(j)).squared_distance);
    out.residuals[members[j]] = residual;
    // A single point has no shape.
    if (spacing > 0) out.ratios[members[j]] = residual / spacing;
  }
}

}  // namespace

OccluderMatch match_occluders(const Cloud& reference, const Cloud& compared,
                              const VisibilityTest& test, std::span<const uint64_t> points,
                              double zone_m, Task& task) {
  OccluderMatch out;
  for (auto* values : {&out.distances, &out.residuals, &out.ratios})
    values->assign(points.size(), kNaN);
  if (points.empty()) return out;
  // 1. Who hides whom; zones.
  std::vector<uint32_t> hiders(points.size());
  PointSet all;
  for (size_t k = 0; k < points.size(); ++k) {
    check_cancel(k, task);
    test.label(compared.point(points[k]), &hiders[k]);
    all.add(compared.point(points[k]));
  }
  Vec3 origin = all.point(0);
  for (int a = 0; a < 3; ++a) origin[a] = std::floor(origin[a]);
  const Components zones =
      connected_components(all.xyz, origin, zone_m, Connectivity3::k26, 1, task);
  // 2. Each zone with its occluders.
  std::vector<std::vector<uint32_t>> members(zones.count());
  for (size_t k = 0; k < points.size(); ++k)
    members[zones.labels[k] - 1].push_back(static_cast<uint32_t>(k));
  for (size_t z = 0; z < members.size(); ++z) {
    task.checkpoint(static_cast<double>(z) / static_cast<double>(members.size()));
    match_zone(reference, compared, points, members[z], hiders, out, task);
  }
  return out;
}

}  // namespace jalon

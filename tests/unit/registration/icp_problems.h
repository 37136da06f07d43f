// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cmath>
#include <functional>
#include <memory>
#include <utility>
#include <vector>

#include "geometry/rigid_motion.h"
#include "registration/icp/iterations.h"
#include "unit/cloud/clouds.h"

namespace jalon::test {

/// Two clouds as ICP works on them, turns about the middle of the moving one.
inline IcpProblem problem_between(Cloud reference, Cloud moving, const IcpSettings& settings = {}) {
  Task task;
  IcpProblem out;
  out.settings = settings;
  out.thinned_reference.cloud = std::make_shared<const Cloud>(std::move(reference));
  out.thinned_moving.cloud = std::make_shared<const Cloud>(std::move(moving));
  out.clouds.reference =
      surface_planes(out.thinned_reference.cloud->octree(task), settings.k, task);
  const SurfacePlanes& m = out.clouds.moving =
      surface_planes(out.thinned_moving.cloud->octree(task), settings.k, task);
  const auto n = static_cast<double>(m.size());
  for (size_t i = 0; i < m.size(); ++i) out.centre += m.place(i) / n;
  double squares = 0;
  for (size_t i = 0; i < m.size(); ++i) squares += squared_norm(m.place(i) - out.centre);
  out.extent_m = std::sqrt(squares / n);
  return out;
}

/// All points in one level, from a pose between the caller's coordinates.
inline IcpState iterated(const IcpProblem& problem, const Transform& T_start, double distance_m) {
  Task task;
  IcpState state;
  state.T_reference_moving = problem.clouds.to_local(T_start);
  state.distance_m = distance_m;
  icp_iterate(problem, {}, state, task);
  return state;
}

/// Planes given point by point, with a scatter of a millimetre. The cloud must outlive them.
inline SurfacePlanes planes_by_hand(const Cloud& cloud,
                                    const std::function<Vec3(const Vec3&)>& normal_at) {
  Task task;
  SurfacePlanes out;
  out.tree = cloud.octree(task);
  out.planes = Buffer<SurfacePlane>(cloud.size());
  for (size_t i = 0; i < cloud.size(); ++i) {
    const Vec3 n = normal_at(cloud.point(out.tree->order()[i]));
    out.planes[i] = {{static_cast<float>(n.x), static_cast<float>(n.y), static_cast<float>(n.z)},
                     0,
                     0.001f,
                     0,
                     0.1f,
                     SurfaceShape::kPlane};
  }
  out.noise_m = 0.001;
  out.flat_m = 0.00175;
  out.radius_m = 0.1;
  return out;
}

inline Buffer<uint32_t> positions_of(const std::vector<uint32_t>& values) {
  Buffer<uint32_t> out(values.size());
  std::copy(values.begin(), values.end(), out.begin());
  return out;
}

/// Where a point of the cloud stands in the tree.
inline uint32_t position_in(const Octree& tree, uint32_t index) {
  const auto order = tree.order();
  return static_cast<uint32_t>(std::find(order.begin(), order.end(), index) - order.begin());
}

/// Of the k points nearest to one of the cloud, itself among them, nearest first.
inline std::vector<uint32_t> positions_near(const Octree& tree, uint32_t position, uint32_t k) {
  std::vector<Neighbour> found(k);
  found.resize(tree.knn_positions(tree.cube().origin + tree.local(position), k, found));
  std::vector<uint32_t> out;
  for (const Neighbour& n : found) out.push_back(n.index);
  return out;
}

/// An even square of nu x nv points with noise across it, jittered along it by a fifth of a step.
inline std::vector<Vec3> noisy_sheet(const Vec3& corner, const Vec3& u, const Vec3& v, int nu,
                                     int nv, double noise_m, RandomStream& random) {
  std::vector<Vec3> out;
  for (int i = 0; i < nu; ++i)
    for (int k = 0; k < nv; ++k) {
      const double a = i + 0.4 * (random.uniform() - 0.5), b = k + 0.4 * (random.uniform() - 0.5);
      out.push_back(corner + u * a + v * b + normalized(cross(u, v)) * (noise_m * random.normal()));
    }
  return out;
}

/// Lines along x on the floor, this far apart, points every 2 cm along them with 2 mm of noise.
inline std::vector<Vec3> floor_of_lines(double apart_m, int lines, int points) {
  RandomStream random(131, 0);
  std::vector<Vec3> out;
  for (int i = 0; i < lines; ++i)
    for (int k = 0; k < points; ++k)
      out.push_back({0.02 * (k + random.uniform()), apart_m * i + 0.002 * random.normal(),
                     0.002 * random.normal()});
  return out;
}

}  // namespace jalon::test

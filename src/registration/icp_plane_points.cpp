// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "registration/icp_plane_points.h"

#include <algorithm>
#include <cmath>

namespace jalon {

namespace {

// Sums of those of some points that are within a limit of a plane, or of all.
PlanePoints sums_of(const Octree& tree, uint32_t position, std::vector<uint32_t>& positions) {
  PlanePoints out;
  out.count = positions.size();
  const int32_t *x = tree.grid_x(), *y = tree.grid_y(), *z = tree.grid_z();
  const auto at = [&](uint32_t p) {
    return Vec3{static_cast<double>(x[p] - x[position]), static_cast<double>(y[p] - y[position]),
                static_cast<double>(z[p] - z[position])};
  };
  for (const uint32_t p : positions) out.offset += at(p);
  out.offset = out.offset / static_cast<double>(out.count);
  for (const uint32_t p : positions) {
    const Vec3 d = at(p) - out.offset;
    const double row[6] = {d.x * d.x, d.x * d.y, d.x * d.z, d.y * d.y, d.y * d.z, d.z * d.z};
    for (size_t c = 0; c < 6; ++c) out.scatter[c] += row[c];
  }
  return out;
}

}  // namespace

PlaneMembers plane_members(const SurfacePlanes& planes, uint32_t position, uint32_t k) {
  const Octree& tree = *planes.tree;
  std::vector<Neighbour> near(k);
  near.resize(tree.knn_positions(tree.cube().origin + tree.local(position), k, near));
  PlaneMembers out;
  const SurfacePlane& plane = planes.planes[position];
  // On a face of its own the plane was drawn through the points near it; elsewhere through all.
  for (const Neighbour& n : near)
    if (std::abs(dot(plane.unit(), planes.place(n.index) - planes.place(position)) - plane.height_m) <=
        kFaceNoises * planes.noise_m || !plane.face)
      out.positions.push_back(n.index);
  out.points = sums_of(tree, position, out.positions);
  const Eigen3 e = symmetric_eigen(out.points.scatter);
  const double step2 = tree.grid_step() * tree.grid_step();
  out.u = e.vectors[2];
  out.v = e.vectors[1];
  out.uu_m2 = e.values[2] * step2;
  out.vv_m2 = e.values[1] * step2;
  return out;
}

}  // namespace jalon

// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "registration/surface/plane_points.h"

#include <cmath>

#include "registration/surface/face_plane.h"
#include "registration/surface/quadric_plane.h"

namespace jalon {

namespace {

// On a face of its own the plane was drawn through the points near it; elsewhere through all.
void keep_face(const SurfacePlanes& planes, uint32_t position, std::vector<uint32_t>& near) {
  const SurfacePlane& plane = planes.planes[position];
  std::erase_if(near, [&](uint32_t n) {
    const double height = dot(plane.unit(), planes.place(n) - planes.place(position));
    return std::abs(height - double{plane.height_m}) > kFaceNoises * planes.noise_m;
  });
}

std::vector<PlaneShare> shares_of_plane(const SurfacePlanes& planes, uint32_t position,
                                        const std::vector<uint32_t>& near) {
  std::vector<PlaneShare> out;
  if (near.empty()) return out;
  Vec3 centre;
  for (const uint32_t n : near) centre += planes.place(n) - planes.place(position);
  const auto count = static_cast<double>(near.size());
  centre = centre / count;
  Symmetric3 scatter{};
  for (const uint32_t n : near) {
    const Vec3 d = planes.place(n) - planes.place(position) - centre;
    const double row[6] = {d.x * d.x, d.x * d.y, d.x * d.z, d.y * d.y, d.y * d.z, d.z * d.z};
    for (size_t c = 0; c < 6; ++c) scatter[c] += row[c];
  }
  const Eigen3 e = symmetric_eigen(scatter);
  const Vec3 &u = e.vectors[2], &v = e.vectors[1];
  if (!(e.values[1] > 0)) return out;
  for (const uint32_t n : near) {
    const Vec3 d = planes.place(n) - planes.place(position) - centre;
    const Vec3 slope = u * (dot(u, d) / e.values[2]) + v * (dot(v, d) / e.values[1]);
    out.push_back({n, 1 / count - dot(centre, slope), slope});
  }
  return out;
}

std::vector<PlaneShare> shares_of_quadric(const SurfacePlanes& planes, uint32_t position,
                                          const std::vector<uint32_t>& near) {
  std::vector<PlaneShare> out;
  const std::optional<TangentQuadric> quadric = local_quadric(*planes.tree, position, near);
  if (!quadric) return out;
  for (const uint32_t n : near) {
    const Coefficients<6> q = quadric->terms(planes.place(n) - planes.place(position));
    double of[3] = {};
    for (size_t r = 0; r < 3; ++r)
      for (size_t c = 0; c < 6; ++c) of[r] += quadric->cofactors[6 * r + c] * q[c];
    out.push_back({n, of[0], (quadric->u * of[1] + quadric->v * of[2]) / quadric->scale_m});
  }
  return out;
}

}  // namespace

std::vector<PlaneShare> plane_shares(const SurfacePlanes& planes, uint32_t position, uint32_t k) {
  const Octree& tree = *planes.tree;
  std::vector<Neighbour> found(k);
  found.resize(tree.knn_positions(tree.cube().origin + tree.local(position), k, found));
  std::vector<uint32_t> near;
  for (const Neighbour& n : found) near.push_back(n.index);
  const SurfaceShape shape = planes.planes[position].shape;
  if (shape == SurfaceShape::kQuadric) return shares_of_quadric(planes, position, near);
  if (shape == SurfaceShape::kFace) keep_face(planes, position, near);
  return shares_of_plane(planes, position, near);
}

}  // namespace jalon

// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>

#include "base/params.h"
#include "geometry/symmetric_eigen.h"
#include "model/model.h"

namespace jalon {

/// The settings of operation "ellipsoids".
struct EllipsoidSettings {
  double confidence = 0.99;
  uint64_t every = 100;
  int fineness = 1;
  double scale = 1;
};
std::span<const ParamRow> ellipsoid_rows();

/// Half-axes of the ellipsoid that holds the truth with this probability: sqrt(q lambda_k) e_k, q the
/// quantile of chi-square with 3 degrees of freedom, the longest first.
std::array<Vec3, 3> ellipsoid_half_axes(const Symmetric3& covariance, double confidence);

/// A closed triangle mesh that stands for the unit sphere: an icosahedron whose triangles are cut in
/// four this many times.
struct SphereMesh {
  std::vector<Vec3> vertices;
  std::vector<std::array<uint32_t, 3>> triangles;
};
SphereMesh sphere_mesh(int fineness);

/// Adds the ellipsoid around centre; its triangles carry the id.
void add_ellipsoid(Model& model, const SphereMesh& sphere, const Vec3& centre,
                   const std::array<Vec3, 3>& half_axes, uint32_t id);

}  // namespace jalon

// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "model/trajectory/ellipsoids.h"

#include <algorithm>
#include <cmath>
#include <map>

#include "base/distributions.h"
#include "base/setting_rows.h"

namespace jalon {

namespace {

constexpr auto kEllipsoidRows = setting_rows(
    number_row<&EllipsoidSettings::confidence>(
        "confidence", 0.001, 0.999999, "", "",
        "Probability that the ellipsoid holds the truth: 0.99 is 3.37 sigmas each way."),
    integer_row<&EllipsoidSettings::every>(
        "every", 1, 1e15, "", "", "One ellipsoid every so many points, the first among them."),
    integer_row<&EllipsoidSettings::fineness>("fineness", 0, 5, "", "",
                                              "20, 80, 320, 1280 ... triangles an ellipsoid."),
    number_row<&EllipsoidSettings::scale>("scale", 1e-6, 1e6, "", "",
                                          "Drawn so many times as large, to be seen."));

uint32_t middle_of(SphereMesh& mesh, std::map<std::pair<uint32_t, uint32_t>, uint32_t>& middles,
                   uint32_t a, uint32_t b) {
  const auto [found, is_new] = middles.try_emplace(std::minmax(a, b), 0);
  if (is_new) {
    found->second = static_cast<uint32_t>(mesh.vertices.size());
    mesh.vertices.push_back(normalized(mesh.vertices[a] + mesh.vertices[b]));
  }
  return found->second;
}

}  // namespace

std::span<const ParamRow> ellipsoid_rows() { return kEllipsoidRows; }

std::array<Vec3, 3> ellipsoid_half_axes(const Symmetric3& covariance, double confidence) {
  const Eigen3 eigen = symmetric_eigen(covariance);
  const double factor = std::sqrt(chi_square_quantile(3, confidence));
  std::array<Vec3, 3> axes;
  for (size_t k = 0; k < 3; ++k)
    axes[k] = eigen.vectors[2 - k] * (factor * std::sqrt(std::max(0.0, eigen.values[2 - k])));
  return axes;
}

SphereMesh sphere_mesh(int fineness) {
  // 1. An icosahedron: three golden rectangles across each other.
  const double g = (1 + std::sqrt(5.0)) / 2;
  SphereMesh mesh;
  for (const double a : {-1.0, 1.0})
    for (const double b : {-g, g})
      for (const Vec3& v : {Vec3{0, a, b}, Vec3{a, b, 0}, Vec3{b, 0, a}})
        mesh.vertices.push_back(normalized(v));
  const double edge2 = 4 / (1 + g * g);  // squared, on the unit sphere
  const auto are_joined = [&](uint32_t i, uint32_t j) {
    return std::fabs(squared_norm(mesh.vertices[i] - mesh.vertices[j]) - edge2) < 1e-9;
  };
  for (uint32_t i = 0; i < 12; ++i)
    for (uint32_t j = i + 1; j < 12; ++j)
      for (uint32_t k = j + 1; k < 12; ++k) {
        if (!are_joined(i, j) || !are_joined(j, k) || !are_joined(i, k)) continue;
        const Vec3 &a = mesh.vertices[i], &b = mesh.vertices[j], &c = mesh.vertices[k];
        if (dot(cross(b - a, c - a), a) > 0) mesh.triangles.push_back({i, j, k});  // outward
        else mesh.triangles.push_back({i, k, j});
      }
  // 2. Each triangle in four, corners on the sphere.
  for (int step = 0; step < fineness; ++step) {
    std::map<std::pair<uint32_t, uint32_t>, uint32_t> middles;
    std::vector<std::array<uint32_t, 3>> finer;
    for (const auto& [a, b, c] : mesh.triangles) {
      const uint32_t ab = middle_of(mesh, middles, a, b), bc = middle_of(mesh, middles, b, c),
                     ca = middle_of(mesh, middles, c, a);
      finer.push_back({a, ab, ca});
      finer.push_back({ab, b, bc});
      finer.push_back({ca, bc, c});
      finer.push_back({ab, bc, ca});
    }
    mesh.triangles = std::move(finer);
  }
  return mesh;
}

void add_ellipsoid(Model& model, const SphereMesh& sphere, const Vec3& centre,
                   const std::array<Vec3, 3>& half_axes, uint32_t id) {
  const auto first = static_cast<uint32_t>(model.vertices.size());
  for (const Vec3& v : sphere.vertices)
    model.vertices.push_back(centre + half_axes[0] * v.x + half_axes[1] * v.y + half_axes[2] * v.z);
  // Eigenvectors may come left-handed from the longest on: the triangles shall still look outward.
  const bool mirrored = dot(cross(half_axes[0], half_axes[1]), half_axes[2]) < 0;
  for (const auto& [a, b, c] : sphere.triangles) {
    if (mirrored) model.triangles.push_back({first + a, first + c, first + b});
    else model.triangles.push_back({first + a, first + b, first + c});
    model.triangle_faces.push_back(id);
  }
}

}  // namespace jalon

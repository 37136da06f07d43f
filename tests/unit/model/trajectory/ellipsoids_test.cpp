// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "model/trajectory/ellipsoids.h"

#include <doctest/doctest.h>

#include <map>

using namespace jalon;

TEST_CASE("ellipsoid__of_the_worked_example__has_the_half_axes_of_the_hand_calculation") {
  const Symmetric3 c = {7.950407e-04, 1.353306e-04,  4.065763e-05,
                        5.248749e-04, -1.181963e-04, 1.300320e-03};
  const auto axes = ellipsoid_half_axes(c, 0.99);
  CHECK(std::fabs(norm(axes[0]) - 0.1223) < 5e-5);
  CHECK(std::fabs(norm(axes[1]) - 0.0983) < 5e-5);
  CHECK(std::fabs(norm(axes[2]) - 0.0715) < 5e-5);
  CHECK(std::fabs(dot(axes[0], axes[1])) < 1e-15);
}

TEST_CASE("sphere_mesh__of_every_fineness__is_closed_and_looks_outward") {
  size_t triangles = 20;
  for (int fineness = 0; fineness < 4; ++fineness, triangles *= 4) {
    const SphereMesh mesh = sphere_mesh(fineness);
    REQUIRE(mesh.triangles.size() == triangles);
    CHECK(mesh.vertices.size() == triangles / 2 + 2);  // Euler
    std::map<std::pair<uint32_t, uint32_t>, int> edges;
    double volume = 0;
    for (const auto& t : mesh.triangles) {
      volume += dot(mesh.vertices[t[0]], cross(mesh.vertices[t[1]], mesh.vertices[t[2]])) / 6;
      for (size_t k = 0; k < 3; ++k) ++edges[{t[k], t[(k + 1) % 3]}];
    }
    for (const auto& [edge, uses] : edges) {
      CHECK(uses == 1);
      CHECK(edges.contains({edge.second, edge.first}));
    }
    CHECK(volume > 2.5);
    CHECK(volume < 4.18879);
  }
}

TEST_CASE("add_ellipsoid__of_either_hand__looks_outward_and_carries_its_id") {
  Model model;
  const SphereMesh sphere = sphere_mesh(1);
  add_ellipsoid(model, sphere, {10, 20, 30}, {Vec3{2, 0, 0}, Vec3{0, 1, 0}, Vec3{0, 0, -0.5}}, 7);
  CHECK(model.triangle_faces.back() == 7);
  double volume = 0;
  for (const auto& t : model.triangles) {
    const Vec3 a = model.vertices[t[0]] - Vec3{10, 20, 30},
               b = model.vertices[t[1]] - Vec3{10, 20, 30},
               c = model.vertices[t[2]] - Vec3{10, 20, 30};
    CHECK(std::fabs(a.x * a.x / 4 + a.y * a.y + a.z * a.z * 4 - 1) < 1e-12);
    volume += dot(a, cross(b, c)) / 6;
  }
  CHECK(volume > 3);
}

// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0

// Surfaces without a plane.
#include <cmath>
#include <numbers>

#include "scan/builder/builder.h"

namespace jalon {

void SceneBuilder::grid(int nu, int nv, uint32_t id, auto&& point) {
  const auto first = static_cast<uint32_t>(model_.vertices.size()),
             width = static_cast<uint32_t>(nu);
  for (int j = 0; j <= nv; ++j)
    for (int i = 0; i < nu; ++i)
      vertex(point(2 * std::numbers::pi * i / nu, static_cast<double>(j) / nv));
  for (uint32_t j = 0; j < static_cast<uint32_t>(nv); ++j)
    for (uint32_t i = 0; i < width; ++i) {
      const uint32_t a = first + j * width + i, b = first + j * width + (i + 1) % width;
      quad(a, b, b + width, a + width, id);
    }
}

void SceneBuilder::cylinder(const Vec3& foot, double radius_m, double height_m, int facets) {
  grid(facets, 1, new_id(), [&](double angle, double part) {
    return foot + Vec3{radius_m * std::cos(angle), radius_m * std::sin(angle), part * height_m};
  });
}

void SceneBuilder::sphere(const Vec3& centre, double radius_m, int facets) {
  grid(facets, facets / 2, new_id(), [&](double angle, double part) {
    const double latitude = std::numbers::pi * (part - 0.5), r = radius_m * std::cos(latitude);
    return centre + Vec3{r * std::cos(angle), r * std::sin(angle), radius_m * std::sin(latitude)};
  });
}

void SceneBuilder::swept(const Frame& frame, const Outline& path, double low_m, double high_m) {
  const uint32_t id = new_id();
  const Vec3 down = frame.normal() * (high_m - low_m);
  for (size_t i = 0; i + 1 < path.size(); ++i) {
    const Vec3 a = frame.point(path[i].u, path[i].v, high_m),
               b = frame.point(path[i + 1].u, path[i + 1].v, high_m);
    triangle(a, b, b - down, id);
    triangle(a, b - down, a - down, id);
  }
}

void SceneBuilder::relief(uint32_t columns, uint32_t rows,
                          const std::function<Vec3(uint32_t, uint32_t)>& corner,
                          const std::function<uint32_t(uint32_t, uint32_t)>& cell_id) {
  const auto first = static_cast<uint32_t>(model_.vertices.size()), width = columns + 1;
  for (uint32_t j = 0; j <= rows; ++j)
    for (uint32_t i = 0; i <= columns; ++i) vertex(corner(i, j));
  for (uint32_t j = 0; j < rows; ++j)
    for (uint32_t i = 0; i < columns; ++i) {
      const uint32_t a = first + j * width + i;
      quad(a, a + 1, a + 1 + width, a + width, cell_id(i, j));
    }
}

void SceneBuilder::triangle(const Vec3& a, const Vec3& b, const Vec3& c, uint32_t id) {
  const uint32_t first = vertex(a);
  vertex(b);
  vertex(c);
  model_.triangles.push_back({first, first + 1, first + 2});
  model_.triangle_faces.push_back(id);
}

void SceneBuilder::crown(const Vec3& centre, double radius_m, int leaves, double leaf_m,
                         RandomStream random) {
  const uint32_t id = new_id();
  const auto in_ball = [&] {
    Vec3 p;
    do
      for (int a = 0; a < 3; ++a) p[a] = 2 * random.uniform() - 1;
    while (squared_norm(p) > 1);
    return p;
  };
  for (int i = 0; i < leaves; ++i) {
    const Vec3 middle = centre + in_ball() * radius_m;
    Vec3 corners[3];
    for (Vec3& c : corners) c = middle + in_ball() * leaf_m;
    triangle(corners[0], corners[1], corners[2], id);
  }
}

}  // namespace jalon

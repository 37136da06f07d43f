// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <vector>

#include "base/task.h"
#include "geometry/vec.h"

namespace jalon::test {

using Triangle = std::array<uint32_t, 3>;

/// Triangles that share no vertex.
struct Mesh {
  std::vector<Vec3> vertices;
  std::vector<Triangle> triangles;

  void add(const Vec3& a, const Vec3& b, const Vec3& c) {
    const auto first = static_cast<uint32_t>(vertices.size());
    vertices.insert(vertices.end(), {a, b, c});
    triangles.push_back({first, first + 1, first + 2});
  }
  /// Corners anticlockwise seen from outside.
  void add_quad(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d) {
    add(a, b, c);
    add(a, c, d);
  }
  /// The side walls and both ends of a prism over a polygon that runs anticlockwise; the ends as triangles of it.
  void add_prism(const std::vector<Vec2>& outline, const std::vector<Triangle>& ends, double z0,
                 double z1) {
    const auto at = [&](size_t i, double z) {
      const Vec2& p = outline[i % outline.size()];
      return Vec3{p.u, p.v, z};
    };
    for (size_t i = 0; i < outline.size(); ++i)
      add_quad(at(i, z0), at(i + 1, z0), at(i + 1, z1), at(i, z1));
    for (const auto& [a, b, c] : ends) {
      add(at(a, z1), at(b, z1), at(c, z1));
      add(at(a, z0), at(c, z0), at(b, z0));
    }
  }
  Mesh shifted(const Vec3& by) const {
    Mesh out = *this;
    for (Vec3& v : out.vertices) v += by;
    return out;
  }
};

/// Tree: TriangleTree or NearestTriangles.
template <class Tree>
std::shared_ptr<const Tree> built(const Mesh& mesh, unsigned threads = 0) {
  Task::Hooks hooks;
  hooks.threads = threads;
  Task task(hooks);
  return Tree::build(mesh.vertices, mesh.triangles, task);
}

}  // namespace jalon::test

// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

// What the tests of the scene builders measure on the triangles alone, without the faces that go with them.

#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <set>
#include <string>
#include <utility>

#include "scan/scenes/scenes.h"
#include "unit/scan/fixture.h"

namespace jalon::test {

constexpr double kRounding_m = 1e-9;  ///< some thousand ulps of coordinates below 100 m

using SceneRecipe = void (*)(const SceneSettings&, SceneBuilder&);

/// The scene in the frame of its recipe.
inline Model built(SceneRecipe recipe, const SceneSettings& settings = {}) {
  SceneBuilder out{Transform{}};
  recipe(settings, out);
  return out.take();
}

inline std::array<Vec3, 3> corners_of(const Model& model, size_t triangle) {
  const auto& [a, b, c] = model.triangles[triangle];
  return {model.vertices[a], model.vertices[b], model.vertices[c]};
}

struct Hit {
  double distance = std::numeric_limits<double>::infinity();
  size_t triangle = 0;
  bool is_front = false;
};

/// The nearest triangle on a ray, by trying them all (Moeller & Trumbore 1997).
inline Hit first_hit(const Model& model, const Vec3& eye, const Vec3& direction) {
  constexpr double kEdge = 1e-10;  // so that no ray slips between neighbours
  Hit best;
  for (size_t t = 0; t < model.triangles.size(); ++t) {
    const auto [a, b, c] = corners_of(model, t);
    const Vec3 p = cross(direction, c - a), s = eye - a, q = cross(s, b - a);
    const double det = dot(b - a, p);
    if (det == 0) continue;
    const double u = dot(s, p) / det, v = dot(direction, q) / det, far = dot(c - a, q) / det;
    if (u < -kEdge || v < -kEdge || u + v > 1 + kEdge || far < 0 || far >= best.distance) continue;
    best = {far, t, det > 0};
  }
  return best;
}

/// Depth y that a level ray along +Y meets first at this place of the front, height that an upright one meets from
/// above; infinite where nothing stands.
inline double front_y(const Model& model, double x, double z) {
  return first_hit(model, {x, -50, z}, {0, 1, 0}).distance - 50;
}
inline double top_z(const Model& model, double x, double y) {
  return 50 - first_hit(model, {x, y, 50}, {0, 0, -1}).distance;
}

/// Is the face one outline with holes, which say its area, and whose triangles have it?
inline bool is_sound(const Model& model, const Face& face) {
  double area_m2 = 0;
  for (uint64_t r = 0; r < face.ring_count; ++r) {
    const Ring& ring = model.rings[face.first_ring + r];
    const auto corner = [&](uint64_t i) {
      return model.vertices[model.corners[ring.first + i % ring.count]];
    };
    Vec3 sum;
    for (uint64_t i = 0; i < ring.count; ++i)
      sum += cross(corner(i) - corner(0), corner(i + 1) - corner(0));
    const double of_ring = dot(sum, face.plane.normal) / 2;
    if ((of_ring > 0) != (r == 0)) return false;
    area_m2 += of_ring;
  }
  double of_triangles = 0;
  for (size_t t = 0; t < model.triangles.size(); ++t) {
    const auto [a, b, c] = corners_of(model, t);
    if (model.triangle_faces[t] == face.id)
      of_triangles += dot(cross(b - a, c - a), face.plane.normal) / 2;
  }
  const double slack_m2 = kRounding_m * (1 + face.area_m2);
  return area_m2 > 0 && std::abs(area_m2 - face.area_m2) < slack_m2 &&
         std::abs(area_m2 - of_triangles) < slack_m2;
}

/// Triangles of a surface; a closed one has no vector area, and its volume does not depend on the origin. One that a
/// plane through the origin would close has the same volume.
struct Shell {
  size_t triangles = 0;
  double area_m2 = 0, volume_m3 = 0;
  Vec3 vector_area;
};

inline Shell shell_of(const Model& model, const std::set<uint32_t>& ids, const Vec3& origin = {}) {
  Shell out;
  for (size_t t = 0; t < model.triangles.size(); ++t) {
    if (!ids.empty() && !ids.contains(model.triangle_faces[t])) continue;
    const auto [a, b, c] = corners_of(model, t);
    const Vec3 area = cross(b - a, c - a) * 0.5;
    ++out.triangles;
    out.area_m2 += norm(area);
    out.vector_area += area;
    out.volume_m3 += dot(a - origin, area) / 3;
  }
  return out;
}

/// Of the faces whose part is of this class; of one part when its number is told.
inline std::set<uint32_t> ids_of(const Model& model, const std::string& part_class,
                                 uint32_t part = kNoPart) {
  std::set<uint32_t> out;
  for (const Face& face : model.faces)
    if (model.parts[face.part].part_class == part_class && (part == kNoPart || part == face.part))
      out.insert(face.id);
  return out;
}

/// Numbers of the parts of a class.
inline std::vector<uint32_t> parts_named(const Model& model, const std::string& part_class) {
  std::vector<uint32_t> out;
  for (uint32_t p = 0; p < model.parts.size(); ++p)
    if (model.parts[p].part_class == part_class) out.push_back(p);
  return out;
}

/// Class of the part whose face a triangle belongs to; nothing for curved surfaces.
inline std::string class_of(const Model& model, size_t triangle) {
  for (const Face& face : model.faces)
    if (face.id == model.triangle_faces[triangle]) return model.parts[face.part].part_class;
  return {};
}

/// Length of the triangle edges that no neighbour walks the other way; places within a nanometre are one.
inline double open_edge_m(const Model& model) {
  using Place = std::array<int64_t, 3>;
  const auto place = [](const Vec3& p) -> Place {
    return {std::llround(p.x * 1e9), std::llround(p.y * 1e9), std::llround(p.z * 1e9)};
  };
  std::map<std::pair<Place, Place>, std::pair<int, double>> edges;
  for (size_t t = 0; t < model.triangles.size(); ++t) {
    const auto corners = corners_of(model, t);
    for (size_t k = 0; k < 3; ++k) {
      const Vec3 &from = corners[k], &to = corners[(k + 1) % 3];
      const Place a = place(from), b = place(to);
      if (a == b) continue;
      auto& [count, length] = edges[std::minmax(a, b)];
      count += a < b ? 1 : -1;
      length = norm(to - from);
    }
  }
  double sum = 0;
  for (const auto& [edge, walks] : edges) sum += std::abs(walks.first) * walks.second;
  return sum;
}

}  // namespace jalon::test

// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "formats/glb/meshes.h"

#include <algorithm>
#include <cmath>
#include <map>

#include "model/polygon_triangles.h"

namespace jalon::glb {

namespace {

Float3 float3_of(const Vec3& v) {
  return {static_cast<float>(v.x), static_cast<float>(v.y), static_cast<float>(v.z)};
}

class Meshes {
 public:
  Meshes(const Model& model, const Vec3& origin) : model_(model), origin_(origin) {}

  void add_face(const Face& face) {
    Mesh& mesh = of(face.part);
    mesh.sigma_m = std::max(mesh.sigma_m, face.sigma_m);
    mesh.area_m2 += face.area_m2;
    const Vec3 normal = normalized(face.plane.normal);
    std::map<uint32_t, uint32_t> number;  // of the model's vertex in the mesh
    for (const auto& triangle : triangles_of_face(model_, face))
      for (const uint32_t vertex : triangle) {
        const auto [at, is_new] = number.emplace(vertex, static_cast<uint32_t>(mesh.places.size()));
        if (is_new) add_corner(mesh, vertex, normal);
        mesh.corners.push_back(at->second);
      }
    for (uint64_t r = face.first_ring + 1; r < face.first_ring + face.ring_count; ++r)
      if (model_.rings[r].part != kNoPart) add_outline(model_.rings[r]);
  }

  void add_triangle(const std::array<uint32_t, 3>& triangle, uint32_t part) {
    const Vec3& a = model_.vertices[triangle[0]];
    const Vec3 across = cross(model_.vertices[triangle[1]] - a, model_.vertices[triangle[2]] - a);
    if (!(norm(across) > 0)) return;  // a normal has the length 1
    Mesh& mesh = of(part);
    for (const uint32_t vertex : triangle) {
      mesh.corners.push_back(static_cast<uint32_t>(mesh.places.size()));
      add_corner(mesh, vertex, normalized(across));
    }
  }

  std::vector<Mesh> take() {
    std::vector<Mesh> out;
    for (auto& [part, mesh] : meshes_)
      if (!mesh.empty()) out.push_back(std::move(mesh));
    return out;
  }

 private:
  Mesh& of(uint32_t part) {
    Mesh& mesh = meshes_[part < model_.parts.size() ? part : kNoPart];
    mesh.part = part < model_.parts.size() ? part : kNoPart;
    return mesh;
  }
  void add_corner(Mesh& mesh, uint32_t vertex, const Vec3& normal) {
    mesh.places.push_back(float3_of(model_.vertices[vertex] - origin_));
    mesh.normals.push_back(float3_of(normal));
  }
  // The hole that an opening is.
  void add_outline(const Ring& ring) {
    if (ring.count < 3) return;
    Mesh& mesh = of(ring.part);
    const auto first = static_cast<uint32_t>(mesh.outline_places.size());
    const auto count = static_cast<uint32_t>(ring.count);
    for (uint32_t i = 0; i < count; ++i) {
      mesh.outline_places.push_back(
          float3_of(model_.vertices[model_.corners[ring.first + i]] - origin_));
      mesh.outline_ends.push_back(first + i);
      mesh.outline_ends.push_back(first + (i + 1) % count);
    }
  }

  const Model& model_;
  Vec3 origin_;
  std::map<uint32_t, Mesh> meshes_;  // kNoPart comes last
};

}  // namespace

std::vector<Mesh> meshes_of(const Model& model, const Vec3& origin, Task& task) {
  Meshes meshes(model, origin);
  for (size_t f = 0; f < model.faces.size(); ++f) {
    if (f % 64 == 0)
      task.checkpoint(static_cast<double>(f) / static_cast<double>(model.faces.size()));
    meshes.add_face(model.faces[f]);
  }
  const bool by_part = is_mesh_by_part(model);
  size_t count = 0;
  for (const uint32_t t : loose_triangles(model)) {
    if (count++ % 65536 == 0) task.checkpoint(1);
    meshes.add_triangle(model.triangles[t], by_part ? model.triangle_faces[t] : kNoPart);
  }
  return meshes.take();
}

}  // namespace jalon::glb

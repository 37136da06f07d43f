// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "modelling/codes/shared_faces.h"

#include <utility>

#include "model/polygon_triangles.h"

namespace jalon {

uint32_t SharedFaces::part(std::string name, std::string part_class, uint64_t parent,
                           Evidence evidence) {
  Part part{std::move(name), std::move(part_class), parent};
  part.evidence = evidence;
  model_.parts.push_back(std::move(part));
  return static_cast<uint32_t>(model_.parts.size() - 1);
}

void SharedFaces::add_ring(const Corners& corners, uint32_t part) {
  model_.rings.push_back({model_.corners.size(), corners.size(), part});
  for (const Vec3& p : corners) {
    const auto [entry, is_new] =
        vertices_.try_emplace({p.x, p.y, p.z}, static_cast<uint32_t>(model_.vertices.size()));
    if (is_new) model_.vertices.push_back(p + origin_);
    model_.corners.push_back(entry->second);
  }
}

void SharedFaces::add(uint32_t part, uint32_t id, const Corners& outline,
                      const std::vector<Hole>& holes) {
  const Vec3 twice = newell_normal(outline);
  if (outline.size() < 3 || squared_norm(twice) == 0) return;
  Face face;
  face.part = part;
  face.id = id;
  face.plane.normal = normalized(twice);
  face.plane.offset = dot(face.plane.normal, outline.front() + origin_);
  face.area_m2 = norm(twice) / 2;
  face.first_ring = model_.rings.size();
  face.ring_count = 1 + holes.size();
  add_ring(outline, kNoPart);
  for (const Hole& hole : holes) {
    add_ring(hole.corners, hole.part);
    face.area_m2 -= norm(newell_normal(hole.corners)) / 2;
  }
  model_.faces.push_back(face);
}

void SharedFaces::close(uint32_t part, size_t first_face) {
  model_.solids.push_back({part, first_face, model_.faces.size() - first_face});
}

Model SharedFaces::take(SharedText crs) {
  model_.crs = std::move(crs);
  return std::move(model_);
}

}  // namespace jalon

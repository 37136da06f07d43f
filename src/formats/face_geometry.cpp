// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "formats/face_geometry.h"

#include <algorithm>
#include <cmath>

namespace jalon {

namespace {

constexpr double kSliver =
    1e-12;  // area over the square of the extent: below it a face has no plane

std::span<uint32_t> corners_of(Model& model, const Ring& ring) {
  return std::span(model.corners).subspan(ring.first, ring.count);
}

}  // namespace

Vec3 twice_area(const Model& model, std::span<const uint32_t> ring, const Vec3& origin) {
  Vec3 sum;
  for (size_t i = 0; i < ring.size(); ++i)
    sum += cross(model.vertices[ring[i]] - origin,
                 model.vertices[ring[(i + 1) % ring.size()]] - origin);
  return sum;
}

bool measure_face(Model& model, Face& face) {
  const std::span<const uint32_t> outline = corners_of(model, model.rings[face.first_ring]);
  if (outline.size() < 3) return false;
  const Vec3 origin = model.vertices[outline[0]];
  const Vec3 twice = twice_area(model, outline, origin);
  Box3 box;
  Vec3 mean;
  for (const uint32_t v : outline) {
    box.add(model.vertices[v]);
    mean += model.vertices[v] - origin;
  }
  if (!(norm(twice) > kSliver * squared_norm(box.max - box.min))) return false;
  face.plane.normal = normalized(twice);
  face.plane.offset = dot(face.plane.normal, origin + mean / static_cast<double>(outline.size()));
  face.area_m2 = norm(twice) / 2;
  for (uint64_t r = face.first_ring + 1; r < face.first_ring + face.ring_count; ++r) {
    const std::span<uint32_t> hole = corners_of(model, model.rings[r]);
    const double area_m2 = dot(face.plane.normal, twice_area(model, hole, origin)) / 2;
    if (area_m2 > 0) std::ranges::reverse(hole);
    face.area_m2 -= std::abs(area_m2);
  }
  return true;
}

Vec3 whole_metre_corner(const Model& model) {
  Box3 box;
  for (const Vec3& p : model.vertices) box.add(p);
  if (box.empty()) return {};
  return {std::floor(box.min.x), std::floor(box.min.y), std::floor(box.min.z)};
}

}  // namespace jalon

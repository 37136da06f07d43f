// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "report/elevation/face_rings.h"

#include "model/topology.h"

namespace jalon {

bool has_arc(const Model& model, const Ring& ring) {
  for (uint64_t i = 0; i < ring.count; ++i)
    if (model.sagitta(ring.first + i) != 0) return true;
  return false;
}

PlaneFrame frame_of(const Model& model, const Face& face) {
  Vec3 origin;
  if (face.ring_count > 0 && model.rings[face.first_ring].count > 0) {
    const Vec3 p = model.vertices[model.corners[model.rings[face.first_ring].first]];
    origin = {std::floor(p.x), std::floor(p.y), std::floor(p.z)};
  }
  return plane_frame(face.plane, origin, {1, 0, 0});
}

std::vector<Vec2> ring_polygon(const Model& model, const Ring& ring, const PlaneFrame& frame) {
  std::vector<Vec2> out;
  const auto corner = [&](uint64_t i) {
    return frame.project(model.vertices[model.corners[ring.first + i % ring.count]]);
  };
  for (uint64_t i = 0; i < ring.count; ++i)
    append_arc(out, corner(i), corner(i + 1), model.sagitta(ring.first + i), kChordError_m);
  return out;
}

FaceBox ring_box(const Model& model, const FaceRing& at) {
  FaceBox box;
  for (const Vec2& p :
       ring_polygon(model, model.rings[at.ring], frame_of(model, model.faces[at.face])))
    box.add(p);
  return box;
}

}  // namespace jalon

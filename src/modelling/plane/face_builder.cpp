// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "modelling/plane/face_builder.h"

#include "base/error.h"
#include "model/edit.h"

namespace jalon {

Vec3 PlaneVertices::lift(const Vec2& p, double w) const {
  return frame_.origin +
         (frame_.axis_u * p.u + frame_.axis_v * p.v + frame_.normal * (frame_.height + w));
}

uint32_t PlaneVertices::at(const Vec2& p, double w) {
  const auto share = w == 0 ? shares_.find({p.u, p.v}) : shares_.end();
  uint32_t& vertex = share != shares_.end()
                         ? shared_->vertices[share->second]
                         : known_.try_emplace({p.u, p.v, w}, kNoVertex).first->second;
  if (vertex == kNoVertex) {
    if (model_->vertices.size() >= kNoVertex)
      fail(Status::kLimit, "a model holds at most 2^32 - 1 vertices");
    vertex = static_cast<uint32_t>(model_->vertices.size());
    model_->vertices.push_back(share != shares_.end() ? shared_->positions[share->second]
                                                      : lift(p, w));
  }
  return vertex;
}

uint32_t PlaneVertices::find(const Vec2& p, double w) const {
  if (w == 0)
    if (const auto share = shares_.find({p.u, p.v}); share != shares_.end())
      return shared_->vertices[share->second];
  const auto own = known_.find({p.u, p.v, w});
  return own != known_.end() ? own->second : kNoVertex;
}

PartRing part_ring(PlaneVertices& vertices, const VectorRing& ring, double w) {
  PartRing out;
  for (size_t i = 0; i < ring.corners.size(); ++i)
    out.corners.push_back({vertices.at(ring.corners[i], w), ring.edges[i].sagitta_m});
  return out;
}

PartRing turned(const PartRing& ring) {
  PartRing out;
  out.part = ring.part;
  const size_t n = ring.corners.size();
  // Seen from behind and walked the other way an arc bulges to the same side of the walk.
  for (size_t i = 0; i < n; ++i)
    out.corners.push_back(
        {ring.corners[n - 1 - i].vertex, ring.corners[(2 * n - 2 - i) % n].sagitta_m});
  return out;
}

void append_face(Model& model, Face face, const std::vector<PartRing>& rings) {
  face.first_ring = model.rings.size();
  face.ring_count = rings.size();
  face.area_m2 = 0;
  for (const PartRing& ring : rings) {
    model.rings.push_back({model.corners.size(), ring.corners.size(), ring.part});
    for (const RingCorner& corner : ring.corners) {
      model.corners.push_back(corner.vertex);
      model.sagittas.push_back(corner.sagitta_m);
    }
    face.area_m2 += ring_area(model, model.rings.back(), face.plane.normal);
  }
  model.faces.push_back(face);
}

void append_polygon(Model& model, uint32_t part, const std::vector<uint32_t>& corners,
                    const Vec3& normal) {
  Face face;
  face.part = part;
  face.plane = {normal, dot(normal, model.vertices[corners.front()])};
  PartRing ring;
  for (const uint32_t corner : corners) ring.corners.push_back({corner, 0});
  append_face(model, face, {ring});
}

uint32_t append_part(Model& model, std::string name, const char* part_class, uint64_t parent,
                     Evidence evidence) {
  Part part;
  part.name = std::move(name);
  part.part_class = part_class;
  part.parent = parent;
  part.evidence = evidence;
  model.parts.push_back(std::move(part));
  return static_cast<uint32_t>(model.parts.size() - 1);
}

}  // namespace jalon

// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "model/model.h"

#include <iterator>
#include <limits>

#include "base/error.h"
#include "base/numbers.h"

namespace jalon {

namespace {

constexpr std::array<double, 9> kUnknownCovariance{kNaN, kNaN, kNaN, kNaN, kNaN,
                                                   kNaN, kNaN, kNaN, kNaN};

constexpr const char* kEvidenceNames[] = {"none",  "measured", "seen_behind", "revealed",
                                          "shape", "copied",   "derived"};

}  // namespace

const char* name_of(Evidence evidence) {
  const auto i = static_cast<size_t>(evidence);
  return i < std::size(kEvidenceNames) ? kEvidenceNames[i] : kEvidenceNames[0];
}

Evidence evidence_named(std::string_view name) {
  for (size_t i = 0; i < std::size(kEvidenceNames); ++i)
    if (name == kEvidenceNames[i]) return static_cast<Evidence>(i);
  return Evidence::kNone;
}

size_t Model::add_face(Face face, const std::vector<std::vector<Vec3>>& face_rings) {
  face.first_ring = rings.size();
  face.ring_count = face_rings.size();
  for (const auto& ring : face_rings) {
    if (vertices.size() + ring.size() > std::numeric_limits<uint32_t>::max())
      fail(Status::kLimit, "a model holds at most 2^32 vertices");
    rings.push_back({corners.size(), ring.size()});
    for (const Vec3& p : ring) {
      corners.push_back(static_cast<uint32_t>(vertices.size()));
      vertices.push_back(p);
      if (!sagittas.empty()) sagittas.push_back(0);
      if (!vertex_covariances.empty()) vertex_covariances.push_back(kUnknownCovariance);
    }
  }
  faces.push_back(face);
  return faces.size() - 1;
}

void validate(const Model& model) {
  const auto number = [](size_t i) { return static_cast<unsigned long long>(i); };
  for (size_t i = 0; i < model.vertices.size(); ++i)
    if (!is_finite(model.vertices[i]))
      fail(Status::kInvalidArgument, "vertex %llu is not finite", number(i));
  for (size_t i = 0; i < model.corners.size(); ++i)
    if (model.corners[i] >= model.vertices.size())
      fail(Status::kInvalidArgument, "corner %llu names vertex %u of %llu", number(i),
           model.corners[i], number(model.vertices.size()));
  for (size_t i = 0; i < model.triangles.size(); ++i)
    for (const uint32_t v : model.triangles[i])
      if (v >= model.vertices.size())
        fail(Status::kInvalidArgument, "triangle %llu names vertex %u of %llu", number(i), v,
             number(model.vertices.size()));
  for (size_t i = 0; i < model.rings.size(); ++i)
    if (model.rings[i].first > model.corners.size() ||
        model.rings[i].count > model.corners.size() - model.rings[i].first)
      fail(Status::kInvalidArgument, "ring %llu reaches beyond the corners", number(i));
  for (size_t i = 0; i < model.faces.size(); ++i)
    if (model.faces[i].first_ring > model.rings.size() ||
        model.faces[i].ring_count > model.rings.size() - model.faces[i].first_ring)
      fail(Status::kInvalidArgument, "face %llu reaches beyond the rings", number(i));
  if (!model.vertex_covariances.empty() && model.vertex_covariances.size() != model.vertices.size())
    fail(Status::kInvalidArgument, "%llu covariances for %llu vertices",
         number(model.vertex_covariances.size()), number(model.vertices.size()));
  if (!model.sagittas.empty() && model.sagittas.size() != model.corners.size())
    fail(Status::kInvalidArgument, "%llu sagittas for %llu corners", number(model.sagittas.size()),
         number(model.corners.size()));
  for (size_t i = 0; i < model.solids.size(); ++i)
    if (model.solids[i].first_face > model.faces.size() ||
        model.solids[i].face_count > model.faces.size() - model.solids[i].first_face)
      fail(Status::kInvalidArgument, "solid %llu reaches beyond the faces", number(i));
  if (model.triangle_faces.size() != model.triangles.size())
    fail(Status::kInvalidArgument, "%llu face ids for %llu triangles",
         number(model.triangle_faces.size()), number(model.triangles.size()));
}

}  // namespace jalon

// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "modelling/outlines.h"

#include <algorithm>
#include <string>

#include "modelling/edges/join/vectorise.h"
#include "modelling/edges/join/vectorise_rows.h"

namespace jalon {

namespace {

const char* part_class_of(Orientation orientation) {
  switch (orientation) {
    case Orientation::kParallel:
      return "wall";
    case Orientation::kVertical:
      return "vertical";
    case Orientation::kHorizontal:
      return "horizontal";
    case Orientation::kInclined:
      return "inclined";
    case Orientation::kNone:
      break;
  }
  return "plane";
}

void add_ring(const VectorPlane& plane, const VectorRing& ring,
              std::vector<std::vector<Vec3>>& rings, std::vector<double>& sagittas) {
  auto& corners = rings.emplace_back();
  for (const Vec2& p : ring.corners) corners.push_back(plane.frame.lift(p));
  for (const VectorEdge& edge : ring.edges) sagittas.push_back(edge.sagitta_m);
}

void add_faces(Model& model, const Segment& segment, const VectorPlane& plane,
               std::vector<double>& sagittas) {
  const auto part = static_cast<uint32_t>(model.parts.size());
  model.parts.push_back(
      {"plane " + std::to_string(segment.label), part_class_of(segment.orientation), 0});
  for (const VectorFace& drawn : plane.faces) {
    Face face;
    face.part = part;
    face.id = segment.label;
    face.face_class = static_cast<uint8_t>(segment.orientation);
    face.plane = segment.fit.plane;
    face.sigma_m = segment.fit.sigma;
    face.covariance = segment.fit.covariance;
    face.area_m2 = area(drawn);
    std::vector<std::vector<Vec3>> rings;
    add_ring(plane, drawn.outline, rings, sagittas);
    for (const VectorRing& opening : drawn.openings) add_ring(plane, opening, rings, sagittas);
    model.add_face(face, rings);
  }
}

}  // namespace

std::span<const ParamRow> outlines_rows() { return kVectoriseRows; }

Model model_outlines(const Segmentation& segmentation, const VectoriseSetting& setting,
                     Task& task) {
  Model model;
  if (plane_count(segmentation.segments) == 0) return model;
  const auto planes = vectorise(segmentation, setting, task);
  model.crs = segmentation.cloud->crs;
  model.parts.push_back({"facade", "facade", kNoParent});
  std::vector<double> sagittas;
  for (size_t s = 0; s < planes.size(); ++s)
    if (segmentation.segments[s].has_plane())
      add_faces(model, segmentation.segments[s], planes[s], sagittas);
  const auto is_arc = [](double sagitta_m) { return sagitta_m != 0; };
  if (std::any_of(sagittas.begin(), sagittas.end(), is_arc)) model.sagittas = std::move(sagittas);
  return model;
}

}  // namespace jalon

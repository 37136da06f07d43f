// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "capi/support/model_tables.h"

#include <algorithm>

#include "base/numbers.h"
#include "base/table_columns.h"
#include "model/topology.h"

namespace jalon::capi {

namespace {

void put(const Vec3& v, double* out) {
  out[0] = v.x;
  out[1] = v.y;
  out[2] = v.z;
}

}  // namespace

FieldTable vertex_table(const Model& model) {
  FieldTable t;
  add_columns<double, 3>(t, model.vertices, "xyz", "m", "vertex",
                         [](const Vec3& v, double* o) { put(v, o); });
  auto covariance = std::make_shared<Column>(FieldInfo{"covariance", ElementType::kFloat64, 9, "m2",
                                                       "of the vertex, row-major; NaN: not known"},
                                             model.vertices.size());
  const auto out = covariance->values<double>();
  if (model.vertex_covariances.empty()) std::fill(out.begin(), out.end(), kNaN);
  else
    for (size_t i = 0; i < model.vertices.size(); ++i)
      std::copy_n(model.vertex_covariances[i].data(), 9, out.data() + 9 * i);
  t.set(std::move(covariance));
  return t;
}

FieldTable face_table(const Model& model) {
  FieldTable t;
  const auto& rows = model.faces;
  add_column<uint32_t>(t, rows, "part", "", "part of the model",
                       [](const Face& f) { return f.part; });
  add_column<uint64_t>(t, rows, "first_ring", "", "first ring: the outline",
                       [](const Face& f) { return f.first_ring; });
  add_column<uint64_t>(t, rows, "ring_count", "", "outline and openings",
                       [](const Face& f) { return f.ring_count; });
  add_column<uint32_t>(t, rows, "id", "", "e.g. label of the segment",
                       [](const Face& f) { return f.id; });
  add_column<uint8_t>(t, rows, "class", "", "orientation class",
                      [](const Face& f) { return f.face_class; });
  add_columns<double, 3>(t, rows, "normal", "1", "unit normal",
                         [](const Face& f, double* o) { put(f.plane.normal, o); });
  add_column<double>(t, rows, "offset", "m", "normal . p = offset",
                     [](const Face& f) { return f.plane.offset; });
  add_column<double>(t, rows, "area", "m2", "openings taken off",
                     [](const Face& f) { return f.area_m2; });
  add_column<double>(t, rows, "sigma", "m", "standard deviation of the points from the plane",
                     [](const Face& f) { return f.sigma_m; });
  add_columns<double, 16>(
      t, rows, "covariance", "", "of normal and offset, row-major",
      [](const Face& f, double* o) { std::copy(f.covariance.begin(), f.covariance.end(), o); });
  return t;
}

FieldTable ring_table(const Model& model) {
  FieldTable t;
  const auto& rows = model.rings;
  add_column<uint64_t>(t, rows, "first", "", "first ring corner",
                       [](const Ring& r) { return r.first; });
  add_column<uint64_t>(t, rows, "count", "", "ring corners", [](const Ring& r) { return r.count; });
  add_column<uint32_t>(t, rows, "part", "", "opening that fills the hole, or 2^32 - 1",
                       [](const Ring& r) { return r.part; });
  return t;
}

FieldTable corner_table(const Model& model) {
  FieldTable t;
  add_column<uint32_t>(t, model.corners, "vertex", "", "vertex of the corner",
                       [](uint32_t v) { return v; });
  auto sagitta =
      std::make_shared<Column>(FieldInfo{"sagitta", ElementType::kFloat64, 1, "m",
                                         "rise of the arc to the next corner; 0: straight"},
                               model.corners.size());
  const auto out = sagitta->values<double>();
  for (size_t i = 0; i < out.size(); ++i) out[i] = model.sagitta(i);
  t.set(std::move(sagitta));
  return t;
}

FieldTable edge_table(const Model& model) {
  FieldTable t;
  const auto rows = find_edges(model);
  add_column<uint32_t>(t, rows, "from", "", "vertex", [](const Edge& e) { return e.from; });
  add_column<uint32_t>(t, rows, "to", "", "vertex", [](const Edge& e) { return e.to; });
  add_column<double>(t, rows, "sagitta", "m", "rise of the arc; 0: straight",
                     [](const Edge& e) { return e.sagitta_m; });
  add_column<uint32_t>(t, rows, "first_face", "", "face, or 2^32 - 1",
                       [](const Edge& e) { return e.first_face; });
  add_column<uint32_t>(t, rows, "second_face", "", "face, or 2^32 - 1",
                       [](const Edge& e) { return e.second_face; });
  add_column<uint32_t>(t, rows, "uses", "", "ring edges along it",
                       [](const Edge& e) { return e.uses; });
  return t;
}

FieldTable solid_table(const Model& model) {
  FieldTable t;
  const auto& rows = model.solids;
  add_column<uint32_t>(t, rows, "part", "", "part of the model",
                       [](const Solid& s) { return s.part; });
  add_column<uint64_t>(t, rows, "first_face", "", "first of its faces",
                       [](const Solid& s) { return s.first_face; });
  add_column<uint64_t>(t, rows, "face_count", "", "how many",
                       [](const Solid& s) { return s.face_count; });
  return t;
}

FieldTable part_table(const Model& model) {
  FieldTable t;
  const auto& rows = model.parts;
  add_column<uint64_t>(t, rows, "parent", "", "part above, or 2^64 - 1",
                       [](const Part& p) { return p.parent; });
  add_column<double>(t, rows, "width", "m", "of the upright box",
                     [](const Part& p) { return p.width_m; });
  add_column<double>(t, rows, "height", "m", "of the upright box",
                     [](const Part& p) { return p.height_m; });
  add_column<double>(t, rows, "depth", "m", "behind the plane of its wall",
                     [](const Part& p) { return p.depth_m; });
  add_column<uint64_t>(t, rows, "copied_from", "", "part it repeats, or 2^64 - 1",
                       [](const Part& p) { return p.copied_from; });
  add_column<uint8_t>(t, rows, "lod", "", "level of detail",
                      [](const Part& p) { return p.level_of_detail; });
  add_column<uint8_t>(t, rows, "evidence", "", "how it is known",
                      [](const Part& p) { return static_cast<uint8_t>(p.evidence); });
  add_column<double>(t, rows, "class_confidence", "", "probability that the class is right",
                     [](const Part& p) { return p.class_confidence; });
  return t;
}

FieldTable triangle_table(const Model& model) {
  FieldTable t;
  add_columns<uint32_t, 3>(t, model.triangles, "vertices", "", "corners",
                           [](const auto& v, uint32_t* o) { std::copy(v.begin(), v.end(), o); });
  add_column<uint32_t>(t, model.triangle_faces, "face", "", "id of the face",
                       [](uint32_t id) { return id; });
  return t;
}

}  // namespace jalon::capi

// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "capi/model_tables.h"

#include <algorithm>
#include <limits>

#include "model/topology.h"

namespace jalon::capi {

namespace {

// One column: components values a row, put there by fill(row, values of the row).
template <class T, class Rows, class F>
void add_column(FieldTable& table, const Rows& rows, const char* name, uint32_t components, const char* unit,
                const char* meaning, F&& fill) {
  auto column = std::make_shared<Column>(FieldInfo{name, element_type_of<T>(), components, unit, meaning}, rows.size());
  T* out = column->template values<T>().data();
  for (const auto& row : rows) {
    fill(row, out);
    out += components;
  }
  table.set(std::move(column));
}

void put(const Vec3& v, double* out) {
  out[0] = v.x;
  out[1] = v.y;
  out[2] = v.z;
}

}  // namespace

FieldTable vertex_table(const Model& model) {
  FieldTable t;
  add_column<double>(t, model.vertices, "xyz", 3, "m", "vertex", [](const Vec3& v, double* o) { put(v, o); });
  auto covariance = std::make_shared<Column>(
      FieldInfo{"covariance", ElementType::kFloat64, 9, "m2", "of the vertex, row-major; NaN: not known"},
      model.vertices.size());
  const auto out = covariance->values<double>();
  if (model.vertex_covariances.empty())
    std::fill(out.begin(), out.end(), std::numeric_limits<double>::quiet_NaN());
  else
    for (size_t i = 0; i < model.vertices.size(); ++i)
      std::copy_n(model.vertex_covariances[i].data(), 9, out.data() + 9 * i);
  t.set(std::move(covariance));
  return t;
}

FieldTable face_table(const Model& model) {
  FieldTable t;
  const auto& rows = model.faces;
  add_column<uint32_t>(t, rows, "part", 1, "", "part of the model", [](const Face& f, uint32_t* o) { *o = f.part; });
  add_column<uint64_t>(t, rows, "first_ring", 1, "", "first ring: the outline",
                       [](const Face& f, uint64_t* o) { *o = f.first_ring; });
  add_column<uint64_t>(t, rows, "ring_count", 1, "", "outline and openings",
                       [](const Face& f, uint64_t* o) { *o = f.ring_count; });
  add_column<uint32_t>(t, rows, "id", 1, "", "e.g. label of the segment",
                       [](const Face& f, uint32_t* o) { *o = f.id; });
  add_column<uint8_t>(t, rows, "class", 1, "", "orientation class",
                      [](const Face& f, uint8_t* o) { *o = f.face_class; });
  add_column<double>(t, rows, "normal", 3, "1", "unit normal",
                     [](const Face& f, double* o) { put(f.plane.normal, o); });
  add_column<double>(t, rows, "offset", 1, "m", "normal . p = offset",
                     [](const Face& f, double* o) { *o = f.plane.offset; });
  add_column<double>(t, rows, "area", 1, "m2", "openings taken off", [](const Face& f, double* o) { *o = f.area_m2; });
  add_column<double>(t, rows, "sigma", 1, "m", "standard deviation of the points from the plane",
                     [](const Face& f, double* o) { *o = f.sigma_m; });
  add_column<double>(t, rows, "covariance", 16, "", "of normal and offset, row-major",
                     [](const Face& f, double* o) { std::copy(f.covariance.begin(), f.covariance.end(), o); });
  return t;
}

FieldTable ring_table(const Model& model) {
  FieldTable t;
  const auto& rows = model.rings;
  add_column<uint64_t>(t, rows, "first", 1, "", "first ring corner", [](const Ring& r, uint64_t* o) { *o = r.first; });
  add_column<uint64_t>(t, rows, "count", 1, "", "ring corners", [](const Ring& r, uint64_t* o) { *o = r.count; });
  add_column<uint32_t>(t, rows, "part", 1, "", "opening that fills the hole, or 2^32 - 1",
                       [](const Ring& r, uint32_t* o) { *o = r.part; });
  return t;
}

FieldTable corner_table(const Model& model) {
  FieldTable t;
  add_column<uint32_t>(t, model.corners, "vertex", 1, "", "vertex of the corner",
                       [](uint32_t v, uint32_t* o) { *o = v; });
  auto sagitta = std::make_shared<Column>(
      FieldInfo{"sagitta", ElementType::kFloat64, 1, "m", "rise of the arc to the next corner; 0: straight"},
      model.corners.size());
  const auto out = sagitta->values<double>();
  for (size_t i = 0; i < out.size(); ++i) out[i] = model.sagitta(i);
  t.set(std::move(sagitta));
  return t;
}

FieldTable edge_table(const Model& model) {
  FieldTable t;
  const auto rows = find_edges(model);
  add_column<uint32_t>(t, rows, "from", 1, "", "vertex", [](const Edge& e, uint32_t* o) { *o = e.from; });
  add_column<uint32_t>(t, rows, "to", 1, "", "vertex", [](const Edge& e, uint32_t* o) { *o = e.to; });
  add_column<double>(t, rows, "sagitta", 1, "m", "rise of the arc; 0: straight",
                     [](const Edge& e, double* o) { *o = e.sagitta_m; });
  add_column<uint32_t>(t, rows, "first_face", 1, "", "face, or 2^32 - 1",
                       [](const Edge& e, uint32_t* o) { *o = e.first_face; });
  add_column<uint32_t>(t, rows, "second_face", 1, "", "face, or 2^32 - 1",
                       [](const Edge& e, uint32_t* o) { *o = e.second_face; });
  add_column<uint32_t>(t, rows, "uses", 1, "", "ring edges along it", [](const Edge& e, uint32_t* o) { *o = e.uses; });
  return t;
}

FieldTable solid_table(const Model& model) {
  FieldTable t;
  const auto& rows = model.solids;
  add_column<uint32_t>(t, rows, "part", 1, "", "part of the model", [](const Solid& s, uint32_t* o) { *o = s.part; });
  add_column<uint64_t>(t, rows, "first_face", 1, "", "first of its faces",
                       [](const Solid& s, uint64_t* o) { *o = s.first_face; });
  add_column<uint64_t>(t, rows, "face_count", 1, "", "how many",
                       [](const Solid& s, uint64_t* o) { *o = s.face_count; });
  return t;
}

FieldTable part_table(const Model& model) {
  FieldTable t;
  const auto& rows = model.parts;
  add_column<uint64_t>(t, rows, "parent", 1, "", "part above, or 2^64 - 1",
                       [](const Part& p, uint64_t* o) { *o = p.parent; });
  add_column<double>(t, rows, "width", 1, "m", "of the upright box", [](const Part& p, double* o) { *o = p.width_m; });
  add_column<double>(t, rows, "height", 1, "m", "of the upright box",
                     [](const Part& p, double* o) { *o = p.height_m; });
  add_column<double>(t, rows, "depth", 1, "m", "behind the plane of its wall",
                     [](const Part& p, double* o) { *o = p.depth_m; });
  add_column<uint64_t>(t, rows, "copied_from", 1, "", "part it repeats, or 2^64 - 1",
                       [](const Part& p, uint64_t* o) { *o = p.copied_from; });
  add_column<uint8_t>(t, rows, "lod", 1, "", "level of detail",
                      [](const Part& p, uint8_t* o) { *o = p.level_of_detail; });
  add_column<uint8_t>(t, rows, "evidence", 1, "", "how it is known",
                      [](const Part& p, uint8_t* o) { *o = static_cast<uint8_t>(p.evidence); });
  return t;
}

FieldTable triangle_table(const Model& model) {
  FieldTable t;
  add_column<uint32_t>(t, model.triangles, "vertices", 3, "", "corners",
                       [](const auto& v, uint32_t* o) { std::copy(v.begin(), v.end(), o); });
  add_column<uint32_t>(t, model.triangle_faces, "face", 1, "", "id of the face",
                       [](uint32_t id, uint32_t* o) { *o = id; });
  return t;
}

}  // namespace jalon::capi

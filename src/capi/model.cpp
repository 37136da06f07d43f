// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "jalon/model.h"

#include <limits>

#include "capi/guard.h"
#include "capi/model_handles.h"

using namespace jalon;
using namespace jalon::capi;

namespace jalon::capi {

jalon_model* new_model(Model model) {
  auto handle = std::make_unique<jalon_model>();
  handle->model = std::make_shared<const Model>(std::move(model));
  return handle.release();
}

namespace {

constexpr uint64_t kMaxElements = std::numeric_limits<uint32_t>::max();  // indices are uint32

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

const Model& model_of(const jalon_model* model) {
  require(model, "model");
  return *model->model;
}

}  // namespace
}  // namespace jalon::capi

jalon_status jalon_model_create_mesh(const void* vertices, int32_t type, uint64_t count_vertices, uint64_t stride_bytes,
                                     const uint32_t* triangles, uint64_t count_triangles, const uint32_t* face_ids,
                                     jalon_model** out) {
  return guard([&] {
    require(out, "out");
    const size_t stride = require_array(vertices, type, count_vertices, 3, stride_bytes, "vertices");
    require_array(triangles, JALON_UINT32, count_triangles, 3, 0, "triangles");
    if (count_vertices > kMaxElements || count_triangles > kMaxElements)
      fail(Status::kLimit, "a model holds at most 2^32 - 1 vertices and triangles");
    Column xyz({"xyz", ElementType::kFloat64, 3, "m", ""}, count_vertices);
    store_converted(xyz, 0, vertices, require_type(type), count_vertices, stride);
    Model model;
    const auto values = xyz.values<double>();
    model.vertices.reserve(count_vertices);
    for (size_t i = 0; i < count_vertices; ++i)
      model.vertices.push_back({values[3 * i], values[3 * i + 1], values[3 * i + 2]});
    model.triangles.reserve(count_triangles);
    model.triangle_faces.reserve(count_triangles);
    for (size_t i = 0; i < count_triangles; ++i) {
      model.triangles.push_back({triangles[3 * i], triangles[3 * i + 1], triangles[3 * i + 2]});
      model.triangle_faces.push_back(face_ids != nullptr ? face_ids[i] : static_cast<uint32_t>(i));
    }
    model.parts.push_back({"mesh", "mesh", kNoParent});
    validate(model);
    *out = new_model(std::move(model));
  });
}

jalon_model* jalon_model_retain(jalon_model* model) { return retain(model); }
void jalon_model_release(jalon_model* model) { release(model); }

jalon_status jalon_model_vertices(const jalon_model* model, jalon_fields** out) {
  return guard([&] {
    const Model& m = model_of(model);
    require(out, "out");
    FieldTable table;
    add_column<double>(table, m.vertices, "xyz", 3, "m", "vertex", [](const Vec3& v, double* o) { put(v, o); });
    *out = new_fields(std::move(table));
  });
}

jalon_status jalon_model_faces(const jalon_model* model, jalon_fields** out) {
  return guard([&] {
    const Model& m = model_of(model);
    require(out, "out");
    *out = new_fields(face_table(m));
  });
}

jalon_status jalon_model_rings(const jalon_model* model, jalon_fields** out) {
  return guard([&] {
    const Model& m = model_of(model);
    require(out, "out");
    FieldTable table;
    add_column<uint64_t>(table, m.rings, "first", 1, "", "first ring corner",
                         [](const Ring& r, uint64_t* o) { *o = r.first; });
    add_column<uint64_t>(table, m.rings, "count", 1, "", "ring corners",
                         [](const Ring& r, uint64_t* o) { *o = r.count; });
    *out = new_fields(std::move(table));
  });
}

jalon_status jalon_model_corners(const jalon_model* model, jalon_fields** out) {
  return guard([&] {
    const Model& m = model_of(model);
    require(out, "out");
    FieldTable table;
    add_column<uint32_t>(table, m.corners, "vertex", 1, "", "vertex of the corner",
                         [](uint32_t v, uint32_t* o) { *o = v; });
    *out = new_fields(std::move(table));
  });
}

jalon_status jalon_model_triangles(const jalon_model* model, jalon_fields** out) {
  return guard([&] {
    const Model& m = model_of(model);
    require(out, "out");
    FieldTable table;
    add_column<uint32_t>(table, m.triangles, "vertices", 3, "", "corners",
                         [](const auto& t, uint32_t* o) { std::copy(t.begin(), t.end(), o); });
    add_column<uint32_t>(table, m.triangle_faces, "face", 1, "", "id of the face",
                         [](uint32_t id, uint32_t* o) { *o = id; });
    *out = new_fields(std::move(table));
  });
}

jalon_status jalon_model_part_count(const jalon_model* model, uint64_t* out) {
  return guard([&] {
    const Model& m = model_of(model);
    require(out, "out");
    *out = m.parts.size();
  });
}

jalon_status jalon_model_part(const jalon_model* model, uint64_t i, const char** name, const char** part_class,
                              uint64_t* parent) {
  return guard([&] {
    const Model& m = model_of(model);
    if (i >= m.parts.size()) fail(Status::kInvalidArgument, "there are %zu parts", m.parts.size());
    const Part& part = m.parts[i];
    if (name != nullptr) *name = part.name.c_str();
    if (part_class != nullptr) *part_class = part.part_class.c_str();
    if (parent != nullptr) *parent = part.parent;
  });
}

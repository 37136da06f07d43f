// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "jalon/model.h"

#include <limits>

#include "capi/support/guard.h"
#include "capi/support/model_handles.h"
#include "capi/support/model_tables.h"
#include "model/edit.h"
#include "model/relations/relations.h"

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

// What the table functions do alike.
void give_table(const jalon_model* model, jalon_fields** out, FieldTable (*table)(const Model&)) {
  require(model, "model");
  require(out, "out");
  *out = new_fields(table(*model->model));
}

const Model& model_of(const jalon_model* model) {
  require(model, "model");
  return *model->model;
}

}  // namespace
}  // namespace jalon::capi

jalon_status jalon_model_create_mesh(const void* vertices, int32_t type, uint64_t count_vertices,
                                     uint64_t stride_bytes, const uint32_t* triangles,
                                     uint64_t count_triangles, const uint32_t* face_ids,
                                     jalon_model** out) {
  return guard([&] {
    require(out, "out");
    const size_t stride =
        require_array(vertices, type, count_vertices, 3, stride_bytes, "vertices");
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
  return guard([&] { give_table(model, out, vertex_table); });
}

jalon_status jalon_model_faces(const jalon_model* model, jalon_fields** out) {
  return guard([&] { give_table(model, out, face_table); });
}

jalon_status jalon_model_rings(const jalon_model* model, jalon_fields** out) {
  return guard([&] { give_table(model, out, ring_table); });
}

jalon_status jalon_model_corners(const jalon_model* model, jalon_fields** out) {
  return guard([&] { give_table(model, out, corner_table); });
}

jalon_status jalon_model_edges(const jalon_model* model, jalon_fields** out) {
  return guard([&] { give_table(model, out, edge_table); });
}

jalon_status jalon_model_solids(const jalon_model* model, jalon_fields** out) {
  return guard([&] { give_table(model, out, solid_table); });
}

jalon_status jalon_model_parts(const jalon_model* model, jalon_fields** out) {
  return guard([&] { give_table(model, out, part_table); });
}

jalon_status jalon_model_triangles(const jalon_model* model, jalon_fields** out) {
  return guard([&] { give_table(model, out, triangle_table); });
}

jalon_status jalon_model_relations(const jalon_model* model, const jalon_params* options,
                                   jalon_task* task, jalon_fields** out) {
  return guard([&] {
    const Model& m = model_of(model);
    require(out, "out");
    const auto chosen = settings_from<RelationSettings>(options_or_default(options, "relations"));
    *out = new_fields(
        with_task(task, [&](Task& t) { return relation_table(find_relations(m, chosen, t)); }));
  });
}

jalon_status jalon_model_crs(const jalon_model* model, const char** out) {
  return guard([&] {
    const Model& m = model_of(model);
    require(out, "out");
    *out = m.crs.c_str();
  });
}

jalon_status jalon_model_part_count(const jalon_model* model, uint64_t* out) {
  return guard([&] {
    const Model& m = model_of(model);
    require(out, "out");
    *out = m.parts.size();
  });
}

jalon_status jalon_model_part(const jalon_model* model, uint64_t i, const char** name,
                              const char** part_class, uint64_t* parent) {
  return guard([&] {
    const Model& m = model_of(model);
    if (i >= m.parts.size()) fail(Status::kInvalidArgument, "there are %zu parts", m.parts.size());
    const Part& part = m.parts[i];
    if (name != nullptr) *name = part.name.c_str();
    if (part_class != nullptr) *part_class = part.part_class.c_str();
    if (parent != nullptr) *parent = part.parent;
  });
}

jalon_status jalon_model_rename_part(const jalon_model* model, uint64_t i, const char* name,
                                     const char* part_class, jalon_model** out) {
  return guard([&] {
    const Model& m = model_of(model);
    require(out, "out");
    if (i >= m.parts.size()) fail(Status::kInvalidArgument, "there are %zu parts", m.parts.size());
    std::string new_name = name != nullptr ? require_text(name, "name") : m.parts[i].name;
    std::string new_class =
        part_class != nullptr ? require_text(part_class, "part_class") : m.parts[i].part_class;
    *out = new_model(with_renamed_part(m, i, std::move(new_name), std::move(new_class)));
  });
}

jalon_status jalon_model_remove_copy(const jalon_model* model, uint64_t i, jalon_model** out) {
  return guard([&] {
    const Model& m = model_of(model);
    require(out, "out");
    *out = new_model(without_copy(m, i));
  });
}

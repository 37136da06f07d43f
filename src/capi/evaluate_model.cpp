// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "capi/support/evaluation_handles.h"
#include "capi/support/guard.h"
#include "capi/support/model_handles.h"
#include "jalon/evaluate.h"
#include "geometry/polygon2.h"
#include "geometry/polygon_sets.h"
#include "modelling/evaluation/model_evaluation.h"

using namespace jalon;
using namespace jalon::capi;

namespace {

void give_table(const jalon_model_evaluation* evaluation, jalon_fields** out,
                FieldTable (*table)(const ModelEvaluation&)) {
  require(evaluation, "evaluation");
  require(out, "out");
  *out = new_fields(table(evaluation->evaluation));
}

constexpr uint64_t kMostCorners = uint64_t{1} << 32;

FieldTable vertices_of(const ModelEvaluation& evaluation) {
  return vertex_pair_table(evaluation.vertices);
}

IndexFormulas formulas_of(const jalon_params* options) {
  return settings_from<IndexSettings>(options_or_default(options, "indices")).formulas;
}

void require_either(jalon_fields** rows, jalon_fields** totals) {
  if (rows == nullptr && totals == nullptr)
    fail(Status::kInvalidArgument, "rows and totals are both NULL");
}

// Hands out the tables that are wanted, both or none.
void give_both(jalon_fields** rows, jalon_fields** totals, FieldTable row_table,
               FieldTable total_table) {
  Owned<jalon_fields> first = own(new_fields(std::move(row_table))),
                      second = own(new_fields(std::move(total_table)));
  if (rows != nullptr) *rows = first.release();
  if (totals != nullptr) *totals = second.release();
}

// Rings by their sense: the union of the anticlockwise ones but the clockwise ones.
std::vector<PolygonWithHoles> region_of(const double* uv, const uint64_t* rings, uint64_t count,
                                        const char* name) {
  if (count > 0) require(uv, name);
  require_array(rings, JALON_UINT64, count, 1, 0, name);
  uint64_t corners = 0;
  for (uint64_t i = 0; i < count; ++i) {
    if (rings[i] > kMostCorners - corners)
      fail(Status::kLimit, "%s: more than %llu corners", name,
           static_cast<unsigned long long>(kMostCorners));
    corners += rings[i];
  }
  require_array(uv, JALON_FLOAT64, corners, 2, 0, name);
  std::vector<PolygonWithHoles> outlines, holes;
  for (uint64_t i = 0, at = 0; i < count; ++i) {
    std::vector<Vec2> ring;
    for (uint64_t k = 0; k < rings[i]; ++k, ++at) {
      ring.push_back({uv[2 * at], uv[2 * at + 1]});
      if (!std::isfinite(ring.back().u) || !std::isfinite(ring.back().v))
        fail(Status::kInvalidArgument, "%s: corner %llu is not finite", name,
             static_cast<unsigned long long>(at));
    }
    (signed_area(ring) < 0 ? holes : outlines).push_back({std::move(ring), {}});
  }
  return combined(SetOperation::kDifference, outlines, holes);
}

std::vector<Vec3> points_of(const double* xyz, uint64_t count, const char* name) {
  require_array(xyz, JALON_FLOAT64, count, 3, 0, name);
  std::vector<Vec3> out;
  for (uint64_t i = 0; i < count; ++i) {
    out.push_back({xyz[3 * i], xyz[3 * i + 1], xyz[3 * i + 2]});
    if (!is_finite(out.back()))
      fail(Status::kInvalidArgument, "%s: vertex %llu is not finite", name,
           static_cast<unsigned long long>(i));
  }
  return out;
}

}  // namespace

jalon_status jalon_model_evaluate(const jalon_model* model, const jalon_model* reference,
                                  const jalon_params* options, jalon_task* task,
                                  jalon_model_evaluation** out) {
  return guard([&] {
    require(model, "model");
    require(reference, "reference");
    require(out, "out");
    const auto settings =
        settings_from<ModelEvaluationSettings>(options_or_default(options, "model_evaluation"));
    auto handle = std::make_unique<jalon_model_evaluation>();
    with_task(task, [&](Task& t) {
      handle->evaluation = evaluate_model(*model->model, *reference->model, settings, t);
    });
    *out = handle.release();
  });
}

jalon_model_evaluation* jalon_model_evaluation_retain(jalon_model_evaluation* evaluation) {
  return retain(evaluation);
}
void jalon_model_evaluation_release(jalon_model_evaluation* evaluation) { release(evaluation); }

jalon_status jalon_model_evaluation_pairs(const jalon_model_evaluation* evaluation,
                                          jalon_fields** out) {
  return guard([&] { give_table(evaluation, out, face_pair_table); });
}

jalon_status jalon_model_evaluation_automatic(const jalon_model_evaluation* evaluation,
                                              jalon_fields** out) {
  return guard([&] { give_table(evaluation, out, automatic_face_table); });
}

jalon_status jalon_model_evaluation_reference(const jalon_model_evaluation* evaluation,
                                              jalon_fields** out) {
  return guard([&] { give_table(evaluation, out, reference_face_table); });
}

jalon_status jalon_model_evaluation_vertices(const jalon_model_evaluation* evaluation,
                                             jalon_fields** out) {
  return guard([&] { give_table(evaluation, out, vertices_of); });
}

jalon_status jalon_model_evaluation_totals(const jalon_model_evaluation* evaluation,
                                           jalon_fields** out) {
  return guard([&] { give_table(evaluation, out, model_totals_table); });
}

jalon_status jalon_area_indices(const double* automatic_m2, const double* reference_m2,
                                const double* intersection_m2, uint64_t count,
                                const jalon_params* options, jalon_fields** rows,
                                jalon_fields** totals) {
  return guard([&] {
    require_either(rows, totals);
    require_array(automatic_m2, JALON_FLOAT64, count, 1, 0, "automatic_m2");
    require_array(reference_m2, JALON_FLOAT64, count, 1, 0, "reference_m2");
    require_array(intersection_m2, JALON_FLOAT64, count, 1, 0, "intersection_m2");
    const IndexFormulas formulas = formulas_of(options);
    std::vector<ComparedAreas> areas;
    for (uint64_t i = 0; i < count; ++i)
      areas.push_back({automatic_m2[i], reference_m2[i], intersection_m2[i]});
    require_areas(areas);
    give_both(rows, totals, index_table(areas, formulas), index_totals_table(areas, {}, formulas));
  });
}

jalon_status jalon_polygon_indices(const double* automatic_uv, const uint64_t* automatic_rings,
                                   uint64_t automatic_ring_count, const double* reference_uv,
                                   const uint64_t* reference_rings, uint64_t reference_ring_count,
                                   const jalon_params* options, jalon_fields** out) {
  return guard([&] {
    require(out, "out");
    const IndexFormulas formulas = formulas_of(options);
    const auto a = region_of(automatic_uv, automatic_rings, automatic_ring_count, "automatic"),
               r = region_of(reference_uv, reference_rings, reference_ring_count, "reference");
    const SharedArea shared = shared_area(a, r);
    const ComparedAreas row[] = {{shared.a, shared.b, shared.both}};
    *out = new_fields(index_table(row, formulas));
  });
}

jalon_status jalon_vertex_deviations(const double* automatic_xyz, const double* reference_xyz,
                                     uint64_t count, jalon_fields** rows, jalon_fields** totals) {
  return guard([&] {
    require_either(rows, totals);
    const std::vector<Vec3> a = points_of(automatic_xyz, count, "automatic_xyz"),
                            r = points_of(reference_xyz, count, "reference_xyz");
    std::vector<VertexPair> pairs;
    for (size_t i = 0; i < a.size(); ++i)
      pairs.push_back({static_cast<uint32_t>(i), static_cast<uint32_t>(i), a[i] - r[i]});
    FieldTable sums;
    add_vertex_totals(sums, pairs);
    give_both(rows, totals, vertex_pair_table(pairs), std::move(sums));
  });
}

/* SPDX-FileCopyrightText: 2026 The Jalon authors
 * SPDX-License-Identifier: Apache-2.0 */
/* The long operations on two clouds, in the shape of operations.h: the cloud against a copy of itself that was moved a
 * little, or in which a part of the facade came forward. */
#ifndef JALON_TEST_OPERATIONS_COMPARE_H
#define JALON_TEST_OPERATIONS_COMPARE_H

#include "support.h"

#include <math.h>

/* Moved by a little that no grid of the tests rounds. */
static inline jalon_status moved_copy(const jalon_cloud* cloud, jalon_cloud** out) {
  const jalon_transform move = {{1, 0, 0, 0x1p-7, 0, 1, 0, -0x1p-8, 0, 0, 1, 0x1p-7}};
  return jalon_cloud_transform(cloud, &move, NULL, out);
}

/* The cloud's first point in whole metres: what stands still beside a cloud moves with it by whole metres. */
static inline jalon_status whole_metres(const jalon_cloud* cloud, double* east_m, double* north_m) {
  jalon_array_view xyz;
  const jalon_status status = jalon_cloud_points(cloud, &xyz);
  if (status != JALON_OK) return status;
  *east_m = floor(((const double*)xyz.data)[0]);
  *north_m = floor(((const double*)xyz.data)[1]);
  return status;
}

/* 2 m x 2 m of the facade, in which the first point lies or below or above it, came 0.25 m forward. */
static inline jalon_status changed_copy(const jalon_cloud* cloud, jalon_cloud** out) {
  jalon_array_view xyz;
  double east_m = 0, north_m = 0;
  jalon_status status = whole_metres(cloud, &east_m, &north_m);
  if (status == JALON_OK) status = jalon_cloud_points(cloud, &xyz);
  if (status != JALON_OK) return status;
  double* own = malloc((size_t)xyz.count * 24 + 24);
  if (own == NULL) return JALON_ERROR_OUT_OF_MEMORY;
  for (uint64_t i = 0; i < xyz.count; ++i) {
    double* p = own + 3 * i;
    memcpy(p, (const char*)xyz.data + i * xyz.stride_bytes, 24);
    if (fabs(p[0] - east_m) < 1 && p[2] > 4 && p[2] < 6) p[1] -= 0.25;
  }
  status = jalon_cloud_create(own, JALON_FLOAT64, xyz.count, 0, 0, out);
  free(own);
  return status;
}

static inline jalon_status compare_by(const char* method, const char* json,
                                      const jalon_cloud* reference, const jalon_cloud* compared,
                                      jalon_task* task, jalon_comparison** out) {
  jalon_comparer* comparer = NULL;
  jalon_params* params = NULL;
  jalon_status status = jalon_comparer_create(method, &comparer);
  if (status == JALON_OK) status = jalon_comparer_params(comparer, &params);
  if (status == JALON_OK) status = jalon_params_from_json(params, json);
  if (status == JALON_OK) status = jalon_comparer_run(comparer, reference, compared, task, out);
  jalon_params_release(params);
  jalon_comparer_release(comparer);
  return status;
}

static inline jalon_status op_compare(const char* method, const char* json,
                                      const jalon_cloud* cloud, jalon_task* task, made* out) {
  jalon_cloud* moved = NULL;
  jalon_comparison* comparison = NULL;
  jalon_status status = moved_copy(cloud, &moved);
  if (status == JALON_OK) status = compare_by(method, json, cloud, moved, task, &comparison);
  if (status == JALON_OK) status = jalon_comparison_cloud(comparison, &out->cloud);
  jalon_comparison_release(comparison);
  jalon_cloud_release(moved);
  return status;
}
static inline jalon_status op_m3c2(const jalon_cloud* cloud, jalon_task* task, made* out) {
  return op_compare("m3c2", "{\"core_spacing_m\": 0.1}", cloud, task, out);
}
static inline jalon_status op_landslide(const jalon_cloud* cloud, jalon_task* task, made* out) {
  return op_compare("landslide", "{\"direction\": [0, -1, 0], \"cell_m\": 0.5, \"min_points\": 3}",
                    cloud, task, out);
}
static inline jalon_status op_distance(const jalon_cloud* cloud, jalon_task* task, made* out) {
  return op_compare("distance", "{\"local_model\": \"plane\", \"differences\": true}", cloud, task,
                    out);
}

/* From an upright plane along the facade and a level one below it. */
static inline jalon_status op_model_distance(const jalon_cloud* cloud, jalon_task* task,
                                             made* out) {
  double corners[18] = {-20, 0, 0, 20, 0, 0, 20, 0, 10, -20, 0, 10, 20, -10, 0, -20, -10, 0};
  double east_m = 0, north_m = 0;
  jalon_status status = whole_metres(cloud, &east_m, &north_m);
  for (int i = 0; i < 6; ++i) corners[3 * i] += east_m, corners[3 * i + 1] += north_m;
  const uint32_t triangles[12] = {0, 1, 2, 0, 2, 3, 0, 5, 4, 0, 4, 1};
  jalon_model* mesh = NULL;
  jalon_comparer* comparer = NULL;
  jalon_comparison* comparison = NULL;
  if (status == JALON_OK)
    status = jalon_model_create_mesh(corners, JALON_FLOAT64, 6, 0, triangles, 4, NULL, &mesh);
  if (status == JALON_OK) status = jalon_comparer_create("distance", &comparer);
  if (status == JALON_OK)
    status = jalon_comparer_run_model(comparer, mesh, cloud, task, &comparison);
  if (status == JALON_OK) status = jalon_comparison_cloud(comparison, &out->cloud);
  jalon_comparison_release(comparison);
  jalon_comparer_release(comparer);
  jalon_model_release(mesh);
  return status;
}

/* Both directions, for what is made of them. Made once for a cloud, which they keep, so that a cancel meets the call
 * under test. */
struct both_ways {
  jalon_cloud *of, *changed;
  jalon_comparison *forward, *reverse;
  jalon_fields *forward_points, *reverse_points, *changes;
};
static const char* const kChanges = "{\"criterion\": \"threshold\", \"threshold_m\": 0.08}";
static inline jalon_status options_from(const char* operation, const char* json,
                                        jalon_params** out) {
  jalon_status status = jalon_params_create(operation, out);
  if (status == JALON_OK) status = jalon_params_from_json(*out, json);
  return status;
}
static inline void release_both(struct both_ways* both) {
  jalon_fields_release(both->forward_points), jalon_fields_release(both->reverse_points);
  jalon_fields_release(both->changes);
  jalon_comparison_release(both->forward), jalon_comparison_release(both->reverse);
  jalon_cloud_release(both->changed), jalon_cloud_release(both->of);
  memset(both, 0, sizeof *both);
}
static inline jalon_status diagnose(const struct both_ways* both, jalon_task* task,
                                    jalon_fields** forward, jalon_fields** reverse,
                                    jalon_fields** changes) {
  jalon_params* options = NULL;
  jalon_status status = options_from("diagnosis", kChanges, &options);
  if (status == JALON_OK)
    status = jalon_comparison_diagnose(both->forward, both->reverse, options, task, forward,
                                       reverse, changes);
  jalon_params_release(options);
  return status;
}
/* One for the process, unless a thread brings its own. */
static struct both_ways kept_both_ways;
static __thread struct both_ways* own_both_ways;
static inline void forget_both_ways(void) {
  release_both(own_both_ways != NULL ? own_both_ways : &kept_both_ways);
}
static inline jalon_status compare_both_ways(const jalon_cloud* cloud,
                                             const struct both_ways** out) {
  struct both_ways* both = own_both_ways != NULL ? own_both_ways : &kept_both_ways;
  *out = both;
  if (both->changes != NULL && both->of == cloud) return JALON_OK;
  release_both(both);
  both->of = jalon_cloud_retain((jalon_cloud*)cloud);
  jalon_status status = changed_copy(cloud, &both->changed);
  if (status == JALON_OK)
    status = compare_by("distance", "{}", cloud, both->changed, NULL, &both->forward);
  if (status == JALON_OK)
    status = compare_by("distance", "{}", both->changed, cloud, NULL, &both->reverse);
  if (status == JALON_OK)
    status = diagnose(both, NULL, &both->forward_points, &both->reverse_points, &both->changes);
  return status;
}
/* What is asked of one comparison, whatever made it. */
static inline jalon_status regions_of(const struct both_ways* both, jalon_task* task, made* out) {
  jalon_params* options = NULL;
  jalon_status status = options_from("regions", kChanges, &options);
  if (status == JALON_OK)
    status = jalon_comparison_regions(both->forward, options, task, NULL, &out->fields);
  jalon_params_release(options);
  return status;
}
/* The vertices of the outlines are the result. */
static inline jalon_status outlines_of(const struct both_ways* both, jalon_task* task, made* out) {
  jalon_model* model = NULL;
  jalon_status status =
      jalon_comparison_outlines(both->forward, both->forward_points, both->reverse,
                                both->reverse_points, both->changes, NULL, task, &model);
  if (status == JALON_OK) status = jalon_model_vertices(model, &out->fields);
  jalon_model_release(model);
  return status;
}
static inline jalon_status op_regions(const jalon_cloud* cloud, jalon_task* task, made* out) {
  const struct both_ways* both;
  const jalon_status status = compare_both_ways(cloud, &both);
  return status == JALON_OK ? regions_of(both, task, out) : status;
}
static inline jalon_status op_diagnose(const jalon_cloud* cloud, jalon_task* task, made* out) {
  const struct both_ways* both;
  const jalon_status status = compare_both_ways(cloud, &both);
  return status == JALON_OK ? diagnose(both, task, NULL, NULL, &out->fields) : status;
}
static inline jalon_status op_change_outlines(const jalon_cloud* cloud, jalon_task* task,
                                              made* out) {
  const struct both_ways* both;
  const jalon_status status = compare_both_ways(cloud, &both);
  return status == JALON_OK ? outlines_of(both, task, out) : status;
}

static inline jalon_status op_visibility(const jalon_cloud* cloud, jalon_task* task, made* out) {
  double east_m = 0, north_m = 0;
  jalon_status status = whole_metres(cloud, &east_m, &north_m);
  const jalon_transform pose = {{1, 0, 0, east_m, 0, 1, 0, north_m - 12, 0, 0, 1, 1.5}};
  jalon_cloud *reference = NULL, *compared = NULL;
  if (status == JALON_OK) status = own_handle(cloud, &reference);
  if (status == JALON_OK) status = jalon_cloud_set_station(reference, "tripod", &pose);
  if (status == JALON_OK) status = changed_copy(cloud, &compared);
  if (status == JALON_OK) status = jalon_cloud_compute_visibility(compared, reference, NULL, task);
  jalon_cloud_release(reference);
  if (status == JALON_OK) out->cloud = compared;
  else jalon_cloud_release(compared);
  return status;
}

static inline jalon_status op_volume(const jalon_cloud* cloud, jalon_task* task, made* out) {
  jalon_cloud* changed = NULL;
  jalon_status status = changed_copy(cloud, &changed);
  if (status == JALON_OK)
    status = jalon_cloud_volume(cloud, changed, NULL, task, &out->fields, NULL);
  jalon_cloud_release(changed);
  return status;
}

static inline jalon_status op_sections(const jalon_cloud* cloud, jalon_task* task, made* out) {
  jalon_params* options = NULL;
  jalon_sections* sections = NULL;
  jalon_status status = jalon_params_create("sections", &options);
  if (status == JALON_OK) status = jalon_params_set_double(options, "step_m", 0.25);
  if (status == JALON_OK) status = jalon_cloud_sections(cloud, NULL, 0, options, task, &sections);
  jalon_params_release(options);
  if (status == JALON_OK) status = jalon_sections_vertices(sections, &out->fields);
  jalon_sections_release(sections);
  return status;
}

static inline jalon_status register_by(const char* method, const jalon_cloud* cloud,
                                       jalon_task* task, made* out) {
  jalon_cloud* moved = NULL;
  jalon_registrar* registrar = NULL;
  jalon_registration* registration = NULL;
  jalon_status status = moved_copy(cloud, &moved);
  if (status == JALON_OK) status = jalon_registrar_create(method, &registrar);
  if (status == JALON_OK)
    status = jalon_registrar_run(registrar, cloud, moved, NULL, task, &registration);
  if (status == JALON_OK) status = jalon_registration_summary(registration, &out->fields);
  jalon_registration_release(registration);
  jalon_registrar_release(registrar);
  jalon_cloud_release(moved);
  return status;
}
static inline jalon_status op_icp(const jalon_cloud* cloud, jalon_task* task, made* out) {
  return register_by("icp", cloud, task, out);
}
static inline jalon_status op_automatic(const jalon_cloud* cloud, jalon_task* task, made* out) {
  return register_by("automatic", cloud, task, out);
}

#endif

/* SPDX-FileCopyrightText: 2026 The Jalon authors
 * SPDX-License-Identifier: Apache-2.0 */
/* Operations on two clouds, on segmentations and on models whose corners are a cloud's points, that the tests' tables
 * do not have, in their shape. */
#ifndef JALON_BENCH_HOSTILE_PAIRS_H
#define JALON_BENCH_HOSTILE_PAIRS_H

#include "../capi/operations.h"

/* ---- comparisons ---- */

#define JALON_BENCH_COMPARE(op, method, json)                                            \
  static inline jalon_status op(const jalon_cloud* cloud, jalon_task* task, made* out) { \
    return op_compare(method, json, cloud, task, out);                                   \
  }
JALON_BENCH_COMPARE(op_nearest, "distance", "{\"hausdorff\": true, \"sampling_error\": true}")
JALON_BENCH_COMPARE(op_within, "distance", "{\"max_distance_m\": 0.1}")
JALON_BENCH_COMPARE(op_delaunay, "distance", "{\"local_model\": \"delaunay\"}")
JALON_BENCH_COMPARE(op_quadrics, "distance",
                    "{\"local_model\": \"quadric\", \"neighbourhood\": \"point\"}")
JALON_BENCH_COMPARE(op_preview, "preview", "{}")
JALON_BENCH_COMPARE(op_preview_angles, "preview", "{\"measure\": \"plane_angle\"}")

/* At every tenth point, as core points of their own. */
static inline jalon_status op_m3c2_core(const jalon_cloud* cloud, jalon_task* task, made* out) {
  jalon_cloud *moved = NULL, *core = NULL;
  jalon_comparer* comparer = NULL;
  jalon_params* params = NULL;
  jalon_comparison* comparison = NULL;
  jalon_array_view xyz;
  jalon_status status = moved_copy(cloud, &moved);
  if (status == JALON_OK) status = jalon_cloud_points(cloud, &xyz);
  if (status == JALON_OK)
    status = jalon_cloud_create(xyz.data, JALON_FLOAT64, xyz.count / 10, 10 * xyz.stride_bytes, 0,
                                &core);
  if (status == JALON_OK) status = jalon_comparer_create("m3c2", &comparer);
  if (status == JALON_OK) status = jalon_comparer_params(comparer, &params);
  if (status == JALON_OK)
    status = jalon_params_from_json(params,
                                    "{\"normal_radius_m\": 0.05, \"cylinder_radius_m\": 0.05, "
                                    "\"max_depth_m\": 0.2}");
  if (status == JALON_OK)
    status = jalon_comparer_run_core(comparer, cloud, moved, core, task, &comparison);
  if (status == JALON_OK) status = jalon_comparison_cloud(comparison, &out->cloud);
  jalon_comparison_release(comparison);
  jalon_params_release(params);
  jalon_comparer_release(comparer);
  jalon_cloud_release(core);
  jalon_cloud_release(moved);
  return status;
}

/* The cloud under a tripod in front of it. */
static inline jalon_status with_tripod(const jalon_cloud* cloud, jalon_cloud** out) {
  double east_m = 0, north_m = 0;
  jalon_status status = whole_metres(cloud, &east_m, &north_m);
  const jalon_transform pose = {{1, 0, 0, east_m, 0, 1, 0, north_m - 12, 0, 0, 1, 1.5}};
  if (status == JALON_OK) status = own_handle(cloud, out);
  if (status == JALON_OK) status = jalon_cloud_set_station(*out, "tripod", &pose);
  return status;
}
static inline jalon_status compare_visible(const jalon_cloud* cloud, jalon_task* task, made* out,
                                           const char* json) {
  jalon_cloud *seen = NULL, *changed = NULL;
  jalon_comparison* comparison = NULL;
  jalon_status status = with_tripod(cloud, &seen);
  if (status == JALON_OK) status = changed_copy(cloud, &changed);
  if (status == JALON_OK) status = compare_by("distance", json, seen, changed, task, &comparison);
  if (status == JALON_OK) status = jalon_comparison_cloud(comparison, &out->cloud);
  jalon_comparison_release(comparison);
  jalon_cloud_release(changed);
  jalon_cloud_release(seen);
  return status;
}
static inline jalon_status op_hidden_vertical(const jalon_cloud* cloud, jalon_task* task,
                                              made* out) {
  return compare_visible(cloud, task, out,
                         "{\"visibility\": \"stations\", \"hidden\": \"vertical\"}");
}
static inline jalon_status op_hidden_occluders(const jalon_cloud* cloud, jalon_task* task,
                                               made* out) {
  return compare_visible(cloud, task, out,
                         "{\"visibility\": \"stations\", \"hidden\": \"occluders\"}");
}
static inline jalon_status op_depth_map(const jalon_cloud* cloud, jalon_task* task, made* out) {
  jalon_cloud* seen = NULL;
  jalon_status status = with_tripod(cloud, &seen);
  if (status == JALON_OK)
    status = jalon_cloud_depth_map(seen, 0, NULL, task, &out->fields, NULL, NULL);
  jalon_cloud_release(seen);
  return status;
}
/* ---- changes: every tenth point went up by 2 m ---- */

static inline jalon_status lifted_copy(const jalon_cloud* cloud, jalon_cloud** out) {
  jalon_array_view xyz;
  jalon_status status = jalon_cloud_points(cloud, &xyz);
  if (status != JALON_OK) return status;
  double* own = malloc((size_t)xyz.count * 24 + 24);
  for (uint64_t i = 0; i < xyz.count; ++i) {
    memcpy(own + 3 * i, (const char*)xyz.data + i * xyz.stride_bytes, 24);
    if (i % 10 == 3) own[3 * i + 2] += 2;
  }
  status = jalon_cloud_create(own, JALON_FLOAT64, xyz.count, 0, 0, out);
  free(own);
  return status;
}
/* As compare_both_ways. */
static inline jalon_status compare_lifted(const jalon_cloud* cloud, const struct both_ways** out) {
  static struct both_ways both;
  *out = &both;
  if (both.changes != NULL && both.of == cloud) return JALON_OK;
  release_both(&both);
  both.of = jalon_cloud_retain((jalon_cloud*)cloud);
  jalon_status status = lifted_copy(cloud, &both.changed);
  if (status == JALON_OK)
    status = compare_by("distance", "{}", cloud, both.changed, NULL, &both.forward);
  if (status == JALON_OK)
    status = compare_by("distance", "{}", both.changed, cloud, NULL, &both.reverse);
  if (status == JALON_OK)
    status = diagnose(&both, NULL, &both.forward_points, &both.reverse_points, &both.changes);
  return status;
}
static inline jalon_status op_regions_lifted(const jalon_cloud* cloud, jalon_task* task,
                                             made* out) {
  const struct both_ways* both;
  const jalon_status status = compare_lifted(cloud, &both);
  return status == JALON_OK ? regions_of(both, task, out) : status;
}
static inline jalon_status op_diagnose_lifted(const jalon_cloud* cloud, jalon_task* task,
                                              made* out) {
  const struct both_ways* both;
  const jalon_status status = compare_lifted(cloud, &both);
  return status == JALON_OK ? diagnose(both, task, NULL, NULL, &out->fields) : status;
}
static inline jalon_status op_outlines_lifted(const jalon_cloud* cloud, jalon_task* task,
                                              made* out) {
  const struct both_ways* both;
  const jalon_status status = compare_lifted(cloud, &both);
  return status == JALON_OK ? outlines_of(both, task, out) : status;
}

static inline jalon_status op_deviations(const jalon_cloud* cloud, jalon_task* task, made* out) {
  const char* path = temporary("deviations.png");
  const struct both_ways* both;
  (void)out;
  jalon_status status = compare_lifted(cloud, &both);
  if (status == JALON_OK) status = jalon_report_write_deviations(both->forward, path, NULL, task);
  unlink(path);
  return status;
}

/* ---- registration ---- */

static inline jalon_status op_coarse(const jalon_cloud* cloud, jalon_task* task, made* out) {
  return register_by("coarse", cloud, task, out);
}

/* ---- segmentations: into the components of the cloud ---- */

static inline jalon_status op_evaluate(const jalon_cloud* cloud, jalon_task* task, made* out) {
  made parts = {NULL, NULL, NULL};
  jalon_evaluation* evaluation = NULL;
  jalon_status status = op_labels(cloud, task, &parts);
  if (status == JALON_OK)
    status = jalon_segmentation_evaluate(parts.segmentation, parts.segmentation, NULL, task,
                                         &evaluation);
  if (status == JALON_OK) status = jalon_evaluation_totals(evaluation, &out->fields);
  jalon_evaluation_release(evaluation);
  release_made(&parts);
  return status;
}
static inline jalon_status model_by(const char* method, const jalon_cloud* cloud, jalon_task* task,
                                    made* out) {
  made parts = {NULL, NULL, NULL};
  jalon_status status = op_labels(cloud, task, &parts);
  if (status == JALON_OK) status = model_of(method, &parts, task, out);
  release_made(&parts);
  return status;
}
static inline jalon_status op_outlines(const jalon_cloud* cloud, jalon_task* task, made* out) {
  return model_by("outlines", cloud, task, out);
}
static inline jalon_status op_extrusion(const jalon_cloud* cloud, jalon_task* task, made* out) {
  return model_by("extrusion", cloud, task, out);
}
static inline jalon_status op_picture(const jalon_cloud* cloud, jalon_task* task, made* out) {
  const char* path = temporary("picture.png");
  made parts = {NULL, NULL, NULL};
  (void)out;
  jalon_status status = op_labels(cloud, task, &parts);
  if (status == JALON_OK) status = jalon_report_write_picture(parts.segmentation, path, NULL, task);
  release_made(&parts);
  unlink(path);
  return status;
}

/* ---- models ---- */

/* A triangle of a centimetre at every third point. */
static inline jalon_status mesh_of(const jalon_cloud* cloud, jalon_model** out) {
  jalon_array_view xyz;
  jalon_status status = jalon_cloud_points(cloud, &xyz);
  if (status != JALON_OK) return status;
  const uint32_t triangles = (uint32_t)(xyz.count / 3);
  double* places = malloc((size_t)triangles * 72 + 72);
  uint32_t* corners = malloc((size_t)triangles * 12 + 12);
  for (uint32_t i = 0; i < 3 * triangles; ++i) {
    memcpy(places + 3 * i, (const char*)xyz.data + i / 3 * 3 * xyz.stride_bytes, 24);
    if (i % 3 != 0) places[3 * i + i % 3 - 1] += 0.01;
    corners[i] = i;
  }
  status = jalon_model_create_mesh(places, JALON_FLOAT64, (uint64_t)3 * triangles, 0, corners,
                                   triangles, NULL, out);
  free(corners), free(places);
  return status;
}
static inline jalon_status op_from_mesh(const jalon_cloud* cloud, jalon_task* task, made* out) {
  jalon_model* mesh = NULL;
  jalon_comparer* comparer = NULL;
  jalon_comparison* comparison = NULL;
  jalon_status status = mesh_of(cloud, &mesh);
  if (status == JALON_OK) status = jalon_comparer_create("distance", &comparer);
  if (status == JALON_OK)
    status = jalon_comparer_run_model(comparer, mesh, cloud, task, &comparison);
  if (status == JALON_OK) status = jalon_comparison_cloud(comparison, &out->cloud);
  jalon_comparison_release(comparison);
  jalon_comparer_release(comparer);
  jalon_model_release(mesh);
  return status;
}
static inline jalon_status op_clearance(const jalon_cloud* cloud, jalon_task* task, made* out) {
  jalon_model* mesh = NULL;
  jalon_cloud* moved = NULL;
  jalon_status status = mesh_of(cloud, &mesh);
  if (status == JALON_OK) status = moved_copy(cloud, &moved);
  if (status == JALON_OK)
    status = jalon_model_clearance(mesh, JALON_WHOLE_MODEL, moved, NULL, task, &out->fields, NULL);
  jalon_cloud_release(moved);
  jalon_model_release(mesh);
  return status;
}
static inline jalon_status op_sample_mesh(const jalon_cloud* cloud, jalon_task* task, made* out) {
  jalon_model* mesh = NULL;
  jalon_params* options = NULL;
  jalon_status status = mesh_of(cloud, &mesh);
  if (status == JALON_OK) status = options_from("model_sample", "{\"points\": 100000}", &options);
  if (status == JALON_OK) status = jalon_model_sample(mesh, options, task, &out->cloud);
  jalon_params_release(options);
  jalon_model_release(mesh);
  return status;
}
/* A box of 0.2 m through the unit cube. */
static inline jalon_status op_sweep(const jalon_cloud* cloud, jalon_task* task, made* out) {
  const jalon_gauge_piece box = {JALON_GAUGE_BOX, 0, {{1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0}},
                                 {0.2, 0.2, 0.2}, 0, 0};
  const jalon_transform poses[2] = {{{1, 0, 0, -1, 0, 1, 0, -1, 0, 0, 1, -1}},
                                    {{1, 0, 0, 2, 0, 1, 0, 2, 0, 0, 1, 2}}};
  return jalon_gauge_sweep(&box, 1, NULL, 0, poses, 2, cloud, NULL, NULL, task, &out->fields, NULL);
}

#endif

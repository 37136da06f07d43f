/* SPDX-FileCopyrightText: 2026 The Jalon authors
 * SPDX-License-Identifier: Apache-2.0 */
/* Operations on one cloud that the tests' table (operations.h) does not have, in its shape: every method whose time may
 * depend on where the points lie. */
#ifndef JALON_BENCH_HOSTILE_FIELDS_H
#define JALON_BENCH_HOSTILE_FIELDS_H

#include "../capi/operations.h"

/* ---- normals, cleaning, sampling ---- */

static inline jalon_status op_triangulation(const jalon_cloud* cloud, jalon_task* task, made* out) {
  return change(cloud, task, out, jalon_cloud_compute_normals, "normals",
                "{\"method\": \"triangulation\"}");
}
static inline jalon_status op_normals_radius(const jalon_cloud* cloud, jalon_task* task,
                                             made* out) {
  return change(cloud, task, out, jalon_cloud_compute_normals, "normals", "{\"radius_m\": 0.05}");
}
static inline jalon_status op_quadric_radius(const jalon_cloud* cloud, jalon_task* task,
                                             made* out) {
  return change(cloud, task, out, jalon_cloud_compute_normals, "normals",
                "{\"method\": \"quadric\", \"radius_m\": 0.05}");
}
/* As op_chi_square, but within a stated radius. */
static inline jalon_status op_chi_square_radius(const jalon_cloud* cloud, jalon_task* task,
                                                made* out) {
  jalon_cloud* own = NULL;
  jalon_noise_law* law = NULL;
  jalon_params* options = NULL;
  jalon_status status = options_from("chi_square", "{\"radius_m\": 0.05}", &options);
  if (status == JALON_OK) status = with_ripple(cloud, &own);
  if (status == JALON_OK)
    status =
        jalon_noise_law_from_json("{\"law\": \"weibull\", \"shape\": 2, \"scale\": 0.005}", &law);
  if (status == JALON_OK)
    status = jalon_cloud_compute_chi_square(own, "ripple", law, options, task, &out->fields);
  jalon_params_release(options);
  jalon_noise_law_release(law);
  if (status == JALON_OK) out->cloud = own;
  else jalon_cloud_release(own);
  return status;
}
static inline jalon_status op_features_radius(const jalon_cloud* cloud, jalon_task* task,
                                              made* out) {
  return change(cloud, task, out, jalon_cloud_compute_features, "features", "{\"radius_m\": 0.05}");
}
static inline jalon_status op_outliers_radius(const jalon_cloud* cloud, jalon_task* task,
                                              made* out) {
  jalon_params* options = NULL;
  jalon_status status =
      options_from("outliers", "{\"method\": \"radius\", \"radius_m\": 0.05}", &options);
  if (status == JALON_OK)
    status = jalon_cloud_remove_outliers(cloud, options, task, &out->cloud, NULL);
  jalon_params_release(options);
  return status;
}
static inline jalon_status op_octree_sample(const jalon_cloud* cloud, jalon_task* task, made* out) {
  return subsample(cloud, task, out, "{\"method\": \"octree\", \"max_points\": 20000}");
}
static inline jalon_status op_crop_cylinder(const jalon_cloud* cloud, jalon_task* task, made* out) {
  const jalon_vec3 foot = {0.5, 0.5, 0}, top = {0.5, 0.5, 1};
  return jalon_cloud_crop_cylinder(cloud, &foot, &top, 0.3, task, &out->cloud, NULL);
}
static inline jalon_status op_crop_polygon(const jalon_cloud* cloud, jalon_task* task, made* out) {
  const double star[10] = {0.5, 1, 0.2, 0, 1, 0.7, 0, 0.7, 0.8, 0};
  return jalon_cloud_crop_polygon(cloud, star, 5, 0, 1, NULL, task, &out->cloud, NULL);
}
static inline jalon_status op_moments(const jalon_cloud* cloud, jalon_task* task, made* out) {
  double covariance[9], moment = 0;
  (void)out;
  const jalon_status status = jalon_cloud_covariance(cloud, task, NULL, covariance);
  return status == JALON_OK ? jalon_cloud_moment(cloud, 4, 2, 0, 1, task, &moment) : status;
}

/* ---- searches ---- */

/* A fifth of the cloud's points as queries; level -2: the best one. */
static inline jalon_status knn_of(const jalon_cloud* cloud, jalon_task* task, int32_t level) {
  enum { kNearest = 8 };
  jalon_array_view xyz;
  jalon_status status = jalon_cloud_points(cloud, &xyz);
  if (status != JALON_OK) return status;
  const uint64_t count = xyz.count / 5;
  uint64_t* indices = malloc((size_t)count * kNearest * 8 + 8);
  if (level == -2) status = jalon_cloud_best_level(cloud, cloud, kNearest, task, &level);
  if (status == JALON_OK)
    status = jalon_cloud_knn(cloud, xyz.data, JALON_FLOAT64, count, 5 * xyz.stride_bytes, kNearest,
                             level, task, indices, NULL);
  free(indices);
  return status;
}
static inline jalon_status op_knn(const jalon_cloud* cloud, jalon_task* task, made* out) {
  (void)out;
  return knn_of(cloud, task, JALON_LEVEL_AUTOMATIC);
}
static inline jalon_status op_knn_at_level(const jalon_cloud* cloud, jalon_task* task, made* out) {
  (void)out;
  return knn_of(cloud, task, -2);
}
static inline jalon_status op_knn_all(const jalon_cloud* cloud, jalon_task* task, made* out) {
  enum { kNearest = 16 };
  const size_t pairs = (size_t)count_of(cloud) * kNearest;
  uint32_t* indices = malloc(pairs * 4 + 4);
  float* squared = malloc(pairs * 4 + 4);
  (void)out;
  const jalon_status status = jalon_cloud_knn_all(cloud, kNearest, task, indices, squared);
  free(indices), free(squared);
  return status;
}
static inline jalon_status op_cells(const jalon_cloud* cloud, jalon_task* task, made* out) {
  jalon_fields* around = NULL;
  jalon_array_view codes;
  jalon_status status = jalon_cloud_cells(cloud, 8, task, &out->fields);
  if (status == JALON_OK) status = jalon_fields_view(out->fields, "code", &codes);
  for (uint64_t i = 0; status == JALON_OK && i < codes.count; i += 100) {
    const uint64_t* code = (const void*)((const char*)codes.data + i * codes.stride_bytes);
    status = jalon_cloud_cell_neighbours(cloud, 8, *code, 3, task, &around);
    jalon_fields_release(around);
    around = NULL;
  }
  return status;
}

/* ---- fields ---- */

static inline jalon_status on_ripple(const jalon_cloud* cloud, jalon_task* task, made* out,
                                     jalon_status (*f)(jalon_cloud*, const char*,
                                                       const jalon_params*, jalon_task*),
                                     const char* name, const char* json) {
  jalon_cloud* own = NULL;
  jalon_params* options = NULL;
  jalon_status status = with_ripple(cloud, &own);
  if (status == JALON_OK) status = options_from(name, json, &options);
  if (status == JALON_OK) status = f(own, "ripple", options, task);
  jalon_params_release(options);
  if (status == JALON_OK) out->cloud = own;
  else jalon_cloud_release(own);
  return status;
}
#define JALON_BENCH_ON_RIPPLE(op, f, name, json)                                         \
  static inline jalon_status op(const jalon_cloud* cloud, jalon_task* task, made* out) { \
    return on_ripple(cloud, task, out, f, name, json);                                   \
  }
JALON_BENCH_ON_RIPPLE(op_gradient, jalon_cloud_compute_gradient, "gradient", "{}")
JALON_BENCH_ON_RIPPLE(op_slopes, jalon_cloud_compute_gradient, "gradient",
                      "{\"method\": \"least_squares\"}")
JALON_BENCH_ON_RIPPLE(op_mean, jalon_cloud_filter_field, "field_filter", "{\"method\": \"mean\"}")
JALON_BENCH_ON_RIPPLE(op_median, jalon_cloud_filter_field, "field_filter",
                      "{\"method\": \"median\"}")
JALON_BENCH_ON_RIPPLE(op_median_k, jalon_cloud_filter_field, "field_filter",
                      "{\"method\": \"median\", \"k\": 16}")
static inline jalon_status classify(jalon_cloud* cloud, const char* field,
                                    const jalon_params* options, jalon_task* task) {
  return jalon_cloud_classify_field(cloud, field, options, task, NULL);
}
JALON_BENCH_ON_RIPPLE(op_classes, classify, "classes", "{}")
static inline jalon_status histogram(jalon_cloud* cloud, const char* field,
                                     const jalon_params* options, jalon_task* task) {
  jalon_fields* summary = NULL;
  const jalon_status status =
      jalon_cloud_field_histogram(cloud, field, NULL, options, task, NULL, &summary);
  jalon_fields_release(summary);
  return status;
}
JALON_BENCH_ON_RIPPLE(op_histogram, histogram, "histogram", "{}")
static inline jalon_status fit_law(jalon_cloud* cloud, const char* field,
                                   const jalon_params* options, jalon_task* task) {
  jalon_noise_law* law = NULL;
  const jalon_status status = jalon_noise_law_fit(cloud, field, options, task, &law);
  jalon_noise_law_release(law);
  return status;
}
JALON_BENCH_ON_RIPPLE(op_noise_law, fit_law, "noise_law", "{\"law\": \"empirical\"}")

static inline jalon_status map_distance(const jalon_cloud* cloud, jalon_task* task, made* out,
                                        const char* json) {
  jalon_cloud* moved = NULL;
  jalon_params* options = NULL;
  jalon_status status = moved_copy(cloud, &moved);
  if (status == JALON_OK) status = options_from("distance_map", json, &options);
  if (status == JALON_OK) status = jalon_cloud_compute_map_distance(moved, cloud, options, task);
  jalon_params_release(options);
  if (status == JALON_OK) out->cloud = moved;
  else jalon_cloud_release(moved);
  return status;
}
static inline jalon_status op_chamfer(const jalon_cloud* cloud, jalon_task* task, made* out) {
  return map_distance(cloud, task, out, "{}");
}
static inline jalon_status op_marching(const jalon_cloud* cloud, jalon_task* task, made* out) {
  return map_distance(cloud, task, out, "{\"method\": \"fast_marching\"}");
}
static inline jalon_status op_distance_map(const jalon_cloud* cloud, jalon_task* task, made* out) {
  return jalon_cloud_distance_map(cloud, NULL, task, &out->cloud);
}

/* ---- primitives and targets ---- */

static inline jalon_status op_fit_sphere(const jalon_cloud* cloud, jalon_task* task, made* out) {
  return jalon_cloud_fit_sphere(cloud, NULL, 0, NULL, task, &out->fields);
}
static inline jalon_status op_fit_circle(const jalon_cloud* cloud, jalon_task* task, made* out) {
  return jalon_cloud_fit_circle(cloud, NULL, 0, NULL, task, &out->fields);
}
static inline jalon_status targets_by(const jalon_cloud* cloud, jalon_task* task, made* out,
                                      const char* json) {
  enum { kPlaces = 5 };
  double places[3 * kPlaces];
  jalon_array_view xyz;
  jalon_params* options = NULL;
  jalon_status status = jalon_cloud_points(cloud, &xyz);
  for (uint64_t i = 0; status == JALON_OK && i < kPlaces; ++i)
    memcpy(places + 3 * i, (const char*)xyz.data + i * (xyz.count / kPlaces) * xyz.stride_bytes,
           24);
  if (status == JALON_OK) status = options_from("target", json, &options);
  if (status == JALON_OK)
    status = jalon_cloud_measure_targets(cloud, places, kPlaces, options, task, &out->fields);
  jalon_params_release(options);
  return status;
}
static inline jalon_status op_sphere_targets(const jalon_cloud* cloud, jalon_task* task,
                                             made* out) {
  return targets_by(cloud, task, out, "{}");
}
static inline jalon_status op_flat_targets(const jalon_cloud* cloud, jalon_task* task, made* out) {
  return targets_by(cloud, task, out, "{\"kind\": \"flat\"}");
}

#endif

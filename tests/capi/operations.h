/* SPDX-FileCopyrightText: 2026 The Jalon authors
 * SPDX-License-Identifier: Apache-2.0 */
/* The long operations in one shape, for tests that treat them all alike: each works on a copy of the handle's cloud
 * where it would change it, writes the handle it makes to *out and gives the hash of what came out. */
#ifndef JALON_TEST_OPERATIONS_H
#define JALON_TEST_OPERATIONS_H

#include "support.h"

#include <math.h>

typedef struct made {
  jalon_cloud* cloud;
  jalon_fields* fields;
  jalon_segmentation* segmentation;
} made;

static inline void release_made(made* m) {
  jalon_cloud_release(m->cloud);
  jalon_fields_release(m->fields);
  jalon_segmentation_release(m->segmentation);
  memset(m, 0, sizeof *m);
}

/* Another handle on the same points, to be changed freely. */
static inline jalon_status own_handle(const jalon_cloud* cloud, jalon_cloud** out) {
  const jalon_transform identity = {{1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0}};
  return jalon_cloud_transform(cloud, &identity, NULL, out);
}

typedef jalon_status (*operation)(const jalon_cloud* cloud, jalon_task* task, made* out);

static inline jalon_status change(const jalon_cloud* cloud, jalon_task* task, made* out,
                                  jalon_status (*f)(jalon_cloud*, const jalon_params*, jalon_task*),
                                  const char* name, const char* json) {
  jalon_cloud* own = NULL;
  jalon_params* options = NULL;
  jalon_status status = own_handle(cloud, &own);
  if (status == JALON_OK) status = jalon_params_create(name, &options);
  if (status == JALON_OK) status = jalon_params_from_json(options, json);
  if (status == JALON_OK) status = f(own, options, task);
  jalon_params_release(options);
  if (status == JALON_OK) out->cloud = own;
  else jalon_cloud_release(own);
  return status;
}

static inline jalon_status op_prepare(const jalon_cloud* cloud, jalon_task* task, made* out) {
  jalon_cloud* own = NULL;
  jalon_status status = own_handle(cloud, &own);
  if (status == JALON_OK) status = jalon_cloud_prepare(own, task);
  if (status == JALON_OK) out->cloud = own;
  else jalon_cloud_release(own);
  return status;
}
static inline jalon_status op_normals(const jalon_cloud* cloud, jalon_task* task, made* out) {
  return change(cloud, task, out, jalon_cloud_compute_normals, "normals", "{\"k\": 12}");
}
static inline jalon_status op_quadric(const jalon_cloud* cloud, jalon_task* task, made* out) {
  return change(cloud, task, out, jalon_cloud_compute_normals, "normals",
                "{\"method\": \"quadric\"}");
}
static inline jalon_status op_features(const jalon_cloud* cloud, jalon_task* task, made* out) {
  return change(cloud, task, out, jalon_cloud_compute_features, "features", "{}");
}
static inline jalon_status components(jalon_cloud* cloud, const jalon_params* options,
                                      jalon_task* task) {
  uint64_t count;
  return jalon_cloud_compute_components(cloud, options, task, &count);
}
static inline jalon_status op_components(const jalon_cloud* cloud, jalon_task* task, made* out) {
  return change(cloud, task, out, components, "components", "{}");
}
static inline jalon_status op_outliers(const jalon_cloud* cloud, jalon_task* task, made* out) {
  return jalon_cloud_remove_outliers(cloud, NULL, task, &out->cloud, NULL);
}
static inline jalon_status subsample(const jalon_cloud* cloud, jalon_task* task, made* out,
                                     const char* json) {
  jalon_params* options = NULL;
  jalon_status status = jalon_params_create("subsample", &options);
  if (status == JALON_OK) status = jalon_params_from_json(options, json);
  if (status == JALON_OK) status = jalon_cloud_subsample(cloud, options, task, &out->cloud, NULL);
  jalon_params_release(options);
  return status;
}
static inline jalon_status op_voxel(const jalon_cloud* cloud, jalon_task* task, made* out) {
  return subsample(cloud, task, out, "{\"method\": \"voxel\"}");
}
static inline jalon_status op_minimum_distance(const jalon_cloud* cloud, jalon_task* task,
                                               made* out) {
  return subsample(cloud, task, out, "{\"method\": \"minimum_distance\"}");
}
static inline jalon_status op_random(const jalon_cloud* cloud, jalon_task* task, made* out) {
  return subsample(cloud, task, out, "{\"method\": \"random\"}");
}
static inline jalon_status op_duplicates(const jalon_cloud* cloud, jalon_task* task, made* out) {
  return jalon_cloud_remove_duplicates(cloud, 1e-4, task, &out->cloud, NULL);
}
static inline jalon_status op_interest(const jalon_cloud* cloud, jalon_task* task, made* out) {
  return jalon_cloud_split_interest(cloud, NULL, task, &out->cloud, NULL);
}
static inline jalon_status op_radius(const jalon_cloud* cloud, jalon_task* task, made* out) {
  jalon_array_view xyz;
  jalon_fields* ranges = NULL;
  jalon_status status = jalon_cloud_points(cloud, &xyz);
  const uint64_t count = xyz.count < 20000 ? xyz.count : 20000;
  if (status == JALON_OK)
    status = jalon_cloud_radius_search(cloud, xyz.data, JALON_FLOAT64, count, 0, 0.1, task, &ranges,
                                       &out->fields);
  jalon_fields_release(ranges);
  return status;
}
static inline jalon_status segment_by(const char* method, const char* json,
                                      const jalon_cloud* cloud, jalon_task* task, made* out) {
  jalon_segmenter* segmenter = NULL;
  jalon_params* params = NULL;
  jalon_status status = jalon_segmenter_create(method, &segmenter);
  if (status == JALON_OK) status = jalon_segmenter_params(segmenter, &params);
  if (status == JALON_OK) status = jalon_params_from_json(params, json);
  if (status == JALON_OK) status = jalon_segmenter_run(segmenter, cloud, task, &out->segmentation);
  jalon_params_release(params);
  jalon_segmenter_release(segmenter);
  return status;
}
static inline jalon_status op_segment(const jalon_cloud* cloud, jalon_task* task, made* out) {
  return segment_by(NULL, "{}", cloud, task, out);
}
static inline jalon_status op_primitives(const jalon_cloud* cloud, jalon_task* task, made* out) {
  return segment_by(NULL, "{\"primitives\": \"all\"}", cloud, task, out);
}
static inline jalon_status op_grow(const jalon_cloud* cloud, jalon_task* task, made* out) {
  return segment_by("region_growing", "{}", cloud, task, out);
}
static inline jalon_status op_raster(const jalon_cloud* cloud, jalon_task* task, made* out) {
  return segment_by("raster_growing", "{}", cloud, task, out);
}
static inline jalon_status op_profiles(const jalon_cloud* cloud, jalon_task* task, made* out) {
  return segment_by("profiles", "{}", cloud, task, out);
}
static inline jalon_status op_triangles(const jalon_cloud* cloud, jalon_task* task, made* out) {
  return segment_by("triangle_growing", "{}", cloud, task, out);
}
static inline jalon_status op_split_merge(const jalon_cloud* cloud, jalon_task* task, made* out) {
  return segment_by("split_merge", "{}", cloud, task, out);
}
static inline jalon_status op_hough(const jalon_cloud* cloud, jalon_task* task, made* out) {
  return segment_by("hough", "{}", cloud, task, out);
}
/* A plane from the cloud's first point as its seed. */
static inline jalon_status op_pick(const jalon_cloud* cloud, jalon_task* task, made* out) {
  jalon_segmentation* start = NULL;
  jalon_array_view xyz;
  jalon_status status = jalon_segmentation_start(cloud, NULL, &start);
  if (status == JALON_OK) status = jalon_cloud_points(cloud, &xyz);
  if (status == JALON_OK)
    status = jalon_segmentation_pick(start, JALON_PRIMITIVE_PLANE, xyz.data, 1, NULL, task,
                                     &out->segmentation);
  jalon_segmentation_release(start);
  return status;
}
/* All points but the facade's, which is no sphere: robust draws, then adjustment. */
static inline jalon_status op_fit(const jalon_cloud* cloud, jalon_task* task, made* out) {
  const jalon_vec3 up = {0, 0, 1};
  jalon_params* options = NULL;
  jalon_status status = jalon_params_create("primitive", &options);
  if (status == JALON_OK)
    status = jalon_params_from_json(options, "{\"tolerance_m\": 4, \"robust\": false}");
  if (status == JALON_OK)
    status = jalon_cloud_fit_cylinder(cloud, NULL, 0, &up, options, task, &out->fields);
  jalon_params_release(options);
  return status;
}
/* Components as given labels; the task is for one call, the one under test. */
static inline jalon_status op_labels(const jalon_cloud* cloud, jalon_task* task, made* out) {
  made parts = {NULL, NULL, NULL};
  jalon_status status = change(cloud, NULL, &parts, components, "components", "{\"cell_m\": 0.2}");
  if (status == JALON_OK)
    status =
        jalon_segmentation_from_labels(parts.cloud, "component", NULL, task, &out->segmentation);
  release_made(&parts);
  return status;
}
/* A model of those components, whose cloud they get; its vertices are the result. */
static inline jalon_status model_of(const char* method, made* parts, jalon_task* task, made* out) {
  jalon_modeller* modeller = NULL;
  jalon_model* model = NULL;
  jalon_status status = jalon_segmentation_cloud(parts->segmentation, &parts->cloud);
  if (status == JALON_OK) status = jalon_modeller_create(method, &modeller);
  if (status == JALON_OK)
    status = jalon_modeller_run(modeller, parts->cloud, parts->segmentation, task, &model);
  if (status == JALON_OK) status = jalon_model_vertices(model, &out->fields);
  jalon_model_release(model);
  jalon_modeller_release(modeller);
  return status;
}
/* Walls and openings. */
static inline jalon_status op_facade(const jalon_cloud* cloud, jalon_task* task, made* out) {
  made parts = {NULL, NULL, NULL};
  jalon_status status = op_labels(cloud, NULL, &parts);
  if (status == JALON_OK) status = model_of("facade", &parts, task, out);
  release_made(&parts);
  return status;
}
static inline jalon_status op_append(const jalon_cloud* cloud, jalon_task* task, made* out) {
  return jalon_cloud_append(cloud, cloud, task, &out->cloud);
}
static inline jalon_status op_crop(const jalon_cloud* cloud, jalon_task* task, made* out) {
  const jalon_box box = {{2, -5, 1}, {15, 5, 8}};
  return jalon_cloud_crop_box(cloud, &box, NULL, task, &out->cloud, NULL);
}

/* Seen from a tripod in front of it all, which moves with the cloud by whole metres. */
static inline jalon_status op_covariances(const jalon_cloud* cloud, jalon_task* task, made* out) {
  jalon_cloud* own = NULL;
  jalon_array_view xyz;
  jalon_status status = jalon_cloud_points(cloud, &xyz);
  const double* first = xyz.data;
  const jalon_transform pose = {
      {1, 0, 0, floor(first[0]), 0, 1, 0, floor(first[1]) - 25, 0, 0, 1, 1.5}};
  if (status == JALON_OK) status = own_handle(cloud, &own);
  if (status == JALON_OK) status = jalon_cloud_set_station(own, "tripod", &pose);
  if (status == JALON_OK) status = jalon_cloud_compute_covariances(own, NULL, task);
  if (status == JALON_OK) out->cloud = own;
  else jalon_cloud_release(own);
  return status;
}

/* On a field that the points' places give: heights of a ripple, which no whole-metre shift changes. Multiples of
 * 2^-10 m and their squares are exact, however the host rounds. */
static inline jalon_status with_ripple(const jalon_cloud* cloud, jalon_cloud** out) {
  jalon_array_view xyz;
  jalon_status status = jalon_cloud_points(cloud, &xyz);
  if (status != JALON_OK) return status;
  const double* p = xyz.data;
  double* values = malloc((size_t)xyz.count * 8 + 8);
  if (values == NULL) return JALON_ERROR_OUT_OF_MEMORY;
  for (uint64_t i = 0; i < xyz.count; ++i) {
    const double u = floor((p[3 * i] - floor(p[3 * i])) * 1024) * 0x1p-10,
                 v = floor((p[3 * i + 2] - floor(p[3 * i + 2])) * 1024) * 0x1p-10;
    values[i] = 0x1p-7 * u * (1 - u) + 0x1p-6 * v * v;
  }
  status = own_handle(cloud, out);
  if (status == JALON_OK)
    status =
        jalon_cloud_set_field(*out, "ripple", values, JALON_FLOAT64, 1, xyz.count, 0, "m", NULL);
  free(values);
  return status;
}
static inline jalon_status op_chi_square(const jalon_cloud* cloud, jalon_task* task, made* out) {
  jalon_cloud* own = NULL;
  jalon_noise_law* law = NULL;
  jalon_status status = with_ripple(cloud, &own);
  if (status == JALON_OK)
    status =
        jalon_noise_law_from_json("{\"law\": \"weibull\", \"shape\": 2, \"scale\": 0.005}", &law);
  if (status == JALON_OK)
    status = jalon_cloud_compute_chi_square(own, "ripple", law, NULL, task, &out->fields);
  jalon_noise_law_release(law);
  if (status == JALON_OK) out->cloud = own;
  else jalon_cloud_release(own);
  return status;
}
static inline jalon_status op_propagation(const jalon_cloud* cloud, jalon_task* task, made* out) {
  jalon_cloud* own = NULL;
  jalon_status status = with_ripple(cloud, &own);
  if (status == JALON_OK)
    status = jalon_cloud_segment_propagation(own, "ripple", "ripple", NULL, task, &out->fields);
  if (status == JALON_OK) out->cloud = own;
  else jalon_cloud_release(own);
  return status;
}
static inline jalon_status op_gaussian(const jalon_cloud* cloud, jalon_task* task, made* out) {
  jalon_cloud* own = NULL;
  jalon_status status = with_ripple(cloud, &own);
  if (status == JALON_OK) status = jalon_cloud_filter_field(own, "ripple", NULL, task);
  if (status == JALON_OK) out->cloud = own;
  else jalon_cloud_release(own);
  return status;
}
static inline jalon_status op_geodesic(const jalon_cloud* cloud, jalon_task* task, made* out) {
  const uint64_t seed = 0;
  jalon_cloud* own = NULL;
  jalon_status status = own_handle(cloud, &own);
  if (status == JALON_OK) status = jalon_cloud_compute_geodesic(own, &seed, 1, NULL, task);
  if (status == JALON_OK) out->cloud = own;
  else jalon_cloud_release(own);
  return status;
}
#include "operations_compare.h"

static const struct {
  const char* name;
  operation run;
} kOperations[] = {
    {"prepare", op_prepare},
    {"normals", op_normals},
    {"normals quadric", op_quadric},
    {"features", op_features},
    {"components", op_components},
    {"outliers", op_outliers},
    {"voxel", op_voxel},
    {"minimum distance", op_minimum_distance},
    {"random", op_random},
    {"duplicates", op_duplicates},
    {"interest", op_interest},
    {"radius search", op_radius},
    {"segment", op_segment},
    {"region growing", op_grow},
    {"raster growing", op_raster},
    {"profiles", op_profiles},
    {"triangle growing", op_triangles},
    {"split and merge", op_split_merge},
    {"hough", op_hough},
    {"append", op_append},
    {"crop", op_crop},
    {"from labels", op_labels},
    {"primitives", op_primitives},
    {"pick", op_pick},
    {"fit", op_fit},
    {"covariances", op_covariances},
    {"facade model", op_facade},
    {"chi-square", op_chi_square},
    {"propagation", op_propagation},
    {"gaussian", op_gaussian},
    {"geodesic", op_geodesic},
    {"m3c2", op_m3c2},
    {"landslide", op_landslide},
    {"distance", op_distance},
    {"model distance", op_model_distance},
    {"regions", op_regions},
    {"diagnosis", op_diagnose},
    {"change outlines", op_change_outlines},
    {"visibility", op_visibility},
    {"volume", op_volume},
    {"sections", op_sections},
    {"icp", op_icp},
    {"automatic registration", op_automatic},
};
enum { kOperationCount = sizeof kOperations / sizeof *kOperations };

static inline uint64_t hash_fields(uint64_t hash, const jalon_fields* fields) {
  uint64_t columns = 0;
  MUST(jalon_fields_count(fields, &columns));
  for (uint64_t c = 0; c < columns; ++c) {
    jalon_field_info info;
    jalon_array_view view;
    info.struct_size = sizeof info;
    MUST(jalon_fields_info(fields, c, &info));
    MUST(jalon_fields_view(fields, info.name, &view));
    static const unsigned char bytes[] = {0, 1, 1, 2, 2, 4, 4, 8, 8, 4, 8};
    hash = hash_bytes(hash, info.name, strlen(info.name));
    for (uint64_t i = 0; i < view.count; ++i)
      hash = hash_bytes(hash, (const char*)view.data + i * view.stride_bytes,
                        (size_t)bytes[view.type] * view.components);
  }
  return hash;
}

static inline uint64_t hash_cloud(uint64_t hash, const jalon_cloud* cloud) {
  jalon_array_view xyz;
  jalon_fields* fields;
  MUST(jalon_cloud_points(cloud, &xyz));
  for (uint64_t i = 0; i < xyz.count; ++i)
    hash = hash_bytes(hash, (const char*)xyz.data + i * xyz.stride_bytes, 24);
  MUST(jalon_cloud_fields(cloud, &fields));
  hash = hash_fields(hash, fields);
  jalon_fields_release(fields);
  return hash;
}

static inline uint64_t hash_made(const made* m) {
  uint64_t hash = 14695981039346656037u;
  if (m->cloud) hash = hash_cloud(hash, m->cloud);
  if (m->fields) hash = hash_fields(hash, m->fields);
  if (m->segmentation) {
    jalon_fields* fields;
    MUST(jalon_segmentation_points(m->segmentation, &fields));
    hash = hash_fields(hash, fields);
    jalon_fields_release(fields);
    MUST(jalon_segmentation_segments(m->segmentation, &fields));
    hash = hash_fields(hash, fields);
    jalon_fields_release(fields);
  }
  return hash;
}

#endif

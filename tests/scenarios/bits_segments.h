/* SPDX-FileCopyrightText: 2026 The Jalon authors
 * SPDX-License-Identifier: Apache-2.0 */
/* Part of bits.c: segmenters with other parameters than the defaults, picks, fits, and every scene of the scanner. */
#ifndef JALON_TEST_BITS_SEGMENTS_H
#define JALON_TEST_BITS_SEGMENTS_H

#include "../capi/operations.h"

#include <math.h>

static const uint64_t kStart = 14695981039346656037u;

static inline void tell(const char* name, uint64_t seed, uint64_t hash) {
  printf("%-28s seed %llu %016llx\n", name, (unsigned long long)seed, (unsigned long long)hash);
}

static inline uint64_t hash_and_release(jalon_fields* fields) {
  const uint64_t hash = hash_fields(kStart, fields);
  jalon_fields_release(fields);
  return hash;
}

static inline uint64_t hash_segmentation(uint64_t hash, const jalon_segmentation* segmentation) {
  jalon_fields* fields;
  jalon_transform frame;
  MUST(jalon_segmentation_facade_frame(segmentation, &frame));
  hash = hash_bytes(hash, &frame, sizeof frame);
  MUST(jalon_segmentation_points(segmentation, &fields));
  hash = hash_fields(hash, fields);
  jalon_fields_release(fields);
  MUST(jalon_segmentation_segments(segmentation, &fields));
  hash = hash_fields(hash, fields);
  jalon_fields_release(fields);
  return hash;
}

static inline void segment_with(const jalon_cloud* cloud, const char* method, const char* json,
                                const char* name, uint64_t seed, jalon_task* task) {
  jalon_segmenter* segmenter;
  jalon_params* params;
  jalon_segmentation* segmentation;
  jalon_fields *bins, *normal;
  MUST(jalon_segmenter_create(method, &segmenter));
  MUST(jalon_segmenter_params(segmenter, &params));
  MUST(jalon_params_from_json(params, json));
  MUST(jalon_segmenter_run(segmenter, cloud, task, &segmentation));
  MUST(jalon_segmentation_residuals(segmentation, 0, 20, task, &bins, &normal));
  tell(name, seed, hash_fields(hash_fields(hash_segmentation(kStart, segmentation), bins), normal));
  jalon_fields_release(bins);
  jalon_fields_release(normal);
  jalon_segmentation_release(segmentation);
  jalon_params_release(params);
  jalon_segmenter_release(segmenter);
}

/* Every value of every choice and switch of a method, the others at their defaults. */
static inline void every_choice(const jalon_cloud* cloud, const char* method, uint64_t seed,
                                jalon_task* task) {
  jalon_segmenter* segmenter;
  jalon_params* params;
  uint64_t rows;
  MUST(jalon_segmenter_create(method, &segmenter));
  MUST(jalon_segmenter_params(segmenter, &params));
  MUST(jalon_params_count(params, &rows));
  for (uint64_t i = 0; i < rows; ++i) {
    jalon_param_info info = {.struct_size = sizeof info};
    char values[300], json[300], *rest = values;
    MUST(jalon_params_info(params, i, &info));
    const int is_choice = info.type == JALON_PARAM_CHOICE;
    if (!is_choice && info.type != JALON_PARAM_BOOL) continue;
    snprintf(values, sizeof values, "%s", is_choice ? info.choices : "false|true");
    for (char* value = strtok_r(values, "|", &rest); value != NULL;
         value = strtok_r(NULL, "|", &rest)) {
      const char* quote = is_choice ? "\"" : "";
      snprintf(json, sizeof json, "{\"%s\": %s%s%s}", info.name, quote, value, quote);
      segment_with(cloud, method, json, json, seed, task);
    }
  }
  jalon_params_release(params);
  jalon_segmenter_release(segmenter);
}

/* Random points of a scene, with outliers. */
static inline jalon_cloud* samples_of(const char* scene_name, uint64_t points, uint64_t seed,
                                      jalon_task* task) {
  jalon_params *options, *params;
  jalon_model* scene;
  jalon_scanner* scanner;
  jalon_cloud* cloud;
  MUST(jalon_params_create("scene", &options));
  MUST(jalon_params_set_string(options, "name", scene_name));
  MUST(jalon_scene_create(options, task, &scene));
  MUST(jalon_scanner_create("sample", &scanner));
  MUST(jalon_scanner_params(scanner, &params));
  MUST(jalon_params_set_int64(params, "points", (int64_t)points));
  MUST(jalon_params_set_int64(params, "seed", (int64_t)seed));
  MUST(jalon_params_set_double(params, "noise_m", 0.006));
  MUST(jalon_params_set_double(params, "outliers", 0.02));
  MUST(jalon_scanner_run(scanner, scene, task, &cloud));
  jalon_params_release(params);
  jalon_scanner_release(scanner);
  jalon_model_release(scene);
  jalon_params_release(options);
  return cloud;
}

static inline void segmenters(uint64_t seed, jalon_task* task) {
  const char* const kRows[] = {
      "{\"tolerance_from\": \"estimate\", \"tolerance_dof\": 2}",
      "{\"orientation_order\": \"vertical horizontal inclined parallel\", \"gap_m\": 0, "
      "\"merge_gap_m\": 0}",
      "{\"orientation_order\": \"parallel horizontal\", \"strip_width_m\": 0.3}",
      "{\"draws\": 2000, \"max_planes\": 2, \"least_radius_m\": 0}",
      "{\"connectivity\": false, \"normals\": \"none\", \"sampling\": \"global\", \"refit\": "
      "false, "
      "\"reassign\": false, \"min_points\": 500}"};
  jalon_cloud* cloud = samples_of("surrounds", 12000, seed, task);
  MUST(jalon_cloud_compute_normals(cloud, NULL, task));
  every_choice(cloud, "ransac", seed, task);
  every_choice(cloud, "region_growing", seed, task);
  every_choice(cloud, "raster_growing", seed, task);
  every_choice(cloud, "profiles", seed, task);
  every_choice(cloud, "triangle_growing", seed, task);
  every_choice(cloud, "split_merge", seed, task);
  every_choice(cloud, "hough", seed, task);
  for (size_t i = 0; i < sizeof kRows / sizeof *kRows; ++i)
    segment_with(cloud, "ransac", kRows[i], kRows[i], seed, task);
  jalon_cloud_release(cloud);
}

/* A wall, a column of 0.2 m and a ball of 0.5 m, with 3 mm of noise. */
static inline jalon_cloud* wall_column_ball(uint64_t seed) {
  enum { kEach = 3000 };
  static double xyz[9 * kEach];
  const double pi = 3.14159265358979323846;
  for (uint64_t i = 0; i < kEach; ++i) {
    double *w = xyz + 3 * i, *c = w + 3 * kEach, *b = c + 3 * kEach;
    const double u = uniform(seed, 8 * i), v = uniform(seed, 8 * i + 1);
    const double noise = 0.006 * (uniform(seed, 8 * i + 2) - 0.5), x = cos(2 * pi * u),
                 y = sin(2 * pi * u);
    const double z = 2 * v - 1, column = 0.2 + noise, ball = 0.5 + noise,
                 around = ball * sqrt(1 - z * z);
    w[0] = 4 * u, w[1] = 3 + noise, w[2] = 2 * v;
    c[0] = 2 + column * x, c[1] = column * y, c[2] = 2 * v;
    b[0] = 5 + around * x, b[1] = around * y, b[2] = 1 + ball * z;
  }
  return cloud_of(xyz, 3 * kEach);
}

static inline void picks(uint64_t seed, jalon_task* task) {
  enum { kEach = 3000 };
  const double corners[12] = {-0.1, 3, -0.1, 4.1, 3, -0.1, 4.1, 3, 2.1, -0.1, 3, 2.1};
  const double middle[3] = {2, 3, 1}, round[9] = {2.2, 0, 0.3, 2, 0.2, 1, 1.8, 0, 1.6};
  const double four[12] = {5.5, 0, 1, 5, 0.5, 1, 5, 0, 1.5, 4.5, 0, 1};
  const struct {
    const char* name;
    int32_t primitive;
    const double* picks;
    uint64_t count;
  } kPicks[] = {{"pick of a wall", JALON_PRIMITIVE_PLANE, corners, 4},
                {"pick of a seed", JALON_PRIMITIVE_PLANE, middle, 1},
                {"pick of a column", JALON_PRIMITIVE_CYLINDER, round, 3},
                {"pick of a column by normals", JALON_PRIMITIVE_CYLINDER, round, 2},
                {"pick of a ball", JALON_PRIMITIVE_SPHERE, four, 4},
                {"pick of a ball by normals", JALON_PRIMITIVE_SPHERE, four, 2}};
  jalon_cloud* cloud = wall_column_ball(seed);
  jalon_segmentation *start, *picked;
  segment_with(cloud, "ransac", "{\"primitives\": \"all\"}", "wall, column and ball", seed, task);
  MUST(jalon_segmentation_start(cloud, task, &start));
  for (size_t i = 0; i < sizeof kPicks / sizeof *kPicks; ++i) {
    MUST(jalon_segmentation_pick(start, kPicks[i].primitive, kPicks[i].picks, kPicks[i].count, NULL,
                                 task, &picked));
    tell(kPicks[i].name, seed, hash_segmentation(kStart, picked));
    jalon_segmentation_release(picked);
  }
  static uint64_t indices[2][kEach];
  jalon_fields* fit;
  for (uint64_t i = 0; i < kEach; ++i) indices[0][i] = kEach + i, indices[1][i] = 2 * kEach + i;
  MUST(jalon_cloud_fit_cylinder(cloud, indices[0], kEach, NULL, NULL, task, &fit));
  tell("fit of a cylinder", seed, hash_and_release(fit));
  MUST(jalon_cloud_fit_sphere(cloud, indices[1], kEach, NULL, task, &fit));
  tell("fit of a sphere", seed, hash_and_release(fit));
  jalon_segmentation_release(start);
  jalon_cloud_release(cloud);
}

/* Every scene, sampled and from its automatic stations, with its true planes. */
static inline void every_scene(uint64_t seed, jalon_task* task) {
  jalon_params* options;
  jalon_param_info info = {.struct_size = sizeof info};
  char names[400], *rest = names;
  MUST(jalon_params_create("scene", &options));
  MUST(jalon_params_info(options, 0, &info));
  snprintf(names, sizeof names, "%s", info.choices);
  for (char* name = strtok_r(names, "|", &rest); name != NULL; name = strtok_r(NULL, "|", &rest)) {
    jalon_model* scene;
    MUST(jalon_params_set_string(options, "name", name));
    MUST(jalon_scene_create(options, task, &scene));
    for (int sampled = 0; sampled < 2; ++sampled) {
      jalon_scanner* scanner;
      jalon_params* params;
      jalon_cloud* cloud;
      jalon_fields* truth;
      MUST(jalon_scanner_create(sampled ? "sample" : "static", &scanner));
      MUST(jalon_scanner_params(scanner, &params));
      MUST(jalon_params_from_json(
          params, sampled ? "{\"points\": 3000}"
                          : "{\"horizontal_step_rad\": 0.03, \"vertical_step_rad\": 0.03}"));
      MUST(jalon_scanner_run(scanner, scene, task, &cloud));
      MUST(jalon_scanner_truth(scanner, scene, cloud, task, &truth));
      assert_true(count_of(cloud) > 100);
      tell(name, seed, hash_fields(hash_cloud(kStart, cloud), truth));
      jalon_fields_release(truth);
      jalon_cloud_release(cloud);
      jalon_params_release(params);
      jalon_scanner_release(scanner);
    }
    jalon_model_release(scene);
  }
  jalon_params_release(options);
}

#endif

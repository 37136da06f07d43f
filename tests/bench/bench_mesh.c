/* SPDX-FileCopyrightText: 2026 The Jalon authors
 * SPDX-License-Identifier: Apache-2.0 */

/* bench_mesh PREFIX: distances of PREFIX.f64 from the triangles of PREFIX_mesh13k.f64 and PREFIX_mesh1m.f64 through
 * Jalon's public C interface, signed; the protocol is that of driver.h. The indices of both are part of the time. */

#include <math.h>

#include "jalon_driver.h"

static jalon_model* load_mesh(const char* prefix, const char* suffix) {
  const Points corners = load(prefix, suffix);
  uint32_t* triangles = malloc(corners.count * sizeof *triangles);
  uint64_t i;
  jalon_model* model = NULL;
  if (triangles == NULL) exit(1);
  for (i = 0; i < corners.count; ++i) triangles[i] = (uint32_t)i;
  check(jalon_model_create_mesh(corners.xyz, JALON_FLOAT64, corners.count, 0, triangles,
                                corners.count / 3, NULL, &model));
  free(triangles);
  free(corners.xyz);
  return model;
}

/* The peers give distances without signs. */
static void write_sample(FILE* sample, const jalon_comparison* comparison) {
  jalon_fields* fields = NULL;
  jalon_array_view distance;
  uint64_t i;
  check(jalon_comparison_points(comparison, &fields));
  check(jalon_fields_view(fields, "distance", &distance));
  for (i = 0; i<distance.count; i += distance.count> SAMPLES ? distance.count / SAMPLES : 1) {
    const double value = fabs(((const double*)distance.data)[i]);
    fwrite(&value, sizeof value, 1, sample);
  }
  jalon_fields_release(fields);
}

typedef struct Scene {
  Points points;
  jalon_model *coarse, *fine;
} Scene;

static Result run(const char* name, void* of, jalon_task* task, FILE* sample) {
  const Scene* scene = of;
  const jalon_model* model = strcmp(name, "c2m_1m") == 0 ? scene->fine : scene->coarse;
  jalon_cloud* cloud = NULL;
  jalon_comparer* comparer = NULL;
  jalon_comparison* comparison = NULL;
  double start;
  Result result = {0, scene->points.count};
  check(jalon_cloud_create(scene->points.xyz, JALON_FLOAT64, scene->points.count, 0, 0, &cloud));
  check(jalon_comparer_create("distance", &comparer));
  start = now();
  check(jalon_comparer_run_model(comparer, model, cloud, task, &comparison));
  result.seconds = now() - start;
  if (sample != NULL) write_sample(sample, comparison);
  jalon_comparison_release(comparison);
  jalon_comparer_release(comparer);
  jalon_cloud_release(cloud);
  return result;
}

int main(int argc, char** argv) {
  Scene scene;
  int code;
  if (argc < 2) return 2;
  scene.points = load(argv[1], ".f64");
  scene.coarse = load_mesh(argv[1], "_mesh13k.f64");
  scene.fine = load_mesh(argv[1], "_mesh1m.f64");
  code = serve("c2m_13k,c2m_1m", scene.points.count, &scene, run);
  jalon_model_release(scene.fine);
  jalon_model_release(scene.coarse);
  free(scene.points.xyz);
  return code;
}

/* SPDX-FileCopyrightText: 2026 The Jalon authors
 * SPDX-License-Identifier: Apache-2.0 */

/* memory_compare PREFIX [THREADS]: the peak of comparisons in bytes a point of both clouds (and a
 * triangle, where a cloud is compared with a mesh) beyond clouds and mesh themselves: indices,
 * normals, results and what is held in between. Each in a process of its own, on clouds without an
 * index. Core points are every so many-th reference point, all of them where there are no more. */

#include "memory_driver.h"

enum { CORE_SMALL = 100000, CORE_LARGE = 1000000 };

typedef struct Scene {
  jalon_cloud *reference, *compared, *core;
  jalon_model* model;
  double points, triangles; /* of both clouds, of the mesh */
} Scene;

/* Every so many-th point of a file. */
static jalon_cloud* load_cloud(const char* prefix, const char* suffix, uint64_t most) {
  uint64_t count = 0, step;
  double* xyz = load(prefix, suffix, &count);
  jalon_cloud* cloud = NULL;
  step = most != 0 && count > most ? count / most : 1;
  check(jalon_cloud_create(xyz, JALON_FLOAT64, (count + step - 1) / step, 24 * step, 0, &cloud));
  free(xyz);
  return cloud;
}

static jalon_model* load_mesh(const char* prefix, const char* suffix, double* count) {
  uint64_t corners = 0, i;
  double* xyz = load(prefix, suffix, &corners);
  uint32_t* triangles = malloc(corners * sizeof *triangles);
  jalon_model* model = NULL;
  if (triangles == NULL) exit(1);
  for (i = 0; i < corners; ++i) triangles[i] = (uint32_t)i;
  check(jalon_model_create_mesh(xyz, JALON_FLOAT64, corners, 0, triangles, corners / 3, NULL,
                                &model));
  *count = (double)(corners / 3);
  free(triangles);
  free(xyz);
  return model;
}

static double points_of(const jalon_cloud* cloud) {
  uint64_t count = 0;
  check(jalon_cloud_count(cloud, &count));
  return (double)count;
}

static Scene load_scene(const char* what, const char* prefix) {
  Scene scene = {NULL, NULL, NULL, NULL, 0, 0};
  double most;
  scene.compared = load_cloud(prefix, "_second.f64", 0);
  scene.points = points_of(scene.compared);
  if (strncmp(what, "c2m", 3) == 0) {
    scene.model = load_mesh(prefix, strcmp(what, "c2m_1m") == 0 ? "_mesh1m.f64" : "_mesh13k.f64",
                            &scene.triangles);
    return scene;
  }
  scene.reference = load_cloud(prefix, ".f64", 0);
  scene.points += points_of(scene.reference);
  if (strcmp(what, "c2c") == 0) return scene;
  most = strcmp(what, "m3c2_1m") == 0 ? CORE_LARGE : CORE_SMALL;
  if (most < points_of(scene.reference)) scene.core = load_cloud(prefix, ".f64", (uint64_t)most);
  else scene.core = jalon_cloud_retain(scene.reference);
  return scene;
}

static void release_scene(const Scene* scene) {
  jalon_cloud_release(scene->core);
  jalon_cloud_release(scene->reference);
  jalon_cloud_release(scene->compared);
  jalon_model_release(scene->model);
}

static jalon_comparison* compare(const Scene* scene, jalon_task* task) {
  jalon_comparer* comparer = NULL;
  jalon_comparison* comparison = NULL;
  check(jalon_comparer_create(scene->core != NULL ? "m3c2" : "distance", &comparer));
  if (scene->core != NULL)
    check(jalon_comparer_run_core(comparer, scene->reference, scene->compared, scene->core, task,
                                  &comparison));
  else if (scene->model != NULL)
    check(jalon_comparer_run_model(comparer, scene->model, scene->compared, task, &comparison));
  else check(jalon_comparer_run(comparer, scene->reference, scene->compared, task, &comparison));
  jalon_comparer_release(comparer);
  return comparison;
}

/* A small comparison first, so that the library's own pages, which are not a comparison's, are there already. */
static void warm_up(jalon_task* task) {
  enum { POINTS = 4096 };
  static double xyz[3 * POINTS];
  Scene scene = {NULL, NULL, NULL, NULL, 2 * POINTS, 0};
  int i;
  for (i = 0; i < POINTS; ++i) {
    xyz[3 * i] = 0.1 * (i % 64);
    xyz[3 * i + 1] = 0.1 * (i / 64);
  }
  check(jalon_cloud_create(xyz, JALON_FLOAT64, POINTS, 0, 0, &scene.reference));
  check(jalon_cloud_create(xyz, JALON_FLOAT64, POINTS, 0, 0, &scene.compared));
  jalon_comparison_release(compare(&scene, task));
  scene.core = jalon_cloud_retain(scene.reference);
  jalon_comparison_release(compare(&scene, task));
  release_scene(&scene);
}

/* Pages of the library are resident from the start: the file that holds them is not the comparison's. */
static void measure(const char* what, const char* prefix, const char* threads) {
  jalon_task* task = new_task(threads);
  jalon_comparison* comparison;
  Scene scene;
  double before, peak, each;
  warm_up(task);
  scene = load_scene(what, prefix);
  malloc_trim(0);
  before = process_bytes("RssAnon:");
  reset_peak();
  comparison = compare(&scene, task);
  peak = process_bytes("VmHWM:") - process_bytes("RssFile:");
  malloc_trim(0);
  each = scene.points + scene.triangles;
  printf("memory|%s|%.0f|%.0f|%.1f|%.1f\n", what, scene.points, scene.triangles,
         (process_bytes("RssAnon:") - before) / each, (peak - before) / each);
  fflush(stdout);
  jalon_comparison_release(comparison);
  jalon_task_release(task);
  release_scene(&scene);
}

int main(int argc, char** argv) {
  static const char* const operations[] = {"c2c", "c2m_13k", "c2m_1m", "m3c2_100k", "m3c2_1m"};
  const char* threads = argc > 2 ? argv[2] : "2";
  size_t i;
  if (argc < 2) return 2;
  printf("memory|operation|points|triangles|bytes each with the result|peak bytes each\n");
  fflush(stdout); /* or the children would print it again */
  for (i = 0; i < sizeof operations / sizeof *operations; ++i)
    measure_apart(measure, operations[i], argv[1], threads);
  return 0;
}

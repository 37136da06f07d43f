/* SPDX-FileCopyrightText: 2026 The Jalon authors
 * SPDX-License-Identifier: Apache-2.0 */

/* memory_jalon PREFIX [THREADS]: bytes a point of a cloud with its index and float normals (k =
 * 16), and of a cloud without either while it is segmented, from the resident set of this process less
 * what it held before; Linux only. The caller's own array is freed before the first measurement. */

#include "memory_driver.h"

static void report(const char* stage, double before, double count) {
  const double peak = process_bytes("VmHWM:");
  malloc_trim(0); /* what the allocator keeps is not the cloud's */
  printf("memory|%s|%.0f|%.1f|%.1f\n", stage, count, (process_bytes("VmRSS:") - before) / count,
         (peak - before) / count);
  fflush(stdout);
}

/* A small cloud first, so that the library's own pages, which are not a cloud's, are there already.
 */
static void warm_up(const jalon_params* options, jalon_task* task) {
  enum { POINTS = 4096 };
  static double xyz[3 * POINTS];
  jalon_cloud* cloud = NULL;
  int i;
  for (i = 0; i < POINTS; ++i) {
    xyz[3 * i] = i % 64;
    xyz[3 * i + 1] = i / 64;
  }
  check(jalon_cloud_create(xyz, JALON_FLOAT64, POINTS, 0, 0, &cloud));
  check(jalon_cloud_prepare(cloud, task));
  check(jalon_cloud_compute_normals(cloud, options, task));
  jalon_cloud_release(cloud);
}

static void segment(const char* method, const char* prefix, const char* threads) {
  uint64_t count = 0;
  double before;
  double* xyz;
  jalon_cloud* cloud = NULL;
  jalon_segmenter* segmenter = NULL;
  jalon_segmentation* segmentation = NULL;
  jalon_task* task = new_task(threads);
  warm_up(NULL, task);
  malloc_trim(0);
  before = process_bytes("VmRSS:");
  xyz = load(prefix, ".f64", &count);
  check(jalon_cloud_create(xyz, JALON_FLOAT64, count, 0, 0, &cloud));
  free(xyz);
  check(jalon_segmenter_create(method, &segmenter));
  reset_peak();
  check(jalon_segmenter_run(segmenter, cloud, task, &segmentation));
  report(method, before, (double)count);
  jalon_segmentation_release(segmentation);
  jalon_segmenter_release(segmenter);
  jalon_cloud_release(cloud);
  jalon_task_release(task);
}

int main(int argc, char** argv) {
  uint64_t count = 0;
  double* xyz;
  double before, with_input;
  const char* threads = argc > 2 ? argv[2] : "2";
  jalon_task* task;
  jalon_params* options = NULL;
  jalon_cloud* cloud = NULL;
  if (argc < 2) return 2;
  printf("memory|stage|points|bytes a point now|peak bytes a point\n");
  fflush(stdout); /* or the children would print it again */
  measure_apart(segment, "ransac", argv[1], threads);
  measure_apart(segment, "region_growing", argv[1], threads);
  task = new_task(threads);
  check(jalon_params_create("normals", &options));
  check(jalon_params_set_string(options, "method", "pca"));
  check(jalon_params_set_int64(options, "k", 16));

  warm_up(options, task);
  malloc_trim(0);
  before = process_bytes("VmRSS:");
  xyz = load(argv[1], ".f64", &count);
  with_input = process_bytes("VmRSS:") - before;
  reset_peak();
  check(jalon_cloud_create(xyz, JALON_FLOAT64, count, 0, 0, &cloud));
  free(xyz);
  report("create (peak less the caller's array)", before, (double)count);
  printf("memory|caller's array|%llu|%.1f|\n", (unsigned long long)count,
         with_input / (double)count);
  reset_peak();
  check(jalon_cloud_prepare(cloud, task));
  report("prepare", before, (double)count);
  reset_peak();
  check(jalon_cloud_compute_normals(cloud, options, task));
  report("normals", before, (double)count);
  jalon_cloud_release(cloud);
  report("release", before, (double)count);
  jalon_params_release(options);
  jalon_task_release(task);
  return 0;
}

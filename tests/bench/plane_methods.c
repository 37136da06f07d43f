/* SPDX-FileCopyrightText: 2026 The Jalon authors
 * SPDX-License-Identifier: Apache-2.0 */

/* plane_methods PREFIX [THREADS [METHOD ...]]: the methods that find planes, with their defaults or with settings as
 * JSON behind the name, raster_growing{"projection": "main"}, on a scene of street_scene, each in a process of its own:
 * by the clock, in processor seconds, the peak in bytes a point, and a hash of labels, residuals and planes, by which
 * two builds are compared. Linux only. */

#include <time.h>

#include "memory_driver.h"

static double clock_seconds(clockid_t clock) {
  struct timespec t;
  clock_gettime(clock, &t);
  return (double)t.tv_sec + 1e-9 * (double)t.tv_nsec;
}

/* Fowler, Noll and Vo 1991, over words. */
static uint64_t hash_column(uint64_t hash, const jalon_fields* fields, const char* name,
                            uint64_t element_bytes) {
  jalon_array_view view;
  uint64_t i, bytes;
  check(jalon_fields_view(fields, name, &view));
  bytes = view.count * view.components * element_bytes;
  for (i = 0; i + 4 <= bytes; i += 4) {
    uint32_t word;
    memcpy(&word, (const char*)view.data + i, sizeof word);
    hash = (hash ^ word) * UINT64_C(1099511628211);
  }
  return hash;
}

/* From the method's name and what stands behind it. */
static jalon_segmenter* new_segmenter(const char* text) {
  const char* settings = strchr(text, '{');
  char method[LINE_BYTES];
  jalon_segmenter* segmenter = NULL;
  jalon_params* params = NULL;
  snprintf(method, sizeof method, "%.*s", (int)strcspn(text, "{"), text);
  check(jalon_segmenter_create(method, &segmenter));
  if (settings == NULL) return segmenter;
  check(jalon_segmenter_params(segmenter, &params));
  check(jalon_params_from_json(params, settings));
  jalon_params_release(params);
  return segmenter;
}

static void run(const char* method, const char* prefix, const char* threads) {
  static const char* const columns[] = {"normal", "offset", "centroid",
                                        "sigma",  "area",   "covariance"};
  uint64_t count = 0, hash = UINT64_C(14695981039346656037), i;
  jalon_cloud* cloud = NULL;
  jalon_segmenter* segmenter = NULL;
  jalon_segmentation* segmentation = NULL;
  jalon_fields *points = NULL, *segments = NULL;
  jalon_array_view labels;
  jalon_task* task = new_task(threads);
  double* xyz = load(prefix, ".f64", &count);
  double before, clock, processor;
  check(jalon_cloud_create(xyz, JALON_FLOAT64, count, 0, 0, &cloud));
  free(xyz);
  malloc_trim(0);
  before = process_bytes("VmRSS:") - 24.0 * (double)count;
  reset_peak();
  segmenter = new_segmenter(method);
  clock = clock_seconds(CLOCK_MONOTONIC), processor = clock_seconds(CLOCK_PROCESS_CPUTIME_ID);
  check(jalon_segmenter_run(segmenter, cloud, task, &segmentation));
  clock = clock_seconds(CLOCK_MONOTONIC) - clock;
  processor = clock_seconds(CLOCK_PROCESS_CPUTIME_ID) - processor;
  check(jalon_segmentation_points(segmentation, &points));
  check(jalon_segmentation_segments(segmentation, &segments));
  check(jalon_fields_view(segments, "label", &labels));
  hash = hash_column(hash, points, "label", 4);
  hash = hash_column(hash, points, "residual", 4);
  for (i = 0; i < sizeof columns / sizeof *columns; ++i)
    hash = hash_column(hash, segments, columns[i], 8);
  printf(
      "%-17s %9llu points, %s threads: %6.2f s, processor %6.2f s, %4llu segments, peak %5.1f B a "
      "point, %016llx\n",
      method, (unsigned long long)count, threads, clock, processor,
      (unsigned long long)labels.count, (process_bytes("VmHWM:") - before) / (double)count,
      (unsigned long long)hash);
  fflush(stdout);
  jalon_fields_release(points);
  jalon_fields_release(segments);
  jalon_segmentation_release(segmentation);
  jalon_segmenter_release(segmenter);
  jalon_cloud_release(cloud);
  jalon_task_release(task);
}

int main(int argc, char** argv) {
  static const char* const methods[] = {"ransac",   "region_growing", "raster_growing",
                                        "profiles", "split_merge",    "triangle_growing",
                                        "hough"};
  const char* threads = argc > 2 ? argv[2] : "2";
  if (argc < 2) return 2;
  if (argc > 3)
    for (int i = 3; i < argc; ++i) measure_apart(run, argv[i], argv[1], threads);
  else
    for (size_t i = 0; i < sizeof methods / sizeof *methods; ++i)
      measure_apart(run, methods[i], argv[1], threads);
  return 0;
}

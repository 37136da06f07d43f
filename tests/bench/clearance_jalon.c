/* SPDX-FileCopyrightText: 2026 The Jalon authors
 * SPDX-License-Identifier: Apache-2.0 */

/* clearance_jalon [POINTS [POSES [THREADS]]]: a tunnel of 500 m on a curve of 400 m, scanned with
 * 5 mm of roughness, and a gauge of three boxes and a cylinder along its axis; wall and processor
 * seconds of the index and of the sweep, and the peak of the resident set. */

#include <jalon/jalon.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/resource.h>
#include <time.h>

static const double kLength_m = 500, kCurve_m = 400, kRadius_m = 3.2;

static void check(jalon_status status) {
  if (status == JALON_OK) return;
  fprintf(stderr, "jalon: %s\n", jalon_last_error_message());
  exit(1);
}

static double wall(void) {
  struct timespec t;
  clock_gettime(CLOCK_MONOTONIC, &t);
  return (double)t.tv_sec + 1e-9 * (double)t.tv_nsec;
}

/* A number in [0, 1) of its arguments alone. */
static double uniform(uint64_t i, uint64_t k) {
  uint64_t z = (3 * i + k + 1) * 0x9E3779B97F4A7C15u;
  z = (z ^ (z >> 30)) * 0xBF58476D1CE4E5B9u;
  z = (z ^ (z >> 27)) * 0x94D049BB133111EBu;
  return (double)((z ^ (z >> 31)) >> 11) * 0x1p-53;
}

/* The frame of the axis at a chainage: x ahead, z up. */
static jalon_transform on_axis(double s_m) {
  const double a = s_m / kCurve_m;
  const jalon_transform t = {{cos(a), -sin(a), 0, kCurve_m * sin(a), sin(a), cos(a), 0,
                              kCurve_m * (1 - cos(a)), 0, 0, 1, 0}};
  return t;
}

static jalon_cloud* tunnel(uint64_t points) {
  double* xyz = malloc((size_t)points * 24);
  jalon_cloud* cloud = NULL;
  if (xyz == NULL) exit(1);
  for (uint64_t i = 0; i < points; ++i) {
    const jalon_transform t = on_axis(kLength_m * uniform(i, 0));
    const double angle = 6.283185307179586 * uniform(i, 1),
                 r = kRadius_m + 0.005 * (uniform(i, 2) - 0.5);
    const double y = r * cos(angle), z = r * sin(angle);
    for (int k = 0; k < 3; ++k)
      xyz[3 * i + (uint64_t)k] = t.m[4 * k + 1] * y + t.m[4 * k + 2] * z + t.m[4 * k + 3];
  }
  check(jalon_cloud_create(xyz, JALON_FLOAT64, points, 0, 0, &cloud));
  free(xyz);
  return cloud;
}

int main(int argc, char** argv) {
  const uint64_t points = argc > 1 ? strtoull(argv[1], NULL, 10) : 10000000;
  const uint64_t count = argc > 2 ? strtoull(argv[2], NULL, 10) : 500;
  const uint32_t threads = argc > 3 ? (uint32_t)strtoul(argv[3], NULL, 10) : 0;
  const jalon_gauge_piece gauge[4] = {
      {JALON_GAUGE_BOX, 0, {{1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, -0.2}}, {18, 3.0, 3.4}, 0, 0},
      {JALON_GAUGE_BOX, 0, {{1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0}}, {18, 3.6, 2.0}, 0, 0},
      {JALON_GAUGE_BOX, 0, {{1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 1.8}}, {4, 1.8, 1.2}, 0, 0},
      {JALON_GAUGE_CYLINDER, 0, {{0, 0, 1, 0, 1, 0, 0, 0, 0, 1, 0, 2.3}}, {0.6, 0, 1.5}, 0, 0}};
  jalon_transform* poses = malloc((size_t)count * sizeof *poses);
  jalon_cloud* cloud = tunnel(points);
  jalon_task* task = NULL;
  jalon_params* options = NULL;
  jalon_fields *places = NULL, *intervals = NULL;
  jalon_array_view view;
  struct rusage before, after;
  double start, index, sweep;
  for (uint64_t i = 0; i < count; ++i)
    poses[i] = on_axis(10 + (kLength_m - 20) * (double)i / (double)(count - 1));
  check(jalon_task_create(&task));
  check(jalon_task_set_threads(task, threads));
  check(jalon_params_create("clearance", &options));
  check(jalon_params_set_double(options, "margin_m", 0.25));
  start = wall();
  check(jalon_cloud_prepare(cloud, task));
  index = wall() - start;
  getrusage(RUSAGE_SELF, &before);
  start = wall();
  check(jalon_gauge_sweep(gauge, 4, NULL, 0, poses, count, cloud, NULL, options, task, &places,
                          &intervals));
  sweep = wall() - start;
  getrusage(RUSAGE_SELF, &after);
  check(jalon_fields_view(places, "clearance", &view));
  printf(
      "%llu points, %llu poses, %u threads: index %.2f s, sweep %.2f s (%.2f s of processors), "
      "%llu places, "
      "peak %.1f B a point\n",
      (unsigned long long)points, (unsigned long long)count, threads, index, sweep,
      (double)(after.ru_utime.tv_sec - before.ru_utime.tv_sec) +
          1e-6 * (double)(after.ru_utime.tv_usec - before.ru_utime.tv_usec),
      (unsigned long long)view.count, 1024.0 * (double)after.ru_maxrss / (double)points);
  jalon_fields_release(places);
  jalon_fields_release(intervals);
  jalon_params_release(options);
  jalon_task_release(task);
  jalon_cloud_release(cloud);
  free(poses);
  return 0;
}

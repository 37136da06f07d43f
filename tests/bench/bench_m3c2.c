/* SPDX-FileCopyrightText: 2026 The Jalon authors
 * SPDX-License-Identifier: Apache-2.0 */

/* bench_m3c2 PREFIX: Jalon's comparer "m3c2" through its public C interface, PREFIX.f64 against PREFIX_second.f64; the
 * protocol is that of driver.h. Indices are part of the time; the core points are every so many-th reference point. */

#include <jalon/jalon.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>

enum { SAMPLES = 2000, LINE_BYTES = 4096 };

typedef struct Points {
  double* xyz;
  uint64_t count;
} Points;

static void check(jalon_status status) {
  if (status == JALON_OK) return;
  fprintf(stderr, "jalon: %s\n", jalon_last_error_message());
  exit(1);
}

static double now(void) {
  struct timespec t;
  clock_gettime(CLOCK_MONOTONIC, &t);
  return (double)t.tv_sec + 1e-9 * (double)t.tv_nsec;
}

static Points load(const char* prefix, const char* suffix) {
  char path[LINE_BYTES];
  FILE* file;
  long bytes;
  Points points;
  snprintf(path, sizeof path, "%s%s", prefix, suffix);
  file = fopen(path, "rb");
  if (file == NULL || fseek(file, 0, SEEK_END) != 0 || (bytes = ftell(file)) <= 0) {
    fprintf(stderr, "cannot read %s\n", path);
    exit(1);
  }
  rewind(file);
  points.count = (uint64_t)bytes / 24;
  points.xyz = malloc((size_t)bytes);
  if (points.xyz == NULL || fread(points.xyz, 24, points.count, file) != points.count) exit(1);
  fclose(file);
  return points;
}

static jalon_cloud* cloud_of(const Points* points, uint64_t step) {
  jalon_cloud* cloud = NULL;
  check(jalon_cloud_create(points->xyz, JALON_FLOAT64, (points->count + step - 1) / step, 24 * step, 0, &cloud));
  return cloud;
}

static void write_sample(FILE* sample, const jalon_comparison* comparison) {
  jalon_fields* fields = NULL;
  jalon_array_view distance;
  uint64_t i;
  check(jalon_comparison_points(comparison, &fields));
  check(jalon_fields_view(fields, "distance", &distance));
  for (i = 0; i < distance.count; i += distance.count > SAMPLES ? distance.count / SAMPLES : 1) {
    fwrite((const double*)distance.data + i, sizeof(double), 1, sample);
  }
  jalon_fields_release(fields);
}

/* Normals within 0.25 m, cylinders of 0.15 m radius and 1 m to either side: the defaults. */
static double run(const Points* epochs, uint64_t core_count, jalon_task* task, FILE* sample) {
  const uint64_t step = epochs[0].count > core_count ? epochs[0].count / core_count : 1;
  jalon_cloud *reference = cloud_of(&epochs[0], 1), *compared = cloud_of(&epochs[1], 1);
  jalon_cloud* core = cloud_of(&epochs[0], step);
  jalon_comparer* comparer = NULL;
  jalon_comparison* comparison = NULL;
  double start, seconds;
  check(jalon_comparer_create("m3c2", &comparer));
  start = now();
  check(jalon_comparer_run_core(comparer, reference, compared, core, task, &comparison));
  seconds = now() - start;
  if (sample != NULL) write_sample(sample, comparison);
  jalon_comparison_release(comparison);
  jalon_comparer_release(comparer);
  jalon_cloud_release(core);
  jalon_cloud_release(compared);
  jalon_cloud_release(reference);
  return seconds;
}

int main(int argc, char** argv) {
  char line[LINE_BYTES];
  Points epochs[2];
  if (argc < 2) return 2;
  epochs[0] = load(argv[1], ".f64");
  epochs[1] = load(argv[1], "_second.f64");
  printf("ready|Jalon|m3c2_100k,m3c2_1m\n");
  fflush(stdout);
  while (fgets(line, sizeof line, stdin) != NULL) {
    char name[64] = "", path[LINE_BYTES] = "";
    unsigned threads = 1;
    const int fields = sscanf(line, "%63s %u %4095s", name, &threads, path);
    const uint64_t core_count = strcmp(name, "m3c2_1m") == 0 ? 1000000 : 100000;
    FILE* sample = fields == 3 ? fopen(path, "wb") : NULL;
    jalon_task* task = NULL;
    double seconds;
    if (fields < 2 || (fields == 3 && sample == NULL)) return 1;
    check(jalon_task_create(&task));
    check(jalon_task_set_threads(task, threads));
    seconds = run(epochs, core_count, task, sample);
    jalon_task_release(task);
    if (sample != NULL && fclose(sample) != 0) return 1;
    printf("Jalon|%s|%llu|%u|%.6f|%llu\n", name, (unsigned long long)epochs[0].count, threads, seconds,
           (unsigned long long)core_count);
    fflush(stdout);
  }
  free(epochs[0].xyz);
  free(epochs[1].xyz);
  return 0;
}

/* SPDX-FileCopyrightText: 2026 The Jalon authors
 * SPDX-License-Identifier: Apache-2.0 */

/* bench_mesh PREFIX: distances of PREFIX.f64 from the triangles of PREFIX_mesh13k.f64 and PREFIX_mesh1m.f64 through
 * Jalon's public C interface, signed; the protocol is that of driver.h. The indices of both are part of the time. */

#include <jalon/jalon.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>

enum { SAMPLES = 2000, LINE_BYTES = 4096 };

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

/* Rows of three doubles. */
static double* load(const char* prefix, const char* suffix, uint64_t* count) {
  char path[LINE_BYTES];
  FILE* file;
  long bytes;
  double* rows;
  snprintf(path, sizeof path, "%s%s", prefix, suffix);
  file = fopen(path, "rb");
  if (file == NULL || fseek(file, 0, SEEK_END) != 0 || (bytes = ftell(file)) <= 0) {
    fprintf(stderr, "cannot read %s\n", path);
    exit(1);
  }
  rewind(file);
  *count = (uint64_t)bytes / 24;
  rows = malloc((size_t)bytes);
  if (rows == NULL || fread(rows, 24, *count, file) != *count) exit(1);
  fclose(file);
  return rows;
}

static jalon_model* load_mesh(const char* prefix, const char* suffix) {
  uint64_t corners, i;
  double* xyz = load(prefix, suffix, &corners);
  uint32_t* triangles = malloc(corners * sizeof *triangles);
  jalon_model* model = NULL;
  if (triangles == NULL) exit(1);
  for (i = 0; i < corners; ++i) triangles[i] = (uint32_t)i;
  check(jalon_model_create_mesh(xyz, JALON_FLOAT64, corners, 0, triangles, corners / 3, NULL, &model));
  free(triangles);
  free(xyz);
  return model;
}

/* The peers give distances without signs. */
static void write_sample(FILE* sample, const jalon_comparison* comparison) {
  jalon_fields* fields = NULL;
  jalon_array_view distance;
  uint64_t i;
  check(jalon_comparison_points(comparison, &fields));
  check(jalon_fields_view(fields, "distance", &distance));
  for (i = 0; i < distance.count; i += distance.count > SAMPLES ? distance.count / SAMPLES : 1) {
    const double value = fabs(((const double*)distance.data)[i]);
    fwrite(&value, sizeof value, 1, sample);
  }
  jalon_fields_release(fields);
}

static double run(const double* xyz, uint64_t count, const jalon_model* model, jalon_task* task, FILE* sample) {
  jalon_cloud* cloud = NULL;
  jalon_comparer* comparer = NULL;
  jalon_comparison* comparison = NULL;
  double start, seconds;
  check(jalon_cloud_create(xyz, JALON_FLOAT64, count, 0, 0, &cloud));
  check(jalon_comparer_create("distance", &comparer));
  start = now();
  check(jalon_comparer_run_model(comparer, model, cloud, task, &comparison));
  seconds = now() - start;
  if (sample != NULL) write_sample(sample, comparison);
  jalon_comparison_release(comparison);
  jalon_comparer_release(comparer);
  jalon_cloud_release(cloud);
  return seconds;
}

int main(int argc, char** argv) {
  char line[LINE_BYTES];
  double* xyz;
  uint64_t count;
  jalon_model *coarse, *fine;
  if (argc < 2) return 2;
  xyz = load(argv[1], ".f64", &count);
  coarse = load_mesh(argv[1], "_mesh13k.f64");
  fine = load_mesh(argv[1], "_mesh1m.f64");
  printf("ready|Jalon|c2m_13k,c2m_1m\n");
  fflush(stdout);
  while (fgets(line, sizeof line, stdin) != NULL) {
    char name[64] = "", path[LINE_BYTES] = "";
    unsigned threads = 1;
    const int fields = sscanf(line, "%63s %u %4095s", name, &threads, path);
    FILE* sample = fields == 3 ? fopen(path, "wb") : NULL;
    jalon_task* task = NULL;
    double seconds;
    if (fields < 2 || (fields == 3 && sample == NULL)) return 1;
    check(jalon_task_create(&task));
    check(jalon_task_set_threads(task, threads));
    seconds = run(xyz, count, strcmp(name, "c2m_1m") == 0 ? fine : coarse, task, sample);
    jalon_task_release(task);
    if (sample != NULL && fclose(sample) != 0) return 1;
    printf("Jalon|%s|%llu|%u|%.6f|%llu\n", name, (unsigned long long)count, threads, seconds,
           (unsigned long long)count);
    fflush(stdout);
  }
  jalon_model_release(fine);
  jalon_model_release(coarse);
  free(xyz);
  return 0;
}

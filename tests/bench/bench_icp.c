/* SPDX-FileCopyrightText: 2026 The Jalon authors
 * SPDX-License-Identifier: Apache-2.0 */

/* bench_icp PREFIX: Jalon's registrar "icp" with its defaults through its public C interface, PREFIX_moved.f64 onto
 * PREFIX.f64; the protocol is that of driver.h. Indices and normals are part of the time; the sample is the pose. */

#include <jalon/jalon.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>

enum { LINE_BYTES = 4096 };

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

static uint64_t iterations_of(const jalon_registration* registration) {
  jalon_fields* fields = NULL;
  jalon_array_view iterations;
  uint64_t count;
  check(jalon_registration_summary(registration, &fields));
  check(jalon_fields_view(fields, "iterations", &iterations));
  count = *(const uint64_t*)iterations.data;
  jalon_fields_release(fields);
  return count;
}

static double run(const Points* points, jalon_task* task, FILE* sample, uint64_t* iterations) {
  jalon_cloud *reference = NULL, *moving = NULL;
  jalon_registrar* registrar = NULL;
  jalon_registration* registration = NULL;
  jalon_transform pose;
  double start, seconds;
  check(jalon_cloud_create(points[0].xyz, JALON_FLOAT64, points[0].count, 24, 0, &reference));
  check(jalon_cloud_create(points[1].xyz, JALON_FLOAT64, points[1].count, 24, 0, &moving));
  check(jalon_registrar_create("icp", &registrar));
  start = now();
  check(jalon_registrar_run(registrar, reference, moving, NULL, task, &registration));
  seconds = now() - start;
  check(jalon_registration_pose(registration, &pose));
  if (sample != NULL) fwrite(pose.m, sizeof(double), 12, sample);
  *iterations = iterations_of(registration);
  jalon_registration_release(registration);
  jalon_registrar_release(registrar);
  jalon_cloud_release(moving);
  jalon_cloud_release(reference);
  return seconds;
}

int main(int argc, char** argv) {
  char line[LINE_BYTES];
  Points points[2];
  if (argc < 2) return 2;
  points[0] = load(argv[1], ".f64");
  points[1] = load(argv[1], "_moved.f64");
  printf("ready|Jalon|icp\n");
  fflush(stdout);
  while (fgets(line, sizeof line, stdin) != NULL) {
    char name[64] = "", path[LINE_BYTES] = "";
    unsigned threads = 1;
    const int fields = sscanf(line, "%63s %u %4095s", name, &threads, path);
    FILE* sample = fields == 3 ? fopen(path, "wb") : NULL;
    jalon_task* task = NULL;
    uint64_t iterations = 0;
    double seconds;
    if (fields < 2 || (fields == 3 && sample == NULL)) return 1;
    check(jalon_task_create(&task));
    check(jalon_task_set_threads(task, threads));
    seconds = run(points, task, sample, &iterations);
    jalon_task_release(task);
    if (sample != NULL && fclose(sample) != 0) return 1;
    printf("Jalon|%s|%llu|%u|%.6f|%llu\n", name, (unsigned long long)points[0].count, threads, seconds,
           (unsigned long long)iterations);
    fflush(stdout);
  }
  free(points[0].xyz);
  free(points[1].xyz);
  return 0;
}

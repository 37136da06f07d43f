/* SPDX-FileCopyrightText: 2026 The Jalon authors
 * SPDX-License-Identifier: Apache-2.0 */

/* What Jalon's drivers have in common, in C: the protocol of driver.h, and the files of coordinates. */
#ifndef BENCH_JALON_DRIVER_H
#define BENCH_JALON_DRIVER_H

#include <jalon/jalon.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>

enum { SAMPLES = 2000, LINE_BYTES = 4096 };

/* Rows of three doubles. */
typedef struct Points {
  double* xyz;
  uint64_t count;
} Points;

/* Of one run: the time taken, and the count that the protocol prints. */
typedef struct Result {
  double seconds;
  uint64_t count;
} Result;

static inline void check(jalon_status status) {
  if (status == JALON_OK) return;
  fprintf(stderr, "jalon: %s\n", jalon_last_error_message());
  exit(1);
}

static inline double now(void) {
  struct timespec t;
  clock_gettime(CLOCK_MONOTONIC, &t);
  return (double)t.tv_sec + 1e-9 * (double)t.tv_nsec;
}

/* The coordinates in PREFIX + suffix; ends the program when there are none. */
static inline Points load(const char* prefix, const char* suffix) {
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

/* Says which operations there are (their names, separated by commas), then does what standard input asks for. run does
 * one of them on the scene and writes its sample where there is a file for it. Status of the program. */
static inline int serve(const char* names, uint64_t points, void* scene,
                        Result (*run)(const char* name, void* scene, jalon_task* task,
                                      FILE* sample)) {
  char line[LINE_BYTES];
  printf("ready|Jalon|%s\n", names);
  fflush(stdout);
  while (fgets(line, sizeof line, stdin) != NULL) {
    char name[64] = "", path[LINE_BYTES] = "";
    unsigned threads = 1;
    const int fields = sscanf(line, "%63s %u %4095s", name, &threads, path);
    FILE* sample = fields == 3 ? fopen(path, "wb") : NULL;
    jalon_task* task = NULL;
    Result result;
    if (fields < 2 || (fields == 3 && sample == NULL)) return 1;
    check(jalon_task_create(&task));
    check(jalon_task_set_threads(task, threads));
    result = run(name, scene, task, sample);
    jalon_task_release(task);
    if (sample != NULL && fclose(sample) != 0) return 1;
    printf("Jalon|%s|%llu|%u|%.6f|%llu\n", name, (unsigned long long)points, threads,
           result.seconds, (unsigned long long)result.count);
    fflush(stdout);
  }
  return 0;
}

#endif

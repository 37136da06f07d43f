/* SPDX-FileCopyrightText: 2026 The Jalon authors
 * SPDX-License-Identifier: Apache-2.0 */

/* What the programs that measure memory share: the resident set of this process, and the scene's points. Linux only. */

#ifndef JALON_BENCH_MEMORY_DRIVER_H
#define JALON_BENCH_MEMORY_DRIVER_H

#include <fcntl.h>
#include <jalon/jalon.h>
#include <malloc.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/wait.h>
#include <unistd.h>

enum { LINE_BYTES = 4096 };

static void check(jalon_status status) {
  if (status == JALON_OK) return;
  fprintf(stderr, "jalon: %s\n", jalon_last_error_message());
  exit(1);
}

/* A line of /proc/self/status, e.g. "VmRSS:", in bytes. */
static double process_bytes(const char* key) {
  char line[256];
  double kilobytes = 0;
  FILE* file = fopen("/proc/self/status", "r");
  if (file == NULL) exit(1);
  while (fgets(line, sizeof line, file) != NULL) {
    if (strncmp(line, key, strlen(key)) == 0)
      kilobytes = (double)strtoul(line + strlen(key), NULL, 10);
  }
  fclose(file);
  return 1024 * kilobytes;
}

/* VmHWM starts again from the present resident set. */
static void reset_peak(void) {
  const int file = open("/proc/self/clear_refs", O_WRONLY);
  if (file < 0 || write(file, "5", 1) != 1) {
    fprintf(stderr, "cannot reset the peak of the resident set\n");
    exit(1);
  }
  close(file);
}

/* Rows of three doubles. */
static inline double* load(const char* prefix, const char* suffix, uint64_t* count) {
  char path[LINE_BYTES];
  double* xyz;
  long bytes;
  FILE* file;
  snprintf(path, sizeof path, "%s%s", prefix, suffix);
  file = fopen(path, "rb");
  if (file == NULL || fseek(file, 0, SEEK_END) != 0 || (bytes = ftell(file)) <= 0) exit(1);
  rewind(file);
  *count = (uint64_t)bytes / 24;
  xyz = malloc((size_t)bytes);
  if (xyz == NULL || fread(xyz, 24, *count, file) != *count) exit(1);
  fclose(file);
  return xyz;
}

static jalon_task* new_task(const char* threads) {
  jalon_task* task = NULL;
  check(jalon_task_create(&task));
  check(jalon_task_set_threads(task, (uint32_t)strtoul(threads, NULL, 10)));
  return task;
}

/* In a process of its own, so that what one left with the allocator is not the next one's. */
static void measure_apart(void (*measure)(const char*, const char*, const char*), const char* what,
                          const char* prefix, const char* threads) {
  int status = 0;
  const pid_t child = fork();
  if (child == 0) {
    measure(what, prefix, threads);
    exit(0);
  }
  if (child < 0 || waitpid(child, &status, 0) != child || status != 0) exit(1);
}

#endif

/* SPDX-FileCopyrightText: 2026 The Jalon authors
 * SPDX-License-Identifier: Apache-2.0 */

/* code_methods SCAN SURVEY TARGETS [THREADS]: both methods by feature codes in both forms, each in a process of its
 * own: by the clock, in processor seconds, points a processor second, and the peak in bytes a point beyond the scan.
 * Linux only. */

#include <time.h>

#include "memory_driver.h"

static double clock_seconds(clockid_t clock) {
  struct timespec t;
  clock_gettime(clock, &t);
  return (double)t.tv_sec + 1e-9 * (double)t.tv_nsec;
}

static char* text_of_file(const char* path) {
  long bytes;
  char* text;
  FILE* file = fopen(path, "rb");
  if (file == NULL || fseek(file, 0, SEEK_END) != 0 || (bytes = ftell(file)) < 0) exit(1);
  rewind(file);
  text = calloc((size_t)bytes + 1, 1);
  if (text == NULL || fread(text, 1, (size_t)bytes, file) != (size_t)bytes) exit(1);
  fclose(file);
  return text;
}

static const char* scan;

/* what: "METHOD FORM". */
static void run(const char* what, const char* codes, const char* threads) {
  char method[LINE_BYTES], form[LINE_BYTES];
  uint64_t count = 0;
  double before, clock, processor, peak;
  jalon_cloud* cloud = NULL;
  jalon_segmenter* segmenter = NULL;
  jalon_params* params = NULL;
  jalon_segmentation* segmentation = NULL;
  jalon_task* task = new_task(threads);
  char* text = text_of_file(codes);
  if (sscanf(what, "%4095s %4095s", method, form) != 2) exit(1);
  check(jalon_cloud_read(scan, NULL, task, &cloud));
  check(jalon_cloud_count(cloud, &count));
  check(jalon_segmenter_create(method, &segmenter));
  check(jalon_segmenter_params(segmenter, &params));
  check(jalon_params_set_string(params, "codes", text));
  check(jalon_params_set_string(params, "form", form));
  malloc_trim(0);
  before = process_bytes("VmRSS:");
  reset_peak();
  clock = clock_seconds(CLOCK_MONOTONIC), processor = clock_seconds(CLOCK_PROCESS_CPUTIME_ID);
  check(jalon_segmenter_run(segmenter, cloud, task, &segmentation));
  clock = clock_seconds(CLOCK_MONOTONIC) - clock;
  processor = clock_seconds(CLOCK_PROCESS_CPUTIME_ID) - processor;
  peak = process_bytes("VmHWM:") - before;
  printf(
      "%-12s %-8s %9llu points, %s threads: %6.2f s, processor %6.2f s, %5.2f M points a processor "
      "second, peak %5.1f B a point\n",
      method, form, (unsigned long long)count, threads, clock, processor,
      1e-6 * (double)count / processor, peak / (double)count);
  fflush(stdout);
  jalon_segmentation_release(segmentation);
  jalon_params_release(params);
  jalon_segmenter_release(segmenter);
  jalon_cloud_release(cloud);
  jalon_task_release(task);
  free(text);
}

int main(int argc, char** argv) {
  const char* threads = argc > 4 ? argv[4] : "2";
  if (argc < 4) {
    fprintf(stderr, "code_methods SCAN SURVEY TARGETS [THREADS]\n");
    return 2;
  }
  scan = argv[1];
  measure_apart(run, "survey_codes source", argv[2], threads);
  measure_apart(run, "survey_codes improved", argv[2], threads);
  measure_apart(run, "target_codes source", argv[3], threads);
  measure_apart(run, "target_codes improved", argv[3], threads);
  return 0;
}

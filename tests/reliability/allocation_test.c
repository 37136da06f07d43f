/* SPDX-FileCopyrightText: 2026 The Jalon authors
 * SPDX-License-Identifier: Apache-2.0 */
/* Allocation failure in each long operation and in the files of each format: the 1st, 2nd, 3rd ... allocation fails,
 * once or from then on. Out of memory or success, nothing kept, no file half written, and the same job then succeeds.
 * By default at most kShallow failures a job and mode, spread over all; JALON_FULL=1 takes kDeep. */
#include "operations.h"

#include "allocation_faults.h"
#include "file_jobs.h"

enum { kShallow = 8, kDeep = 200, kOperationPoints = 2500, kWarm = 3 };

#ifndef CANNOT_REPLACE_MALLOC

static jalon_cloud* small;
static io_job files[kMostJobs];
static int file_count;

static const char* job_name(int job) {
  static char name[100];
  if (job < kOperationCount) return kOperations[job].name;
  const io_job* const file = &files[job - kOperationCount];
  snprintf(name, sizeof name, "%s %s", file->reads ? "reading" : "writing", file->file);
  return name;
}

static jalon_status run_operation(int job) {
  made m = {NULL, NULL, NULL};
  const jalon_status status = kOperations[job].run(small, task, &m);
  release_made(&m);
  return status;
}

typedef struct outcome {
  jalon_status status;
  long kept, failures, attempts;
} outcome;

static outcome run_job(int job, long k, int from_then_on) {
  outcome out;
  const char* path = NULL;
  if (job >= kOperationCount) path = path_in(folder, files[job - kOperationCount].file);
  const long before = live_blocks();
  arm_allocations(k, from_then_on);
  out.status = path == NULL ? run_operation(job) : files[job - kOperationCount].run(path);
  disarm_allocations();
  out.kept = live_blocks() - before;
  out.failures = failures;
  out.attempts = attempts;
  return out;
}

/* Of a writing nothing may be left but the whole file. */
static void expect_no_leftovers(int job, long k) {
  folder_state now;
  read_folder(folder, &now);
  for (int i = 0; i < now.count; ++i)
    if (strstr(now.files[i].name, ".part") != NULL)
      fail_msg("%s, allocation %ld: %s is left behind", job_name(job), k, now.files[i].name);
  free_folder(&now);
}

static void expect_ordinary(int job, long k, int mode, long of) {
  const outcome out = run_job(job, k, mode);
  if (out.status == JALON_ERROR_OUT_OF_MEMORY) {
    expect_one_line();
  } else if (out.status != JALON_OK) {
    fail_msg("%s, allocation %ld of %ld fails %s: %s: %s", job_name(job), k, of,
             mode ? "and all after" : "once", jalon_status_name(out.status),
             jalon_last_error_message());
  }
  if (out.kept > 0 && run_job(job, k, mode).kept > 0) /* twice: no stack that happened to be new */
    fail_msg("%s, allocation %ld of %ld fails %s: %ld blocks are never freed", job_name(job), k, of,
             mode ? "and all after" : "once", out.kept);
  expect_no_leftovers(job, k);
}

/* All failures of a job; how many. */
static long fail_in(int job) {
  outcome whole = {JALON_OK, 0, 0, 0};
  clear_folder(folder);
  if (job >= kOperationCount && files[job - kOperationCount].reads) /* the writing before it */
    MUST(files[job - kOperationCount - 1].run(path_in(folder, files[job - kOperationCount].file)));
  /* What a process keeps for ever is kept by the first runs. */
  for (int warm = 0; warm < kWarm; ++warm) {
    whole = run_job(job, 0, 0);
    if (whole.status != JALON_OK)
      fail_msg("%s does not run: %s", job_name(job), jalon_last_error_message());
  }
  if (whole.kept > 0)
    fail_msg("%s keeps %ld blocks without any failure", job_name(job), whole.kept);
  const long wanted = is_full_run() ? kDeep : kShallow;
  const long steps = whole.attempts < wanted ? whole.attempts : wanted;
  for (int mode = 0; mode < 2; ++mode)
    for (long step = 0; step < steps; ++step) /* a shift by mode takes others the second time */
      expect_ordinary(job, 1 + (step * whole.attempts + mode * whole.attempts / 2) / steps, mode,
                      whole.attempts);
  const outcome again = run_job(job, 0, 0);
  if (again.status != JALON_OK)
    fail_msg("%s fails afterwards: %s", job_name(job), jalon_last_error_message());
  return 2 * steps;
}

static void out_of_memory__in_operations_and_files_is_an_ordinary_error(void** state) {
  (void)state;
  long injected = 0;
  small = street_cloud(kOperationPoints, 12);
  file_count = all_jobs(files);
  for (int job = 0; job < kOperationCount + file_count; ++job) injected += fail_in(job);
  jalon_cloud_release(small);
  printf("FIGURE out of memory: %ld failures in %d jobs\n", injected, kOperationCount + file_count);
  assert_true(kOperationCount + file_count >= 60);
}

#endif

int main(void) {
#ifdef CANNOT_REPLACE_MALLOC
  printf("skipped: the sanitizer owns the allocator\n");
  return 77;
#else
  const struct CMUnitTest tests[] = {
      cmocka_unit_test(out_of_memory__in_operations_and_files_is_an_ordinary_error)};
  return cmocka_run_group_tests(tests, make_scene, drop_scene);
#endif
}

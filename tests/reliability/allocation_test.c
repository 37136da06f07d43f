/* SPDX-FileCopyrightText: 2026 The Jalon authors
 * SPDX-License-Identifier: Apache-2.0 */
/* Allocation failure in each long operation and in the files of each format: the 1st, 2nd, 3rd ... allocation fails,
 * once or from then on. Out of memory or success, nothing kept, no file half written, and the same job then succeeds.
 * By default at most kShallow failures a job and mode, spread over all; JALON_FULL=1 takes kDeep. */
#include "operations.h"

#include "allocation_jobs.h"

#ifndef CANNOT_REPLACE_MALLOC

#include "file_jobs.h"

enum { kShallow = 8, kDeep = 200, kOperationPoints = 2500 };

static jalon_cloud* small;
static io_job files[kMostJobs];

static jalon_status run_operation(int index) {
  made m = {NULL, NULL, NULL};
  const jalon_status status = kOperations[index].run(small, task, &m);
  release_made(&m);
  return status;
}
static jalon_status run_file(int index) {
  return files[index].run(path_in(folder, files[index].file));
}

/* Of a writing nothing may be left but the whole file. */
static void expect_no_leftovers(const char* name, long k) {
  folder_state now;
  read_folder(folder, &now);
  for (int i = 0; i < now.count; ++i)
    if (strstr(now.files[i].name, ".part") != NULL)
      fail_msg("%s, allocation %ld: %s is left behind", name, k, now.files[i].name);
  free_folder(&now);
}

static void out_of_memory__in_operations_and_files_is_an_ordinary_error(void** state) {
  (void)state;
  allocation_tally tally = {0, 0};
  const long most = is_full_run() ? kDeep : kShallow;
  const int file_count = all_jobs(files);
  small = street_cloud(kOperationPoints, 12);
  for (int i = 0; i < kOperationCount; ++i) {
    allocation_job job = {"", run_operation, i};
    snprintf(job.name, sizeof job.name, "%s", kOperations[i].name);
    fail_allocations(&job, most, NULL, &tally);
  }
  for (int i = 0; i < file_count; ++i) {
    allocation_job job = {"", run_file, i};
    snprintf(job.name, sizeof job.name, "%s %.60s", files[i].reads ? "reading" : "writing",
             files[i].file);
    clear_folder(folder);
    if (files[i].reads) MUST(files[i - 1].run(path_in(folder, files[i].file))); /* writes it */
    fail_allocations(&job, most, expect_no_leftovers, &tally);
  }
  jalon_cloud_release(small);
  printf("FIGURE out of memory: %ld failures in %d jobs, %ld calls refused\n", tally.failures,
         kOperationCount + file_count, tally.refused);
  assert_true(kOperationCount + file_count >= 60);
  assert_true(tally.refused > 100);
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

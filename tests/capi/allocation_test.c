/* SPDX-FileCopyrightText: 2026 The Jalon authors
 * SPDX-License-Identifier: Apache-2.0 */
/* Allocation failure is an ordinary error: in small jobs through the whole surface the 1st, 2nd, 3rd ... allocation
 * fails, once or from then on. Each time: out of memory or success, no crash, nothing kept, and the same job then
 * succeeds. By default at most kShallow failures a job and mode, spread over all; JALON_FULL=1 takes every one. */
#include "allocation_jobs.h"
#include "allocation_scenarios.h"

#include <dirent.h>
#include <limits.h>

enum { kShallow = 60 };

#ifndef CANNOT_REPLACE_MALLOC

static jalon_status run_scenario(int index) { return kScenarios[index].run(); }

static void expect_no_files(const char* name, long k) {
  DIR* const folder = opendir(small_folder);
  for (const struct dirent* entry; folder != NULL && (entry = readdir(folder)) != NULL;)
    if (entry->d_name[0] != '.' || entry->d_name[1] > '.')
      fail_msg("%s, allocation %ld: a file is left behind", name, k);
  if (folder != NULL) closedir(folder);
}

static void out_of_memory__is_an_ordinary_error_everywhere(void** state) {
  (void)state;
  allocation_tally tally = {0, 0};
  for (int i = 0; i < kScenarioCount; ++i) {
    allocation_job job = {"", run_scenario, i};
    snprintf(job.name, sizeof job.name, "%s", kScenarios[i].name);
    fail_allocations(&job, is_full_run() ? LONG_MAX : kShallow, expect_no_files, &tally);
  }
  printf("FIGURE %ld failures injected in %d jobs, %ld calls refused\n", tally.failures,
         (int)kScenarioCount, tally.refused);
  assert_true(kScenarioCount >= 10);
  assert_true(tally.refused > 100);
}

#endif

int main(void) {
#ifdef CANNOT_REPLACE_MALLOC
  (void)kScenarios;
  printf("skipped: the sanitizer owns the allocator\n");
  return 77;
#else
  const char* folder = getenv("TMPDIR");
  snprintf(small_folder, sizeof small_folder, "%s/jalon_allocation_XXXXXX",
           folder ? folder : "/tmp");
  if (mkdtemp(small_folder) == NULL) return 1;
  street_points(small_xyz, kSmall, 12, 0, 0);
  if (jalon_task_create(&small_task) != JALON_OK ||
      jalon_task_set_threads(small_task, 2) != JALON_OK)
    return 1;
  const struct CMUnitTest tests[] = {
      cmocka_unit_test(out_of_memory__is_an_ordinary_error_everywhere)};
  const int result = cmocka_run_group_tests(tests, NULL, NULL);
  jalon_task_release(small_task);
  rmdir(small_folder);
  return result;
#endif
}

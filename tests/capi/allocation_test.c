/* SPDX-FileCopyrightText: 2026 The Jalon authors
 * SPDX-License-Identifier: Apache-2.0 */
/* Allocation failure is an ordinary error: in small jobs through the whole surface the 1st, 2nd, 3rd ... allocation
 * fails, once or from then on. Each time: out of memory or success, no crash, nothing kept, and the same job then
 * succeeds. By default at most kShallow failures a job and mode, spread over all; JALON_FULL=1 takes every one. */
#include "allocation_faults.h"
#include "allocation_scenarios.h"

#include <dirent.h>

enum { kShallow = 60 };

#ifndef CANNOT_REPLACE_MALLOC

/* One run of a job with the k-th allocation failing (0 = none): its status, what it kept, and whether anything did
 * fail. */
struct outcome {
  jalon_status status;
  long kept, failures, attempts;
};

static struct outcome run_job(int job, long k, int from_then_on) {
  struct outcome outcome;
  const long before = live_blocks();
  arm_allocations(k, from_then_on);
  outcome.status = kScenarios[job].run();
  disarm_allocations();
  outcome.kept = live_blocks() - before;
  outcome.failures = failures;
  outcome.attempts = attempts;
  return outcome;
}

static int files_left(void) {
  int count = 0;
  DIR* folder = opendir(small_folder);
  if (folder == NULL) return 0;
  for (struct dirent* entry; (entry = readdir(folder)) != NULL;)
    count += entry->d_name[0] != '.' || entry->d_name[1] > '.';
  closedir(folder);
  return count;
}

static void out_of_memory__is_an_ordinary_error_everywhere(void** state) {
  (void)state;
  long injected = 0, refused = 0;
  for (int job = 0; job < kScenarioCount; ++job) {
    const char* name = kScenarios[job].name;
    struct outcome whole;
    /* What a process keeps for ever (thread stacks, the C library's tables) is kept by the first runs. */
    for (int warm = 0; warm < 3; ++warm) {
      whole = run_job(job, 0, 0);
      if (whole.status != JALON_OK)
        fail_msg("%s does not run: %s", name, jalon_last_error_message());
    }
    if (whole.kept != 0) fail_msg("%s keeps %ld blocks without any failure", name, whole.kept);
    const long steps = is_full_run() || whole.attempts < kShallow ? whole.attempts : kShallow;
    for (int mode = 0; mode < 2; ++mode)
      for (long step = 0; step < steps; ++step) {
        /* The last one of each stretch; a shift by mode takes others the second time. */
        const long k = steps == whole.attempts
                           ? step + 1
                           : 1 + (step * whole.attempts + mode * whole.attempts / 2) / steps;
        struct outcome outcome = run_job(job, k, mode);
        injected += outcome.failures;
        if (outcome.status == JALON_ERROR_OUT_OF_MEMORY) {
          ++refused;
          expect_one_line();
        } else if (outcome.status != JALON_OK) {
          fail_msg("%s, allocation %ld of %ld fails %s: %s: %s", name, k, whole.attempts,
                   mode ? "and all after" : "once", jalon_status_name(outcome.status),
                   jalon_last_error_message());
        }
        if (outcome.kept != 0 &&
            run_job(job, k, mode).kept > 0) /* twice: no thread stack that happened to be new */
          fail_msg("%s, allocation %ld of %ld fails %s: %ld blocks are never freed", name, k,
                   whole.attempts, mode ? "and all after" : "once", outcome.kept);
        if (files_left() != 0)
          fail_msg("%s, allocation %ld of %ld: a file is left behind", name, k, whole.attempts);
        const struct outcome again = run_job(job, 0, 0);
        if (again.status != JALON_OK)
          fail_msg("%s fails after allocation %ld failed: %s", name, k, jalon_last_error_message());
      }
    printf("    %-22s %6ld allocations, %ld tried twice\n", name, whole.attempts, steps);
  }
  printf("FIGURE %ld failures injected in %d jobs, %ld calls refused\n", injected,
         (int)kScenarioCount, refused);
  assert_true(kScenarioCount >= 10);
  assert_true(refused > 100);
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

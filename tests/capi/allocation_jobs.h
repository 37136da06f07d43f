/* SPDX-FileCopyrightText: 2026 The Jalon authors
 * SPDX-License-Identifier: Apache-2.0 */
/* A job with each of its allocations failing: each time out of memory or success, nothing kept, and the same job then
 * succeeds. */
#ifndef JALON_TEST_ALLOCATION_JOBS_H
#define JALON_TEST_ALLOCATION_JOBS_H

#include "support.h"

#include "allocation_faults.h"

#ifndef CANNOT_REPLACE_MALLOC

typedef struct allocation_job {
  char name[100];
  jalon_status (*run)(int index);
  int index;
} allocation_job;

/* What was injected and refused so far. */
typedef struct allocation_tally {
  long failures, refused;
} allocation_tally;

/* One run with the k-th allocation failing (0 = none): its status, what it kept, and whether anything did fail. */
typedef struct allocation_outcome {
  jalon_status status;
  long kept, failures, attempts;
} allocation_outcome;

static allocation_outcome run_failing(const allocation_job* job, long k, int from_then_on) {
  allocation_outcome out;
  const long before = live_blocks();
  arm_allocations(k, from_then_on);
  out.status = job->run(job->index);
  disarm_allocations();
  out.kept = live_blocks() - before;
  out.failures = failures;
  out.attempts = attempts;
  return out;
}

static void expect_ordinary_failure(const allocation_job* job, long k, int from_then_on, long of,
                                    allocation_tally* tally) {
  const char* const how = from_then_on ? "and all after" : "once";
  const allocation_outcome out = run_failing(job, k, from_then_on);
  tally->failures += out.failures;
  if (out.status == JALON_ERROR_OUT_OF_MEMORY) {
    ++tally->refused;
    expect_one_line();
  } else if (out.status != JALON_OK) {
    fail_msg("%s, allocation %ld of %ld fails %s: %s: %s", job->name, k, of, how,
             jalon_status_name(out.status), jalon_last_error_message());
  }
  if (out.kept != 0 && /* twice: no thread stack that happened to be new */
      run_failing(job, k, from_then_on).kept > 0)
    fail_msg("%s, allocation %ld of %ld fails %s: %ld blocks are never freed", job->name, k, of,
             how, out.kept);
}

/* All its allocations, or at most so many of each mode, spread over them. look: at what a failure left, or NULL. */
static void fail_allocations(const allocation_job* job, long most,
                             void (*look)(const char* name, long k), allocation_tally* tally) {
  allocation_outcome whole = {JALON_OK, 0, 0, 0};
  /* What a process keeps for ever (thread stacks, the C library's tables) is kept by the first runs. */
  for (int warm = 0; warm < 3; ++warm) {
    whole = run_failing(job, 0, 0);
    if (whole.status != JALON_OK)
      fail_msg("%s does not run: %s", job->name, jalon_last_error_message());
  }
  if (whole.kept != 0) fail_msg("%s keeps %ld blocks without any failure", job->name, whole.kept);
  const long steps = whole.attempts < most ? whole.attempts : most;
  for (int mode = 0; mode < 2; ++mode)
    for (long step = 0; step < steps; ++step) {
      /* The last one of each stretch; a shift by mode takes others the second time. */
      const long k = steps == whole.attempts
                         ? step + 1
                         : 1 + (step * whole.attempts + mode * whole.attempts / 2) / steps;
      expect_ordinary_failure(job, k, mode, whole.attempts, tally);
      if (look != NULL) look(job->name, k);
      if (run_failing(job, 0, 0).status != JALON_OK)
        fail_msg("%s fails after allocation %ld failed: %s", job->name, k,
                 jalon_last_error_message());
    }
  printf("    %-28s %6ld allocations, %ld tried twice\n", job->name, whole.attempts, steps);
}

#endif

#endif

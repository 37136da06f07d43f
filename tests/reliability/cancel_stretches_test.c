/* SPDX-FileCopyrightText: 2026 The Jalon authors
 * SPDX-License-Identifier: Apache-2.0 */
/* How long a cancel may have to wait: the longest stretch of processor time between two places where an operation asks
 * whether to go on, by one thread, on five million points. What an operation's job prepares comes before its first look
 * and does not count. Printed, not asserted: it is the machine's as much as ours. A few looks within chunks of work
 * call no host and are not seen: the true stretches are no longer than these. With JALON_FULL=1. */
#include "stepped_clock.h"

#include "../bench/hostile_operations.h"

enum { kStretchPoints = 5000000 };
static const double kLong_s = 0.1;

struct stretches {
  double last_s, longest_s;
  long looks;
  jalon_status status;
};

static int32_t note_look(double fraction, const char* stage, void* user) {
  struct stretches* const seen = user;
  const double now_s = thread_s();
  (void)fraction, (void)stage;
  if (seen->looks++ > 0 && now_s - seen->last_s > seen->longest_s)
    seen->longest_s = now_s - seen->last_s;
  seen->last_s = thread_s();
  return 0;
}

static struct stretches stretches_of(const jalon_cloud* cloud, int which) {
  struct stretches seen = {0, 0, 0, JALON_OK};
  made out = {NULL, NULL, NULL};
  jalon_task* task = NULL;
  make_ready(cloud, which);
  MUST(jalon_task_create(&task));
  MUST(jalon_task_set_threads(task, 1));
  MUST(jalon_task_set_progress(task, note_look, &seen));
  seen.status = operation_of(which)(cloud, task, &out);
  release_made(&out);
  jalon_task_release(task);
  return seen;
}

static void cancel__waits_for_no_long_stretch(void** state) {
  (void)state;
  if (!is_full_run() || is_sanitized()) skip();
  jalon_cloud* const cloud = street_cloud(kStretchPoints, 10);
  const char* worst_name = "";
  double worst_s = 0;
  int many = 0;
  for (int i = 0; i < kAllCount; ++i) {
    const struct stretches seen = stretches_of(cloud, i);
    /* A street may hold nothing that it works on. */
    if (seen.status == JALON_OK && seen.looks == 0)
      fail_msg("%s never asks whether to go on", name_of(i));
    if (seen.longest_s > kLong_s)
      ++many,
          printf("    %-24s %6.0f ms of %ld looks\n", name_of(i), 1e3 * seen.longest_s, seen.looks);
    if (seen.longest_s > worst_s) worst_s = seen.longest_s, worst_name = name_of(i);
  }
  printf(
      "FIGURE stretches without a look, %d operations on %d points: %d above %.0f ms, longest %.0f "
      "ms (%s)\n",
      kAllCount, kStretchPoints, many, 1e3 * kLong_s, 1e3 * worst_s, worst_name);
  jalon_cloud_release(cloud);
}

int main(void) {
  const struct CMUnitTest tests[] = {cmocka_unit_test(cancel__waits_for_no_long_stretch)};
  return cmocka_run_group_tests(tests, NULL, NULL);
}

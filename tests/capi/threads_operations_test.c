/* SPDX-FileCopyrightText: 2026 The Jalon authors
 * SPDX-License-Identifier: Apache-2.0 */
/* Every long operation on one shared cloud from eight threads at once, each with threads of its own: what comes out
 * is what one thread makes alone, and a cancel from outside ends the call that it is meant for and no other. */
#include "operations.h"

#include <pthread.h>
#include <time.h>

enum { kThreads = 8, kPoints = 600, kSanitizedPoints = 250, kLongPoints = 3000, kLongRounds = 24 };

static uint64_t points(void) {
  return is_sanitized() ? kSanitizedPoints : is_full_run() ? kLongPoints : kPoints;
}
/* Of all operations, in each thread: a thousand in the long run. */
static int rounds(void) { return is_full_run() ? kLongRounds : 1; }

static struct outcome {
  jalon_status status;
  uint64_t hash;
} expected[kOperationCount];

/* Assertions end in a longjmp, which no other thread may take: the threads only count what went wrong. */
struct worker {
  pthread_t thread;
  const jalon_cloud* cloud;
  jalon_task* task;
  int number, wrong, done, cancelled;
  char why[256];
};

static void note(struct worker* w, const char* operation, const char* why) {
  if (w->wrong++ == 0) snprintf(w->why, sizeof w->why, "%s: %s", operation, why);
}

static struct outcome outcome_of(int i, const jalon_cloud* cloud, jalon_task* task) {
  made out = {NULL, NULL, NULL};
  struct outcome result = {kOperations[i].run(cloud, task, &out), 0};
  if (result.status == JALON_OK) result.hash = hash_made(&out);
  release_made(&out);
  return result;
}

static void* operations_body(void* argument) {
  struct worker* w = argument;
  struct both_ways own;
  memset(&own, 0, sizeof own);
  own_both_ways = &own;
  for (int r = 0; r < rounds() * kOperationCount; ++r) {
    const int i = (r + 5 * w->number) % kOperationCount;
    const struct outcome got = outcome_of(i, w->cloud, w->task);
    if (got.status == JALON_ERROR_CANCELLED) {
      ++w->cancelled;
      if (jalon_task_reset(w->task) != JALON_OK) note(w, kOperations[i].name, "no task is left");
    } else if (got.status != expected[i].status)
      note(w, kOperations[i].name, jalon_last_error_message());
    else if (got.hash != expected[i].hash) note(w, kOperations[i].name, "another result");
    ++w->done;
  }
  forget_both_ways();
  return NULL;
}

static void start(struct worker* workers, const jalon_cloud* cloud) {
  for (int i = 0; i < kThreads; ++i) {
    struct worker* w = workers + i;
    memset(w, 0, sizeof *w);
    w->cloud = cloud, w->number = i;
    MUST(jalon_task_create(&w->task));
    MUST(jalon_task_set_threads(w->task, 1 + (uint32_t)i % 3));
    assert_int_equal(pthread_create(&w->thread, NULL, operations_body, w), 0);
  }
}

static void finish(struct worker* workers, int* cancelled) {
  for (int i = 0; i < kThreads; ++i) pthread_join(workers[i].thread, NULL);
  for (int i = 0; i < kThreads; ++i) {
    jalon_task_release(workers[i].task);
    if (cancelled != NULL) *cancelled += workers[i].cancelled;
    else assert_int_equal(workers[i].cancelled, 0);
    if (workers[i].wrong) fail_msg("thread %d: %d times: %s", i, workers[i].wrong, workers[i].why);
    assert_int_equal(workers[i].done, rounds() * kOperationCount);
  }
}

static void threads__run_every_operation_on_one_cloud(void** state) {
  (void)state;
  struct worker workers[kThreads];
  jalon_cloud* cloud = street_cloud(points(), 11);
  int succeed = 0;
  for (int i = 0; i < kOperationCount; ++i) {
    expected[i] = outcome_of(i, cloud, NULL);
    succeed += expected[i].status == JALON_OK;
  }
  assert_true(succeed > kOperationCount * 3 / 4);
  jalon_cloud_release(cloud);
  cloud = street_cloud(points(), 11); /* its index is built by whichever thread comes first */
  start(workers, cloud);
  finish(workers, NULL);
  jalon_cloud_release(cloud);
  printf("FIGURE threads: %d operations x %d threads x %d on one cloud, %d with a result\n",
         (int)kOperationCount, (int)kThreads, rounds(), succeed);
}

static void threads__are_cancelled_one_by_one(void** state) {
  (void)state;
  struct worker workers[kThreads];
  int cancelled = 0;
  jalon_cloud* cloud = street_cloud(points(), 11);
  start(workers, cloud);
  for (int k = 0; k < 40 * rounds(); ++k) {
    const struct timespec pause = {0, 4000000};
    nanosleep(&pause, NULL);
    MUST(jalon_task_cancel(workers[k % (kThreads / 2)].task)); /* the others are never cancelled */
  }
  finish(workers, &cancelled);
  jalon_cloud_release(cloud);
  assert_true(cancelled > 0);
  for (int i = kThreads / 2; i < kThreads; ++i) assert_int_equal(workers[i].cancelled, 0);
}

int main(void) {
  const struct CMUnitTest tests[] = {
      cmocka_unit_test(threads__run_every_operation_on_one_cloud),
      cmocka_unit_test(threads__are_cancelled_one_by_one),
  };
  return cmocka_run_group_tests_name("threads_operations", tests, NULL, NULL);
}

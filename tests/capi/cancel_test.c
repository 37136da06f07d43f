/* SPDX-FileCopyrightText: 2026 The Jalon authors
 * SPDX-License-Identifier: Apache-2.0 */
/* Progress and cancel of every long operation: the contract of task.h. How soon a cancel acts is printed, not
 * asserted: it is the machine's as much as ours; tests/bench/promised.py holds it against 100 ms. */
#include "operations.h"

#include <pthread.h>
#include <time.h>

static uint64_t points(void) {
  if (is_sanitized()) return 20000;
  return is_full_run() ? 200000 : 100000;
}

static double now_s(void) {
  struct timespec t;
  clock_gettime(CLOCK_MONOTONIC, &t);
  return (double)t.tv_sec + 1e-9 * (double)t.tv_nsec;
}

/* What an operation gives undisturbed and how long it takes, found once for a cloud. */
struct undisturbed {
  int is_known;
  uint64_t hash;
  double whole_s;
};
static struct undisturbed* undisturbed_of(const jalon_cloud* cloud, int which) {
  static const jalon_cloud* of;
  static struct undisturbed all[kOperationCount];
  if (of != cloud) memset(all, 0, sizeof all);
  of = cloud;
  return &all[which];
}
static struct undisturbed undisturbed(const jalon_cloud* cloud, int which) {
  struct undisturbed* found = undisturbed_of(cloud, which);
  if (!found->is_known) {
    made reference = {NULL, NULL, NULL};
    const double begin = now_s();
    MUST(kOperations[which].run(cloud, NULL, &reference));
    *found = (struct undisturbed){1, hash_made(&reference), now_s() - begin};
    release_made(&reference);
  }
  return *found;
}

/* ---- progress ---- */

struct watch {
  pthread_t caller;
  double last;
  int calls, ones, backward, outside, stranger, unnamed, stop_at;
};

static int32_t watch_progress(double fraction, const char* stage, void* user) {
  struct watch* w = user;
  ++w->calls;
  w->ones += fraction == 1.0;
  w->backward += !(fraction >= w->last);
  w->outside += !(fraction >= 0 && fraction <= 1);
  w->stranger += !pthread_equal(w->caller, pthread_self());
  w->unnamed += stage == NULL || stage[0] == 0;
  w->last = fraction;
  return w->calls == w->stop_at;
}

static void expect_contract(const struct watch* w, const char* name) {
  if (w->backward || w->outside || w->stranger || w->unnamed)
    fail_msg(
        "%s: of %d reports %d went backward, %d left 0..1, %d came on another thread, %d had no "
        "stage",
        name, w->calls, w->backward, w->outside, w->stranger, w->unnamed);
}

static void progress__is_monotone_and_one_only_at_the_end_and_threads_change_no_bit(void** state) {
  jalon_cloud* cloud = *state;
  int reports = 0;
  for (uint32_t threads = 1; threads <= 2; ++threads)
    for (int i = 0; i < kOperationCount; ++i) {
      struct watch w = {pthread_self(), -1, 0, 0, 0, 0, 0, 0, 0};
      made out = {NULL, NULL, NULL};
      jalon_task* task;
      MUST(jalon_task_create(&task));
      MUST(jalon_task_set_threads(task, threads));
      MUST(jalon_task_set_progress(task, watch_progress, &w));
      const double begin = now_s();
      MUST(kOperations[i].run(cloud, task, &out));
      const double whole_s = now_s() - begin;
      expect_contract(&w, kOperations[i].name);
      if (w.ones != 1 || w.last != 1.0)
        fail_msg("%s: %d reports of 1, the last is %g", kOperations[i].name, w.ones, w.last);
      reports += w.calls;
      const uint64_t hash = hash_made(&out);
      struct undisturbed* found = undisturbed_of(cloud, i);
      if (threads == 1) *found = (struct undisturbed){1, hash, whole_s};
      else if (hash != found->hash)
        fail_msg("%s: other bits with %u threads", kOperations[i].name, threads);
      release_made(&out);
      jalon_task_release(task);
    }
  printf("FIGURE progress reports of %d operations, 1 and 2 threads: %d\n", kOperationCount,
         reports);
}

/* Stop at the first, second, ... report; then the same call with the same task gives what an undisturbed one gives. */
static void callback__stops_at_any_report_and_the_same_call_then_succeeds(void** state) {
  jalon_cloud* cloud = *state;
  int stopped = 0;
  const int most = is_full_run() ? 200 : is_sanitized() ? 1 : 2;
  for (int i = 0; i < kOperationCount; ++i) {
    const uint64_t expected = undisturbed(cloud, i).hash;
    for (int stop_at = 1; stop_at <= most; ++stop_at) {
      struct watch w = {pthread_self(), -1, 0, 0, 0, 0, 0, 0, stop_at};
      made out = {NULL, NULL, NULL};
      jalon_task* task;
      MUST(jalon_task_create(&task));
      MUST(jalon_task_set_threads(task, 1));
      MUST(jalon_task_set_progress(task, watch_progress, &w));
      const jalon_status status = kOperations[i].run(cloud, task, &out);
      if (status == JALON_ERROR_CANCELLED) {
        ++stopped;
        expect_one_line();
        if (out.cloud || out.fields || out.segmentation)
          fail_msg("%s wrote an output", kOperations[i].name);
        if (w.ones) fail_msg("%s reported 1 although it was cancelled", kOperations[i].name);
        expect_contract(&w, kOperations[i].name);
        MUST(jalon_task_set_progress(task, NULL, NULL));
        MUST(kOperations[i].run(cloud, task, &out));
      } else if (status != JALON_OK) {
        fail_msg("%s: %s", kOperations[i].name, jalon_last_error_message());
      }
      if (hash_made(&out) != expected)
        fail_msg("%s: another result after a cancel", kOperations[i].name);
      release_made(&out);
      jalon_task_release(task);
      if (status == JALON_OK) break; /* fewer reports than that */
    }
  }
  printf("FIGURE calls stopped by the callback: %d\n", stopped);
}

/* ---- cancel from another thread ---- */

struct cancelled_call {
  const jalon_cloud* cloud;
  jalon_task* task;
  operation run;
  made out;
  jalon_status status;
  double ended_s;
};

static void* run_call(void* argument) {
  struct cancelled_call* call = argument;
  call->status = call->run(call->cloud, call->task, &call->out);
  call->ended_s = now_s();
  return NULL;
}

static int by_size(const void* a, const void* b) {
  const double x = *(const double*)a, y = *(const double*)b;
  return (x > y) - (x < y);
}

enum { kMostCancels = 4000 };
struct latencies {
  double late_s[kMostCancels];
  int count, early;
  double worst_s;
  const char* worst_name;
};

/* One cancel after a random part of the time that the operation takes. */
static void cancel_once(const jalon_cloud* cloud, int which, int round, double whole_s,
                        struct latencies* seen) {
  const char* name = kOperations[which].name;
  struct cancelled_call call = {cloud, NULL, kOperations[which].run, {NULL, NULL, NULL}, 0, 0};
  pthread_t thread;
  MUST(jalon_task_create(&call.task));
  MUST(jalon_task_set_threads(call.task, 1 + (uint32_t)(round % 2)));
  assert_int_equal(pthread_create(&thread, NULL, run_call, &call), 0);
  const double wait_s = whole_s * uniform(77, (uint64_t)(1000 * which + round));
  const struct timespec nap = {(time_t)wait_s, (long)(1e9 * (wait_s - (double)(time_t)wait_s))};
  nanosleep(&nap, NULL);
  const double asked_s = now_s();
  MUST(jalon_task_cancel(call.task));
  pthread_join(thread, NULL);
  if (call.status == JALON_ERROR_CANCELLED) {
    if (call.out.cloud || call.out.fields || call.out.segmentation)
      fail_msg("%s wrote an output", name);
    const double late_s = call.ended_s - asked_s;
    if (late_s > seen->worst_s) seen->worst_s = late_s, seen->worst_name = name;
    seen->late_s[seen->count++] = late_s;
  } else if (call.status == JALON_OK) {
    ++seen->early; /* it had ended before */
  } else {
    fail_msg("%s: status %d instead of cancelled", name, (int)call.status);
  }
  release_made(&call.out);
  jalon_task_release(call.task);
}

static void cancel_everything(const jalon_cloud* cloud, int rounds, int least) {
  static struct latencies seen;
  memset(&seen, 0, sizeof seen);
  for (int i = 0; i < kOperationCount; ++i) {
    const double whole_s = undisturbed(cloud, i).whole_s;
    for (int r = 0; r < rounds && seen.count < kMostCancels; ++r)
      cancel_once(cloud, i, r, whole_s, &seen);
  }
  qsort(seen.late_s, (size_t)seen.count, sizeof *seen.late_s, by_size);
  const double p99 = seen.count > 0 ? seen.late_s[(int)(0.99 * (seen.count - 1))] : 0;
  printf(
      "FIGURE cancel latency, %d cancels on %llu points: median %.1f ms, p99 %.1f ms, worst %.1f "
      "ms (%s); "
      "%d ended before\n",
      seen.count, (unsigned long long)count_of(cloud),
      seen.count > 0 ? 1e3 * seen.late_s[seen.count / 2] : 0, 1e3 * p99, 1e3 * seen.worst_s,
      seen.worst_name, seen.early);
  assert_true(seen.count >= least);
}

static void cancel__at_any_moment_ends_any_call_without_an_output(void** state) {
  if (is_sanitized()) cancel_everything(*state, 1, 5);
  else cancel_everything(*state, is_full_run() ? 100 : 3, 30);
}

static void cancel__at_any_moment_ends_any_call_on_five_million_points(void** state) {
  (void)state;
  if (!is_full_run() || is_sanitized()) skip();
  jalon_cloud* cloud = street_cloud(5000000, 10);
  cancel_everything(cloud, 8, 50);
  jalon_cloud_release(cloud);
}

static int make_cloud_once(void** state) {
  *state = street_cloud(points(), 10);
  return 0;
}
static int release_cloud(void** state) {
  jalon_cloud_release(*state);
  return 0;
}

int main(void) {
  const struct CMUnitTest tests[] = {
      cmocka_unit_test(progress__is_monotone_and_one_only_at_the_end_and_threads_change_no_bit),
      cmocka_unit_test(callback__stops_at_any_report_and_the_same_call_then_succeeds),
      cmocka_unit_test(cancel__at_any_moment_ends_any_call_without_an_output),
      cmocka_unit_test(cancel__at_any_moment_ends_any_call_on_five_million_points),
  };
  return cmocka_run_group_tests(tests, make_cloud_once, release_cloud);
}

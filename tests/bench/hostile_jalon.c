/* SPDX-FileCopyrightText: 2026 The Jalon authors
 * SPDX-License-Identifier: Apache-2.0 */
/* The long operations on clouds that are hard on a spatial index, as multiples of their time on a random cloud of the
 * same size, and how late they obey a cancel.
 *   hostile_jalon [POINTS [CLOUD [OPERATION]]]      names, or all */
#include "hostile_operations.h"

#include <pthread.h>
#include <sys/resource.h>
#include <time.h>

enum { kMostTimes = 30, kMostTimesOfAnswers = 1000, kCancels = 4 };
static const double kLeast_s = 0.5;  /* an operation may always take that long */
static const double kLatest_s = 2.0; /* of the cancels */

static double seconds_of(clockid_t clock) {
  struct timespec t;
  clock_gettime(clock, &t);
  return (double)t.tv_sec + 1e-9 * (double)t.tv_nsec;
}

struct call {
  const jalon_cloud* cloud;
  jalon_task* task;
  operation run;
  jalon_status status;
  double took_s;     /* of the processor */
  uint64_t answered; /* rows of what a radius search found; of other operations 1 */
  volatile int ended;
};

static void* run_call(void* argument) {
  struct call* call = argument;
  made out = {NULL, NULL, NULL};
  call->status = call->run(call->cloud, call->task, &out);
  call->took_s = seconds_of(CLOCK_THREAD_CPUTIME_ID);
  call->answered = answered_by(call->run, &out);
  release_made(&out);
  call->ended = 1;
  return NULL;
}

/* Processor seconds of the call, or those that it went on for after the cancel at limit_s: they hold on a busy machine
 * as well. */
static double run_until(const jalon_cloud* cloud, int operation_number, double limit_s,
                        jalon_status* status, uint64_t* answered) {
  struct call call = {cloud, NULL, operation_of(operation_number), JALON_OK, 0, 1, 0};
  pthread_t thread;
  clockid_t clock;
  MUST(jalon_task_create(&call.task));
  MUST(jalon_task_set_threads(call.task, 1));
  if (pthread_create(&thread, NULL, run_call, &call) != 0) fail_msg("no thread");
  const int ran = pthread_getcpuclockid(thread, &clock) == 0; /* else it has ended already */
  const struct timespec nap = {0, 500000};
  double asked_s = 0;
  while (ran && !call.ended && asked_s < limit_s) {
    nanosleep(&nap, NULL);
    if (!call.ended) asked_s = seconds_of(clock);
  }
  MUST(jalon_task_cancel(call.task));
  pthread_join(thread, NULL);
  jalon_task_release(call.task);
  *status = call.status;
  *answered = call.answered;
  return call.status == JALON_ERROR_CANCELLED ? call.took_s - asked_s : call.took_s;
}

static double time_of(const jalon_cloud* cloud, int operation_number, jalon_status* status,
                      uint64_t* answered) {
  const double a = run_until(cloud, operation_number, 1e9, status, answered);
  if (a > 0.5) return a;
  const double b = run_until(cloud, operation_number, 1e9, status, answered);
  return a < b ? a : b;
}

static void measure(int cloud_number, int operation_number, uint64_t n, double random_s,
                    uint64_t random_answered) {
  jalon_cloud* cloud = hostile_cloud(cloud_number, n);
  jalon_status status = JALON_OK, again = JALON_OK;
  make_ready(cloud, operation_number);
  const int most_times = random_answered > 1 ? kMostTimesOfAnswers : kMostTimes;
  const double limit_s = most_times * random_s + kLeast_s;
  uint64_t answered = 1, again_answered = 1;
  const double s = run_until(cloud, operation_number, limit_s, &status, &answered);
  const int cancelled = status == JALON_ERROR_CANCELLED;
  double late_s = cancelled ? s : 0;
  for (int i = 0; i < kCancels; ++i) {
    const double most_s = cancelled ? limit_s : s;
    const double after_s = (most_s < kLatest_s ? most_s : kLatest_s) * uniform(5, (uint64_t)i);
    const double t = run_until(cloud, operation_number, after_s, &again, &again_answered);
    if (again == JALON_ERROR_CANCELLED && t > late_s) late_s = t;
  }
  printf("%-14s %-24s %s%7.1f times %.4f s, cancel %6.1f ms%s%s\n", kHostile[cloud_number].name,
         name_of(operation_number), cancelled ? ">" : " ", (cancelled ? limit_s : s) / random_s,
         random_s, 1e3 * late_s, status == JALON_OK || cancelled ? "" : ", ",
         status == JALON_OK || cancelled ? "" : jalon_status_name(status));
  if (status == JALON_OK && random_answered > 1)
    printf("%-14s %-24s  %7.1f times for each of %llu found (random %llu)\n",
           kHostile[cloud_number].name, name_of(operation_number),
           s / random_s * (double)random_answered / (double)answered, (unsigned long long)answered,
           (unsigned long long)random_answered);
  fflush(stdout);
  jalon_cloud_release(cloud);
}

int main(int argc, char** argv) {
  const uint64_t n = argc > 1 ? (uint64_t)atof(argv[1]) : 100000;
  const struct rlimit memory = {(rlim_t)6 << 30, (rlim_t)6 << 30}; /* answers may be of any size */
  setrlimit(RLIMIT_AS, &memory);
  for (int operation_number = 0; operation_number < kAllCount; ++operation_number) {
    if (!named(argc, argv, 3, name_of(operation_number))) continue;
    jalon_cloud* cloud = hostile_cloud(0, n);
    jalon_status status = JALON_OK;
    make_ready(cloud, operation_number);
    uint64_t answered = 1;
    const double random_s = time_of(cloud, operation_number, &status, &answered);
    jalon_cloud_release(cloud);
    for (int c = 1; c < kHostileCount; ++c)
      if (named(argc, argv, 2, kHostile[c].name))
        measure(c, operation_number, n, random_s, answered);
  }
  return 0;
}

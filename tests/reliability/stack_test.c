/* SPDX-FileCopyrightText: 2026 The Jalon authors
 * SPDX-License-Identifier: Apache-2.0 */
/* Hosts call from threads with little stack: each long operation, and the files, on 256 KiB and by that thread alone,
 * with points in layouts that make indexes deep. 10^6 points with JALON_FULL=1. */
#include "operations.h"

#include <math.h>
#include <pthread.h>

enum { kStackBytes = 256 * 1024 };
static const uint64_t kLimitBytes = (uint64_t)4 << 30;

static uint64_t points(void) { return is_full_run() ? 1000000 : is_sanitized() ? 1000 : 4000; }

typedef void (*layout)(double* p, uint64_t i);
static void equal_points(double* p, uint64_t i) {
  p[0] = 1, p[1] = 2, p[2] = (double)(i % 3) * 1e-9;
}
static void falling_spacing(double* p, uint64_t i) {
  p[0] = pow(2, -(double)(i % 900));
  p[1] = pow(2, -(double)(i % 600));
  p[2] = uniform(5, i) * pow(2, -(double)(i % 300));
}
static void long_line(double* p, uint64_t i) {
  p[0] = (double)i * 1e-3, p[1] = 0, p[2] = uniform(6, i) * 1e-3;
}

static const struct {
  const char* name;
  layout put;
} kLayouts[] = {
    {"a street", NULL},
    {"equal points", equal_points},
    {"falling spacing", falling_spacing},
    {"a long line", long_line},
};

static jalon_cloud* cloud_in(layout put) {
  const uint64_t n = points();
  if (put == NULL) return street_cloud(n, 3);
  double* const xyz = malloc((size_t)n * 24);
  assert_non_null(xyz);
  for (uint64_t i = 0; i < n; ++i) put(xyz + 3 * i, i);
  jalon_cloud* const cloud = cloud_of(xyz, n);
  free(xyz);
  return cloud;
}

/* Assertions end in a longjmp, which no other thread may take: it notes what went wrong. */
typedef struct narrow_thread {
  jalon_cloud* cloud;
  int operation;
  jalon_status status;
  char message[300];
} narrow_thread;

static jalon_status write_and_read(const jalon_cloud* cloud, jalon_task* task, const char* name) {
  jalon_cloud* back = NULL;
  const char* const path = temporary(name);
  jalon_status status = jalon_cloud_write(cloud, path, NULL, task);
  if (status == JALON_OK) status = jalon_cloud_read(path, NULL, task, &back);
  jalon_cloud_release(back);
  unlink(path);
  return status;
}

static const char* const kFiles[] = {"stack.las", "stack.laz", "stack.e57", "stack.ply",
                                     "stack.xyz", "stack.pts", "stack.pcd"};
enum { kFileCount = sizeof kFiles / sizeof *kFiles };

static void* run_narrow(void* argument) {
  narrow_thread* const t = argument;
  jalon_task* task = NULL;
  made m = {NULL, NULL, NULL};
  t->status = jalon_task_create(&task);
  if (t->status == JALON_OK) t->status = jalon_task_set_threads(task, 1);
  if (t->status == JALON_OK) {
    /* n equal points have n^2 neighbours: of a million of them no machine holds the list. */
    const jalon_status limited = jalon_task_set_memory_limit(task, kLimitBytes);
    if (limited != JALON_ERROR_UNSUPPORTED) t->status = limited;
  }
  if (t->status == JALON_OK)
    t->status = t->operation < kOperationCount
                    ? kOperations[t->operation].run(t->cloud, task, &m)
                    : write_and_read(t->cloud, task, kFiles[t->operation - kOperationCount]);
  snprintf(t->message, sizeof t->message, "%s", jalon_last_error_message());
  release_made(&m);
  jalon_task_release(task);
  return NULL;
}

static void run_on_small_stack(narrow_thread* t) {
  pthread_attr_t attributes;
  pthread_t thread;
  assert_int_equal(pthread_attr_init(&attributes), 0);
  assert_int_equal(pthread_attr_setstacksize(&attributes, kStackBytes), 0);
  assert_int_equal(pthread_create(&thread, &attributes, run_narrow, t), 0);
  assert_int_equal(pthread_join(thread, NULL), 0);
  pthread_attr_destroy(&attributes);
}

/* Clouds without a surface have nothing to segment, or too many neighbours: that is said and is no failure here. */
static int is_expected(jalon_status status, layout put) {
  return status == JALON_OK ||
         (put != NULL &&
          (status == JALON_ERROR_DEGENERATE || status == JALON_ERROR_UNSUPPORTED ||
           status == JALON_ERROR_INSUFFICIENT_DATA || status == JALON_ERROR_LIMIT ||
           status == JALON_ERROR_NOT_FOUND || status == JALON_ERROR_INVALID_ARGUMENT ||
           status == JALON_ERROR_OUT_OF_MEMORY));
}

static void stack__of_256_kib_is_enough_for_every_operation(void** state) {
  (void)state;
  int runs = 0, done = 0;
  for (size_t l = 0; l < sizeof kLayouts / sizeof *kLayouts; ++l) {
    jalon_cloud* const cloud = cloud_in(kLayouts[l].put);
    for (int k = 0; k < kOperationCount + kFileCount; ++k, ++runs) {
      narrow_thread t = {cloud, k, JALON_OK, ""};
      run_on_small_stack(&t);
      done += t.status == JALON_OK;
      if (!is_expected(t.status, kLayouts[l].put))
        fail_msg("%s of %s: %s: %s",
                 k < kOperationCount ? kOperations[k].name : kFiles[k - kOperationCount],
                 kLayouts[l].name, jalon_status_name(t.status), t.message);
    }
    jalon_cloud_release(cloud);
  }
  printf("FIGURE small stack: %d runs on 256 KiB with %llu points, %d with a result\n", runs,
         (unsigned long long)points(), done);
  assert_true(2 * done > runs);
}

int main(void) {
  const struct CMUnitTest tests[] = {
      cmocka_unit_test(stack__of_256_kib_is_enough_for_every_operation),
  };
  return cmocka_run_group_tests(tests, NULL, NULL);
}

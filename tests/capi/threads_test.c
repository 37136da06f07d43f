/* SPDX-FileCopyrightText: 2026 The Jalon authors
 * SPDX-License-Identifier: Apache-2.0 */
/* One cloud for many threads, messages per thread, busy tasks, and a process that forks. */
#include "operations.h"

#include <pthread.h>
#include <sys/wait.h>

enum { kThreads = 8, kNeighbours = 6, kQueries = 64 };

static uint64_t points(void) { return is_sanitized() ? 5000 : 20000; }
static int rounds(void) { return is_full_run() ? 1000 : is_sanitized() ? 20 : 100; }

/* Assertions end in a longjmp, which no other thread may take: the threads only count what went wrong. */
struct worker {
  pthread_t thread;
  jalon_cloud* cloud;
  int number, wrong;
  char why[256];
};

static void note(struct worker* w, const char* why) {
  if (w->wrong++ == 0) snprintf(w->why, sizeof w->why, "%s", why);
}

static void run_threads(struct worker* workers, void* (*body)(void*), jalon_cloud* cloud) {
  for (int i = 0; i < kThreads; ++i) {
    workers[i].cloud = cloud;
    workers[i].number = i;
    workers[i].wrong = 0;
    assert_int_equal(pthread_create(&workers[i].thread, NULL, body, &workers[i]), 0);
  }
  for (int i = 0; i < kThreads; ++i) pthread_join(workers[i].thread, NULL);
  for (int i = 0; i < kThreads; ++i)
    if (workers[i].wrong) fail_msg("thread %d: %d times: %s", i, workers[i].wrong, workers[i].why);
}

/* ---- one cloud, many readers ---- */

static uint64_t expected_neighbours[kQueries * kNeighbours];

static void* query_body(void* argument) {
  struct worker* w = argument;
  const int n = rounds();
  jalon_task* task = NULL;
  if (jalon_task_create(&task) != JALON_OK) note(w, "no task");
  if (jalon_task_set_threads(task, 1 + w->number % 3) != JALON_OK) note(w, "threads");
  for (int r = 0; r < n; ++r) {
    jalon_array_view xyz;
    uint64_t found[kQueries * kNeighbours];
    jalon_fields *ranges = NULL, *near = NULL, *fields = NULL;
    jalon_box box;
    if (jalon_cloud_points(w->cloud, &xyz) != JALON_OK) note(w, "points");
    if (jalon_cloud_knn(w->cloud, xyz.data, JALON_FLOAT64, kQueries, 0, kNeighbours,
                        JALON_LEVEL_AUTOMATIC, task, found, NULL) != JALON_OK)
      note(w, jalon_last_error_message());
    else if (memcmp(found, expected_neighbours, sizeof found) != 0) note(w, "other neighbours");
    if (jalon_cloud_radius_search(w->cloud, xyz.data, JALON_FLOAT64, 16, 0, 0.2, task, &ranges,
                                  &near) != JALON_OK)
      note(w, jalon_last_error_message());
    if (jalon_cloud_fields(w->cloud, &fields) != JALON_OK ||
        jalon_cloud_bounds(w->cloud, &box) != JALON_OK)
      note(w, "fields");
    jalon_fields_release(ranges);
    jalon_fields_release(near);
    jalon_fields_release(fields);
  }
  jalon_task_release(task);
  return NULL;
}

static void threads__may_all_query_one_cloud(void** state) {
  (void)state;
  struct worker workers[kThreads];
  jalon_cloud* reference = street_cloud(points(), 5);
  jalon_array_view xyz;
  MUST(jalon_cloud_points(reference, &xyz));
  MUST(jalon_cloud_knn(reference, xyz.data, JALON_FLOAT64, kQueries, 0, kNeighbours,
                       JALON_LEVEL_AUTOMATIC, NULL, expected_neighbours, NULL));
  jalon_cloud_release(reference);
  jalon_cloud* cloud =
      street_cloud(points(), 5); /* its index is built by whichever thread comes first */
  run_threads(workers, query_body, cloud);
  jalon_cloud_release(cloud);
}

/* ---- handles of their own on shared storage ---- */

static uint64_t expected_hash;

static void* own_handle_body(void* argument) {
  struct worker* w = argument;
  const int n = 1 + rounds() / 50;
  for (int r = 0; r < n; ++r) {
    jalon_cloud* own = NULL;
    jalon_array_view normals;
    jalon_fields* fields = NULL;
    if (own_handle(w->cloud, &own) != JALON_OK) note(w, jalon_last_error_message());
    if (jalon_cloud_compute_normals(own, NULL, NULL) != JALON_OK)
      note(w, jalon_last_error_message());
    if (jalon_cloud_fields(own, &fields) != JALON_OK ||
        jalon_fields_view(fields, "normal", &normals) != JALON_OK)
      note(w, "no normals");
    else if (hash_bytes(1, normals.data, normals.count * 12) != expected_hash)
      note(w, "other normals");
    jalon_fields_release(fields);
    jalon_cloud_release(own);
  }
  return NULL;
}

static void threads__may_change_handles_of_their_own(void** state) {
  (void)state;
  struct worker workers[kThreads];
  jalon_cloud *cloud = street_cloud(points(), 6), *own;
  jalon_fields* fields;
  jalon_array_view normals;
  MUST(own_handle(cloud, &own));
  MUST(jalon_cloud_compute_normals(own, NULL, NULL));
  MUST(jalon_cloud_fields(own, &fields));
  MUST(jalon_fields_view(fields, "normal", &normals));
  assert_int_equal(normals.stride_bytes, 12);
  expected_hash = hash_bytes(1, normals.data, normals.count * 12);
  jalon_fields_release(fields);
  jalon_cloud_release(own);
  run_threads(workers, own_handle_body, cloud);
  jalon_cloud_release(cloud);
}

/* ---- create and destroy ---- */

static void* storm_body(void* argument) {
  struct worker* w = argument;
  const int n = 10 * rounds();
  double xyz[30];
  for (int i = 0; i < 30; ++i) xyz[i] = i + w->number;
  for (int r = 0; r < n; ++r) {
    jalon_cloud *made_here = NULL, *shared = jalon_cloud_retain(w->cloud);
    jalon_task* task = NULL;
    jalon_params* params = NULL;
    uint64_t count = 0;
    if (jalon_cloud_create(xyz, JALON_FLOAT64, 10, 0, 0, &made_here) != JALON_OK) note(w, "create");
    if (jalon_task_create(&task) != JALON_OK || jalon_params_create("normals", &params) != JALON_OK)
      note(w, "create");
    if (jalon_cloud_count(shared, &count) != JALON_OK || count != 100) note(w, "count");
    jalon_cloud_release(made_here);
    jalon_cloud_release(shared);
    jalon_task_release(task);
    jalon_params_release(params);
  }
  return NULL;
}

static void threads__may_create_and_destroy_in_a_storm(void** state) {
  (void)state;
  struct worker workers[kThreads];
  jalon_cloud* cloud = street_cloud(100, 7);
  run_threads(workers, storm_body, cloud);
  assert_int_equal(count_of(cloud), 100);
  jalon_cloud_release(cloud);
}

/* ---- messages ---- */

static void* message_body(void* argument) {
  struct worker* w = argument;
  const int n = 10 * rounds();
  char name[32];
  if (jalon_last_error_message()[0] != 0) note(w, "a new thread has a message");
  for (int r = 0; r < n; ++r) {
    jalon_params* params = NULL;
    snprintf(name, sizeof name, "thread_%d_round_%d", w->number, r);
    if (jalon_params_create(name, &params) != JALON_ERROR_NOT_FOUND) note(w, "found");
    if (strstr(jalon_last_error_message(), name) == NULL) note(w, "the message of another thread");
  }
  return NULL;
}

static void threads__have_a_message_each(void** state) {
  (void)state;
  struct worker workers[kThreads];
  run_threads(workers, message_body, NULL);
}

/* ---- fork ---- */

static void process__may_fork_after_use(void** state) {
  (void)state;
  jalon_cloud* cloud = street_cloud(points(), 9);
  MUST(jalon_cloud_compute_normals(cloud, NULL, NULL));
  const int forks = is_full_run() ? 100 : 5;
  for (int i = 0; i < forks; ++i) {
    const pid_t child = fork();
    if (child == 0) {
      alarm(30);
      jalon_segmenter* segmenter = NULL;
      jalon_segmentation* segmentation = NULL;
      int bad = jalon_cloud_compute_normals(cloud, NULL, NULL) != JALON_OK;
      bad |= jalon_segmenter_create(NULL, &segmenter) != JALON_OK;
      bad |= jalon_segmenter_run(segmenter, cloud, NULL, &segmentation) != JALON_OK;
      _exit(bad);
    }
    int status = -1;
    assert_int_equal(waitpid(child, &status, 0), child);
    assert_true(WIFEXITED(status));
    assert_int_equal(WEXITSTATUS(status), 0);
  }
  jalon_cloud_release(cloud);
}

int main(void) {
  const struct CMUnitTest tests[] = {
      cmocka_unit_test(threads__may_all_query_one_cloud),
      cmocka_unit_test(threads__may_change_handles_of_their_own),
      cmocka_unit_test(threads__may_create_and_destroy_in_a_storm),
      cmocka_unit_test(threads__have_a_message_each),
      cmocka_unit_test(process__may_fork_after_use),
  };
  return cmocka_run_group_tests(tests, NULL, NULL);
}

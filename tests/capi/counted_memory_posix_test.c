/* SPDX-FileCopyrightText: 2026 The Jalon authors
 * SPDX-License-Identifier: Apache-2.0 */
/* What a task counts of the memory of its calls; tests/reliability/memory_limit_test.c has all operations. */
#include "support.h"

#include "memory_counted.h"

enum { kPoints = 20000, kCalls = 100 };

static jalon_task* counting(uint64_t limit, uint32_t threads) {
  jalon_task* task;
  MUST(jalon_task_create(&task));
  MUST(jalon_task_set_memory_limit(task, limit));
  MUST(jalon_task_set_threads(task, threads));
  return task;
}
static uint64_t peak_of(const jalon_task* task) {
  uint64_t peak = 0;
  MUST(jalon_task_memory_peak(task, &peak));
  return peak;
}

static void memory__is_counted_where_there_is_a_limit_and_the_limit_stays(void** state) {
  (void)state;
  jalon_cloud* cloud = street_cloud(kPoints, 3);
  jalon_task* task = counting(0, 0);
  MUST(jalon_cloud_compute_normals(cloud, NULL, task));
  assert_int_equal(peak_of(task), 0);
  MUST(jalon_task_set_memory_limit(task, 1000));
  for (int i = 0; i < 2; ++i)
    REFUSED(JALON_ERROR_OUT_OF_MEMORY, jalon_cloud_compute_normals(cloud, NULL, task));
  MUST(jalon_cloud_compute_normals(cloud, NULL, NULL)); /* another task's */
  MUST(jalon_task_set_memory_limit(task, UINT64_MAX));
  MUST(jalon_cloud_compute_normals(cloud, NULL, task));
  assert_true(peak_of(task) > kPoints * 3 * sizeof(float)); /* the field that it makes */
  jalon_task_release(task);
  jalon_cloud_release(cloud);
}

static uint64_t peak_of_normals(uint32_t threads) {
  jalon_cloud* cloud = street_cloud(kPoints, 3);
  jalon_task* task = counting(UINT64_MAX, threads);
  MUST(jalon_cloud_compute_normals(cloud, NULL, task));
  const uint64_t peak = peak_of(task);
  jalon_task_release(task);
  jalon_cloud_release(cloud);
  return peak;
}

/* Each of seven threads gathers neighbours of its own: that is more than one thread does. On a busy machine one thread
 * may have done all before a second one wakes: several calls are made. Memory that is not counted is in none. */
static void memory__of_all_threads_of_a_call_is_counted(void** state) {
  (void)state;
  const uint64_t of_one = peak_of_normals(1);
  uint64_t of_seven = of_one;
  for (int call = 0; call < kCalls && of_seven <= of_one; ++call) of_seven = peak_of_normals(7);
  assert_true(of_seven > of_one);
}

/* A text of many growing steps: its memory is the standard library's to take. */
static void memory__of_texts_is_counted(void** state) {
  (void)state;
  jalon_cloud* cloud = street_cloud(kPoints, 3);
  jalon_task* task = counting(UINT64_MAX, 1);
  jalon_bytes* bytes = NULL;
  jalon_array_view view;
  MUST(jalon_cloud_to_bytes(cloud, task, &bytes));
  MUST(jalon_bytes_view(bytes, &view));
  assert_true(peak_of(task) >= view.count);
  assert_true(peak_of(task) < 8 * view.count);
  jalon_bytes_release(bytes);
  jalon_task_release(task);
  jalon_cloud_release(cloud);
}

struct host {
  jalon_task* task;
  jalon_status limit, peak;
};

static int32_t use_the_task(double fraction, const char* stage, void* user) {
  struct host* host = user;
  uint64_t peak;
  (void)fraction, (void)stage;
  host->limit = jalon_task_set_memory_limit(host->task, 1);
  host->peak = jalon_task_memory_peak(host->task, &peak);
  return 0;
}

static void memory__limits_are_set_between_calls(void** state) {
  (void)state;
  jalon_cloud* cloud = street_cloud(kPoints, 3);
  struct host host = {counting(UINT64_MAX, 1), JALON_OK, JALON_OK};
  MUST(jalon_task_set_progress(host.task, use_the_task, &host));
  MUST(jalon_cloud_compute_normals(cloud, NULL, host.task));
  assert_int_equal(host.limit, JALON_ERROR_BUSY);
  assert_int_equal(host.peak, JALON_ERROR_BUSY);
  REFUSED(JALON_ERROR_INVALID_ARGUMENT, jalon_task_memory_peak(host.task, NULL));
  REFUSED(JALON_ERROR_INVALID_ARGUMENT, jalon_task_set_memory_limit(NULL, 1));
  jalon_task_release(host.task);
  jalon_cloud_release(cloud);
}

int main(void) {
  if (!is_memory_counted()) return 77;
  const struct CMUnitTest tests[] = {
      cmocka_unit_test(memory__is_counted_where_there_is_a_limit_and_the_limit_stays),
      cmocka_unit_test(memory__of_all_threads_of_a_call_is_counted),
      cmocka_unit_test(memory__of_texts_is_counted),
      cmocka_unit_test(memory__limits_are_set_between_calls)};
  return cmocka_run_group_tests(tests, NULL, NULL);
}

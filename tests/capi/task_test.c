/* SPDX-FileCopyrightText: 2026 The Jalon authors
 * SPDX-License-Identifier: Apache-2.0 */
/* Tasks: cancel, threads, one call at a time. */
#include "support.h"

static void task__cancel_stays_until_reset(void** state) {
  (void)state;
  jalon_task* task;
  int32_t cancelled = 7;
  jalon_cloud* cloud = street_cloud(500, 2);
  MUST(jalon_task_create(&task));
  MUST(jalon_task_is_cancelled(task, &cancelled));
  assert_int_equal(cancelled, 0);
  MUST(jalon_task_cancel(task));
  MUST(jalon_task_is_cancelled(task, &cancelled));
  assert_int_equal(cancelled, 1);
  for (int i = 0; i < 2; ++i)
    REFUSED(JALON_ERROR_CANCELLED, jalon_cloud_compute_normals(cloud, NULL, task));
  MUST(jalon_task_reset(task));
  MUST(jalon_cloud_compute_normals(cloud, NULL, task));
  jalon_task_release(task);
  jalon_cloud_release(cloud);
}

static void task__takes_up_to_256_threads(void** state) {
  (void)state;
  jalon_task* task;
  jalon_cloud* cloud = street_cloud(2000, 3);
  MUST(jalon_task_create(&task));
  REFUSED(JALON_ERROR_INVALID_ARGUMENT, jalon_task_set_threads(task, 257));
  const uint32_t threads[] = {0, 1, 256};
  for (int i = 0; i < 3; ++i) {
    MUST(jalon_task_set_threads(task, threads[i]));
    MUST(jalon_cloud_compute_normals(cloud, NULL, task));
  }
  jalon_task_release(task);
  jalon_cloud_release(cloud);
}

struct nested {
  jalon_task* task;
  jalon_cloud* cloud;
  int calls, busy, setter_busy;
};

static int32_t use_task_again(double fraction, const char* stage, void* user) {
  struct nested* nested = user;
  (void)fraction, (void)stage;
  ++nested->calls;
  nested->busy += jalon_cloud_prepare(nested->cloud, nested->task) == JALON_ERROR_BUSY;
  nested->setter_busy += jalon_task_set_threads(nested->task, 2) == JALON_ERROR_BUSY;
  return 0;
}

static void task__runs_one_call_at_a_time(void** state) {
  (void)state;
  struct nested nested = {NULL, street_cloud(20000, 8), 0, 0, 0};
  MUST(jalon_task_create(&nested.task));
  MUST(jalon_task_set_progress(nested.task, use_task_again, &nested));
  MUST(jalon_cloud_compute_normals(nested.cloud, NULL, nested.task));
  assert_true(nested.calls >= 1);
  assert_int_equal(nested.busy, nested.calls);
  assert_int_equal(nested.setter_busy, nested.calls);
  MUST(jalon_task_set_progress(nested.task, NULL, NULL));
  MUST(jalon_cloud_prepare(nested.cloud, nested.task)); /* free again */
  jalon_task_release(nested.task);
  jalon_cloud_release(nested.cloud);
}

int main(void) {
  const struct CMUnitTest tests[] = {
      cmocka_unit_test(task__cancel_stays_until_reset),
      cmocka_unit_test(task__takes_up_to_256_threads),
      cmocka_unit_test(task__runs_one_call_at_a_time),
  };
  return cmocka_run_group_tests(tests, NULL, NULL);
}

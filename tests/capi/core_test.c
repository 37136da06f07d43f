/* SPDX-FileCopyrightText: 2026 The Jalon authors
 * SPDX-License-Identifier: Apache-2.0 */
/* Statuses, messages, tasks and the life of handles. */
#include "support.h"

/* ---- statuses ---- */

static void status__each_has_a_name_of_its_own(void** state) {
  (void)state;
  const int32_t numbers[] = {0, -1, -2, -3, -4, -5, -6, -7, -8, -9, -10, -11, -12, -99};
  for (size_t i = 0; i < 14; ++i) {
    assert_string_not_equal(jalon_status_name(numbers[i]), "unknown status");
    for (size_t j = 0; j < i; ++j)
      assert_string_not_equal(jalon_status_name(numbers[i]), jalon_status_name(numbers[j]));
  }
  assert_string_equal(jalon_status_name(-98), "unknown status");
  assert_string_equal(jalon_status_name(1), "unknown status");
}

static void message__stays_until_the_next_failure(void** state) {
  (void)state;
  char first[1024];
  uint64_t count;
  jalon_params* params;
  REFUSED(JALON_ERROR_NOT_FOUND, jalon_params_create("no such operation", &params));
  snprintf(first, sizeof first, "%s", jalon_last_error_message());
  assert_non_null(strstr(first, "no such operation"));
  MUST(jalon_params_operation_count(&count));
  assert_string_equal(jalon_last_error_message(), first);
  REFUSED(JALON_ERROR_INVALID_ARGUMENT, jalon_params_operation_count(NULL));
  assert_string_not_equal(jalon_last_error_message(), first);
}

static void message__is_one_line_whatever_the_caller_wrote(void** state) {
  (void)state;
  jalon_params* params;
  REFUSED(JALON_ERROR_NOT_FOUND, jalon_params_create("two\nlines\tand \x1b[31mcolour", &params));
  REFUSED(JALON_ERROR_INVALID_ARGUMENT, jalon_params_create("not utf-8 \xC3(", &params));
  char text[60001];
  for (size_t i = 0; i < 60000; i += 2) memcpy(text + i, "\xC3\xA9", 2);
  text[60000] = 0;
  REFUSED(JALON_ERROR_NOT_FOUND, jalon_params_create(text, &params));
  assert_true(strlen(jalon_last_error_message()) < 1024);
}

/* ---- tasks ---- */

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

static void handles__live_as_long_as_any_owner(void** state) {
  (void)state;
  jalon_task* task;
  MUST(jalon_task_create(&task));
  assert_ptr_equal(jalon_task_retain(task), task);
  jalon_task_release(task);
  MUST(jalon_task_reset(task));
  jalon_task_release(task);
  jalon_task_release(NULL);
  assert_null(jalon_task_retain(NULL));
  /* A result keeps what it looks at; the order of releases is free. */
  jalon_cloud* cloud = street_cloud(3000, 4);
  jalon_segmenter* segmenter;
  jalon_segmentation* segmentation;
  jalon_fields* points;
  jalon_array_view labels;
  MUST(jalon_segmenter_create(NULL, &segmenter));
  MUST(jalon_segmenter_run(segmenter, cloud, NULL, &segmentation));
  jalon_cloud_release(cloud);
  jalon_segmenter_release(segmenter);
  MUST(jalon_segmentation_points(segmentation, &points));
  jalon_segmentation_release(segmentation);
  MUST(jalon_fields_view(points, "label", &labels));
  assert_int_equal(labels.count, 3000);
  uint32_t largest = 0;
  for (uint64_t i = 0; i < labels.count; ++i) {
    const uint32_t label = *(const uint32_t*)((const char*)labels.data + i * labels.stride_bytes);
    largest = label > largest ? label : largest;
  }
  assert_true(largest >= 1);
  jalon_fields_release(points);
}

int main(void) {
  const struct CMUnitTest tests[] = {
      cmocka_unit_test(status__each_has_a_name_of_its_own),
      cmocka_unit_test(message__stays_until_the_next_failure),
      cmocka_unit_test(message__is_one_line_whatever_the_caller_wrote),
      cmocka_unit_test(task__cancel_stays_until_reset),
      cmocka_unit_test(task__takes_up_to_256_threads),
      cmocka_unit_test(handles__live_as_long_as_any_owner),
  };
  return cmocka_run_group_tests(tests, NULL, NULL);
}

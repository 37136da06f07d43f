/* SPDX-FileCopyrightText: 2026 The Jalon authors
 * SPDX-License-Identifier: Apache-2.0 */
/* The life of handles. */
#include "support.h"

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
      cmocka_unit_test(handles__live_as_long_as_any_owner),
  };
  return cmocka_run_group_tests(tests, NULL, NULL);
}

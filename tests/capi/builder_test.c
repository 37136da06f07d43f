/* SPDX-FileCopyrightText: 2026 The Jalon authors
 * SPDX-License-Identifier: Apache-2.0 */
#include <jalon/jalon.h>
#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <string.h>

#include <cmocka.h>

#define OK(call) assert_int_equal((call), JALON_OK)
#define INVALID(call) assert_int_equal((call), JALON_ERROR_INVALID_ARGUMENT)

static void build__two_stations_in_blocks__gives_points_fields_and_ranges(void** state) {
  (void)state;
  jalon_cloud_builder* builder = NULL;
  jalon_cloud* cloud = NULL;
  jalon_fields* fields = NULL;
  const float block[9] = {1, 2, 3, 4, 5, 6, 7, 8, 9};
  const double wide[5] = {10, 20, 30, 40, 50};
  const jalon_transform pose = {{1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 1.7}};
  double values[5];
  uint64_t n = 0, first = 0, count = 0;
  int32_t has_pose = 0;
  const char* text = NULL;
  OK(jalon_cloud_builder_create(0, &builder));
  OK(jalon_cloud_builder_set_crs(builder, "EPSG:2154"));
  OK(jalon_cloud_builder_declare_field(builder, "intensity", JALON_UINT16, 1, "1", NULL));
  OK(jalon_cloud_builder_begin_station(builder, "A", &pose));
  OK(jalon_cloud_builder_append_points(builder, block, JALON_FLOAT32, 3, 0));
  OK(jalon_cloud_builder_append_field(builder, "intensity", wide, JALON_FLOAT64, 4,
                                      0)); /* ahead of the points */
  OK(jalon_cloud_builder_begin_station(builder, "B", NULL));
  OK(jalon_cloud_builder_append_points(builder, block, JALON_FLOAT32, 2, 0));
  OK(jalon_cloud_builder_append_field(builder, "intensity", wide + 4, JALON_FLOAT64, 1, 0));
  OK(jalon_cloud_builder_seal(builder, &cloud));
  OK(jalon_cloud_count(cloud, &n));
  assert_int_equal(n, 5);
  OK(jalon_cloud_station(cloud, 1, &text, &has_pose, NULL, &first, &count));
  assert_string_equal(text, "B");
  assert_true(has_pose == 0 && first == 3 && count == 2);
  OK(jalon_cloud_fields(cloud, &fields));
  OK(jalon_fields_copy(fields, "intensity", JALON_FLOAT64, values, 5));
  assert_true(values[0] == 10 && values[4] == 50);
  OK(jalon_cloud_crs(cloud, &text));
  assert_string_equal(text, "EPSG:2154");
  jalon_fields_release(fields);
  jalon_cloud_release(cloud);
  /* Sealed: the builder is as new. */
  OK(jalon_cloud_builder_seal(builder, &cloud));
  OK(jalon_cloud_count(cloud, &n));
  assert_int_equal(n, 0);
  jalon_cloud_release(cloud);
  jalon_cloud_builder_release(builder);
}

static void build__drop_invalid__drops_the_field_values_too(void** state) {
  (void)state;
  jalon_cloud_builder* builder = NULL;
  jalon_cloud* cloud = NULL;
  jalon_fields* fields = NULL;
  const double xyz[12] = {0, 0, 0, NAN, 0, 0, 1, 1, 1, 0, INFINITY, 0};
  const int32_t number[4] = {0, 1, 2, 3};
  int32_t kept[4] = {-1, -1, -1, -1};
  uint64_t n = 0, first = 0, count = 0;
  OK(jalon_cloud_builder_create(JALON_CLOUD_DROP_INVALID, &builder));
  OK(jalon_cloud_builder_declare_field(builder, "number", JALON_INT32, 1, NULL, NULL));
  OK(jalon_cloud_builder_begin_station(builder, "S", NULL));
  OK(jalon_cloud_builder_append_points(builder, xyz, JALON_FLOAT64, 4, 0));
  OK(jalon_cloud_builder_append_field(builder, "number", number, JALON_INT32, 4, 0));
  OK(jalon_cloud_builder_seal(builder, &cloud));
  OK(jalon_cloud_count(cloud, &n));
  assert_int_equal(n, 2);
  OK(jalon_cloud_fields(cloud, &fields));
  OK(jalon_fields_copy(fields, "number", JALON_INT32, kept, 4));
  assert_true(kept[0] == 0 && kept[1] == 2);
  OK(jalon_cloud_station(cloud, 0, NULL, NULL, NULL, &first, &count));
  assert_true(first == 0 && count == 2);
  jalon_fields_release(fields);
  jalon_cloud_release(cloud);
  jalon_cloud_builder_release(builder);
}

static void build__mistakes__are_refused_and_leave_the_builder_as_it_was(void** state) {
  (void)state;
  jalon_cloud_builder* builder = NULL;
  jalon_cloud* cloud = NULL;
  const double good[6] = {0, 0, 0, 1, 1, 1}, bad[6] = {0, 0, 0, 1, NAN, 1};
  const double big = 70000;
  uint64_t n = 0;
  INVALID(jalon_cloud_builder_create(2, &builder));
  INVALID(jalon_cloud_builder_create(0, NULL));
  OK(jalon_cloud_builder_create(0, &builder));
  OK(jalon_cloud_builder_declare_field(builder, "f", JALON_UINT16, 1, NULL, NULL));
  INVALID(jalon_cloud_builder_declare_field(builder, "f", JALON_UINT16, 1, NULL, NULL));
  OK(jalon_cloud_builder_append_points(builder, good, JALON_FLOAT64, 2, 0));
  INVALID(jalon_cloud_builder_append_points(builder, bad, JALON_FLOAT64, 2, 0));
  assert_string_equal(jalon_last_error_message(), "point 3: y is nan, not a finite number");
  assert_int_equal(jalon_cloud_builder_append_field(builder, "g", good, JALON_FLOAT64, 1, 0),
                   JALON_ERROR_NOT_FOUND);
  INVALID(jalon_cloud_builder_append_field(builder, "f", &big, JALON_FLOAT64, 1, 0));
  INVALID(jalon_cloud_builder_seal(builder, &cloud));
  assert_string_equal(jalon_last_error_message(), "field \"f\" has 0 items for 2 points");
  assert_null(cloud);
  OK(jalon_cloud_builder_append_field(builder, "f", good, JALON_FLOAT64, 2, 0));
  OK(jalon_cloud_builder_seal(builder, &cloud));
  OK(jalon_cloud_count(cloud, &n));
  assert_int_equal(n, 2);
  jalon_cloud_release(cloud);
  jalon_cloud_builder_release(jalon_cloud_builder_retain(builder));
  jalon_cloud_builder_release(builder);
  jalon_cloud_builder_release(NULL);
}

int main(void) {
  const struct CMUnitTest tests[] = {
      cmocka_unit_test(build__two_stations_in_blocks__gives_points_fields_and_ranges),
      cmocka_unit_test(build__drop_invalid__drops_the_field_values_too),
      cmocka_unit_test(build__mistakes__are_refused_and_leave_the_builder_as_it_was),
  };
  return cmocka_run_group_tests(tests, NULL, NULL);
}

/* SPDX-FileCopyrightText: 2026 The Jalon authors
 * SPDX-License-Identifier: Apache-2.0 */
#include <jalon/jalon.h>
#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <string.h>

#include <cmocka.h>

#define OK(call) assert_int_equal((call), JALON_OK)
#define INVALID(call) assert_int_equal((call), JALON_ERROR_INVALID_ARGUMENT)

static const double kFour[12] = {0, 0, 0, 1, 0, 0, 0, 2, 0, 0, 0, 3};

static jalon_cloud* four(void) {
  jalon_cloud* cloud = NULL;
  OK(jalon_cloud_create(kFour, JALON_FLOAT64, 4, 0, 0, &cloud));
  return cloud;
}

static uint64_t count_of(const jalon_cloud* cloud) {
  uint64_t n = 0;
  OK(jalon_cloud_count(cloud, &n));
  return n;
}

static double coordinate(const jalon_cloud* cloud, uint64_t i, int c) {
  jalon_array_view view;
  OK(jalon_cloud_points(cloud, &view));
  return ((const double*)view.data)[3 * i + (uint64_t)c];
}

static double field_value(const jalon_cloud* cloud, const char* name, uint64_t i) {
  jalon_fields* fields = NULL;
  jalon_array_view view;
  double values[64];
  OK(jalon_cloud_fields(cloud, &fields));
  OK(jalon_fields_view(fields, name, &view));
  OK(jalon_fields_copy(fields, name, JALON_FLOAT64, values, 64));
  jalon_fields_release(fields);
  return values[i];
}

static void create__strided_records_of_every_type__keep_the_values(void** state) {
  (void)state;
  struct record {
    char tag;
    float xyz[3];
    short more;
  } records[3] = {{0, {1, 2, 3}, 0}, {0, {4, 5, 6}, 0}, {0, {7, 8, 9}, 0}};
  const int16_t shorts[6] = {-1, -2, -3, 4, 5, 6};
  const uint8_t bytes[6] = {1, 2, 3, 250, 251, 252};
  const int64_t longs[3] = {652000, 6861000, -120};
  jalon_cloud* cloud = NULL;
  OK(jalon_cloud_create(records[0].xyz, JALON_FLOAT32, 3, sizeof records[0], 0, &cloud));
  assert_int_equal(count_of(cloud), 3);
  assert_true(coordinate(cloud, 2, 0) == 7 && coordinate(cloud, 1, 2) == 6);
  jalon_cloud_release(cloud);
  OK(jalon_cloud_create(shorts, JALON_INT16, 2, 0, 0, &cloud));
  assert_true(coordinate(cloud, 0, 1) == -2);
  jalon_cloud_release(cloud);
  OK(jalon_cloud_create(bytes, JALON_UINT8, 2, 0, 0, &cloud));
  assert_true(coordinate(cloud, 1, 2) == 252);
  jalon_cloud_release(cloud);
  OK(jalon_cloud_create(longs, JALON_INT64, 1, 0, 0, &cloud));
  assert_true(coordinate(cloud, 0, 1) == 6861000);
  jalon_cloud_release(cloud);
}

static void create__unaligned_memory__is_read_bytewise(void** state) {
  (void)state;
  unsigned char memory[1 + 2 * 25];
  const double xyz[6] = {1, 2, 3, 4, 5, 6};
  jalon_cloud* cloud = NULL;
  memcpy(memory + 1, xyz, 24);
  memcpy(memory + 26, xyz + 3, 24);
  OK(jalon_cloud_create(memory + 1, JALON_FLOAT64, 2, 25, 0, &cloud));
  assert_true(coordinate(cloud, 1, 1) == 5);
  jalon_cloud_release(cloud);
}

static void create_columns__three_arrays__make_points(void** state) {
  (void)state;
  const double x[3] = {1, 2, 3}, y[3] = {4, 5, 6}, z[3] = {7, 8, NAN};
  jalon_cloud* cloud = NULL;
  INVALID(jalon_cloud_create_columns(x, y, z, JALON_FLOAT64, 3, 0, 0, &cloud));
  assert_string_equal(jalon_last_error_message(), "point 2: z is nan, not a finite number");
  assert_null(cloud);
  OK(jalon_cloud_create_columns(x, y, z, JALON_FLOAT64, 3, 0, JALON_CLOUD_DROP_INVALID, &cloud));
  assert_int_equal(count_of(cloud), 2);
  assert_true(coordinate(cloud, 1, 2) == 8);
  jalon_cloud_release(cloud);
}

static void create__bad_arguments__are_refused_with_a_line(void** state) {
  (void)state;
  jalon_cloud* cloud = NULL;
  INVALID(jalon_cloud_create(NULL, JALON_FLOAT64, 1, 0, 0, &cloud));
  INVALID(jalon_cloud_create(kFour, 99, 1, 0, 0, &cloud));
  INVALID(jalon_cloud_create(kFour, JALON_FLOAT64, 1, 4, 0, &cloud));
  INVALID(jalon_cloud_create(kFour, JALON_FLOAT64, UINT64_MAX, 0, 0, &cloud));
  INVALID(jalon_cloud_create(kFour, JALON_FLOAT64, 4, 0, 8, &cloud));
  INVALID(jalon_cloud_create(kFour, JALON_FLOAT64, 4, 0, 0, NULL));
  assert_null(cloud);
  OK(jalon_cloud_create(NULL, JALON_FLOAT64, 0, 0, 0, &cloud));
  assert_int_equal(count_of(cloud), 0);
  jalon_box box;
  assert_int_equal(jalon_cloud_bounds(cloud, &box), JALON_ERROR_INSUFFICIENT_DATA);
  jalon_cloud_release(cloud);
  jalon_cloud_release(NULL);
}

static void looking__bounds_points_crs_and_stations(void** state) {
  (void)state;
  jalon_cloud* cloud = four();
  jalon_box box;
  const char *crs = NULL, *name = NULL;
  uint64_t stations = 9, first = 9, count = 9;
  int32_t has_pose = 9;
  jalon_transform pose = {{1, 0, 0, 5, 0, 1, 0, 6, 0, 0, 1, 7}}, back;
  OK(jalon_cloud_bounds(cloud, &box));
  assert_true(box.max.x == 1 && box.max.y == 2 && box.max.z == 3 && box.min.x == 0);
  OK(jalon_cloud_crs(cloud, &crs));
  assert_string_equal(crs, "");
  OK(jalon_cloud_set_crs(cloud, "EPSG:2154"));
  OK(jalon_cloud_crs(cloud, &crs));
  OK(jalon_cloud_station_count(cloud, &stations));
  assert_int_equal(stations, 0);
  INVALID(jalon_cloud_station(cloud, 0, NULL, NULL, NULL, NULL, NULL));
  OK(jalon_cloud_set_station(cloud, "tripod 1", &pose));
  OK(jalon_cloud_station(cloud, 0, &name, &has_pose, &back, &first, &count));
  assert_string_equal(name, "tripod 1");
  assert_true(has_pose == 1 && first == 0 && count == 4 && back.m[11] == 7);
  /* The texts outlive changes of other things. */
  OK(jalon_cloud_compute_normals(cloud, NULL, NULL));
  assert_string_equal(crs, "EPSG:2154");
  assert_string_equal(name, "tripod 1");
  pose.m[0] = NAN;
  INVALID(jalon_cloud_set_station(cloud, "x", &pose));
  INVALID(jalon_cloud_set_crs(cloud, "\xff"));
  jalon_cloud_release(cloud);
}

static void fields__set_replace_remove__and_a_snapshot_stays(void** state) {
  (void)state;
  jalon_cloud* cloud = four();
  const float intensity[4] = {1, 2, 3, 4}, other[4] = {9, 9, 9, 9};
  jalon_fields* snapshot = NULL;
  jalon_array_view view;
  uint64_t n = 0;
  OK(jalon_cloud_set_field(cloud, "intensity", intensity, JALON_FLOAT32, 1, 4, 0, "1",
                           "return strength"));
  OK(jalon_cloud_fields(cloud, &snapshot));
  OK(jalon_cloud_set_field(cloud, "intensity", other, JALON_FLOAT32, 1, 4, 0, NULL, NULL));
  OK(jalon_fields_view(snapshot, "intensity", &view));
  assert_true(((const float*)view.data)[2] == 3);
  assert_true(field_value(cloud, "intensity", 2) == 9);
  OK(jalon_cloud_remove_field(cloud, "intensity"));
  assert_int_equal(jalon_cloud_remove_field(cloud, "intensity"), JALON_ERROR_NOT_FOUND);
  OK(jalon_fields_count(snapshot, &n));
  assert_int_equal(n, 1);
  jalon_cloud_release(cloud);
  assert_true(((const float*)view.data)[3] == 4);
  jalon_fields_release(snapshot);
  cloud = four();
  INVALID(jalon_cloud_set_field(cloud, "f", intensity, JALON_FLOAT32, 1, 3, 0, NULL, NULL));
  assert_string_equal(jalon_last_error_message(),
                      "field \"f\" has 3 items; the cloud has 4 points");
  INVALID(jalon_cloud_set_field(cloud, "", intensity, JALON_FLOAT32, 1, 4, 0, NULL, NULL));
  INVALID(jalon_cloud_set_field(cloud, "f", intensity, JALON_FLOAT32, 0, 4, 0, NULL, NULL));
  INVALID(jalon_cloud_set_field(cloud, "f", NULL, JALON_FLOAT32, 1, 4, 0, NULL, NULL));
  jalon_cloud_release(cloud);
}

static void select_split_append_transform__give_new_clouds(void** state) {
  (void)state;
  jalon_cloud *cloud = four(), *some = NULL, *equal = NULL, *others = NULL, *both = NULL,
              *moved = NULL;
  const uint8_t kind[4] = {1, 2, 1, 1};
  const uint64_t indices[3] = {3, 3, 0}, wrong[1] = {4};
  const jalon_transform shift = {{1, 0, 0, 652000, 0, 1, 0, 6861000, 0, 0, 1, 0}};
  const jalon_transform flat = {{1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 0, 0}};
  OK(jalon_cloud_set_field(cloud, "kind", kind, JALON_UINT8, 1, 4, 0, NULL, NULL));
  OK(jalon_cloud_select(cloud, indices, 3, NULL, &some));
  assert_true(count_of(some) == 3 && coordinate(some, 1, 2) == 3 &&
              field_value(some, "kind", 2) == 1);
  INVALID(jalon_cloud_select(cloud, wrong, 1, NULL, &equal));
  OK(jalon_cloud_split(cloud, "kind", 1, NULL, &equal, &others));
  assert_true(count_of(equal) == 3 && count_of(others) == 1);
  OK(jalon_cloud_append(equal, others, NULL, &both));
  assert_int_equal(count_of(both), 4);
  OK(jalon_cloud_transform(both, &shift, NULL, &moved));
  assert_true(coordinate(moved, 3, 0) == 652001);
  jalon_cloud_release(moved);
  moved = NULL;
  INVALID(jalon_cloud_transform(both, &flat, NULL, &moved));
  assert_null(moved);
  assert_int_equal(jalon_cloud_split(cloud, "none", 1, NULL, NULL, NULL), JALON_ERROR_NOT_FOUND);
  OK(jalon_cloud_split(cloud, "kind", 1, NULL, NULL, NULL));
  jalon_cloud_release(cloud);
  jalon_cloud_release(some);
  jalon_cloud_release(equal);
  jalon_cloud_release(others);
  jalon_cloud_release(both);
}

static void crop__box_polygon_cylinder__inside_and_outside(void** state) {
  (void)state;
  jalon_cloud *cloud = four(), *in = NULL, *out = NULL;
  const jalon_box box = {{-1, -1, -1}, {1, 1, 1}}, wrong = {{1, 0, 0}, {0, 1, 1}};
  const double triangle[6] = {-1, -1, 3, -1, -1, 0.5};
  const jalon_vec3 foot = {0, 0, -1}, top = {0, 0, 5};
  OK(jalon_cloud_crop_box(cloud, &box, NULL, NULL, &in, &out));
  assert_true(count_of(in) == 2 && count_of(out) == 2);
  jalon_cloud_release(in);
  jalon_cloud_release(out);
  INVALID(jalon_cloud_crop_box(cloud, &wrong, NULL, NULL, &in, NULL));
  OK(jalon_cloud_crop_polygon(cloud, triangle, 3, 0, 1, NULL, NULL, &in, NULL));
  assert_int_equal(count_of(in), 1);
  jalon_cloud_release(in);
  INVALID(jalon_cloud_crop_polygon(cloud, triangle, 2, 0, 1, NULL, NULL, &in, NULL));
  INVALID(jalon_cloud_crop_polygon(cloud, triangle, 3, 1, 0, NULL, NULL, &in, NULL));
  INVALID(jalon_cloud_crop_polygon(cloud, triangle, UINT64_MAX, 0, 1, NULL, NULL, &in, NULL));
  OK(jalon_cloud_crop_cylinder(cloud, &foot, &top, 1.0, NULL, &in, &out));
  assert_true(count_of(in) == 3 && coordinate(out, 0, 1) == 2);
  jalon_cloud_release(in);
  jalon_cloud_release(out);
  INVALID(jalon_cloud_crop_cylinder(cloud, &foot, &foot, 1.0, NULL, &in, NULL));
  INVALID(jalon_cloud_crop_cylinder(cloud, &foot, &top, 0.0, NULL, &in, NULL));
  jalon_cloud_release(cloud);
}

int main(void) {
  const struct CMUnitTest tests[] = {
      cmocka_unit_test(create__strided_records_of_every_type__keep_the_values),
      cmocka_unit_test(create__unaligned_memory__is_read_bytewise),
      cmocka_unit_test(create_columns__three_arrays__make_points),
      cmocka_unit_test(create__bad_arguments__are_refused_with_a_line),
      cmocka_unit_test(looking__bounds_points_crs_and_stations),
      cmocka_unit_test(fields__set_replace_remove__and_a_snapshot_stays),
      cmocka_unit_test(select_split_append_transform__give_new_clouds),
      cmocka_unit_test(crop__box_polygon_cylinder__inside_and_outside),
  };
  return cmocka_run_group_tests(tests, NULL, NULL);
}

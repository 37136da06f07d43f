/* SPDX-FileCopyrightText: 2026 The Jalon authors
 * SPDX-License-Identifier: Apache-2.0 */
/* Snapshots of fields: copies in other types, structs of other sizes, and how long they live. */
#include "lifted_square.h"

/* Three points with "level" (int16) and "colour" (uint8 x 2). */
static jalon_fields* snapshot_of_three(jalon_cloud** cloud) {
  const double xyz[9] = {0};
  const int16_t level[3] = {-300, 7, 255};
  const uint8_t colour[6] = {1, 2, 3, 4, 5, 6};
  jalon_fields* fields = NULL;
  *cloud = cloud_of(xyz, 3);
  MUST(
      jalon_cloud_set_field(*cloud, "level", level, JALON_INT16, 1, 3, 0, "cm", "over the street"));
  MUST(jalon_cloud_set_field(*cloud, "colour", colour, JALON_UINT8, 2, 3, 0, NULL, NULL));
  MUST(jalon_cloud_fields(*cloud, &fields));
  return fields;
}

static void copy__converts_or_writes_nothing(void** state) {
  (void)state;
  jalon_cloud* cloud = NULL;
  jalon_fields* fields = snapshot_of_three(&cloud);
  double wide[4] = {9, 9, 9, 9};
  float colours[6];
  uint8_t narrow[4] = {9, 9, 9, 9};
  int64_t whole[3];
  MUST(jalon_fields_copy(fields, "level", JALON_FLOAT64, wide, 4));
  assert_true(wide[0] == -300 && wide[1] == 7 && wide[2] == 255 && wide[3] == 9);
  MUST(jalon_fields_copy(fields, "level", JALON_INT64, whole, 3));
  assert_true(whole[0] == -300 && whole[2] == 255);
  MUST(jalon_fields_copy(fields, "colour", JALON_FLOAT32, colours, 6)); /* item by item */
  for (int i = 0; i < 6; ++i) assert_true(colours[i] == (float)(i + 1));
  REFUSED(JALON_ERROR_INVALID_ARGUMENT, jalon_fields_copy(fields, "level", JALON_UINT8, narrow, 4));
  for (int i = 0; i < 4; ++i) assert_int_equal(narrow[i], 9);
  REFUSED(JALON_ERROR_INVALID_ARGUMENT,
          jalon_fields_copy(fields, "colour", JALON_UINT8, narrow, 5));
  expect_message("room for 5 elements; field \"colour\" has 6");
  for (int i = 0; i < 4; ++i) assert_int_equal(narrow[i], 9);
  REFUSED(JALON_ERROR_INVALID_ARGUMENT, jalon_fields_copy(fields, "level", 11, wide, 4));
  expect_message("11 is no element type");
  REFUSED(JALON_ERROR_INVALID_ARGUMENT, jalon_fields_copy(fields, "level", JALON_INT16, NULL, 4));
  REFUSED(JALON_ERROR_NOT_FOUND, jalon_fields_copy(fields, "height", JALON_INT16, narrow, 4));
  expect_message("level");
  expect_message("colour");
  jalon_fields_release(fields);
  jalon_cloud_release(cloud);
  /* A column without items needs no room. */
  cloud = cloud_of(NULL, 0);
  MUST(jalon_cloud_set_field(cloud, "none", NULL, JALON_INT32, 1, 0, 0, NULL, NULL));
  MUST(jalon_cloud_fields(cloud, &fields));
  MUST(jalon_fields_copy(fields, "none", JALON_FLOAT64, NULL, 0));
  jalon_fields_release(fields);
  jalon_cloud_release(cloud);
}

static void info__serves_structs_of_any_size(void** state) {
  (void)state;
  jalon_cloud* cloud = NULL;
  jalon_fields* fields = snapshot_of_three(&cloud);
  jalon_field_info info;
  memset(&info, 0xAB, sizeof info);
  info.struct_size = sizeof info;
  MUST(jalon_fields_info(fields, 0, &info));
  assert_true(info.type == JALON_INT16 && info.components == 1 && info.count == 3);
  assert_true(info.reserved == 0 && info.struct_size == sizeof info);
  assert_string_equal(info.name, "level");
  assert_string_equal(info.unit, "cm");
  assert_string_equal(info.meaning, "over the street");
  /* An older caller: only the first three members. */
  union {
    jalon_field_info info;
    unsigned char bytes[sizeof(jalon_field_info)];
  } small;
  memset(&small, 0xAB, sizeof small);
  small.info.struct_size = 12;
  MUST(jalon_fields_info(fields, 1, &small.info));
  assert_int_equal(small.info.components, 2);
  for (size_t i = 12; i < sizeof small; ++i) assert_int_equal(small.bytes[i], 0xAB);
  /* A newer caller: the members that are not known stay. */
  struct {
    jalon_field_info known;
    uint64_t later;
  } large;
  memset(&large, 0xAB, sizeof large);
  large.known.struct_size = sizeof large;
  MUST(jalon_fields_info(fields, 1, &large.known));
  assert_string_equal(large.known.unit, "");
  assert_true(large.later == 0xABABABABABABABABu);
  info.struct_size = 0;
  REFUSED(JALON_ERROR_INVALID_ARGUMENT, jalon_fields_info(fields, 0, &info));
  expect_message("struct_size");
  info.struct_size = sizeof info;
  REFUSED(JALON_ERROR_INVALID_ARGUMENT, jalon_fields_info(fields, 2, &info));
  expect_message("there are 2 fields");
  REFUSED(JALON_ERROR_INVALID_ARGUMENT, jalon_fields_info(fields, UINT64_MAX, &info));
  jalon_fields_release(fields);
  jalon_cloud_release(cloud);
}

static void view__is_good_until_the_last_owner_goes(void** state) {
  (void)state;
  jalon_cloud* cloud = NULL;
  jalon_fields* fields = snapshot_of_three(&cloud);
  jalon_array_view view;
  uint64_t count = 0;
  MUST(jalon_fields_view(fields, "colour", &view));
  MUST(jalon_cloud_remove_field(cloud, "colour"));
  jalon_cloud_release(cloud);
  assert_ptr_equal(jalon_fields_retain(fields), fields);
  jalon_fields_release(fields);
  assert_true(view.count == 3 && view.components == 2 && view.type == JALON_UINT8);
  assert_int_equal(view.stride_bytes, 2);
  for (int i = 0; i < 6; ++i) assert_int_equal(((const uint8_t*)view.data)[i], i + 1);
  MUST(jalon_fields_count(fields, &count));
  assert_int_equal(count, 2);
  const jalon_array_view before = view;
  REFUSED(JALON_ERROR_NOT_FOUND, jalon_fields_view(fields, "colours", &view));
  REFUSED(JALON_ERROR_INVALID_ARGUMENT, jalon_fields_view(fields, NULL, &view));
  assert_ptr_equal(view.data, before.data); /* outputs are written on success only */
  jalon_fields_release(fields);
  jalon_fields_release(NULL);
  assert_null(jalon_fields_retain(NULL));
}

int main(void) {
  const struct CMUnitTest tests[] = {
      cmocka_unit_test(copy__converts_or_writes_nothing),
      cmocka_unit_test(info__serves_structs_of_any_size),
      cmocka_unit_test(view__is_good_until_the_last_owner_goes),
  };
  return cmocka_run_group_tests(tests, NULL, NULL);
}

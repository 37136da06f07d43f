/* SPDX-FileCopyrightText: 2026 The Jalon authors
 * SPDX-License-Identifier: Apache-2.0 */
/* The layout of the public structs and the numbers of the constants: a changed line here is a broken program
 * somewhere. */
#include "support.h"

#define AT(type, member, offset) assert_int_equal(offsetof(type, member), offset)

static void layout__of_frozen_structs_never_changes(void** state) {
  (void)state;
  assert_int_equal(sizeof(jalon_vec3), 24);
  AT(jalon_vec3, x, 0), AT(jalon_vec3, y, 8), AT(jalon_vec3, z, 16);
  assert_int_equal(sizeof(jalon_box), 48);
  AT(jalon_box, min, 0), AT(jalon_box, max, 24);
  assert_int_equal(sizeof(jalon_transform), 96);
  AT(jalon_transform, m, 0);
  assert_int_equal(sizeof(jalon_reduction), 32);
  AT(jalon_reduction, count_in, 0), AT(jalon_reduction, count_out, 8),
      AT(jalon_reduction, removed, 16);
  AT(jalon_reduction, removed_percent, 24);
  assert_int_equal(sizeof(jalon_array_view), 16 + 2 * sizeof(void*));
  AT(jalon_array_view, data, 0), AT(jalon_array_view, count, 8),
      AT(jalon_array_view, components, 16);
  AT(jalon_array_view, type, 20), AT(jalon_array_view, stride_bytes, 24);
}

static void layout__of_sized_structs_only_grows_at_the_end(void** state) {
  (void)state;
  assert_true(sizeof(jalon_field_info) >= 24 + 3 * sizeof(char*));
  AT(jalon_field_info, struct_size, 0), AT(jalon_field_info, type, 4),
      AT(jalon_field_info, components, 8);
  AT(jalon_field_info, reserved, 12), AT(jalon_field_info, count, 16),
      AT(jalon_field_info, name, 24);
  AT(jalon_field_info, unit, 24 + sizeof(char*)),
      AT(jalon_field_info, meaning, 24 + 2 * sizeof(char*));
  assert_true(sizeof(jalon_param_info) >= 24 + 6 * sizeof(char*));
  AT(jalon_param_info, struct_size, 0), AT(jalon_param_info, type, 4),
      AT(jalon_param_info, name, 8);
  AT(jalon_param_info, unit, 8 + sizeof(char*)),
      AT(jalon_param_info, methods, 8 + 2 * sizeof(char*));
  AT(jalon_param_info, help, 8 + 3 * sizeof(char*)),
      AT(jalon_param_info, choices, 8 + 4 * sizeof(char*));
  AT(jalon_param_info, default_text, 8 + 5 * sizeof(char*)),
      AT(jalon_param_info, minimum, 8 + 6 * sizeof(char*));
  AT(jalon_param_info, maximum, 16 + 6 * sizeof(char*));
}

static void constants__keep_their_numbers(void** state) {
  (void)state;
  const int32_t types[] = {JALON_INT8,   JALON_UINT8, JALON_INT16,  JALON_UINT16,  JALON_INT32,
                           JALON_UINT32, JALON_INT64, JALON_UINT64, JALON_FLOAT32, JALON_FLOAT64};
  for (int32_t i = 0; i < 10; ++i) assert_int_equal(types[i], i + 1);
  const int32_t statuses[] = {JALON_OK,
                              JALON_ERROR_INVALID_ARGUMENT,
                              JALON_ERROR_OUT_OF_MEMORY,
                              JALON_ERROR_CANCELLED,
                              JALON_ERROR_NOT_FOUND,
                              JALON_ERROR_INSUFFICIENT_DATA,
                              JALON_ERROR_DEGENERATE,
                              JALON_ERROR_IO,
                              JALON_ERROR_FORMAT,
                              JALON_ERROR_UNSUPPORTED,
                              JALON_ERROR_CALLBACK,
                              JALON_ERROR_BUSY,
                              JALON_ERROR_LIMIT};
  for (int32_t i = 0; i < 13; ++i) assert_int_equal(statuses[i], -i);
  assert_int_equal(JALON_ERROR_INTERNAL, -99);
  const int32_t params[] = {JALON_PARAM_DOUBLE, JALON_PARAM_INT64,  JALON_PARAM_BOOL,
                            JALON_PARAM_STRING, JALON_PARAM_CHOICE, JALON_PARAM_DOUBLES};
  for (int32_t i = 0; i < 6; ++i) assert_int_equal(params[i], i + 1);
  const int32_t classes[] = {JALON_ORIENTATION_NONE, JALON_ORIENTATION_PARALLEL,
                             JALON_ORIENTATION_VERTICAL, JALON_ORIENTATION_HORIZONTAL,
                             JALON_ORIENTATION_INCLINED};
  for (int32_t i = 0; i < 5; ++i) assert_int_equal(classes[i], i);
  assert_int_equal(JALON_LOG_DEBUG, 1);
  assert_int_equal(JALON_LOG_INFO, 2);
  assert_int_equal(JALON_LOG_WARNING, 3);
  assert_int_equal(JALON_CLOUD_DROP_INVALID, 1);
  assert_int_equal(JALON_OCTREE_MAX_LEVEL, 21);
  assert_int_equal(JALON_LEVEL_AUTOMATIC, -1);
  assert_true(JALON_NO_POINT == UINT64_MAX);
}

int main(void) {
  const struct CMUnitTest tests[] = {
      cmocka_unit_test(layout__of_frozen_structs_never_changes),
      cmocka_unit_test(layout__of_sized_structs_only_grows_at_the_end),
      cmocka_unit_test(constants__keep_their_numbers),
  };
  return cmocka_run_group_tests(tests, NULL, NULL);
}

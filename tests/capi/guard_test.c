/* SPDX-FileCopyrightText: 2026 The Jalon authors
 * SPDX-License-Identifier: Apache-2.0 */
/* The wall between the library and its callers: arrays, texts and messages at the edges of what is allowed. */
#include "lifted_square.h"

static void arrays__are_checked_by_type_stride_and_size(void** state) {
  (void)state;
  const double xyz[7] = {0, 1, 2, 3, 4, 5, 6};
  jalon_cloud* cloud = NULL;
  const int32_t types[] = {0, 11, -1, INT32_MAX, INT32_MIN};
  for (int i = 0; i < 5; ++i) {
    char told[64];
    snprintf(told, sizeof told, "%d is no element type", (int)types[i]);
    REFUSED(JALON_ERROR_INVALID_ARGUMENT, jalon_cloud_create(xyz, types[i], 1, 0, 0, &cloud));
    expect_message(told);
  }
  REFUSED(JALON_ERROR_INVALID_ARGUMENT,
          jalon_cloud_create(xyz, JALON_FLOAT64, 2, 7, 0, &cloud)); /* less than an element */
  expect_message("xyz: a stride of 7 bytes");
  REFUSED(JALON_ERROR_INVALID_ARGUMENT, jalon_cloud_create(NULL, JALON_FLOAT64, 1, 0, 0, &cloud));
  expect_message("xyz is NULL");
  /* More than any memory holds, by the number, by the stride, and where their product wraps to little. */
  const uint64_t sizes[3][2] = {{UINT64_MAX / 24, 0}, {2, UINT64_MAX}, {(uint64_t)1 << 61, 8}};
  for (int i = 0; i < 3; ++i) {
    REFUSED(JALON_ERROR_INVALID_ARGUMENT,
            jalon_cloud_create(xyz, JALON_FLOAT64, sizes[i][0], sizes[i][1], 0, &cloud));
    expect_message("do not fit the address space");
  }
  assert_null(cloud);
  /* Items may overlap: each point begins one element behind the last. */
  MUST(jalon_cloud_create(xyz, JALON_FLOAT64, 5, 8, 0, &cloud));
  jalon_array_view view;
  MUST(jalon_cloud_points(cloud, &view));
  for (int i = 0; i < 15; ++i) assert_true(((const double*)view.data)[i] == i / 3 + i % 3);
  jalon_cloud_release(cloud);
  MUST(jalon_cloud_create(NULL, JALON_INT8, 0, 0, 0, &cloud)); /* nothing needs no memory */
  assert_int_equal(count_of(cloud), 0);
  jalon_cloud_release(cloud);
}

static void texts__are_utf_8_of_a_bounded_length(void** state) {
  (void)state;
  jalon_cloud* cloud = cloud_of(NULL, 0);
  /* Cut off, overlong, a surrogate, above U+10FFFF, a lone continuation, Latin-1. */
  const char* const broken[] = {"\xC3",         "\xE2\x82",         "\xC0\xAF", "\xE0\x80\x80",
                                "\xED\xA0\x80", "\xF4\x90\x80\x80", "a\x80",    "caf\xE9"};
  for (size_t i = 0; i < sizeof broken / sizeof *broken; ++i) {
    REFUSED(JALON_ERROR_INVALID_ARGUMENT, jalon_cloud_set_station(cloud, broken[i], NULL));
    expect_message("name is not valid UTF-8");
  }
  const char* const whole[] = {"", "\xC3\xA9", "\xE2\x82\xAC", "\xED\x9F\xBF", "\xF4\x8F\xBF\xBF"};
  for (size_t i = 0; i < sizeof whole / sizeof *whole; ++i) {
    const char* name = NULL;
    MUST(jalon_cloud_set_station(cloud, whole[i], NULL));
    MUST(jalon_cloud_station(cloud, 0, &name, NULL, NULL, NULL, NULL));
    assert_string_equal(name, whole[i]);
  }
  /* 64 KiB, and not a byte more. */
  char* text = malloc(65538);
  assert_non_null(text);
  memset(text, 'x', 65537);
  text[65537] = 0;
  REFUSED(JALON_ERROR_INVALID_ARGUMENT, jalon_cloud_set_station(cloud, text, NULL));
  expect_message("name is longer than 65536 bytes");
  text[65536] = 0;
  MUST(jalon_cloud_set_station(cloud, text, NULL));
  free(text);
  jalon_cloud_release(cloud);
}

static void transforms__must_be_finite_in_every_number(void** state) {
  (void)state;
  const double xyz[3] = {1, 2, 3}, wild[3] = {NAN, INFINITY, -INFINITY};
  jalon_cloud *cloud = cloud_of(xyz, 1), *moved = NULL;
  for (int k = 0; k < 12; ++k)
    for (int i = 0; i < 3; ++i) {
      jalon_transform transform = {{1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0}};
      transform.m[k] = wild[i];
      REFUSED(JALON_ERROR_INVALID_ARGUMENT, jalon_cloud_transform(cloud, &transform, NULL, &moved));
      expect_message("not finite");
      REFUSED(JALON_ERROR_INVALID_ARGUMENT, jalon_cloud_set_station(cloud, "S", &transform));
    }
  assert_null(moved);
  uint64_t stations = 7;
  MUST(jalon_cloud_station_count(cloud, &stations));
  assert_int_equal(stations, 0); /* none of them came about */
  jalon_cloud_release(cloud);
}

static void poses_of_stations__must_be_rigid_motions(void** state) {
  (void)state;
  const struct {
    jalon_transform pose;
    const char* told;
  } wrong[] = {
      {{{0}},
       "the pose is no rigid motion: the columns of its 3 x 3 part have the lengths 0.000000"},
      {{{1, 0, 0, 5, 0, 1, 0, 6, 0, 0, -1, 7}}, "the pose is no rigid motion: it mirrors"},
      {{{0.001, 0, 0, 0, 0, 0.001, 0, 0, 0, 0, 0.001, 0}}, "the lengths 0.001000"},
      {{{1, 0.01, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0}}, "square to one another within 1e-6"}};
  const double xyz[3] = {1, 2, 3};
  jalon_cloud *cloud = cloud_of(xyz, 1), *built = NULL;
  jalon_cloud_builder* builder = NULL;
  MUST(jalon_cloud_builder_create(0, &builder));
  for (size_t i = 0; i < sizeof wrong / sizeof *wrong; ++i) {
    REFUSED(JALON_ERROR_INVALID_ARGUMENT, jalon_cloud_set_station(cloud, "S", &wrong[i].pose));
    expect_message(wrong[i].told);
    REFUSED(JALON_ERROR_INVALID_ARGUMENT,
            jalon_cloud_builder_begin_station(builder, "S", &wrong[i].pose));
    expect_message(wrong[i].told);
  }
  uint64_t stations = 7;
  MUST(jalon_cloud_station_count(cloud, &stations));
  assert_int_equal(stations, 0); /* none of them came about */
  MUST(jalon_cloud_builder_seal(builder, &built));
  MUST(jalon_cloud_station_count(built, &stations));
  assert_int_equal(stations, 0);
  jalon_cloud_release(built);
  jalon_cloud_builder_release(builder);
  jalon_cloud_release(cloud);
}

/* Millimetres made metres, and a mirror: the station goes along and stays a place to look from. */
static void transform__that_stretches_or_mirrors__leaves_stations_rigid(void** state) {
  (void)state;
  const double xyz[3] = {1, 2, 3};
  const jalon_transform pose = {{0, -1, 0, 1000, 1, 0, 0, 2000, 0, 0, 1, 1700}};
  const jalon_transform maps[] = {{{0.001, 0, 0, 0, 0, 0.001, 0, 0, 0, 0, 0.001, 0}},
                                  {{-1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0}}};
  const jalon_transform expected[] = {{{0, -1, 0, 1, 1, 0, 0, 2, 0, 0, 1, 1.7}},
                                      {{0, -1, 0, -1000, 1, 0, 0, 2000, 0, 0, 1, 1700}}};
  for (size_t i = 0; i < 2; ++i) {
    jalon_cloud *cloud = cloud_of(xyz, 1), *moved = NULL;
    jalon_transform back;
    MUST(jalon_cloud_set_station(cloud, "S", &pose));
    MUST(jalon_cloud_transform(cloud, &maps[i], NULL, &moved));
    MUST(jalon_cloud_station(moved, 0, NULL, NULL, &back, NULL, NULL));
    for (size_t k = 0; k < 12; ++k) assert_true(fabs(back.m[k] - expected[i].m[k]) < 1e-12);
    MUST(jalon_cloud_set_station(cloud, "S", &back));
    jalon_cloud_release(moved);
    jalon_cloud_release(cloud);
  }
}

static void messages__of_long_names_are_cut_and_stay_on_one_line(void** state) {
  (void)state;
  jalon_cloud_builder* builder = NULL;
  char name[5000];
  MUST(jalon_cloud_builder_create(0, &builder));
  for (size_t i = 0; i < sizeof name; ++i) name[i] = "ab\n\t\r\x01\x7f"[i % 7];
  for (size_t length = 900; length < sizeof name; length += 41) {
    const char end = name[length];
    name[length] = 0;
    REFUSED(JALON_ERROR_NOT_FOUND,
            jalon_cloud_builder_append_field(builder, name, NULL, JALON_INT8, 0, 0));
    const char* message = jalon_last_error_message();
    assert_true(strlen(message) <= 1023);
    assert_true(strlen(message) == 1023 || strstr(message, "there are: none") != NULL);
    expect_message(
        "no field \"ab    \x7f"
        "ab    \x7f"); /* control characters are blanks */
    name[length] = end;
  }
  jalon_cloud_builder_release(builder);
}

/* The library's own judge: a station's name must be whole UTF-8. */
static void expect_whole_message(void) {
  char message[2048];
  snprintf(message, sizeof message, "%s", jalon_last_error_message());
  assert_true(strlen(message) <= 1023);
  jalon_cloud* cloud = cloud_of(NULL, 0);
  MUST(jalon_cloud_set_station(cloud, message, NULL));
  jalon_cloud_release(cloud);
}

static void messages__hold_whole_characters_wherever_names_are_cut(void** state) {
  (void)state;
  static const char* const characters[] = {"\xC3\xA9", "\xE2\x82\xAC", "\xF0\x9F\x98\x80"};
  jalon_cloud_builder* builder = NULL;
  MUST(jalon_cloud_builder_create(0, &builder));
  for (size_t c = 0; c < 3; ++c)
    for (size_t before = 0; before < 4; ++before) {
      const size_t bytes = strlen(characters[c]);
      char name[1500];
      size_t length = before;
      memset(name, 'x', before);
      for (; length + bytes < sizeof name; length += bytes)
        memcpy(name + length, characters[c], bytes);
      name[length] = 0;
      /* The whole message is too long: it ends with the last character that fits. */
      REFUSED(JALON_ERROR_NOT_FOUND,
              jalon_cloud_builder_append_field(builder, name, NULL, JALON_INT8, 0, 0));
      assert_true(strlen(jalon_last_error_message()) + bytes > 1023);
      assert_memory_equal(jalon_last_error_message() + strlen(jalon_last_error_message()) - bytes,
                          characters[c], bytes);
      expect_whole_message();
      /* The name in it is cut. */
      jalon_params* params = NULL;
      REFUSED(JALON_ERROR_NOT_FOUND, jalon_params_create(name, &params));
      expect_message("; there are: normals, ");
      expect_whole_message();
    }
  jalon_cloud_builder_release(builder);
  char name[102];
  memset(name, 'x', 99);
  memcpy(name + 99, "\xC3\xA9", 3);
  jalon_params* params = NULL;
  REFUSED(JALON_ERROR_NOT_FOUND, jalon_params_create(name, &params));
  expect_message("xx?\"; there are: normals");
  expect_whole_message();
}

int main(void) {
  const struct CMUnitTest tests[] = {
      cmocka_unit_test(arrays__are_checked_by_type_stride_and_size),
      cmocka_unit_test(texts__are_utf_8_of_a_bounded_length),
      cmocka_unit_test(transforms__must_be_finite_in_every_number),
      cmocka_unit_test(poses_of_stations__must_be_rigid_motions),
      cmocka_unit_test(transform__that_stretches_or_mirrors__leaves_stations_rigid),
      cmocka_unit_test(messages__of_long_names_are_cut_and_stay_on_one_line),
      cmocka_unit_test(messages__hold_whole_characters_wherever_names_are_cut),
  };
  return cmocka_run_group_tests(tests, NULL, NULL);
}

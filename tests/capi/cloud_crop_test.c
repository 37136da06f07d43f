/* SPDX-FileCopyrightText: 2026 The Jalon authors
 * SPDX-License-Identifier: Apache-2.0 */
/* Crops and splits of random points, each point against a test of its own. */
#include "lifted_square.h"

enum { kCropPoints = 3000 };

/* A cube of 10 m; the field "index" tells where each point came from. */
static jalon_cloud* random_cube(double xyz[3 * kCropPoints]) {
  static uint32_t index[kCropPoints];
  for (uint64_t i = 0; i < kCropPoints; ++i) {
    for (uint64_t k = 0; k < 3; ++k) xyz[3 * i + k] = 10 * uniform(21, 3 * i + k);
    index[i] = (uint32_t)i;
  }
  jalon_cloud* cloud = cloud_of(xyz, kCropPoints);
  MUST(jalon_cloud_set_field(cloud, "index", index, JALON_UINT32, 1, kCropPoints, 0, NULL, NULL));
  return cloud;
}

/* Both parts hold exactly the points that they should, in their order. */
static void expect_parts(jalon_cloud* in, jalon_cloud* out, const uint8_t* is_in) {
  assert_int_equal(count_of(in) + count_of(out), kCropPoints);
  assert_true(count_of(in) > 50 && count_of(out) > 50);
  for (int part = 0; part < 2; ++part) {
    jalon_cloud* cloud = part == 0 ? in : out;
    jalon_fields* fields = NULL;
    static uint32_t index[kCropPoints];
    MUST(jalon_cloud_fields(cloud, &fields));
    MUST(jalon_fields_copy(fields, "index", JALON_UINT32, index, kCropPoints));
    for (uint64_t i = 0; i < count_of(cloud); ++i) {
      assert_int_equal(is_in[index[i]], part == 0);
      if (i > 0) assert_true(index[i] > index[i - 1]);
    }
    jalon_fields_release(fields);
    jalon_cloud_release(cloud);
  }
}

static void crop__shares_out_the_points_as_a_test_of_each_does(void** state) {
  (void)state;
  static double xyz[3 * kCropPoints];
  static uint8_t is_in[kCropPoints];
  jalon_cloud *cloud = random_cube(xyz), *in = NULL, *out = NULL;
  /* A box turned by 53.13 degrees about the vertical through (5, 5). */
  const jalon_transform turned = {{0.6, 0.8, 0, -7, -0.8, 0.6, 0, 1, 0, 0, 1, -2}};
  const jalon_box box = {{-3, -2, 0}, {3, 2, 6}};
  for (int i = 0; i < kCropPoints; ++i) {
    const double x = xyz[3 * i] - 5, y = xyz[3 * i + 1] - 5, z = xyz[3 * i + 2];
    is_in[i] = fabs(0.6 * x + 0.8 * y) <= 3 && fabs(0.6 * y - 0.8 * x) <= 2 && z >= 2 && z <= 8;
  }
  MUST(jalon_cloud_crop_box(cloud, &box, &turned, NULL, &in, &out));
  expect_parts(in, out, is_in);
  /* A triangle x + y <= 9 along y: u, v, w = x, z, y. */
  const jalon_transform lying = {{1, 0, 0, 0, 0, 0, 1, 0, 0, 1, 0, 0}};
  const double triangle[6] = {0, 0, 9, 0, 0, 9};
  for (int i = 0; i < kCropPoints; ++i)
    is_in[i] = xyz[3 * i] + xyz[3 * i + 2] <= 9 && xyz[3 * i + 1] >= 2 && xyz[3 * i + 1] <= 7;
  MUST(jalon_cloud_crop_polygon(cloud, triangle, 3, 2, 7, &lying, NULL, &in, &out));
  expect_parts(in, out, is_in);
  /* A cylinder along the diagonal of a face, 2 m wide. */
  const jalon_vec3 foot = {1, 1, 5}, top = {9, 9, 5};
  for (int i = 0; i < kCropPoints; ++i) {
    const double x = xyz[3 * i], y = xyz[3 * i + 1], z = xyz[3 * i + 2] - 5;
    is_in[i] = x + y >= 2 && x + y <= 18 && (x - y) * (x - y) / 2 + z * z <= 4;
  }
  MUST(jalon_cloud_crop_cylinder(cloud, &foot, &top, 2, NULL, &in, &out));
  expect_parts(in, out, is_in);
  jalon_cloud_release(cloud);
}

static void split__compares_values_of_every_element_type(void** state) {
  (void)state;
  const double xyz[18] = {0};
  const double values[6] = {3, 1, 3, 0, 3, 2};
  jalon_cloud *cloud = cloud_of(xyz, 6), *equal = NULL, *others = NULL;
  for (int32_t type = JALON_INT8; type <= JALON_FLOAT64; ++type) {
    /* The values as this type, by way of a cloud's field. */
    unsigned char bytes[48];
    jalon_fields* fields = NULL;
    MUST(jalon_cloud_set_field(cloud, "v", values, JALON_FLOAT64, 1, 6, 0, NULL, NULL));
    MUST(jalon_cloud_fields(cloud, &fields));
    MUST(jalon_fields_copy(fields, "v", type, bytes, 6));
    jalon_fields_release(fields);
    MUST(jalon_cloud_set_field(cloud, "v", bytes, type, 1, 6, 0, NULL, NULL));
    MUST(jalon_cloud_split(cloud, "v", 3, NULL, &equal, &others));
    assert_int_equal(count_of(equal), 3);
    assert_int_equal(count_of(others), 3);
    jalon_cloud_release(equal), jalon_cloud_release(others);
    MUST(jalon_cloud_split(cloud, "v", 2.5, NULL, &equal, NULL)); /* what no integer is */
    assert_int_equal(count_of(equal), 0);
    jalon_cloud_release(equal);
  }
  equal = NULL;
  MUST(jalon_cloud_set_field(cloud, "two", xyz, JALON_FLOAT64, 2, 6, 0, NULL, NULL));
  REFUSED(JALON_ERROR_INVALID_ARGUMENT, jalon_cloud_split(cloud, "two", 3, NULL, &equal, NULL));
  expect_message("\"two\" has 2 components");
  REFUSED(JALON_ERROR_INVALID_ARGUMENT, jalon_cloud_split(cloud, "v", NAN, NULL, &equal, NULL));
  REFUSED(JALON_ERROR_NOT_FOUND, jalon_cloud_split(cloud, "w", 3, NULL, &equal, NULL));
  expect_message("two"); /* the fields there are */
  assert_null(equal);
  jalon_cloud_release(cloud);
}

static void crop__regions_that_are_none_are_named_and_nothing_is_written(void** state) {
  (void)state;
  static double xyz[3 * kCropPoints];
  jalon_cloud *cloud = random_cube(xyz), *in = NULL;
  const jalon_box wrong = {{0, 5, 0}, {9, 4, 9}}, nan_box = {{0, 0, 0}, {9, NAN, 9}};
  const jalon_transform wild = {{1, 0, 0, 0, 0, 1, 0, 0, 0, 0, INFINITY, 0}};
  const jalon_box good = {{0, 0, 0}, {5, 5, 5}};
  const double corners[6] = {0, 0, 4, NAN, 0, 4}, triangle[6] = {0, 0, 9, 0, 0, 9};
  const jalon_vec3 foot = {1, NAN, 0}, top = {1, 1, 5};
  REFUSED(JALON_ERROR_INVALID_ARGUMENT, jalon_cloud_crop_box(cloud, &wrong, NULL, NULL, &in, NULL));
  expect_message("box: the smallest value 5 is above the largest 4");
  REFUSED(JALON_ERROR_INVALID_ARGUMENT,
          jalon_cloud_crop_box(cloud, &nan_box, NULL, NULL, &in, NULL));
  REFUSED(JALON_ERROR_INVALID_ARGUMENT, jalon_cloud_crop_box(cloud, &good, &wild, NULL, &in, NULL));
  REFUSED(JALON_ERROR_INVALID_ARGUMENT,
          jalon_cloud_crop_polygon(cloud, corners, 3, 0, 1, NULL, NULL, &in, NULL));
  expect_message("corner 1");
  REFUSED(JALON_ERROR_INVALID_ARGUMENT,
          jalon_cloud_crop_polygon(cloud, triangle, 3, NAN, 1, NULL, NULL, &in, NULL));
  REFUSED(JALON_ERROR_INVALID_ARGUMENT,
          jalon_cloud_crop_polygon(cloud, NULL, 3, 0, 1, NULL, NULL, &in, NULL));
  expect_message("polygon_uv is NULL");
  REFUSED(JALON_ERROR_INVALID_ARGUMENT,
          jalon_cloud_crop_cylinder(cloud, &foot, &top, 1, NULL, &in, NULL));
  expect_message("foot");
  REFUSED(JALON_ERROR_INVALID_ARGUMENT,
          jalon_cloud_crop_cylinder(cloud, &top, NULL, 1, NULL, &in, NULL));
  expect_message("top is NULL");
  assert_null(in);
  /* An endless interval is one. */
  MUST(jalon_cloud_crop_polygon(cloud, triangle, 3, -INFINITY, INFINITY, NULL, NULL, &in, NULL));
  assert_true(count_of(in) > 0);
  jalon_cloud_release(in);
  jalon_cloud_release(cloud);
}

int main(void) {
  const struct CMUnitTest tests[] = {
      cmocka_unit_test(crop__shares_out_the_points_as_a_test_of_each_does),
      cmocka_unit_test(split__compares_values_of_every_element_type),
      cmocka_unit_test(crop__regions_that_are_none_are_named_and_nothing_is_written),
  };
  return cmocka_run_group_tests(tests, NULL, NULL);
}

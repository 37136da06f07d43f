/* SPDX-FileCopyrightText: 2026 The Jalon authors
 * SPDX-License-Identifier: Apache-2.0 */
/* What a registration is used for: its pose on other points, its covariance in a level of detection. */
#include "lifted_square.h"

/* Points on three walls of a corner, or on the floor alone, with 1 mm of noise. */
static jalon_cloud* room_corner(int sides, uint64_t seed, const char* crs) {
  static double xyz[3 * 1500];
  for (uint64_t i = 0; i < 1500; ++i) {
    const uint64_t side = i % (uint64_t)sides;
    for (uint64_t k = 0; k < 3; ++k)
      xyz[3 * i + k] =
          k == side ? 0.002 * (uniform(seed + 100, i) - 0.5) : 2 * uniform(seed, 3 * i + k);
  }
  jalon_cloud* cloud = cloud_of(xyz, 1500);
  if (crs != NULL) MUST(jalon_cloud_set_crs(cloud, crs));
  return cloud;
}

static jalon_registration* registered(int sides, const char* crs) {
  jalon_cloud *reference = room_corner(sides, 51, crs), *moving = room_corner(sides, 52, NULL);
  jalon_registrar* registrar = NULL;
  jalon_registration* registration = NULL;
  const jalon_transform start = {{1, 0, 0, 0.01, 0, 1, 0, -0.01, 0, 0, 1, 0.01}};
  MUST(jalon_registrar_create("icp", &registrar));
  MUST(jalon_registrar_run(registrar, reference, moving, &start, NULL, &registration));
  jalon_registrar_release(registrar);
  jalon_cloud_release(reference), jalon_cloud_release(moving);
  return registration;
}

static void apply__moves_points_by_the_pose_and_hands_on_the_crs(void** state) {
  (void)state;
  jalon_registration* registration = registered(3, "EPSG:2154");
  jalon_transform pose;
  MUST(jalon_registration_pose(registration, &pose));
  double xyz[30];
  for (uint64_t i = 0; i < 30; ++i) xyz[i] = 100 * uniform(53, i) - 50;
  jalon_cloud *cloud = cloud_of(xyz, 10), *moved = NULL;
  const float up[3] = {0, 0, 1};
  float normals[30];
  for (int i = 0; i < 30; ++i) normals[i] = up[i % 3];
  MUST(jalon_cloud_set_field(cloud, "normal", normals, JALON_FLOAT32, 3, 10, 0, NULL, NULL));
  MUST(jalon_registration_apply(registration, cloud, NULL, &moved));
  jalon_array_view view;
  MUST(jalon_cloud_points(moved, &view));
  for (int i = 0; i < 10; ++i)
    for (int r = 0; r < 3; ++r) {
      double truth = pose.m[4 * r + 3];
      for (int c = 0; c < 3; ++c) truth += pose.m[4 * r + c] * xyz[3 * i + c];
      /* four roundings of numbers up to 100 */
      assert_true(fabs(((const double*)view.data)[3 * i + r] - truth) < 4 * 100 * 2.3e-16);
    }
  jalon_fields* fields = NULL;
  MUST(jalon_cloud_fields(moved, &fields));
  for (uint32_t r = 0; r < 3; ++r)
    assert_true(fabs(cell_of(fields, "normal", 0, r) - pose.m[4 * r + 2]) < 1e-7);
  jalon_fields_release(fields);
  const char* crs = NULL;
  MUST(jalon_cloud_crs(moved, &crs));
  assert_string_equal(crs, "EPSG:2154");
  jalon_cloud_release(moved);
  MUST(jalon_cloud_set_crs(cloud, "EPSG:2056")); /* one of its own stays */
  MUST(jalon_registration_apply(registration, cloud, NULL, &moved));
  MUST(jalon_cloud_crs(moved, &crs));
  assert_string_equal(crs, "EPSG:2056");
  jalon_cloud_release(moved);
  moved = NULL;
  REFUSED(JALON_ERROR_INVALID_ARGUMENT, jalon_registration_apply(registration, NULL, NULL, &moved));
  expect_message("cloud is NULL");
  REFUSED(JALON_ERROR_INVALID_ARGUMENT, jalon_registration_apply(NULL, cloud, NULL, &moved));
  assert_null(moved);
  jalon_cloud_release(cloud);
  jalon_registration_release(registration);
}

static jalon_comparer* comparer_of(const char* method, jalon_params** params) {
  jalon_comparer* comparer = NULL;
  MUST(jalon_comparer_create(method, &comparer));
  MUST(jalon_comparer_params(comparer, params));
  return comparer;
}

static void use__sets_the_covariance_and_centre_of_the_summary(void** state) {
  (void)state;
  jalon_registration* registration = registered(3, NULL);
  jalon_fields* summary = NULL;
  jalon_params *params = NULL, *others = NULL;
  jalon_comparer* comparer = comparer_of("m3c2", &params);
  const double *covariance = NULL, *centre = NULL;
  uint64_t count = 0;
  MUST(jalon_registration_summary(registration, &summary));
  assert_int_equal(cell_of(summary, "unobservable", 0, 0), 0);
  MUST(jalon_comparer_use_registration(comparer, registration));
  MUST(jalon_params_get_doubles(params, "registration_covariance", &covariance, &count));
  assert_int_equal(count, 36);
  for (uint32_t k = 0; k < 36; ++k) {
    assert_true(covariance[k] == cell_of(summary, "covariance", 0, k));
    assert_true(k % 7 != 0 || covariance[k] > 0);
  }
  MUST(jalon_params_get_doubles(params, "registration_centre", &centre, &count));
  assert_int_equal(count, 3);
  for (uint32_t k = 0; k < 3; ++k) assert_true(centre[k] == cell_of(summary, "centre", 0, k));
  const char* const without[] = {"distance", "preview"};
  for (int i = 0; i < 2; ++i) {
    jalon_comparer* other = comparer_of(without[i], &others);
    REFUSED(JALON_ERROR_UNSUPPORTED, jalon_comparer_use_registration(other, registration));
    expect_message(without[i]);
    jalon_params_release(others);
    jalon_comparer_release(other);
  }
  jalon_fields_release(summary);
  jalon_params_release(params);
  jalon_comparer_release(comparer);
  jalon_registration_release(registration);
}

static void use__is_refused_where_directions_are_open_and_nothing_is_set(void** state) {
  (void)state;
  jalon_registration* sliding = registered(1, NULL); /* a floor fixes three of six directions */
  jalon_fields* summary = NULL;
  jalon_params* params = NULL;
  jalon_comparer* comparer = comparer_of("m3c2", &params);
  MUST(jalon_registration_summary(sliding, &summary));
  assert_int_equal(cell_of(summary, "unobservable", 0, 0), 3);
  REFUSED(JALON_ERROR_DEGENERATE, jalon_comparer_use_registration(comparer, sliding));
  expect_message("leaves 3 directions open");
  const double* covariance = NULL;
  uint64_t count = 77;
  MUST(jalon_params_get_doubles(params, "registration_covariance", &covariance, &count));
  for (uint64_t k = 0; k < count; ++k) assert_true(covariance[k] == 0);
  jalon_fields_release(summary);
  jalon_params_release(params);
  jalon_comparer_release(comparer);
  jalon_registration_release(sliding);
}

int main(void) {
  const struct CMUnitTest tests[] = {
      cmocka_unit_test(apply__moves_points_by_the_pose_and_hands_on_the_crs),
      cmocka_unit_test(use__sets_the_covariance_and_centre_of_the_summary),
      cmocka_unit_test(use__is_refused_where_directions_are_open_and_nothing_is_set),
  };
  return cmocka_run_group_tests(tests, NULL, NULL);
}

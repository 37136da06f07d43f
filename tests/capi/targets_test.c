/* SPDX-FileCopyrightText: 2026 The Jalon authors
 * SPDX-License-Identifier: Apache-2.0 */
#include "support.h"

#include <math.h>

enum { kSpheres = 4, kRings = 24, kAround = 48, kPoints = kSpheres * kRings * kAround };
static const double kAt[kSpheres][3] = {{0, 0, 1}, {9, 1, 2}, {8, 11, 1.2}, {-2, 10, 3}};

/* Spheres of 145 mm all round, turned and shifted onto a national grid when moved. */
static jalon_cloud* spheres(int moved) {
  static double xyz[3 * kPoints];
  double* out = xyz;
  for (int s = 0; s < kSpheres; ++s)
    for (int i = 0; i < kRings; ++i)
      for (int k = 0; k < kAround; ++k) {
        const double v = 3.14159265 * (i + 0.5) / kRings, a = 6.2831853 * k / kAround;
        const double r = 0.0725 + 0.0005 * sin(12.9898 * (i * kAround + k + s));
        const double x = kAt[s][0] + r * sin(v) * cos(a), y = kAt[s][1] + r * sin(v) * sin(a);
        *out++ = moved ? 652000 - y : x;
        *out++ = moved ? 6861000 + x : y;
        *out++ = kAt[s][2] + r * cos(v) + (moved ? 100 : 0);
      }
  jalon_cloud* cloud = NULL;
  MUST(jalon_cloud_create(xyz, JALON_FLOAT64, kPoints, 0, 0, &cloud));
  return cloud;
}

static jalon_params* options(double radius_m) {
  jalon_params* params = NULL;
  MUST(jalon_params_create("target", &params));
  MUST(jalon_params_set_double(params, "radius_m", radius_m));
  return params;
}

/* The targets measured in a cloud, ready for the registrar; unnamed. */
static void measured(const jalon_cloud* cloud, const double* places, jalon_target* out) {
  jalon_fields* rows = NULL;
  jalon_params* params = options(0.0725);
  MUST(jalon_cloud_measure_targets(cloud, places, kSpheres, params, NULL, &rows));
  int32_t status[kSpheres];
  double centre[3 * kSpheres], covariance[9 * kSpheres];
  MUST(jalon_fields_copy(rows, "status", JALON_INT32, status, kSpheres));
  MUST(jalon_fields_copy(rows, "centre", JALON_FLOAT64, centre, 3 * kSpheres));
  MUST(jalon_fields_copy(rows, "covariance", JALON_FLOAT64, covariance, 9 * kSpheres));
  for (int i = 0; i < kSpheres; ++i) {
    assert_int_equal(status[i], JALON_OK);
    out[i].name = NULL;
    out[i].xyz = (jalon_vec3){centre[3 * i], centre[3 * i + 1], centre[3 * i + 2]};
    memcpy(out[i].covariance, covariance + 9 * i, sizeof out[i].covariance);
  }
  jalon_params_release(params);
  jalon_fields_release(rows);
}

static void targets__measured_in_two_clouds_register_them_without_names(void** state) {
  (void)state;
  jalon_cloud *reference = spheres(1), *moving = spheres(0);
  double from[3 * kSpheres], to[3 * kSpheres];
  for (int i = 0; i < kSpheres; ++i) {
    const int j = (i + 1) % kSpheres; /* in another order */
    from[3 * i] = kAt[i][0] + 0.03, from[3 * i + 1] = kAt[i][1], from[3 * i + 2] = kAt[i][2] + 0.05;
    to[3 * i] = 652000 - kAt[j][1], to[3 * i + 1] = 6861000 + kAt[j][0] + 0.06,
           to[3 * i + 2] = kAt[j][2] + 100;
  }
  jalon_target a[kSpheres], b[kSpheres];
  measured(reference, to, a);
  measured(moving, from, b);
  jalon_registrar* registrar = NULL;
  jalon_registration* registration = NULL;
  MUST(jalon_registrar_create("targets", &registrar));
  MUST(jalon_registrar_run_targets(registrar, a, kSpheres, b, kSpheres, NULL, &registration));
  jalon_transform pose;
  MUST(jalon_registration_pose(registration, &pose));
  const double truth[12] = {0, -1, 0, 652000, 1, 0, 0, 6861000, 0, 0, 1, 100};
  for (int i = 0; i < 12; ++i) assert_true(fabs(pose.m[i] - truth[i]) < (i % 4 == 3 ? 1e-3 : 1e-4));
  jalon_registration_release(registration);
  jalon_registrar_release(registrar);
  jalon_cloud_release(reference);
  jalon_cloud_release(moving);
}

static void targets__that_are_not_there_are_rows_that_say_so(void** state) {
  (void)state;
  jalon_cloud* cloud = spheres(0);
  const double places[9] = {0, 0, 1.05, 4, 4, 4, 9, 1, 2.05};
  jalon_fields* rows = NULL;
  MUST(jalon_cloud_measure_targets(cloud, places, 3, NULL, NULL, &rows));
  int32_t status[3];
  double radius[3];
  uint8_t kind[3];
  MUST(jalon_fields_copy(rows, "status", JALON_INT32, status, 3));
  MUST(jalon_fields_copy(rows, "radius", JALON_FLOAT64, radius, 3));
  MUST(jalon_fields_copy(rows, "kind", JALON_UINT8, kind, 3));
  assert_int_equal(status[0], JALON_OK);
  assert_int_equal(status[1], JALON_ERROR_INSUFFICIENT_DATA);
  assert_int_equal(status[2], JALON_OK);
  assert_int_equal(kind[1], 0);
  assert_int_equal(kind[2], JALON_TARGET_SPHERE);
  assert_true(fabs(radius[2] - 0.0725) < 1e-4);
  jalon_fields_release(rows);
  rows = NULL;
  const double wrong[6] = {0, 0, 1, 0, NAN, 0};
  REFUSED(JALON_ERROR_INVALID_ARGUMENT,
          jalon_cloud_measure_targets(cloud, wrong, 2, NULL, NULL, &rows));
  assert_non_null(strstr(jalon_last_error_message(), "place 1"));
  assert_null(rows);
  jalon_cloud_release(cloud);
}

static void targets__of_a_square_are_a_result_that_says_ambiguous(void** state) {
  (void)state;
  jalon_target corners[4];
  memset(corners, 0, sizeof corners);
  for (int i = 0; i < 4; ++i)
    corners[i].xyz = (jalon_vec3){i == 1 || i == 2 ? 10 : 0, i > 1 ? 10 : 0, 0};
  jalon_registrar* registrar = NULL;
  jalon_registration* registration = NULL;
  MUST(jalon_registrar_create("targets", &registrar));
  MUST(jalon_registrar_run_targets(registrar, corners, 4, corners, 4, NULL, &registration));
  jalon_fields* summary = NULL;
  MUST(jalon_registration_summary(registration, &summary));
  uint8_t converged = 1, stopped = 0;
  uint64_t solutions = 0;
  MUST(jalon_fields_copy(summary, "converged", JALON_UINT8, &converged, 1));
  MUST(jalon_fields_copy(summary, "stopped", JALON_UINT8, &stopped, 1));
  MUST(jalon_fields_copy(summary, "solutions", JALON_UINT64, &solutions, 1));
  assert_int_equal(converged, 0);
  assert_int_equal(stopped, JALON_STOPPED_AMBIGUOUS);
  assert_int_equal(solutions, 8);
  jalon_fields_release(summary);
  jalon_registration_release(registration);
  jalon_registrar_release(registrar);
}

int main(void) {
  const struct CMUnitTest tests[] = {
      cmocka_unit_test(targets__measured_in_two_clouds_register_them_without_names),
      cmocka_unit_test(targets__that_are_not_there_are_rows_that_say_so),
      cmocka_unit_test(targets__of_a_square_are_a_result_that_says_ambiguous),
  };
  return cmocka_run_group_tests(tests, NULL, NULL);
}

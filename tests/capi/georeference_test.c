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

static const double kDegree = 3.14159265358979323846 / 180;

/* The vehicle of the worked example stands still. */
static jalon_trajectory* standing(int with_sigmas) {
  const double times[2] = {0, 10};
  double positions[6], attitudes[6], p[6], a[6];
  for (int i = 0; i < 2; ++i) {
    const double place[3] = {100, 200, 50}, angles[3] = {0.8, -1.2, 37}, sp[3] = {0.02, 0.02, 0.03},
                 sa[3] = {0.005, 0.005, 0.02};
    for (int k = 0; k < 3; ++k) {
      positions[3 * i + k] = place[k], attitudes[3 * i + k] = angles[k] * kDegree;
      p[3 * i + k] = sp[k], a[3 * i + k] = sa[k] * kDegree;
    }
  }
  jalon_trajectory* made = NULL;
  OK(jalon_trajectory_create(times, positions, attitudes, with_sigmas ? p : NULL, NULL,
                             with_sigmas ? a : NULL, 2, NULL, NULL, &made));
  return made;
}

static jalon_params* mounted(void) {
  jalon_params* options = NULL;
  const double mirror[3] = {0.01, -0.02, 0.03}, arm[3] = {0.5, 0.2, 1.8};
  double boresight[3] = {1 * kDegree, -2 * kDegree, 45 * kDegree};
  OK(jalon_params_create("georeference", &options));
  OK(jalon_params_set_doubles(options, "mirror_offset_m", mirror, 3));
  OK(jalon_params_set_doubles(options, "boresight_rad", boresight, 3));
  OK(jalon_params_set_doubles(options, "lever_arm_m", arm, 3));
  return options;
}

static jalon_cloud* example(void) {
  jalon_trajectory* trajectory = standing(1);
  jalon_params* options = mounted();
  const double time = 5, range = 12, theta = 30 * kDegree, phi = 75 * kDegree;
  jalon_cloud* cloud = NULL;
  OK(jalon_trajectory_georeference(trajectory, &time, &range, &theta, &phi, 1, options, NULL,
                                   &cloud));
  jalon_params_release(options);
  jalon_trajectory_release(trajectory);
  return cloud;
}

static void georeference__worked_example__gives_its_point_and_covariance(void** state) {
  (void)state;
  jalon_cloud* cloud = example();
  jalon_array_view view;
  OK(jalon_cloud_points(cloud, &view));
  const double printed[3] = {95.949155, 210.957978, 55.613209};
  for (int k = 0; k < 3; ++k) assert_true(fabs(((const double*)view.data)[k] - printed[k]) < 5e-7);
  jalon_fields* fields = NULL;
  double values[6], origin[3], direction[3];
  const double covariance[6] = {7.950407e-04, 1.353306e-04,  4.065763e-05,
                                5.248749e-04, -1.181963e-04, 1.300320e-03};
  OK(jalon_cloud_fields(cloud, &fields));
  OK(jalon_fields_copy(fields, "covariance", JALON_FLOAT64, values, 6));
  for (int k = 0; k < 6; ++k)
    assert_true(fabs(values[k] - covariance[k]) < 6e-7 * fabs(covariance[k]));
  OK(jalon_fields_copy(fields, "point_sigma", JALON_FLOAT64, values, 6));
  assert_true(fabs(values[0] - sqrt(covariance[0] + covariance[3] + covariance[5])) < 1e-8);
  OK(jalon_fields_copy(fields, "beam_origin", JALON_FLOAT64, origin, 3));
  OK(jalon_fields_copy(fields, "beam_direction", JALON_FLOAT64, direction, 3));
  for (int k = 0; k < 3; ++k) assert_true(fabs(origin[k] + 12 * direction[k] - printed[k]) < 2e-6);
  jalon_fields_release(fields);
  jalon_cloud_release(cloud);
}

static void georeference__impossible_returns__are_refused_with_a_line(void** state) {
  (void)state;
  jalon_trajectory *whole = standing(1), *bare = standing(0);
  const double times[2] = {5, 11}, ranges[2] = {12, 3}, angles[2] = {1, 1}, none[2] = {12, -1};
  jalon_cloud* cloud = NULL;
  INVALID(
      jalon_trajectory_georeference(whole, times, ranges, angles, angles, 2, NULL, NULL, &cloud));
  assert_string_equal(jalon_last_error_message(),
                      "time 11 of item 1 is outside of the trajectory, which lasts from 0 to 10");
  INVALID(jalon_trajectory_georeference(whole, times, none, angles, angles, 2, NULL, NULL, &cloud));
  assert_string_equal(jalon_last_error_message(), "return 1: the range is -1");
  INVALID(
      jalon_trajectory_georeference(bare, times, ranges, angles, angles, 1, NULL, NULL, &cloud));
  assert_non_null(strstr(jalon_last_error_message(), "no sigmas of position"));
  assert_null(cloud);
  jalon_params* options = NULL;
  OK(jalon_params_create("georeference", &options));
  OK(jalon_params_set_bool(options, "covariances", 0));
  OK(jalon_trajectory_georeference(bare, times, ranges, angles, angles, 1, options, NULL, &cloud));
  jalon_cloud_release(cloud);
  jalon_params_release(options);
  jalon_trajectory_release(whole);
  jalon_trajectory_release(bare);
}

static void ellipsoids__of_the_worked_example__have_its_half_axes(void** state) {
  (void)state;
  jalon_cloud* cloud = example();
  jalon_params* options = NULL;
  OK(jalon_params_create("ellipsoids", &options));
  OK(jalon_params_set_int64(options, "fineness", 4));
  jalon_model* model = NULL;
  OK(jalon_cloud_ellipsoids(cloud, options, NULL, &model));
  jalon_fields* vertices = NULL;
  jalon_array_view view;
  OK(jalon_model_vertices(model, &vertices));
  OK(jalon_fields_view(vertices, "xyz", &view));
  double most = 0, least = 1;
  for (uint64_t i = 0; i < view.count; ++i) {
    const double* p = (const double*)view.data + 3 * i;
    const double d =
        sqrt(pow(p[0] - 95.949155, 2) + pow(p[1] - 210.957978, 2) + pow(p[2] - 55.613209, 2));
    most = d > most ? d : most, least = d < least ? d : least;
  }
  assert_true(fabs(most - 0.1223) < 1e-3); /* of 99 %; corners of a mesh fall beside the tips */
  assert_true(fabs(least - 0.0715) < 1e-3);
  jalon_fields_release(vertices);
  jalon_model_release(model);
  jalon_cloud* bare = NULL;
  const double xyz[3] = {0, 0, 0};
  OK(jalon_cloud_create(xyz, JALON_FLOAT64, 1, 0, 0, &bare));
  model = NULL;
  assert_int_equal(jalon_cloud_ellipsoids(bare, options, NULL, &model), JALON_ERROR_NOT_FOUND);
  assert_null(model);
  jalon_cloud_release(bare);
  jalon_params_release(options);
  jalon_cloud_release(cloud);
}

/* A comparison takes the covariances of the points as they are. */
static void georeference__covariances__feed_the_level_of_detection(void** state) {
  (void)state;
  enum { kSide = 60, kReturns = kSide * kSide };
  static double times[kReturns], ranges[kReturns], thetas[kReturns], phis[kReturns];
  jalon_trajectory* trajectory = standing(1);
  for (int i = 0; i < kReturns; ++i) { /* a wall 10 m ahead */
    thetas[i] = 0.01 * (i % kSide) - 0.3, phis[i] = 1.57 + 0.01 * (i / kSide) - 0.3;
    times[i] = 5, ranges[i] = 10 / (cos(thetas[i]) * sin(phis[i]));
  }
  jalon_cloud* cloud = NULL;
  OK(jalon_trajectory_georeference(trajectory, times, ranges, thetas, phis, kReturns, NULL, NULL,
                                   &cloud));
  jalon_comparer* comparer = NULL;
  jalon_params* params = NULL;
  jalon_comparison* comparison = NULL;
  jalon_fields* points = NULL;
  OK(jalon_comparer_create("m3c2", &comparer));
  OK(jalon_comparer_params(comparer, &params));
  /* The same surface twice: what each place is worth comes from the points' covariances. */
  OK(jalon_params_set_string(params, "precision_from", "covariances"));
  OK(jalon_comparer_run(comparer, cloud, cloud, NULL, &comparison));
  OK(jalon_comparison_points(comparison, &points));
  static double detection[kReturns];
  OK(jalon_fields_copy(points, "lod", JALON_FLOAT64, detection, kReturns));
  int finite = 0;
  for (int i = 0; i < kReturns; ++i) finite += detection[i] > 0;
  assert_true(finite > kReturns / 2);
  jalon_fields_release(points);
  jalon_comparison_release(comparison);
  jalon_params_release(params);
  jalon_comparer_release(comparer);
  jalon_cloud_release(cloud);
  jalon_trajectory_release(trajectory);
}

int main(void) {
  const struct CMUnitTest tests[] = {
      cmocka_unit_test(georeference__worked_example__gives_its_point_and_covariance),
      cmocka_unit_test(georeference__impossible_returns__are_refused_with_a_line),
      cmocka_unit_test(ellipsoids__of_the_worked_example__have_its_half_axes),
      cmocka_unit_test(georeference__covariances__feed_the_level_of_detection),
  };
  return cmocka_run_group_tests_name("georeference", tests, NULL, NULL);
}

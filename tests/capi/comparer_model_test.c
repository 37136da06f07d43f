/* SPDX-FileCopyrightText: 2026 The Jalon authors
 * SPDX-License-Identifier: Apache-2.0 */
#include "support.h"

#include <math.h>

/* A cube of 2 m as twelve triangles, corners anticlockwise seen from outside; the last one may be made NaN. */
static jalon_model* cube(double last_z) {
  const double xyz[24] = {0, 0, 0, 2, 0, 0, 2, 2, 0, 0, 2, 0,
                          0, 0, 2, 2, 0, 2, 2, 2, 2, 0, 2, last_z};
  const uint32_t triangles[36] = {0, 2, 1, 0, 3, 2, 4, 5, 6, 4, 6, 7, 0, 1, 5, 0, 5, 4,
                                  1, 2, 6, 1, 6, 5, 2, 3, 7, 2, 7, 6, 3, 0, 4, 3, 4, 7};
  jalon_model* model = NULL;
  if (isnan(last_z)) {
    REFUSED(JALON_ERROR_INVALID_ARGUMENT,
            jalon_model_create_mesh(xyz, JALON_FLOAT64, 8, 0, triangles, 12, NULL, &model));
    return NULL;
  }
  MUST(jalon_model_create_mesh(xyz, JALON_FLOAT64, 8, 0, triangles, 12, NULL, &model));
  return model;
}

static jalon_cloud* points_of(const double* xyz, uint64_t n) {
  jalon_cloud* cloud = NULL;
  MUST(jalon_cloud_create(xyz, JALON_FLOAT64, n, 0, 0, &cloud));
  return cloud;
}

static void comparer__measures_signed_distances_from_a_model(void** state) {
  (void)state;
  const double xyz[15] = {1, 1, 1.5, 1, 1, 2.5, 3, 3, 3, -1, 1, 1, 0.25, 1, 1};
  jalon_model* model = cube(2);
  jalon_cloud* cloud = points_of(xyz, 5);
  jalon_comparer* comparer = NULL;
  MUST(jalon_comparer_create("distance", &comparer));
  jalon_params* params = NULL;
  MUST(jalon_comparer_params(comparer, &params));
  MUST(jalon_params_set_double(params, "tolerance_m", 0.5));
  MUST(jalon_params_set_double(params, "max_distance_m", 1.5));
  jalon_comparison* comparison = NULL;
  MUST(jalon_comparer_run_model(comparer, model, cloud, NULL, &comparison));
  jalon_fields* points = NULL;
  MUST(jalon_comparison_points(comparison, &points));
  double distance[5];
  uint8_t status[5], within[5];
  MUST(jalon_fields_copy(points, "distance", JALON_FLOAT64, distance, 5));
  MUST(jalon_fields_copy(points, "status", JALON_UINT8, status, 5));
  MUST(jalon_fields_copy(points, "within_tolerance", JALON_UINT8, within, 5));
  assert_true(distance[0] == -0.5 && distance[1] == 0.5 && distance[3] == 1 &&
              distance[4] == -0.25);
  assert_true(isnan(distance[2]));
  assert_int_equal(status[2], JALON_NOTHING_NEAR);
  assert_int_equal(within[0], 1);
  assert_int_equal(within[2], 2);
  assert_int_equal(within[3], 0);
  jalon_fields* parts = NULL;
  MUST(jalon_comparison_parts(comparison, &parts));
  jalon_fields_release(parts);
  jalon_fields_release(points);
  jalon_comparison_release(comparison);
  jalon_params_release(params);
  jalon_comparer_release(comparer);
  jalon_cloud_release(cloud);
  jalon_model_release(model);
}

static void comparer__with_a_model_refuses_what_it_cannot_measure(void** state) {
  (void)state;
  const double origin[3] = {0, 0, 0};
  assert_null(cube(NAN));
  jalon_model* model = cube(2);
  jalon_model* nothing = NULL;
  MUST(jalon_model_create_mesh(origin, JALON_FLOAT64, 1, 0, NULL, 0, NULL, &nothing));
  jalon_cloud* one = points_of(origin, 1);
  jalon_cloud* empty = points_of(NULL, 0);
  jalon_comparer* comparer = NULL;
  MUST(jalon_comparer_create(NULL, &comparer));
  jalon_comparison* comparison = NULL;
  REFUSED(JALON_ERROR_INSUFFICIENT_DATA,
          jalon_comparer_run_model(comparer, nothing, one, NULL, &comparison));
  REFUSED(JALON_ERROR_INSUFFICIENT_DATA,
          jalon_comparer_run_model(comparer, model, empty, NULL, &comparison));
  assert_null(comparison);
  jalon_comparer_release(comparer);
  jalon_cloud_release(one);
  jalon_cloud_release(empty);
  jalon_model_release(nothing);
  jalon_model_release(model);
}

static void comparer__takes_triangles_without_area_as_segments_and_points(void** state) {
  (void)state;
  const double xyz[9] = {0, 0, 0, 4, 0, 0, 2, 0, 0};
  const uint32_t triangles[6] = {0, 1, 2, 2, 2, 2};
  const double at[6] = {1, 0, 0.5, -3, 4, 0};
  jalon_model* model = NULL;
  MUST(jalon_model_create_mesh(xyz, JALON_FLOAT64, 3, 0, triangles, 2, NULL, &model));
  jalon_cloud* cloud = points_of(at, 2);
  jalon_comparer* comparer = NULL;
  MUST(jalon_comparer_create(NULL, &comparer));
  jalon_comparison* comparison = NULL;
  MUST(jalon_comparer_run_model(comparer, model, cloud, NULL, &comparison));
  jalon_fields* points = NULL;
  MUST(jalon_comparison_points(comparison, &points));
  double distance[2];
  MUST(jalon_fields_copy(points, "distance", JALON_FLOAT64, distance, 2));
  assert_true(distance[0] == 0.5 && distance[1] == 5);
  jalon_fields_release(points);
  jalon_comparison_release(comparison);
  jalon_comparer_release(comparer);
  jalon_cloud_release(cloud);
  jalon_model_release(model);
}

int main(void) {
  const struct CMUnitTest tests[] = {
      cmocka_unit_test(comparer__measures_signed_distances_from_a_model),
      cmocka_unit_test(comparer__with_a_model_refuses_what_it_cannot_measure),
      cmocka_unit_test(comparer__takes_triangles_without_area_as_segments_and_points),
  };
  return cmocka_run_group_tests(tests, NULL, NULL);
}

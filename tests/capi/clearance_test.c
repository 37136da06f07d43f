/* SPDX-FileCopyrightText: 2026 The Jalon authors
 * SPDX-License-Identifier: Apache-2.0 */
#include "support.h"

#include <math.h>

static const jalon_transform kHere = {{1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0}};

/* A block from (0, 0, 0) to (1, 2, 3). */
static jalon_model* block(double east_m) {
  double xyz[24];
  for (int i = 0; i < 8; ++i) {
    xyz[3 * i] = east_m + (i & 1 ? 1 : 0);
    xyz[3 * i + 1] = i & 2 ? 2 : 0;
    xyz[3 * i + 2] = i & 4 ? 3 : 0;
  }
  const uint32_t sides[36] = {0, 2, 3, 0, 3, 1, 4, 5, 7, 4, 7, 6, 0, 1, 5, 0, 5, 4,
                              2, 6, 7, 2, 7, 3, 0, 4, 6, 0, 6, 2, 1, 3, 7, 1, 7, 5};
  jalon_model* model = NULL;
  MUST(jalon_model_create_mesh(xyz, JALON_FLOAT64, 8, 0, sides, 12, NULL, &model));
  return model;
}

static jalon_cloud* points(const double* xyz, uint64_t count) {
  jalon_cloud* cloud = NULL;
  MUST(jalon_cloud_create(xyz, JALON_FLOAT64, count, 0, 0, &cloud));
  return cloud;
}

static double number(const jalon_fields* table, const char* name, uint64_t row) {
  jalon_array_view view;
  MUST(jalon_fields_view(table, name, &view));
  assert_true(row < view.count);
  double* all = malloc((size_t)view.count * view.components * 8);
  MUST(jalon_fields_copy(table, name, JALON_FLOAT64, all, view.count * view.components));
  const double value = all[row * view.components];
  free(all);
  return value;
}

static uint64_t rows(const jalon_fields* table) {
  jalon_array_view view;
  MUST(jalon_fields_view(table, "clearance", &view));
  return view.count;
}

static void near_to(double value, double truth) {
  if (!(fabs(value - truth) < 1e-6)) fail_msg("%.9f is not %.9f", value, truth);
}

static void clearance__of_a_cloud_tells_the_nearest_point_and_all_within_the_margin(void** state) {
  (void)state;
  jalon_model* model = block(0);
  const double xyz[12] = {1.25, 1, 1, 1.05, 1, 1, 9, 9, 9, 0.5, 1, -0.08};
  jalon_cloud* cloud = points(xyz, 4);
  jalon_fields *summary = NULL, *near_points = NULL;
  MUST(jalon_model_clearance(model, JALON_WHOLE_MODEL, cloud, NULL, NULL, &summary, &near_points));
  near_to(number(summary, "clearance", 0), 0.05);
  near_to(number(summary, "point", 0), 1);
  near_to(number(summary, "foot", 0), 1);
  near_to(number(summary, "interferes", 0), 0);
  assert_int_equal(rows(near_points), 2);
  near_to(number(near_points, "clearance", 1), 0.08);
  jalon_fields_release(summary);
  jalon_fields_release(near_points);
  jalon_cloud_release(cloud);

  const double inside[6] = {0.7, 1, 1, 0.9, 1, 1};
  cloud = points(inside, 2);
  MUST(jalon_model_clearance(model, JALON_WHOLE_MODEL, cloud, NULL, NULL, &summary, NULL));
  near_to(number(summary, "clearance", 0), -0.3);
  near_to(number(summary, "depth", 0), 0.3);
  near_to(number(summary, "interferes", 0), 1);
  near_to(number(summary, "inside", 0), 2);
  jalon_fields_release(summary);
  jalon_cloud_release(cloud);
  cloud = points(NULL, 0);
  REFUSED(JALON_ERROR_INSUFFICIENT_DATA,
          jalon_model_clearance(model, JALON_WHOLE_MODEL, cloud, NULL, NULL, &summary, NULL));
  jalon_cloud_release(cloud);
  jalon_model_release(model);
}

static void clearance__of_two_models_is_signed(void** state) {
  (void)state;
  jalon_model *model = block(0), *apart = block(1.5), *into = block(0.75);
  jalon_fields *summary = NULL, *near_faces = NULL;
  const jalon_status status = jalon_model_clearance_to_model(
      model, JALON_WHOLE_MODEL, apart, JALON_WHOLE_MODEL, NULL, NULL, &summary, NULL);
  if (status == JALON_ERROR_UNSUPPORTED) { /* built without FCL */
    jalon_model_release(model), jalon_model_release(apart), jalon_model_release(into);
    skip();
  }
  near_to(number(summary, "clearance", 0), 0.5);
  near_to(number(summary, "interferes", 0), 0);
  jalon_fields_release(summary);
  MUST(jalon_model_clearance_to_model(model, JALON_WHOLE_MODEL, into, JALON_WHOLE_MODEL, NULL, NULL,
                                      &summary, &near_faces));
  near_to(number(summary, "clearance", 0), -0.25);
  near_to(number(summary, "depth", 0), 0.25);
  near_to(number(summary, "interferes", 0), 1);
  assert_true(rows(near_faces) >= 8);
  jalon_fields_release(summary);
  jalon_fields_release(near_faces);
  jalon_model_release(model);
  jalon_model_release(apart);
  jalon_model_release(into);
}

static void gauge__meets_a_pole_between_far_poses(void** state) {
  (void)state;
  const double pole[6] = {60, 0.97, 0, 61, 3, 0};
  jalon_cloud* cloud = points(pole, 2);
  const double corners[24] = {-.5, -1, -1, .5, -1, -1, -.5, 1, -1, .5, 1, -1,
                              -.5, -1, 1,  .5, -1, 1,  -.5, 1, 1,  .5, 1, 1};
  jalon_gauge_piece piece = {JALON_GAUGE_BOX, 0, {{1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0}},
                             {1, 2, 2},       0, 0};
  jalon_transform poses[2] = {kHere, kHere};
  poses[1].m[3] = 240;
  for (int hull = 0; hull < 2; ++hull) {
    if (hull) piece.kind = JALON_GAUGE_HULL, piece.count = 8;
    jalon_fields *places = NULL, *intervals = NULL;
    MUST(jalon_gauge_sweep(&piece, 1, corners, 8, poses, 2, cloud, NULL, NULL, NULL, &places,
                           &intervals));
    assert_int_equal(rows(places), 1);
    near_to(number(places, "clearance", 0), -0.03);
    assert_true(fabs(number(places, "parameter", 0) - 0.25) < 0.003);
    near_to(number(places, "gauge_xyz", 0), 60);
    assert_int_equal(rows(intervals), 1);
    near_to(number(intervals, "near", 0), 1);
    jalon_fields_release(places);
    jalon_fields_release(intervals);
  }
  jalon_cloud_release(cloud);
}

static void gauge__as_a_model_against_a_model(void** state) {
  (void)state;
  jalon_model *gauge = block(0), *wall = block(1.2);
  jalon_transform poses[3] = {kHere, kHere, kHere};
  poses[1].m[7] = 1;
  poses[2].m[3] = 0.15, poses[2].m[7] = 1;
  jalon_fields* intervals = NULL;
  MUST(jalon_gauge_sweep_model(gauge, poses, 3, NULL, wall, NULL, NULL, NULL, &intervals));
  assert_int_equal(rows(intervals), 2);
  near_to(number(intervals, "clearance", 0), 0.2);
  near_to(number(intervals, "clearance", 1), 0.05);
  near_to(number(intervals, "parameter", 1), 2);
  jalon_fields_release(intervals);
  poses[2].m[0] = 2;
  REFUSED(JALON_ERROR_INVALID_ARGUMENT,
          jalon_gauge_sweep_model(gauge, poses, 3, NULL, wall, NULL, NULL, NULL, &intervals));
  REFUSED(JALON_ERROR_INVALID_ARGUMENT,
          jalon_gauge_sweep_model(gauge, poses, 1, NULL, NULL, NULL, NULL, NULL, &intervals));
  jalon_model_release(gauge);
  jalon_model_release(wall);
}

int main(void) {
  const struct CMUnitTest tests[] = {
      cmocka_unit_test(clearance__of_a_cloud_tells_the_nearest_point_and_all_within_the_margin),
      cmocka_unit_test(clearance__of_two_models_is_signed),
      cmocka_unit_test(gauge__meets_a_pole_between_far_poses),
      cmocka_unit_test(gauge__as_a_model_against_a_model),
  };
  return cmocka_run_group_tests(tests, NULL, NULL);
}

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
enum { kMost = 1000 };

static uint64_t rows(jalon_fields* fields, const char* name) {
  jalon_array_view view;
  OK(jalon_fields_view(fields, name, &view));
  return view.count;
}

static void street(jalon_model** model, jalon_trajectory** trajectory) {
  OK(jalon_scene_street_drive(NULL, model, trajectory));
}

static void strips_of(const jalon_model* model, jalon_model** strips, jalon_fields** table) {
  jalon_params* options = NULL;
  OK(jalon_params_create("building_strips", &options));
  OK(jalon_params_set_double(options, "touch_m", 2));
  OK(jalon_model_building_strips(model, options, NULL, strips, table));
  jalon_params_release(options);
}

static void strips__of_the_street__are_of_14_blocks_and_56_facades(void** state) {
  (void)state;
  jalon_model *model = NULL, *strips = NULL;
  jalon_fields* table = NULL;
  street(&model, NULL);
  strips_of(model, &strips, &table);
  static double block[kMost], facade[kMost], width[kMost], part[kMost], normal[3 * kMost];
  const uint64_t n = rows(table, "block");
  assert_int_equal(n, 304);
  OK(jalon_fields_copy(table, "block", JALON_FLOAT64, block, kMost));
  OK(jalon_fields_copy(table, "facade", JALON_FLOAT64, facade, kMost));
  OK(jalon_fields_copy(table, "width", JALON_FLOAT64, width, kMost));
  OK(jalon_fields_copy(table, "part", JALON_FLOAT64, part, kMost));
  OK(jalon_fields_copy(table, "normal", JALON_FLOAT64, normal, 3 * kMost));
  for (uint64_t i = 0; i < n; ++i) {
    const char *name = NULL, *class = NULL;
    OK(jalon_model_part(strips, (uint64_t)part[i], &name, &class, NULL));
    assert_string_equal(class, "strip");
    assert_true(width[i] > 0.74 && width[i] < 2.26);
    assert_true(fabs(hypot(normal[3 * i], normal[3 * i + 1]) - 1) < 1e-12);
  }
  assert_true(block[n - 1] == 13 && facade[n - 1] == 55);
  jalon_fields* triangles = NULL;
  OK(jalon_model_triangles(strips, &triangles));
  assert_int_equal(rows(triangles, "face"), 2 * n);
  jalon_fields_release(triangles);
  jalon_fields_release(table);
  jalon_model_release(strips);
  jalon_model_release(model);
}

static void strips__of_what_has_no_walls__are_refused(void** state) {
  (void)state;
  const double floor[9] = {0, 0, 0, 1, 0, 0, 0, 1, 0};
  const uint32_t triangle[3] = {0, 1, 2};
  jalon_model *model = NULL, *strips = NULL;
  OK(jalon_model_create_mesh(floor, JALON_FLOAT64, 3, 0, triangle, 1, NULL, &model));
  assert_int_equal(jalon_model_building_strips(model, NULL, NULL, &strips, NULL),
                   JALON_ERROR_INSUFFICIENT_DATA);
  assert_null(strips);
  jalon_model *house = NULL, *moved = NULL; /* faces, but no strips */
  street(&house, NULL);
  INVALID(jalon_model_perturb_strips(house, NULL, &moved, NULL, NULL, NULL));
  assert_non_null(strstr(jalon_last_error_message(), "it is no model of strips"));
  assert_null(moved);
  jalon_model_release(house);
  jalon_model_release(model);
}

static void perturbed_strips__stand_off_by_their_draws(void** state) {
  (void)state;
  jalon_model *model = NULL, *strips = NULL, *moved = NULL;
  jalon_fields *blocks = NULL, *facades = NULL, *of_strips = NULL, *before = NULL, *after = NULL,
               *table = NULL;
  street(&model, NULL);
  strips_of(model, &strips, &table);
  OK(jalon_model_perturb_strips(strips, NULL, &moved, &blocks, &facades, &of_strips));
  static double b[2 * kMost], f[kMost], s[kMost], was[kMost], is[kMost], normal[3 * kMost],
      block[kMost], facade[kMost];
  OK(jalon_fields_copy(blocks, "offset", JALON_FLOAT64, b, 2 * kMost));
  OK(jalon_fields_copy(facades, "offset", JALON_FLOAT64, f, kMost));
  OK(jalon_fields_copy(of_strips, "offset", JALON_FLOAT64, s, kMost));
  OK(jalon_fields_copy(table, "block", JALON_FLOAT64, block, kMost));
  OK(jalon_fields_copy(table, "facade", JALON_FLOAT64, facade, kMost));
  OK(jalon_fields_copy(table, "normal", JALON_FLOAT64, normal, 3 * kMost));
  OK(jalon_model_faces(strips, &before));
  OK(jalon_model_faces(moved, &after));
  OK(jalon_fields_copy(before, "offset", JALON_FLOAT64, was, kMost));
  OK(jalon_fields_copy(after, "offset", JALON_FLOAT64, is, kMost));
  for (uint64_t i = 0; i < rows(table, "block"); ++i) {
    const double* d = b + 2 * (int)block[i];
    const double off = d[0] * normal[3 * i] + d[1] * normal[3 * i + 1] + f[(int)facade[i]] + s[i];
    assert_true(fabs(is[i] - was[i] - off) < 1e-9);
  }
  jalon_fields* all[] = {blocks, facades, of_strips, before, after, table};
  for (size_t i = 0; i < 6; ++i) jalon_fields_release(all[i]);
  jalon_model_release(moved);
  jalon_model_release(strips);
  jalon_model_release(model);
}

/* Every point of a drive through the strips lies in the plane of the strip that it names. */
static void drive__through_the_strips__gives_perfect_matches(void** state) {
  (void)state;
  jalon_model *model = NULL, *strips = NULL;
  jalon_trajectory* trajectory = NULL;
  jalon_fields *table = NULL, *fields = NULL;
  street(&model, &trajectory);
  strips_of(model, &strips, &table);
  jalon_scanner* scanner = NULL;
  jalon_params* params = NULL;
  jalon_cloud* cloud = NULL;
  const double boresight[3] = {0, 1.5707963267948966, 0.4};
  OK(jalon_scanner_create("mobile", &scanner));
  OK(jalon_scanner_params(scanner, &params));
  OK(jalon_params_set_doubles(params, "boresight_rad", boresight, 3));
  OK(jalon_params_set_double(params, "revolutions_per_s", 5));
  OK(jalon_params_set_int64(params, "pulses", 200));
  OK(jalon_scanner_drive(scanner, strips, trajectory, NULL, &cloud));
  OK(jalon_cloud_fields(cloud, &fields));
  jalon_array_view points, ids;
  OK(jalon_cloud_points(cloud, &points));
  OK(jalon_fields_view(fields, "strip", &ids));
  static double normal[3 * kMost], place[3 * kMost];
  OK(jalon_fields_copy(table, "normal", JALON_FLOAT64, normal, 3 * kMost));
  OK(jalon_fields_copy(table, "place", JALON_FLOAT64, place, 3 * kMost));
  assert_true(points.count > 1000);
  for (uint64_t i = 0; i < points.count; ++i) {
    const double* p = (const double*)points.data + 3 * i;
    const uint32_t strip = ((const uint32_t*)ids.data)[i];
    assert_true(strip < 304);
    const double *n = normal + 3 * strip, *q = place + 3 * strip;
    assert_true(fabs((p[0] - q[0]) * n[0] + (p[1] - q[1]) * n[1]) < 1e-9);
  }
  jalon_cloud* none = NULL;
  jalon_scanner* tripod = NULL;
  OK(jalon_scanner_create(NULL, &tripod));
  assert_int_equal(jalon_scanner_drive(tripod, strips, trajectory, NULL, &none),
                   JALON_ERROR_UNSUPPORTED);
  assert_int_equal(jalon_scanner_run(scanner, strips, NULL, &none), JALON_ERROR_UNSUPPORTED);
  assert_null(none);
  jalon_fields_release(fields);
  jalon_fields_release(table);
  jalon_cloud_release(cloud);
  jalon_params_release(params);
  jalon_scanner_release(scanner);
  jalon_scanner_release(tripod);
  jalon_trajectory_release(trajectory);
  jalon_model_release(strips);
  jalon_model_release(model);
}

int main(void) {
  const struct CMUnitTest tests[] = {
      cmocka_unit_test(strips__of_the_street__are_of_14_blocks_and_56_facades),
      cmocka_unit_test(strips__of_what_has_no_walls__are_refused),
      cmocka_unit_test(perturbed_strips__stand_off_by_their_draws),
      cmocka_unit_test(drive__through_the_strips__gives_perfect_matches),
  };
  return cmocka_run_group_tests_name("buildings", tests, NULL, NULL);
}

/* SPDX-FileCopyrightText: 2026 The Jalon authors
 * SPDX-License-Identifier: Apache-2.0 */
#include "support.h"

#include <locale.h>
#include <math.h>
#include <stdio.h>

enum { kBall = 600, kPipe = 900, kWall = 1600, kAll = kBall + kPipe + kWall };

/* A ball at (5, 0, 1) r 0.5, a column at (2, 0) r 0.2, and a wall y = 3, 2 mm noise. */
static jalon_cloud* yard(void) {
  static double xyz[3 * kAll];
  for (int i = 0; i < kAll; ++i) {
    const uint64_t k = (uint64_t)i;
    const double a = 6.283185307 * uniform(1, k), b = uniform(2, k),
                 noise = 0.004 * (uniform(3, k) - 0.5);
    double* p = xyz + 3 * i;
    if (i < kBall) {
      const double z = 2 * b - 1, s = sqrt(1 - z * z), r = 0.5 + noise;
      p[0] = 5 + r * s * cos(a), p[1] = r * s * sin(a), p[2] = 1 + r * z;
    } else if (i < kBall + kPipe) {
      p[0] = 2 + (0.2 + noise) * cos(a), p[1] = (0.2 + noise) * sin(a), p[2] = 2 * b;
    } else {
      p[0] = 4 * uniform(4, k), p[1] = 3 + noise, p[2] = 2 * b;
    }
  }
  jalon_cloud* cloud = NULL;
  MUST(jalon_cloud_create(xyz, JALON_FLOAT64, kAll, 0, 0, &cloud));
  return cloud;
}

static double number(const jalon_fields* fields, const char* name, uint64_t row,
                     uint32_t component) {
  jalon_array_view view;
  MUST(jalon_fields_view(fields, name, &view));
  assert_int_equal(view.type, JALON_FLOAT64);
  assert_true(row < view.count);
  return ((const double*)view.data)[row * view.components + component];
}

static void primitives__fits_by_index_with_covariance(void** state) {
  (void)state;
  jalon_cloud* cloud = yard();
  uint64_t ball[kBall], pipe[kPipe];
  for (uint64_t i = 0; i < kBall; ++i) ball[i] = i;
  for (uint64_t i = 0; i < kPipe; ++i) pipe[i] = kBall + i;
  jalon_fields* fit = NULL;
  MUST(jalon_cloud_fit_sphere(cloud, ball, kBall, NULL, NULL, &fit));
  assert_true(fabs(number(fit, "radius", 0, 0) - 0.5) < 3e-4);
  assert_true(fabs(number(fit, "centroid", 0, 0) - 5) < 3e-4);
  const double sigma_r = sqrt(number(fit, "covariance", 0, 15));
  assert_true(sigma_r > 2e-5 && sigma_r < 1e-4);
  assert_true(isnan(number(fit, "normal", 0, 0)) &&
              isnan(number(fit, "cylinder_covariance", 0, 0)));
  jalon_fields_release(fit);
  MUST(jalon_cloud_fit_cylinder(cloud, pipe, kPipe, NULL, NULL, NULL, &fit));
  assert_true(fabs(number(fit, "radius", 0, 0) - 0.2) < 3e-4);
  assert_true(number(fit, "normal", 0, 2) > 0.99999);
  assert_true(number(fit, "cylinder_covariance", 0, 48) > 0);
  assert_true(fabs(number(fit, "length_u", 0, 0) - 2) < 0.02);
  jalon_fields_release(fit);
  const jalon_vec3 up = {0, 0, 3};
  MUST(jalon_cloud_fit_cylinder(cloud, pipe, kPipe, &up, NULL, NULL, &fit));
  assert_true(number(fit, "normal", 0, 2) == 1);
  assert_true(fabs(number(fit, "radius", 0, 0) - 0.2) < 3e-4);
  jalon_fields_release(fit);
  const double ring[12] = {1, 0, 5, 0, 1, 5, -1, 0, 5, 0, -1, 5};
  jalon_cloud* circle = NULL;
  MUST(jalon_cloud_create(ring, JALON_FLOAT64, 4, 0, 0, &circle));
  MUST(jalon_cloud_fit_circle(circle, NULL, 0, NULL, NULL, &fit));
  assert_true(fabs(number(fit, "radius", 0, 0) - 1) < 1e-9);
  assert_true(fabs(number(fit, "centre", 0, 2) - 5) < 1e-9);
  jalon_fields_release(fit);
  jalon_cloud_release(circle);
  jalon_cloud_release(cloud);
}

static void primitives__refuses_what_fixes_nothing(void** state) {
  (void)state;
  const double line[15] = {0, 0, 0, 1, 1, 1, 2, 2, 2, 3, 3, 3, 4, 4, 4};
  const uint64_t three[3] = {0, 1, 2}, beyond[4] = {0, 1, 2, 5};
  const jalon_vec3 none = {0, 0, 0};
  jalon_cloud* cloud = NULL;
  jalon_fields* fit = NULL;
  MUST(jalon_cloud_create(line, JALON_FLOAT64, 5, 0, 0, &cloud));
  REFUSED(JALON_ERROR_INSUFFICIENT_DATA, jalon_cloud_fit_sphere(cloud, three, 3, NULL, NULL, &fit));
  REFUSED(JALON_ERROR_INVALID_ARGUMENT, jalon_cloud_fit_sphere(cloud, beyond, 4, NULL, NULL, &fit));
  REFUSED(JALON_ERROR_DEGENERATE, jalon_cloud_fit_sphere(cloud, NULL, 0, NULL, NULL, &fit));
  REFUSED(JALON_ERROR_DEGENERATE, jalon_cloud_fit_cylinder(cloud, NULL, 0, NULL, NULL, NULL, &fit));
  REFUSED(JALON_ERROR_INVALID_ARGUMENT,
          jalon_cloud_fit_cylinder(cloud, NULL, 0, &none, NULL, NULL, &fit));
  REFUSED(JALON_ERROR_DEGENERATE, jalon_cloud_fit_circle(cloud, NULL, 0, NULL, NULL, &fit));
  assert_true(fit == NULL);
  jalon_cloud_release(cloud);
}

/* The rows of the parameter file hold the numbers of the table, to the bit: type; normal and offset, centre and radius,
 * or axis point, direction and radius. */
static void expect_parameter_file(const jalon_segmentation* segmentation) {
  static const char* const kColumns[4][3] = {{NULL},
                                             {"normal", "offset", NULL},
                                             {"centroid", "radius", NULL},
                                             {"centroid", "normal", "radius"}};
  const char* path = temporary("primitives.txt");
  jalon_fields* segments = NULL;
  jalon_array_view types;
  size_t bytes = 0;
  MUST(jalon_segmentation_segments(segmentation, &segments));
  MUST(jalon_fields_view(segments, "type", &types));
  MUST(jalon_segmentation_write_primitives(segmentation, path));
  char* text = content_of(path, &bytes);
  assert_non_null(text);
  for (char* c = text; *c != 0;
       ++c) /* strtod reads the host's decimal mark, the file has points in every locale */
    if (*c == '.') *c = *localeconv()->decimal_point;
  char* at = text;
  for (uint64_t row = 0; row < types.count; ++row) {
    const uint8_t type = ((const uint8_t*)types.data)[row];
    assert_int_equal(strtol(at, &at, 10), type);
    for (int c = 0; c < 3 && kColumns[type][c] != NULL; ++c) {
      jalon_array_view column;
      MUST(jalon_fields_view(segments, kColumns[type][c], &column));
      for (uint32_t k = 0; k < column.components; ++k)
        assert_true(strtod(at, &at) == number(segments, kColumns[type][c], row, k));
    }
    assert_true(*at++ == '\n');
  }
  assert_true(*at == 0);
  free(text);
  remove(path);
  jalon_fields_release(segments);
}

static void primitives__picks_one_after_the_other_with_undo(void** state) {
  (void)state;
  jalon_cloud *cloud = yard(), *rest = NULL;
  jalon_segmentation *none = NULL, *wall = NULL, *column = NULL, *ball = NULL;
  jalon_params* options = NULL;
  MUST(jalon_params_create("pick", &options));
  MUST(jalon_params_set_double(options, "tolerance_m", 0.01));
  const double corners[12] = {-0.1, 3, -0.1, 4.1, 3, -0.1, 4.1, 3, 2.1, -0.1, 3, 2.1};
  const double round[9] = {2.2, 0, 0.3, 2, 0.2, 1, 1.8, 0, 1.6};
  const double four[12] = {5.5, 0, 1, 5, 0.5, 1, 5, 0, 1.5, 4.5, 0, 1};
  MUST(jalon_segmentation_start(cloud, NULL, &none));
  MUST(jalon_segmentation_pick(none, JALON_PRIMITIVE_PLANE, corners, 4, options, NULL, &wall));
  MUST(jalon_segmentation_pick(wall, JALON_PRIMITIVE_CYLINDER, round, 3, options, NULL, &column));
  MUST(jalon_segmentation_pick(column, JALON_PRIMITIVE_SPHERE, four, 4, options, NULL, &ball));
  jalon_fields* segments = NULL;
  jalon_array_view type, inliers;
  MUST(jalon_segmentation_segments(ball, &segments));
  MUST(jalon_fields_view(segments, "type", &type));
  MUST(jalon_fields_view(segments, "inliers", &inliers));
  assert_int_equal(type.count, 3);
  const uint8_t* types = type.data;
  assert_true(types[0] == JALON_PRIMITIVE_PLANE && types[1] == JALON_PRIMITIVE_CYLINDER &&
              types[2] == JALON_PRIMITIVE_SPHERE);
  assert_true(((const uint64_t*)inliers.data)[0] == kWall);
  assert_true(fabs(number(segments, "radius", 1, 0) - 0.2) < 5e-4);
  assert_true(fabs(number(segments, "radius", 2, 0) - 0.5) < 5e-4);
  jalon_fields_release(segments);
  uint64_t count = 0;
  MUST(jalon_segmentation_remaining(wall, NULL, &rest));
  MUST(jalon_cloud_count(rest, &count));
  assert_int_equal(count, kAll - kWall);
  jalon_cloud_release(rest);
  MUST(jalon_segmentation_remaining(none, NULL, &rest)); /* the undo is untouched */
  MUST(jalon_cloud_count(rest, &count));
  assert_int_equal(count, kAll);
  jalon_cloud_release(rest);
  expect_parameter_file(ball);
  jalon_segmentation* more = NULL;
  REFUSED(JALON_ERROR_INSUFFICIENT_DATA,
          jalon_segmentation_pick(ball, JALON_PRIMITIVE_PLANE, corners, 4, NULL, NULL, &more));
  REFUSED(JALON_ERROR_INVALID_ARGUMENT,
          jalon_segmentation_pick(ball, 4, corners, 4, NULL, NULL, &more));
  assert_true(more == NULL);
  jalon_segmentation_release(none);
  jalon_segmentation_release(wall);
  jalon_segmentation_release(column);
  jalon_segmentation_release(ball);
  jalon_params_release(options);
  jalon_cloud_release(cloud);
}

int main(void) {
  const struct CMUnitTest tests[] = {
      cmocka_unit_test(primitives__fits_by_index_with_covariance),
      cmocka_unit_test(primitives__refuses_what_fixes_nothing),
      cmocka_unit_test(primitives__picks_one_after_the_other_with_undo),
  };
  return cmocka_run_group_tests(tests, NULL, NULL);
}

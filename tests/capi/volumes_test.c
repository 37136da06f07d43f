/* SPDX-FileCopyrightText: 2026 The Jalon authors
 * SPDX-License-Identifier: Apache-2.0 */
#include "support.h"

#include <math.h>

/* A square metre of points every 0.1 m at this height. */
static jalon_cloud* square(double z) {
  double xyz[300];
  for (int i = 0; i < 100; ++i) {
    xyz[3 * i] = 0.05 + 0.1 * (i % 10);
    xyz[3 * i + 1] = 0.05 + 0.1 * (i / 10);
    xyz[3 * i + 2] = z;
  }
  jalon_cloud* cloud = NULL;
  MUST(jalon_cloud_create(xyz, JALON_FLOAT64, 100, 0, 0, &cloud));
  return cloud;
}

/* A tetrahedron with three edges of this length along the axes; without its slanted face when it is to be open. */
static jalon_model* tetrahedron(double edge_m, uint64_t faces) {
  const double xyz[12] = {0, 0, 0, edge_m, 0, 0, 0, edge_m, 0, 0, 0, edge_m};
  const uint32_t triangles[12] = {0, 2, 1, 0, 1, 3, 0, 3, 2, 1, 2, 3};
  jalon_model* model = NULL;
  MUST(jalon_model_create_mesh(xyz, JALON_FLOAT64, 4, 0, triangles, faces, NULL, &model));
  return model;
}

static double number_of(jalon_fields* table, const char* name) {
  double value = 0;
  MUST(jalon_fields_copy(table, name, JALON_FLOAT64, &value, 1));
  return value;
}

static void volume__between_two_clouds_has_cut_and_fill(void** state) {
  (void)state;
  jalon_cloud* low = square(1);
  jalon_cloud* high = square(1.5);
  jalon_params* options = NULL;
  MUST(jalon_params_create("volume", &options));
  MUST(jalon_params_set_double(options, "cell_m", 0.25));
  jalon_fields* summary = NULL;
  jalon_fields* cells = NULL;
  MUST(jalon_cloud_volume(low, high, options, NULL, &summary, &cells));
  assert_true(fabs(number_of(summary, "fill") - 0.5) < 1e-12);
  assert_true(number_of(summary, "cut") == 0);
  assert_true(number_of(summary, "cells") == 16);
  double volumes[16];
  MUST(jalon_fields_copy(cells, "volume", JALON_FLOAT64, volumes, 16));
  assert_true(fabs(volumes[15] - 0.5 / 16) < 1e-12);
  jalon_fields_release(cells);
  jalon_fields_release(summary);
  MUST(jalon_cloud_volume(high, low, options, NULL, &summary, NULL));
  assert_true(fabs(number_of(summary, "cut") - 0.5) < 1e-12);
  jalon_fields_release(summary);
  summary = NULL;
  MUST(jalon_cloud_set_crs(low, "EPSG:2154"));
  MUST(jalon_cloud_set_crs(high, "EPSG:2056"));
  REFUSED(JALON_ERROR_INVALID_ARGUMENT,
          jalon_cloud_volume(low, high, options, NULL, &summary, NULL));
  MUST(jalon_params_set_double(options, "cell_m", 1e-5));
  REFUSED(JALON_ERROR_LIMIT, jalon_cloud_volume(low, low, options, NULL, &summary, NULL));
  assert_null(summary);
  jalon_params_release(options);
  jalon_cloud_release(low);
  jalon_cloud_release(high);
}

static void volume__between_two_models_is_what_they_enclose(void** state) {
  (void)state;
  jalon_model* small = tetrahedron(1, 4);
  jalon_model* large = tetrahedron(2, 4);
  jalon_model* open = tetrahedron(1, 3);
  jalon_fields* summary = NULL;
  MUST(jalon_model_volume(small, large, NULL, NULL, &summary, NULL));
  assert_true(fabs(number_of(summary, "net") - 7.0 / 6) < 1e-12);
  jalon_fields_release(summary);
  summary = NULL;
  jalon_params* options = NULL;
  MUST(jalon_params_create("volume", &options));
  MUST(jalon_params_set_string(options, "surfaces", "closed"));
  REFUSED(JALON_ERROR_DEGENERATE, jalon_model_volume(small, open, options, NULL, &summary, NULL));
  assert_null(summary);
  jalon_params_release(options);
  jalon_model_release(open);
  jalon_model_release(large);
  jalon_model_release(small);
}

static void model_sample__lies_on_the_model_that_it_is_compared_with(void** state) {
  (void)state;
  jalon_model* model = tetrahedron(2, 4);
  jalon_params* options = NULL;
  MUST(jalon_params_create("model_sample", &options));
  MUST(jalon_params_set_int64(options, "points", 500));
  jalon_cloud* cloud = NULL;
  MUST(jalon_model_sample(model, options, NULL, &cloud));
  jalon_comparer* comparer = NULL;
  MUST(jalon_comparer_create("distance", &comparer));
  jalon_comparison* comparison = NULL;
  MUST(jalon_comparer_run_model(comparer, model, cloud, NULL, &comparison));
  jalon_fields* summary = NULL;
  MUST(jalon_comparison_summary(comparison, &summary));
  assert_true(number_of(summary, "compared") == 500);
  assert_true(number_of(summary, "maximum_absolute") < 1e-14);
  jalon_fields_release(summary);
  jalon_comparison_release(comparison);
  jalon_comparer_release(comparer);
  jalon_cloud_release(cloud);
  jalon_params_release(options);
  jalon_model_release(model);
}

int main(void) {
  const struct CMUnitTest tests[] = {
      cmocka_unit_test(volume__between_two_clouds_has_cut_and_fill),
      cmocka_unit_test(volume__between_two_models_is_what_they_enclose),
      cmocka_unit_test(model_sample__lies_on_the_model_that_it_is_compared_with),
  };
  return cmocka_run_group_tests(tests, NULL, NULL);
}

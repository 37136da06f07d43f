/* SPDX-FileCopyrightText: 2026 The Jalon authors
 * SPDX-License-Identifier: Apache-2.0 */
/* From distances to change regions, as a plug-in would do it. */
#include "support.h"

#include <math.h>

enum { kPoints = 40000 };

/* A plate of 4 x 4 m with folded noise of 3 mm; a disc of 0.4 m radius in its middle has moved by 3 cm. */
static jalon_cloud* plate(uint64_t n) {
  double* xyz = malloc(n * 24);
  double* distance = malloc(n * 8);
  jalon_cloud* cloud = NULL;
  for (uint64_t i = 0; i < n; ++i) {
    const double x = 4 * uniform(1, 3 * i), y = 4 * uniform(1, 3 * i + 1);
    double sum = -6;
    for (uint64_t j = 0; j < 12; ++j) sum += uniform(2, 12 * i + j); /* nearly normal */
    xyz[3 * i] = x, xyz[3 * i + 1] = y, xyz[3 * i + 2] = 0;
    distance[i] = fabs(0.003 * sum) + (hypot(x - 2, y - 2) < 0.4 ? 0.03 : 0);
  }
  MUST(jalon_cloud_create(xyz, JALON_FLOAT64, n, 0, 0, &cloud));
  MUST(jalon_cloud_set_field(cloud, "distance", distance, JALON_FLOAT64, 1, n, 0, "m", NULL));
  free(xyz);
  free(distance);
  return cloud;
}

static double number(const jalon_fields* fields, const char* name) {
  double value = NAN;
  MUST(jalon_fields_copy(fields, name, JALON_FLOAT64, &value, 1));
  return value;
}

/* The law of the plate without its middle. */
static jalon_noise_law* law_of(const jalon_cloud* cloud) {
  const jalon_vec3 foot = {2, 2, -1}, top = {2, 2, 1};
  jalon_cloud *middle = NULL, *rest = NULL;
  jalon_noise_law* law = NULL;
  MUST(jalon_cloud_crop_cylinder(cloud, &foot, &top, 0.8, NULL, &middle, &rest));
  MUST(jalon_noise_law_fit(rest, "distance", NULL, NULL, &law));
  jalon_cloud_release(middle);
  jalon_cloud_release(rest);
  return law;
}

static void law__fitted_kept_as_text_and_used_again(void** state) {
  (void)state;
  jalon_cloud* cloud = plate(kPoints);
  jalon_noise_law *law = law_of(cloud), *again = NULL;
  jalon_fields* table = NULL;
  const char *text = NULL, *text_again = NULL;
  MUST(jalon_noise_law_table(law, &table));
  assert_true(fabs(number(table, "shape") - 1.263) < 0.03);
  assert_true(fabs(number(table, "scale") - 0.003 * 0.855) < 0.0001);
  jalon_fields_release(table);
  MUST(jalon_noise_law_json(law, &text));
  MUST(jalon_noise_law_from_json(text, &again));
  MUST(jalon_noise_law_json(again, &text_again));
  assert_true(strcmp(text, text_again) == 0);
  const double probabilities[3] = {0.5, 0.95, 2};
  double values[3], cumulative[3], density[3];
  MUST(jalon_noise_law_quantiles(again, probabilities, 3, values));
  MUST(jalon_noise_law_evaluate(again, values, 2, density, cumulative));
  assert_true(fabs(cumulative[0] - 0.5) < 1e-12 && fabs(cumulative[1] - 0.95) < 1e-12 &&
              density[0] > density[1]);
  assert_true(isnan(values[2]));
  jalon_noise_law_release(again);
  jalon_noise_law_release(law);
  jalon_cloud_release(cloud);
}

static void histogram__counts_every_value(void** state) {
  (void)state;
  jalon_cloud* cloud = plate(kPoints);
  jalon_noise_law* law = law_of(cloud);
  jalon_fields *bins = NULL, *summary = NULL;
  jalon_array_view count;
  uint64_t sum = 0;
  MUST(jalon_cloud_field_histogram(cloud, "distance", law, NULL, NULL, &bins, &summary));
  MUST(jalon_fields_view(bins, "count", &count));
  for (uint64_t i = 0; i < count.count; ++i) sum += ((const uint64_t*)count.data)[i];
  assert_int_equal(sum, kPoints);
  assert_true(number(summary, "p_value") < 1e-6); /* the disc does not follow the law */
  jalon_fields_release(bins);
  jalon_fields_release(summary);
  jalon_noise_law_release(law);
  jalon_cloud_release(cloud);
}

static void chain__filter_and_components__one_region_the_disc(void** state) {
  (void)state;
  jalon_cloud* cloud = plate(kPoints);
  jalon_noise_law* law = law_of(cloud);
  jalon_params* options = NULL;
  jalon_fields *summary = NULL, *fields = NULL;
  jalon_array_view component, xyz;
  uint64_t components = 0, inside = 0, found = 0;
  MUST(jalon_cloud_compute_chi_square(cloud, "distance", law, NULL, NULL, &summary));
  assert_int_equal(number(summary, "tested"), kPoints);
  assert_true(number(summary, "ceiling") == 48);
  MUST(jalon_params_create("components", &options));
  MUST(jalon_params_from_json(options,
                              "{\"field\": \"changed\", \"cell_m\": 0.1, \"min_points\": 50}"));
  MUST(jalon_cloud_compute_components(cloud, options, NULL, &components));
  assert_int_equal(components, 1);
  MUST(jalon_cloud_fields(cloud, &fields));
  MUST(jalon_fields_view(fields, "component", &component));
  MUST(jalon_cloud_points(cloud, &xyz));
  for (uint64_t i = 0; i < kPoints; ++i) {
    const double* p = (const double*)xyz.data + 3 * i;
    const int in = hypot(p[0] - 2, p[1] - 2) < 0.4;
    inside += (uint64_t)in;
    found += in && ((const uint32_t*)component.data)[i] == 1;
  }
  assert_true(found > 0.98 * inside);
  jalon_fields_release(fields);
  jalon_fields_release(summary);
  jalon_params_release(options);
  jalon_noise_law_release(law);
  jalon_cloud_release(cloud);
}

static void tools__add_their_fields_and_refuse_what_they_must(void** state) {
  (void)state;
  jalon_cloud* cloud = plate(2000);
  jalon_cloud* map = NULL;
  jalon_fields* table = NULL;
  jalon_fields* fields = NULL;
  jalon_params* options = NULL;
  const uint64_t seeds[2] = {7, 70}, wild = 2000;
  MUST(jalon_cloud_compute_gradient(cloud, "distance", NULL, NULL));
  MUST(jalon_cloud_filter_field(cloud, "gradient", NULL, NULL));
  MUST(jalon_cloud_segment_propagation(cloud, "distance", "filtered", NULL, NULL, &table));
  jalon_fields_release(table);
  MUST(jalon_cloud_classify_field(cloud, "distance", NULL, NULL, &table));
  assert_true(number(table, "low_cut") > 0.01 && number(table, "low_cut") < 0.03);
  jalon_fields_release(table);
  MUST(jalon_cloud_compute_field(cloud, "distance", "gradient", NULL, NULL));
  MUST(jalon_cloud_compute_geodesic(cloud, seeds, 2, NULL, NULL));
  MUST(jalon_cloud_compute_map_distance(cloud, cloud, NULL, NULL));
  MUST(jalon_cloud_distance_map(cloud, NULL, NULL, &map));
  MUST(jalon_cloud_fields(cloud, &fields));
  const char* names[] = {"gradient", "filtered", "region",      "class",
                         "computed", "geodesic", "map_distance"};
  for (size_t i = 0; i < sizeof names / sizeof *names; ++i) {
    jalon_array_view view;
    MUST(jalon_fields_view(fields, names[i], &view));
    assert_int_equal(view.count, 2000);
  }
  REFUSED(JALON_ERROR_NOT_FOUND, jalon_cloud_compute_gradient(cloud, "no such field", NULL, NULL));
  REFUSED(JALON_ERROR_INSUFFICIENT_DATA, jalon_cloud_compute_geodesic(cloud, NULL, 0, NULL, NULL));
  REFUSED(JALON_ERROR_INVALID_ARGUMENT, jalon_cloud_compute_geodesic(cloud, &wild, 1, NULL, NULL));
  MUST(jalon_params_create("gradient", &options));
  REFUSED(JALON_ERROR_INVALID_ARGUMENT, jalon_cloud_filter_field(cloud, "distance", options, NULL));
  jalon_params_release(options);
  jalon_fields_release(fields);
  jalon_cloud_release(map);
  jalon_cloud_release(cloud);
}

int main(void) {
  const struct CMUnitTest tests[] = {
      cmocka_unit_test(law__fitted_kept_as_text_and_used_again),
      cmocka_unit_test(histogram__counts_every_value),
      cmocka_unit_test(chain__filter_and_components__one_region_the_disc),
      cmocka_unit_test(tools__add_their_fields_and_refuse_what_they_must),
  };
  return cmocka_run_group_tests(tests, NULL, NULL);
}

/* SPDX-FileCopyrightText: 2026 The Jalon authors
 * SPDX-License-Identifier: Apache-2.0 */
#include "support.h"

#include <math.h>

static double component(jalon_fields* fields, const char* name, uint64_t row, uint32_t k) {
  double out[64];
  jalon_array_view view;
  MUST(jalon_fields_view(fields, name, &view));
  assert_true(row < view.count && view.count * view.components <= 64);
  MUST(jalon_fields_copy(fields, name, JALON_FLOAT64, out, 64));
  return out[row * view.components + k];
}

static double value(jalon_fields* fields, const char* name, uint64_t row) {
  return component(fields, name, row, 0);
}

static void budget__of_a_trimble_gx_is_11_6_mm_at_100_m(void** state) {
  (void)state;
  const double ranges[3] = {100, 100, 100},
               vertical[3] = {0, 0.52359877559829887, 0.78539816339744831};
  const double expected_mm[3] = {11.58, 11.18, 10.77};
  jalon_fields* budget = NULL;
  MUST(jalon_precision_budget(ranges, vertical, NULL, 3, NULL, &budget));
  for (uint64_t i = 0; i < 3; ++i)
    assert_true(fabs(1000 * value(budget, "point", i) - expected_mm[i]) < 0.005);
  assert_true(fabs(component(budget, "covariance", 0, 0) - 36e-6) <
              1e-12); /* X: 60 urad over 100 m */
  assert_true(fabs(component(budget, "covariance", 0, 4) - 49e-6) < 1e-12); /* Y: the range */
  assert_true(fabs(component(budget, "covariance", 0, 8) - 49e-6) <
              1e-12); /* Z: 70 urad over 100 m */
  jalon_fields_release(budget);
  const double wrong[1] = {-1}, steep[1] = {2};
  REFUSED(JALON_ERROR_INVALID_ARGUMENT,
          jalon_precision_budget(wrong, NULL, NULL, 1, NULL, &budget));
  REFUSED(JALON_ERROR_INVALID_ARGUMENT,
          jalon_precision_budget(ranges, steep, NULL, 1, NULL, &budget));
}

static void cloud__gets_covariances_seen_from_its_station(void** state) {
  (void)state;
  const double xyz[6] = {0, 0, 1.7, 652010, 6861000, 150};
  jalon_cloud* cloud = cloud_of(xyz + 3, 1);
  REFUSED(JALON_ERROR_INVALID_ARGUMENT, jalon_cloud_compute_covariances(cloud, NULL, NULL));
  const jalon_transform pose = {{1, 0, 0, 652000, 0, 1, 0, 6861000, 0, 0, 1, 150}};
  MUST(jalon_cloud_set_station(cloud, "tripod", &pose));
  MUST(jalon_cloud_compute_covariances(cloud, NULL, NULL));
  jalon_fields* fields = NULL;
  MUST(jalon_cloud_fields(cloud, &fields));
  /* 10 m along X: the range is X, the horizontal angle Y, the vertical one Z. */
  assert_true(fabs(component(fields, "covariance", 0, 0) - 49e-6) < 1e-11);
  assert_true(fabs(component(fields, "covariance", 0, 3) - 3.6e-7) < 1e-13);
  assert_true(fabs(component(fields, "covariance", 0, 5) - 4.9e-7) < 1e-13);
  assert_true(fabs(value(fields, "point_sigma", 0) - sqrt(49e-6 + 8.5e-7)) < 1e-8);
  jalon_fields_release(fields);
  jalon_cloud_release(cloud);
}

static void planes__are_adjusted_with_their_points_covariances(void** state) {
  (void)state;
  jalon_cloud* cloud = street_cloud(20000, 3);
  const jalon_transform pose = {{1, 0, 0, 10, 0, 1, 0, -12, 0, 0, 1, 1.7}};
  jalon_segmenter* segmenter = NULL;
  jalon_segmentation* segmentation = NULL;
  jalon_fields* planes = NULL;
  MUST(jalon_segmenter_create(NULL, &segmenter));
  MUST(jalon_segmenter_run(segmenter, cloud, NULL, &segmentation));
  REFUSED(JALON_ERROR_INVALID_ARGUMENT,
          jalon_segmentation_plane_covariances(segmentation, NULL, NULL, &planes));
  jalon_segmentation_release(segmentation);
  MUST(jalon_cloud_set_station(cloud, "tripod", &pose));
  MUST(jalon_segmenter_run(segmenter, cloud, NULL, &segmentation));
  MUST(jalon_segmentation_plane_covariances(segmentation, NULL, NULL, &planes));
  assert_true(value(planes, "label", 0) == 1);
  assert_true(value(planes, "sigma_prior", 0) > 0.003 && value(planes, "sigma_prior", 0) < 0.0071);
  assert_true(value(planes, "sigma", 0) < 0.003);
  assert_true(value(planes, "variance_factor", 0) < 1); /* the points are better than a GX's */
  assert_true(component(planes, "covariance", 0, 15) > 0);
  jalon_fields_release(planes);
  jalon_segmentation_release(segmentation);
  jalon_segmenter_release(segmenter);
  jalon_cloud_release(cloud);
}

static void baseline__gives_back_its_additive_constant(void** state) {
  (void)state;
  const double known[4] = {7, 12, 19, 31}, measured[4] = {7.008, 12.009, 19.007, 31.008};
  jalon_fields* found = NULL;
  MUST(jalon_baseline_constant(measured, known, 4, &found));
  assert_true(fabs(value(found, "constant", 0) - 0.008) < 1e-12);
  assert_true(fabs(value(found, "sigma", 0) - sqrt(2e-6 / 3)) < 1e-12);
  assert_true(fabs(value(found, "sigma_constant", 0) - sqrt(2e-6 / 3) / 2) < 1e-12);
  jalon_fields_release(found);
  REFUSED(JALON_ERROR_INSUFFICIENT_DATA, jalon_baseline_constant(NULL, NULL, 0, &found));
  const double ranges[4] = {10, 10, 20, 20};
  MUST(jalon_angular_precision(measured, known, ranges, 4, &found));
  assert_true(fabs(value(found, "mean", 0) - (8e-4 + 9e-4 + 3.5e-4 + 4e-4) / 4) < 1e-12);
  jalon_fields_release(found);
}

static void sample__tells_range_precision_and_intensity(void** state) {
  (void)state;
  static double xyz[3 * 7500];
  static float intensity[7500];
  double squares = 0;
  for (int i = 0; i < 7500; ++i) { /* the panel of the tests: 0.20 x 0.15 m in steps of 2 mm */
    double noise = -6;
    for (uint64_t k = 0; k < 12; ++k) noise += uniform(8, 12 * (uint64_t)i + k);
    xyz[3 * i] = 0.002 * (i % 100), xyz[3 * i + 1] = 10 + 0.0016 * noise,
            xyz[3 * i + 2] = 0.002 * (double)(i / 100);
    intensity[i] = (float)(100 + i % 3);
    squares += noise * noise;
  }
  jalon_cloud* cloud = cloud_of(xyz, 7500);
  jalon_fields* sample = NULL;
  MUST(jalon_cloud_set_field(cloud, "intensity", intensity, JALON_FLOAT32, 1, 7500, 0, NULL, NULL));
  MUST(jalon_cloud_range_precision(cloud, NULL, 0, NULL, &sample));
  assert_true(value(sample, "points", 0) == 7500);
  assert_true(fabs(value(sample, "range_precision", 0) - 0.0016 * sqrt(squares / 7499)) < 2e-6);
  assert_true(fabs(value(sample, "mean_intensity", 0) - 101) < 1e-9);
  jalon_fields_release(sample);
  const uint64_t two[2] = {0, 1}, wrong[3] = {0, 1, 7500};
  REFUSED(JALON_ERROR_INSUFFICIENT_DATA, jalon_cloud_range_precision(cloud, two, 2, NULL, &sample));
  REFUSED(JALON_ERROR_INVALID_ARGUMENT,
          jalon_cloud_range_precision(cloud, wrong, 3, NULL, &sample));
  jalon_cloud_release(cloud);
}

static void phases__give_the_range(void** state) {
  (void)state;
  const double wavelengths[3] = {10.003, 9.978, 9.527}, range = 73.2345;
  double remainders[3], found = 0;
  for (int i = 0; i < 3; ++i) remainders[i] = fmod(2 * range, wavelengths[i]);
  MUST(jalon_phase_range(wavelengths, remainders, 3, &found));
  assert_true(fabs(found - range) < 1e-9);
  REFUSED(JALON_ERROR_INVALID_ARGUMENT, jalon_phase_range(wavelengths, wavelengths + 1, 2, NULL));
}

int main(void) {
  const struct CMUnitTest tests[] = {
      cmocka_unit_test(budget__of_a_trimble_gx_is_11_6_mm_at_100_m),
      cmocka_unit_test(cloud__gets_covariances_seen_from_its_station),
      cmocka_unit_test(planes__are_adjusted_with_their_points_covariances),
      cmocka_unit_test(baseline__gives_back_its_additive_constant),
      cmocka_unit_test(sample__tells_range_precision_and_intensity),
      cmocka_unit_test(phases__give_the_range),
  };
  return cmocka_run_group_tests(tests, NULL, NULL);
}

/* SPDX-FileCopyrightText: 2026 The Jalon authors
 * SPDX-License-Identifier: Apache-2.0 */
#include <jalon/jalon.h>
#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

#define OK(call) assert_int_equal((call), JALON_OK)

static double value(jalon_fields* fields, const char* name) {
  double out = NAN;
  OK(jalon_fields_copy(fields, name, JALON_FLOAT64, &out, 1));
  return out;
}

/* scipy.stats.shapiro 1.17.1; skew and kurtosis with bias=False. */
static void normality__of_a_known_sample__is_that_of_scipy(void** state) {
  (void)state;
  const double sample[11] = {148, 154, 158, 160, 161, 162, 166, 170, 182, 195, 236};
  jalon_fields* report = NULL;
  OK(jalon_normality(sample, 11, NULL, &report));
  assert_true(fabs(value(report, "W") - 0.7888146) < 1e-6);
  assert_true(fabs(value(report, "p") - 0.0067038) < 1e-6);
  assert_true(value(report, "is_normal") == 0 && value(report, "tested") == 11);
  assert_true(fabs(value(report, "mean") - 172) < 1e-12 && value(report, "median") == 162);
  assert_true(value(report, "range") == 88 && value(report, "quartile_range") == 17);
  assert_true(fabs(value(report, "standard_deviation") - 24.9519538) < 1e-6);
  jalon_fields_release(report);
}

static void normality__of_a_field__leaves_out_what_is_not_finite(void** state) {
  (void)state;
  enum { kPoints = 40 };
  double xyz[3 * kPoints] = {0}, values[kPoints];
  for (int i = 0; i < kPoints; ++i) xyz[3 * i] = i, values[i] = i * i;
  values[7] = NAN;
  jalon_cloud* cloud = NULL;
  OK(jalon_cloud_create(xyz, JALON_FLOAT64, kPoints, 0, 0, &cloud));
  OK(jalon_cloud_set_field(cloud, "deviation", values, JALON_FLOAT64, 1, kPoints, 0, "m", NULL));
  jalon_fields* report = NULL;
  OK(jalon_cloud_field_normality(cloud, "deviation", NULL, NULL, &report));
  assert_true(value(report, "values") == kPoints - 1);
  assert_true(value(report, "p") < 0.05 && value(report, "is_normal") == 0);
  jalon_fields_release(report);
  report = NULL;
  assert_int_equal(jalon_cloud_field_normality(cloud, "none", NULL, NULL, &report),
                   JALON_ERROR_NOT_FOUND);
  for (int i = 0; i < kPoints; ++i) values[i] = 3;
  assert_int_equal(jalon_normality(values, kPoints, NULL, &report), JALON_ERROR_DEGENERATE);
  assert_int_equal(jalon_normality(values, 2, NULL, &report), JALON_ERROR_INSUFFICIENT_DATA);
  assert_null(report);
  jalon_cloud_release(cloud);
}

int main(void) {
  const struct CMUnitTest tests[] = {
      cmocka_unit_test(normality__of_a_known_sample__is_that_of_scipy),
      cmocka_unit_test(normality__of_a_field__leaves_out_what_is_not_finite),
  };
  return cmocka_run_group_tests_name("field_tools_normality", tests, NULL, NULL);
}

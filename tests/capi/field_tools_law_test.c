/* SPDX-FileCopyrightText: 2026 The Jalon authors
 * SPDX-License-Identifier: Apache-2.0 */
/* Noise laws against their closed forms and the samples they were drawn from; the histogram against a recount. */
#include "lifted_square.h"

enum { kSample = 9000 };
static const double kPi = 3.14159265358979323846;

/* Normal values (Box & Muller 1958) of mean 2 mm and sigma 5 mm; the first few are missing. */
static void normal_sample(double* values, uint64_t missing) {
  for (uint64_t i = 0; i < kSample; ++i) {
    const double u = 1 - uniform(41, 2 * i), angle = 2 * kPi * uniform(41, 2 * i + 1);
    values[i] = i < missing ? NAN : 0.002 + 0.005 * sqrt(-2 * log(u)) * cos(angle);
  }
}

static jalon_cloud* cloud_with(const double* values, uint64_t n) {
  static double xyz[3 * kSample];
  jalon_cloud* cloud = cloud_of(xyz, n);
  MUST(jalon_cloud_set_field(cloud, "d", values, JALON_FLOAT64, 1, n, 0, "m", NULL));
  return cloud;
}

static jalon_noise_law* law_from(const char* json) {
  jalon_noise_law* law = NULL;
  MUST(jalon_noise_law_from_json(json, &law));
  return law;
}

static void law__evaluates_to_its_closed_form_and_quantiles_invert_it(void** state) {
  (void)state;
  const struct {
    const char* json;
    double a, b, x0; /* of Weibull; a = 0: normal with mean x0 and sigma b */
  } laws[] = {
      {"{\"law\": \"weibull\", \"shape\": 2, \"scale\": 0.005, \"shift\": 0}", 2, 0.005, 0},
      {"{\"law\": \"weibull\", \"shape\": 1.3, \"scale\": 0.4, \"shift\": 0.1}", 1.3, 0.4, 0.1},
      {"{\"law\": \"gauss\", \"mean\": 0.01, \"sigma\": 0.003}", 0, 0.003, 0.01}};
  for (int k = 0; k < 3; ++k) {
    jalon_noise_law* law = law_from(laws[k].json);
    double x[20], density[20], cumulative[20], back[20];
    for (int i = 0; i < 20; ++i)
      x[i] = laws[k].x0 + laws[k].b * (laws[k].a > 0 ? 0.1 * (i + 1) : 0.3 * (i - 9.5));
    MUST(jalon_noise_law_evaluate(law, x, 20, density, cumulative));
    MUST(jalon_noise_law_quantiles(law, cumulative, 20, back));
    for (int i = 0; i < 20; ++i) {
      const double t = (x[i] - laws[k].x0) / laws[k].b, a = laws[k].a;
      const double f = a > 0 ? a / laws[k].b * pow(t, a - 1) * exp(-pow(t, a))
                             : exp(-t * t / 2) / (laws[k].b * sqrt(2 * kPi));
      const double p = a > 0 ? 1 - exp(-pow(t, a)) : 0.5 * erfc(-t / sqrt(2));
      assert_true(fabs(density[i] - f) < 1e-12 * f);
      assert_true(fabs(cumulative[i] - p) < 1e-14);
      /* A probability of an ulp more moves the quantile by that over the density. */
      assert_true(fabs(back[i] - x[i]) < 1e-12 * laws[k].b + 1e-14 / f);
    }
    const double outside[3] = {-0.001, 1.001, NAN};
    MUST(jalon_noise_law_quantiles(law, outside, 3, back));
    for (int i = 0; i < 3; ++i) assert_true(isnan(back[i]));
    MUST(jalon_noise_law_evaluate(law, x, 20, NULL, NULL));
    MUST(jalon_noise_law_evaluate(law, NULL, 0, density, NULL));
    MUST(jalon_noise_law_quantiles(law, NULL, 0, NULL));
    REFUSED(JALON_ERROR_INVALID_ARGUMENT, jalon_noise_law_evaluate(law, NULL, 1, density, NULL));
    expect_message("values is NULL");
    jalon_noise_law_release(law);
  }
}

static void law__of_a_sample_is_the_one_it_was_drawn_from(void** state) {
  (void)state;
  static double values[kSample];
  normal_sample(values, 1000);
  jalon_cloud* cloud = cloud_with(values, kSample);
  jalon_params* options = options_of("noise_law", "{\"law\": \"gauss\"}");
  jalon_noise_law *law = NULL, *again = NULL;
  jalon_fields *table = NULL, *copy = NULL;
  MUST(jalon_noise_law_fit(cloud, "d", options, NULL, &law));
  MUST(jalon_noise_law_table(law, &table));
  const double n = kSample - 1000;
  assert_int_equal(cell_of(table, "samples", 0, 0), (int)n);
  /* Four standard deviations of mean and sigma of n values. */
  assert_true(fabs(cell_of(table, "mean", 0, 0) - 0.002) < 4 * 0.005 / sqrt(n));
  assert_true(fabs(cell_of(table, "standard_deviation", 0, 0) - 0.005) < 4 * 0.005 / sqrt(2 * n));
  assert_true(isnan(cell_of(table, "shape", 0, 0)));
  const char* json = NULL;
  MUST(jalon_noise_law_json(law, &json));
  again = law_from(json);
  MUST(jalon_noise_law_table(again, &copy));
  const char* const names[] = {"mean", "standard_deviation", "samples", "chi_square", "classes"};
  for (int k = 0; k < 5; ++k)
    assert_true(cell_of(copy, names[k], 0, 0) == cell_of(table, names[k], 0, 0));
  jalon_noise_law* kept = jalon_noise_law_retain(again);
  jalon_noise_law_release(again);
  MUST(jalon_noise_law_json(kept, &json));
  jalon_noise_law_release(kept), jalon_noise_law_release(law);
  jalon_fields_release(table), jalon_fields_release(copy);
  jalon_params_release(options);
  jalon_cloud_release(cloud);
}

static void law__without_enough_to_go_by_is_refused(void** state) {
  (void)state;
  const double few[8] = {1, 2, 3, 4, 5, 6, 7, 8}, same[12] = {2, 2, 2, 2, 2, 2, 2, 2, 2, 2, 2, 2};
  jalon_cloud *short_one = cloud_with(few, 8), *even = cloud_with(same, 12);
  jalon_noise_law* law = NULL;
  REFUSED(JALON_ERROR_INSUFFICIENT_DATA, jalon_noise_law_fit(short_one, "d", NULL, NULL, &law));
  REFUSED(JALON_ERROR_DEGENERATE, jalon_noise_law_fit(even, "d", NULL, NULL, &law));
  REFUSED(JALON_ERROR_NOT_FOUND, jalon_noise_law_fit(even, "e", NULL, NULL, &law));
  const char* const texts[] = {
      "",    "{", "[]", "{\"law\": \"cauchy\"}", "{\"law\": \"gauss\", \"mean\": 0, \"sigma\": -1}",
      "\xff"};
  for (size_t i = 0; i < sizeof texts / sizeof *texts; ++i)
    REFUSED(JALON_ERROR_INVALID_ARGUMENT, jalon_noise_law_from_json(texts[i], &law));
  REFUSED(JALON_ERROR_INVALID_ARGUMENT, jalon_noise_law_from_json(NULL, &law));
  assert_null(law);
  jalon_cloud_release(short_one), jalon_cloud_release(even);
}

static void histogram__counts_as_a_recount_does(void** state) {
  (void)state;
  static double values[kSample];
  normal_sample(values, 123);
  jalon_cloud* cloud = cloud_with(values, kSample);
  jalon_params* options =
      options_of("histogram", "{\"bins\": 8, \"minimum\": -0.008, \"maximum\": 0.008}");
  jalon_fields *bins = NULL, *summary = NULL;
  MUST(jalon_cloud_field_histogram(cloud, "d", NULL, options, NULL, &bins, &summary));
  assert_int_equal(rows_of(bins, "count"), 8);
  uint64_t below = 0, above = 0;
  for (uint64_t i = 123; i < kSample; ++i) below += values[i]<-0.008, above += values[i]> 0.008;
  assert_int_equal(cell_of(summary, "missing", 0, 0), 123);
  assert_int_equal(cell_of(summary, "values", 0, 0), kSample - 123);
  assert_int_equal(cell_of(summary, "below", 0, 0), below);
  assert_int_equal(cell_of(summary, "above", 0, 0), above);
  for (uint64_t k = 0; k < 8; ++k) {
    const double from = cell_of(bins, "from", k, 0), to = cell_of(bins, "to", k, 0);
    uint64_t count = 0;
    assert_true(fabs(from + 0.008 - 0.002 * (double)k) < 1e-15 && fabs(to - from - 0.002) < 1e-15);
    for (uint64_t i = 123; i < kSample; ++i) count += values[i] >= from && values[i] < to;
    assert_int_equal(cell_of(bins, "count", k, 0), count);
  }
  jalon_array_view view;
  REFUSED(JALON_ERROR_NOT_FOUND, jalon_fields_view(bins, "expected", &view)); /* without a law */
  jalon_fields_release(bins), jalon_fields_release(summary);
  jalon_noise_law* law = law_from("{\"law\": \"gauss\", \"mean\": 0.002, \"sigma\": 0.005}");
  MUST(jalon_cloud_field_histogram(cloud, "d", law, options, NULL, &bins, NULL));
  for (uint64_t k = 0; k < 8; ++k) { /* five sigmas of a count */
    const double expected = cell_of(bins, "expected", k, 0);
    assert_true(fabs(cell_of(bins, "count", k, 0) - expected) < 5 * sqrt(expected));
  }
  MUST(jalon_cloud_field_histogram(cloud, "d", NULL, NULL, NULL, NULL, NULL));
  jalon_fields_release(bins);
  jalon_noise_law_release(law);
  jalon_params_release(options);
  jalon_cloud_release(cloud);
}

int main(void) {
  const struct CMUnitTest tests[] = {
      cmocka_unit_test(law__evaluates_to_its_closed_form_and_quantiles_invert_it),
      cmocka_unit_test(law__of_a_sample_is_the_one_it_was_drawn_from),
      cmocka_unit_test(law__without_enough_to_go_by_is_refused),
      cmocka_unit_test(histogram__counts_as_a_recount_does),
  };
  return cmocka_run_group_tests(tests, NULL, NULL);
}

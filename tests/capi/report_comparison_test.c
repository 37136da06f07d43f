/* SPDX-FileCopyrightText: 2026 The Jalon authors
 * SPDX-License-Identifier: Apache-2.0 */
/* Pictures, histograms and pages of the comparison with a lifted square, whose distances are known. */
#include "lifted_square.h"

static char report_path[512];

static const char* report_at(const char* name) {
  snprintf(report_path, sizeof report_path, "%s", temporary(name));
  return report_path;
}

static char* report_text(void) {
  char* text = content_of(report_path, NULL);
  assert_non_null(text);
  remove(report_path);
  return text;
}

static void expect_text(const char* text, const char* part, int there) {
  if ((strstr(text, part) != NULL) != there)
    fail_msg("\"%s\" is %s the report", part, there ? "not in" : "in");
}

static void deviations__have_the_scale_view_and_title_of_the_options(void** state) {
  (void)state;
  jalon_comparison* comparison = lifted_comparison();
  jalon_params* options =
      options_of("deviation_picture", "{\"limit_m\": 0.4, \"view\": \"side\", \"title\": \"<S>\"}");
  MUST(jalon_report_write_deviations(comparison, report_at("d.svg"), options, NULL));
  char* text = report_text();
  const char* const told[] = {"<svg", "&lt;S&gt;", ">Y (m)<", ">Z (m)<", ">400<", ">0<"};
  for (size_t i = 0; i < sizeof told / sizeof *told; ++i) expect_text(text, told[i], 1);
  expect_text(text, ">X (m)<", 0);
  free(text);
  MUST(jalon_report_write_deviations(comparison, report_at("d.svg"), NULL, NULL));
  text =
      report_text(); /* seen from above; more than 98 % lie within 0.5 m, which no 1, 2, 5 below holds */
  expect_text(text, ">X (m)<", 1);
  expect_text(text, ">Y (m)<", 1);
  expect_text(text, ">500<", 1);
  free(text);
  jalon_params_release(options);
  jalon_comparison_release(comparison);
}

static void histogram__marks_the_threshold_that_the_options_tell(void** state) {
  (void)state;
  jalon_comparison* comparison = lifted_comparison();
  jalon_params* options = options_of("comparison_report", "{\"threshold_m\": 0.125}");
  MUST(jalon_report_write_histogram(comparison, report_at("h.svg"), options, NULL));
  char* text = report_text();
  expect_text(text, "<svg", 1);
  expect_text(text, "threshold 125.0 mm", 1);
  free(text);
  MUST(jalon_report_write_histogram(comparison, report_at("h.svg"), NULL, NULL));
  text = report_text();
  expect_text(text, "threshold", 0);
  free(text);
  jalon_params_release(options);
  jalon_comparison_release(comparison);
}

static void page__has_what_was_given_and_no_more(void** state) {
  (void)state;
  jalon_cloud *before = floor_cloud(0), *after = floor_cloud(1);
  jalon_comparison *forward = compared_by("distance", before, after),
                   *reverse = compared_by("distance", after, before);
  jalon_params *options = options_of("comparison_report", "{\"picture\": false}"),
               *found =
                   options_of("regions", "{\"criterion\": \"threshold\", \"threshold_m\": 0.1}");
  jalon_fields* regions = NULL;
  MUST(jalon_comparison_regions(forward, found, NULL, NULL, &regions));
  MUST(
      jalon_report_write_comparison(forward, NULL, NULL, NULL, report_at("p.html"), options, NULL));
  char* text = report_text();
  expect_text(text, ">1 681<", 1); /* the points */
  const char* const optional[] = {"reference with the compared", "Change regions", "<image",
                                  "a&amp;b.las"};
  for (size_t i = 0; i < 4; ++i) expect_text(text, optional[i], 0);
  free(text);
  MUST(jalon_report_write_comparison(forward, reverse, regions,
                                     "{\"input\": {\"file\": \"a&b.las\"}}", report_at("p.html"),
                                     NULL, NULL));
  text = report_text();
  for (size_t i = 0; i < 4; ++i) expect_text(text, optional[i], 1);
  expect_text(text, ">289<", 1);    /* points of the region */
  expect_text(text, ">250.00<", 1); /* their mean, mm */
  free(text);
  jalon_fields_release(regions);
  jalon_params_release(options), jalon_params_release(found);
  jalon_comparison_release(forward), jalon_comparison_release(reverse);
  jalon_cloud_release(before), jalon_cloud_release(after);
}

static void reports__refuse_wrong_arguments_and_write_no_file(void** state) {
  (void)state;
  jalon_comparison* comparison = lifted_comparison();
  jalon_params *picture = options_of("deviation_picture", "{}"),
               *page = options_of("comparison_report", "{}");
  const char* path = report_at("none.svg");
  const jalon_status wrong = JALON_ERROR_INVALID_ARGUMENT;
  REFUSED(wrong, jalon_report_write_deviations(NULL, path, NULL, NULL));
  expect_message("comparison is NULL");
  REFUSED(wrong, jalon_report_write_deviations(comparison, path, page, NULL));
  REFUSED(wrong, jalon_report_write_histogram(comparison, path, picture, NULL));
  REFUSED(wrong, jalon_report_write_histogram(comparison, NULL, NULL, NULL));
  expect_message("path is NULL");
  REFUSED(wrong, jalon_report_write_comparison(NULL, comparison, NULL, NULL, path, NULL, NULL));
  expect_message("forward is NULL");
  REFUSED(wrong, jalon_report_write_comparison(comparison, NULL, NULL, "[]", path, NULL, NULL));
  assert_null(content_of(path, NULL));
  jalon_params_release(picture), jalon_params_release(page);
  jalon_comparison_release(comparison);
}

int main(void) {
  const struct CMUnitTest tests[] = {
      cmocka_unit_test(deviations__have_the_scale_view_and_title_of_the_options),
      cmocka_unit_test(histogram__marks_the_threshold_that_the_options_tell),
      cmocka_unit_test(page__has_what_was_given_and_no_more),
      cmocka_unit_test(reports__refuse_wrong_arguments_and_write_no_file),
  };
  return cmocka_run_group_tests(tests, NULL, NULL);
}

/* SPDX-FileCopyrightText: 2026 The Jalon authors
 * SPDX-License-Identifier: Apache-2.0 */
#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <string.h>

#include <cmocka.h>

#include "jalon/jalon.h"

static const char kNails[] = "id x y z sx sy sz\nA 0 0 0 0 0 0\nB 0 50 0 0 0 0\n";
static const char kSights[] =
    "from to direction zenith distance code\nA B 0 100 50 -\nA C 50 100 30 350\n"
    "B C 159.57 100 35.76 350\nB A 200 100 50 -\n";

static jalon_network* adjusted(void) {
  jalon_network* network = NULL;
  assert_int_equal(jalon_network_adjust(kSights, kNails, NULL, NULL, &network), JALON_OK);
  return network;
}

static const double* column(jalon_fields* table, const char* name, uint64_t rows) {
  jalon_array_view view;
  assert_int_equal(jalon_fields_view(table, name, &view), JALON_OK);
  assert_int_equal(view.count, rows);
  return (const double*)view.data;
}

static void network__tells_points_observations_and_codes(void** state) {
  (void)state;
  jalon_network* network = adjusted();
  jalon_fields *points = NULL, *observations = NULL, *summary = NULL;
  assert_int_equal(jalon_network_points(network, &points), JALON_OK);
  assert_int_equal(jalon_network_observations(network, &observations), JALON_OK);
  assert_int_equal(jalon_network_summary(network, &summary), JALON_OK);
  const double* xyz = column(points, "xyz", 3);
  assert_true(fabs(xyz[6] - 30 * sin(0.25 * 3.14159265358979)) < 0.1);
  const double* sigma = column(points, "sigma", 3);
  assert_true(sigma[0] == 0 && sigma[6] > 0);
  const char *name = NULL, *codes = NULL, *parameters = NULL;
  assert_int_equal(jalon_network_point_name(network, 2, &name), JALON_OK);
  assert_string_equal(name, "C");
  assert_int_equal(jalon_network_point_name(network, 3, &name), JALON_ERROR_INVALID_ARGUMENT);
  assert_int_equal(jalon_network_codes(network, &codes), JALON_OK);
  assert_true(strncmp(codes, "C;", 2) == 0 && strstr(codes, ";350\n") != NULL);
  assert_int_equal(jalon_network_parameters(network, &parameters), JALON_OK);
  assert_non_null(strstr(parameters, "\"datum\""));
  jalon_network_release(network);
  assert_true(isfinite(column(observations, "residual", 18)[0])); /* a table outlives its network */
  jalon_fields_release(points);
  jalon_fields_release(observations);
  jalon_fields_release(summary);
}

static void network__its_report_is_a_page_or_a_plan(void** state) {
  static const char* const paths[] = {"network_report.html", "network_report.svg"};
  static const char* const begins[] = {"<!DOCTYPE html>", "<svg"};
  jalon_network* network = adjusted();
  (void)state;
  for (int i = 0; i < 2; ++i) {
    static char text[1 << 20];
    FILE* file;
    assert_int_equal(jalon_report_write_network(network, NULL, paths[i], NULL), JALON_OK);
    file = fopen(paths[i], "rb");
    assert_non_null(file);
    text[fread(text, 1, sizeof text - 1, file)] = 0;
    fclose(file);
    remove(paths[i]);
    assert_non_null(strstr(text, begins[i]));
    assert_non_null(strstr(text, "3 points"));
  }
  assert_int_equal(jalon_report_write_network(network, NULL, NULL, NULL),
                   JALON_ERROR_INVALID_ARGUMENT);
  jalon_network_release(network);
}

static void network__says_what_is_wrong_and_writes_nothing(void** state) {
  (void)state;
  jalon_network* network = NULL;
  assert_int_equal(jalon_network_adjust("from to way\nA B 1\n", kNails, NULL, NULL, &network),
                   JALON_ERROR_FORMAT);
  assert_non_null(strstr(jalon_last_error_message(), "way"));
  assert_int_equal(jalon_network_adjust(kSights, NULL, NULL, NULL, &network),
                   JALON_ERROR_DEGENERATE);
  assert_int_equal(jalon_network_adjust("from to distance\n", kNails, NULL, NULL, &network),
                   JALON_ERROR_INSUFFICIENT_DATA);
  assert_null(network);
}

static void network__a_free_one_needs_no_points(void** state) {
  (void)state;
  jalon_params* options = NULL;
  assert_int_equal(jalon_params_create("network", &options), JALON_OK);
  assert_int_equal(jalon_params_set_string(options, "datum", "free"), JALON_OK);
  jalon_network* network = NULL;
  assert_int_equal(jalon_network_adjust(kSights, NULL, options, NULL, &network), JALON_OK);
  jalon_network* other = jalon_network_retain(network);
  jalon_network_release(network);
  jalon_network_release(other);
  jalon_params_release(options);
}

int main(void) {
  const struct CMUnitTest tests[] = {
      cmocka_unit_test(network__tells_points_observations_and_codes),
      cmocka_unit_test(network__its_report_is_a_page_or_a_plan),
      cmocka_unit_test(network__says_what_is_wrong_and_writes_nothing),
      cmocka_unit_test(network__a_free_one_needs_no_points),
  };
  return cmocka_run_group_tests(tests, NULL, NULL);
}

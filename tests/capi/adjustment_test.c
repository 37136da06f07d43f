/* SPDX-FileCopyrightText: 2026 The Jalon authors
 * SPDX-License-Identifier: Apache-2.0 */
#include <jalon/jalon.h>
#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

#include <cmocka.h>

#define OK(call) assert_int_equal((call), JALON_OK)
#define INVALID(call) assert_int_equal((call), JALON_ERROR_INVALID_ARGUMENT)

#include "drive.h"

static double* column(jalon_fields* fields, const char* name, uint64_t* elements) {
  jalon_array_view view;
  OK(jalon_fields_view(fields, name, &view));
  *elements = view.count * view.components;
  double* values = malloc((size_t)(*elements + 1) * sizeof(double));
  assert_non_null(values);
  OK(jalon_fields_copy(fields, name, JALON_FLOAT64, values, *elements));
  return values;
}

static double value(const jalon_adjustment* made, const char* name) {
  jalon_fields* summary = NULL;
  uint64_t n = 0;
  OK(jalon_adjustment_summary(made, &summary));
  double* all = column(summary, name, &n);
  const double first = all[0];
  free(all);
  jalon_fields_release(summary);
  return first;
}

/* Root mean square of the positions of a trajectory off the true one. */
static double off(jalon_trajectory* trajectory, jalon_trajectory* truth) {
  jalon_fields *a = NULL, *b = NULL;
  uint64_t n = 0;
  OK(jalon_trajectory_epochs(trajectory, &a));
  OK(jalon_trajectory_epochs(truth, &b));
  double *p = column(a, "xyz", &n), *q = column(b, "xyz", &n), sum = 0;
  for (uint64_t i = 0; i < n; ++i) sum += (p[i] - q[i]) * (p[i] - q[i]);
  free(p);
  free(q);
  jalon_fields_release(a);
  jalon_fields_release(b);
  return sqrt(sum / (double)n);
}

/* A sure model and a drive that is 2 m off: the drive is located to centimetres. */
static void adjusted__by_a_sure_model__is_located(void** state) {
  (void)state;
  Drive drive = drive_of(1);
  jalon_params* options = NULL;
  OK(jalon_params_create("adjust", &options));
  const char* sigmas[] = {"sigma_block_x_m", "sigma_block_y_m", "sigma_facade_m", "sigma_strip_m"};
  for (int i = 0; i < 4; ++i) OK(jalon_params_set_double(options, sigmas[i], 0.01));
  jalon_adjustment* made = NULL;
  OK(jalon_trajectory_adjust(drive.trajectory, drive.cloud, drive.model, options, NULL, &made));
  jalon_trajectory* located = NULL;
  OK(jalon_adjustment_trajectory(made, &located));
  assert_true(off(drive.trajectory, drive.true_trajectory) > 0.5);
  assert_true(off(located, drive.true_trajectory) < 0.05);
  assert_true(value(made, "converged") == 1);
  assert_true(value(made, "p_value") > 1e-3);
  assert_true(value(made, "wrong_facades") < 0.02);
  jalon_trajectory_release(located);
  jalon_adjustment_release(made);
  jalon_params_release(options);
  release_drive(&drive);
}

/* The adjusted cloud follows the adjusted trajectory: its points move as the corrections at their times say. */
static void adjusted_cloud__follows_the_corrections(void** state) {
  (void)state;
  Drive drive = drive_of(5);
  jalon_adjustment* made = NULL;
  OK(jalon_trajectory_adjust(drive.trajectory, drive.cloud, drive.model, NULL, NULL, &made));
  jalon_cloud* cloud = NULL;
  OK(jalon_adjustment_apply(made, drive.cloud, NULL, &cloud));
  jalon_fields *controls = NULL, *before = NULL, *after = NULL;
  OK(jalon_adjustment_controls(made, &controls));
  OK(jalon_cloud_fields(drive.cloud, &before));
  OK(jalon_cloud_fields(cloud, &after));
  uint64_t n = 0, steps = 0;
  double *times = column(before, "time", &n), *t = column(controls, "time", &steps);
  double* by = column(controls, "correction", &steps);
  double *was = column(before, "beam_origin", &n), *is = column(after, "beam_origin", &n);
  for (uint64_t i = 0; i < n / 3; i += 97) {
    uint64_t c = 0;
    while (c + 2 < steps / 2 && t[c + 1] <= times[i]) ++c;
    const double share = (times[i] - t[c]) / (t[c + 1] - t[c]);
    for (int k = 0; k < 2; ++k) {
      const double expected = by[2 * c + k] * (1 - share) + by[2 * c + 2 + k] * share;
      assert_true(fabs(is[3 * i + k] - was[3 * i + k] - expected) < 1e-9);
    }
    assert_true(is[3 * i + 2] == was[3 * i + 2]);
  }
  double* all[] = {times, t, by, was, is};
  for (int i = 0; i < 5; ++i) free(all[i]);
  jalon_fields_release(controls);
  jalon_fields_release(before);
  jalon_fields_release(after);
  jalon_cloud_release(cloud);
  jalon_adjustment_release(made);
  release_drive(&drive);
}

/* Three places that the map knows hold a drive whose model is as unsure as itself. */
static void adjusted__by_control_points__is_nearer_and_no_wall_stands_before_its_eaves(
    void** state) {
  (void)state;
  Drive drive = drive_of(5);
  jalon_fields *given = NULL, *truth = NULL;
  OK(jalon_trajectory_epochs(drive.trajectory, &given));
  OK(jalon_trajectory_epochs(drive.true_trajectory, &truth));
  uint64_t n = 0, count = 0;
  double *t = column(given, "time", &count), *p = column(given, "xyz", &n),
         *q = column(truth, "xyz", &n), points[18];
  for (uint64_t i = 0; i < 3; ++i) {
    const uint64_t e = (2 * i + 1) * count / 6;
    const double six[] = {t[e], p[3 * e], p[3 * e + 1], q[3 * e], q[3 * e + 1], 0.01};
    memcpy(points + 6 * i, six, sizeof six);
  }
  jalon_params* options = NULL;
  OK(jalon_params_create("adjust", &options));
  jalon_adjustment *free_drive = NULL, *held = NULL, *none = NULL;
  OK(jalon_trajectory_adjust(drive.trajectory, drive.cloud, drive.model, NULL, NULL, &free_drive));
  OK(jalon_params_set_doubles(options, "control_points", points, 18));
  OK(jalon_params_set_string(options, "set_back", "behind"));
  OK(jalon_params_set_double(options, "strip_correlation_m", 3));
  OK(jalon_trajectory_adjust(drive.trajectory, drive.cloud, drive.model, options, NULL, &held));
  jalon_trajectory *before = NULL, *after = NULL;
  OK(jalon_adjustment_trajectory(free_drive, &before));
  OK(jalon_adjustment_trajectory(held, &after));
  assert_true(off(after, drive.true_trajectory) < 0.05);
  assert_true(off(after, drive.true_trajectory) < off(before, drive.true_trajectory));
  jalon_fields* facades = NULL;
  OK(jalon_adjustment_facades(held, &facades));
  double* offsets = column(facades, "offset", &n);
  for (uint64_t f = 0; f < n; ++f) assert_true(offsets[f] <= 1e-9);
  OK(jalon_params_set_doubles(options, "control_points", points, 17));
  INVALID(
      jalon_trajectory_adjust(drive.trajectory, drive.cloud, drive.model, options, NULL, &none));
  assert_non_null(strstr(jalon_last_error_message(), "17 numbers"));
  assert_null(none);
  double* all[] = {t, p, q, offsets};
  for (int i = 0; i < 4; ++i) free(all[i]);
  jalon_fields_release(given);
  jalon_fields_release(truth);
  jalon_fields_release(facades);
  jalon_trajectory_release(before);
  jalon_trajectory_release(after);
  jalon_adjustment_release(free_drive);
  jalon_adjustment_release(held);
  jalon_params_release(options);
  release_drive(&drive);
}

/* Attitudes that may be off by a constant: it is told with its sigmas, has rows of the covariance, turns the drive. */
static void adjusted__with_attitude_biases__tells_them(void** state) {
  (void)state;
  Drive drive = drive_of(1);
  jalon_params* options = NULL;
  OK(jalon_params_create("adjust", &options));
  OK(jalon_params_set_double(options, "sigma_heading_bias_rad", 0.01));
  OK(jalon_params_set_bool(options, "covariance", 1));
  jalon_adjustment* made = NULL;
  OK(jalon_trajectory_adjust(drive.trajectory, drive.cloud, drive.model, options, NULL, &made));
  jalon_fields *summary = NULL, *covariance = NULL, *given = NULL, *turned = NULL;
  jalon_trajectory* after = NULL;
  OK(jalon_adjustment_summary(made, &summary));
  OK(jalon_adjustment_covariance(made, &covariance));
  OK(jalon_adjustment_trajectory(made, &after));
  OK(jalon_trajectory_epochs(drive.trajectory, &given));
  OK(jalon_trajectory_epochs(after, &turned));
  uint64_t n = 0, rows = 0, all = 0;
  double *bias = column(summary, "attitude_bias", &n),
         *sigma = column(summary, "attitude_bias_sigma", &n),
         *group = column(covariance, "group", &rows), *axis = column(covariance, "axis", &rows),
         *with_each = column(covariance, "covariance", &all), *was = column(given, "attitude", &n),
         *is = column(turned, "attitude", &n);
  assert_true(bias[0] == 0 && bias[1] == 0 && bias[2] != 0);
  assert_true(sigma[0] == 0 && sigma[2] > 0 && sigma[2] <= 0.01);
  assert_true(group[rows - 3] == 2 && group[rows - 4] == 1 && axis[rows - 1] == 2);
  assert_true(fabs(sqrt(with_each[all - 1]) - sigma[2]) < 1e-9);
  /* A level vehicle turns by its heading alone. */
  assert_true(fabs(is[2] - was[2] - bias[2]) < 1e-9);
  double* lists[] = {bias, sigma, group, axis, with_each, was, is};
  for (int i = 0; i < 7; ++i) free(lists[i]);
  jalon_fields_release(summary);
  jalon_fields_release(covariance);
  jalon_fields_release(given);
  jalon_fields_release(turned);
  jalon_trajectory_release(after);
  jalon_adjustment_release(made);
  jalon_params_release(options);
  release_drive(&drive);
}

/* Of everything: facades and the strips that were adjusted stand behind what stands there else. */
static void adjusted__with_the_covariance_of_all__has_rows_of_facades_and_strips(void** state) {
  (void)state;
  Drive drive = drive_of(5);
  jalon_params* options = NULL;
  jalon_adjustment *places = NULL, *whole = NULL;
  jalon_fields *of_places = NULL, *of_all = NULL, *strips = NULL;
  OK(jalon_params_create("adjust", &options));
  OK(jalon_params_set_bool(options, "covariance", 1));
  OK(jalon_trajectory_adjust(drive.trajectory, drive.cloud, drive.model, options, NULL, &places));
  OK(jalon_params_set_string(options, "covariance_of", "all"));
  OK(jalon_trajectory_adjust(drive.trajectory, drive.cloud, drive.model, options, NULL, &whole));
  OK(jalon_adjustment_covariance(places, &of_places));
  OK(jalon_adjustment_covariance(whole, &of_all));
  OK(jalon_adjustment_strips(whole, &strips));
  uint64_t few = 0, rows = 0, all = 0, n = 0;
  double *before = column(of_places, "group", &few), *part = column(of_places, "covariance", &n),
         *group = column(of_all, "group", &rows), *number = column(of_all, "number", &n),
         *covariance = column(of_all, "covariance", &all), *sigma = column(strips, "sigma", &n);
  assert_true(rows > few && all == rows * rows);
  assert_true(group[few] == 3 && group[rows - 1] == 4);
  for (uint64_t i = 0; i < rows; ++i) {
    if (i < few) assert_true(fabs(covariance[i * rows] - part[i * few]) < 1e-12);
    if (group[i] == 4)
      assert_true(fabs(sqrt(covariance[i * rows + i]) - sigma[(uint64_t)number[i]]) < 1e-9);
  }
  double* lists[] = {before, part, group, number, covariance, sigma};
  for (int i = 0; i < 6; ++i) free(lists[i]);
  jalon_fields_release(of_places);
  jalon_fields_release(of_all);
  jalon_fields_release(strips);
  jalon_adjustment_release(places);
  jalon_adjustment_release(whole);
  jalon_params_release(options);
  release_drive(&drive);
}

static void adjust__of_impossible_input__names_what_is_wrong(void** state) {
  (void)state;
  Drive drive = drive_of(5);
  jalon_adjustment* made = NULL;
  jalon_model* house = NULL;
  OK(jalon_scene_street_drive(NULL, &house, NULL));
  INVALID(jalon_trajectory_adjust(drive.trajectory, drive.cloud, house, NULL, NULL, &made));
  assert_non_null(strstr(jalon_last_error_message(), "no strips"));
  OK(jalon_cloud_set_crs(drive.cloud, "EPSG:2154"));
  jalon_fields* epochs = NULL;
  OK(jalon_trajectory_epochs(drive.trajectory, &epochs));
  uint64_t n = 0, count = 0;
  double *t = column(epochs, "time", &count), *xyz = column(epochs, "xyz", &n),
         *attitude = column(epochs, "attitude", &n), *sigma = column(epochs, "position_sigma", &n);
  jalon_trajectory *elsewhere = NULL, *bold = NULL;
  OK(jalon_trajectory_create(t, xyz, attitude, sigma, NULL, NULL, count, "EPSG:32631", NULL,
                             &elsewhere));
  INVALID(jalon_trajectory_adjust(elsewhere, drive.cloud, drive.model, NULL, NULL, &made));
  assert_non_null(strstr(jalon_last_error_message(), "EPSG:32631"));
  OK(jalon_trajectory_create(t, xyz, attitude, NULL, NULL, NULL, count, NULL, NULL, &bold));
  INVALID(jalon_trajectory_adjust(bold, drive.cloud, drive.model, NULL, NULL, &made));
  assert_non_null(strstr(jalon_last_error_message(), "sigmas of position"));
  assert_null(made);
  double* all[] = {t, xyz, attitude, sigma};
  for (int i = 0; i < 4; ++i) free(all[i]);
  jalon_trajectory_release(elsewhere);
  jalon_trajectory_release(bold);
  jalon_fields_release(epochs);
  jalon_model_release(house);
  release_drive(&drive);
}

int main(void) {
  const struct CMUnitTest tests[] = {
      cmocka_unit_test(adjusted__by_a_sure_model__is_located),
      cmocka_unit_test(adjusted_cloud__follows_the_corrections),
      cmocka_unit_test(adjusted__by_control_points__is_nearer_and_no_wall_stands_before_its_eaves),
      cmocka_unit_test(adjusted__with_attitude_biases__tells_them),
      cmocka_unit_test(adjusted__with_the_covariance_of_all__has_rows_of_facades_and_strips),
      cmocka_unit_test(adjust__of_impossible_input__names_what_is_wrong),
  };
  return cmocka_run_group_tests(tests, NULL, NULL);
}

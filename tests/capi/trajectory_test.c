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

enum { kEpochs = 5 };
static const double kTimes[kEpochs] = {10, 11, 12, 13, 14.5};
static const double kPositions[3 * kEpochs] = {0, 0, 40, 5, 0, 40, 10, 0, 41, 15, 1, 41, 22, 2, 41};
static const double kAttitudes[3 * kEpochs] = {0, 0, 3.1, 0.01, 0, -3.1, 0,  0.02,
                                               3, 0, 0,   2.9,  0, 0,    2.8};
static const double kSigmas[3 * kEpochs] = {0.02, 0.03, 0.05, 0.02, 0.03, 0.05, 0.04, 0.03,
                                            0.05, 0.02, 0.03, 0.05, 0.02, 0.03, 0.05};

static jalon_trajectory* drive(void) {
  jalon_trajectory* made = NULL;
  OK(jalon_trajectory_create(kTimes, kPositions, kAttitudes, kSigmas, kSigmas, kSigmas, kEpochs,
                             "EPSG:2154", NULL, &made));
  return made;
}

static void column(jalon_fields* fields, const char* name, double* out, uint64_t capacity) {
  OK(jalon_fields_copy(fields, name, JALON_FLOAT64, out, capacity));
}

static void trajectory__made_of_arrays__gives_them_back(void** state) {
  (void)state;
  jalon_trajectory* made = drive();
  uint64_t count = 0;
  const char* text = NULL;
  OK(jalon_trajectory_count(made, &count));
  assert_int_equal(count, kEpochs);
  OK(jalon_trajectory_crs(made, &text));
  assert_string_equal(text, "EPSG:2154");
  OK(jalon_trajectory_axes(made, &text));
  assert_string_equal(text, "enu");
  jalon_fields* epochs = NULL;
  OK(jalon_trajectory_epochs(made, &epochs));
  double values[3 * kEpochs];
  column(epochs, "time", values, kEpochs);
  assert_memory_equal(values, kTimes, sizeof kTimes);
  column(epochs, "xyz", values, 3 * kEpochs);
  assert_memory_equal(values, kPositions, sizeof values);
  column(epochs, "attitude", values, 3 * kEpochs);
  assert_memory_equal(values, kAttitudes, sizeof values);
  column(epochs, "attitude_sigma", values, 3 * kEpochs);
  assert_memory_equal(values, kSigmas, sizeof values);
  column(epochs, "velocity", values, 3 * kEpochs);
  assert_true(isnan(values[0]) && isnan(values[14]));
  jalon_fields_release(epochs);
  jalon_trajectory_release(jalon_trajectory_retain(made));
  jalon_trajectory_release(made);
}

static void trajectory__that_is_wrong__is_refused_with_epoch_and_field(void** state) {
  (void)state;
  jalon_trajectory* made = NULL;
  const double late[kEpochs] = {10, 11, 10.5, 13, 14};
  INVALID(jalon_trajectory_create(late, kPositions, kAttitudes, NULL, NULL, NULL, kEpochs, NULL,
                                  NULL, &made));
  assert_string_equal(
      jalon_last_error_message(),
      "epoch 2 of the trajectory: time 10.5 is not after time 11 of the epoch before");
  double sigmas[3 * kEpochs];
  memcpy(sigmas, kSigmas, sizeof sigmas);
  sigmas[10] = 0;
  INVALID(jalon_trajectory_create(kTimes, kPositions, kAttitudes, sigmas, NULL, NULL, kEpochs, NULL,
                                  NULL, &made));
  assert_string_equal(
      jalon_last_error_message(),
      "epoch 3 of the trajectory: position sigma y is 0; a standard deviation must be positive");
  assert_int_equal(jalon_trajectory_create(kTimes, kPositions, kAttitudes, NULL, NULL, NULL, 1,
                                           NULL, NULL, &made),
                   JALON_ERROR_INSUFFICIENT_DATA);
  assert_null(made);
}

static void trajectory__between_epochs__is_straight_and_turns_the_short_way(void** state) {
  (void)state;
  jalon_trajectory *whole = drive(), *some = NULL;
  const double times[2] = {10.5, 14.5};
  OK(jalon_trajectory_interpolate(whole, times, 2, &some));
  jalon_fields* epochs = NULL;
  double values[6];
  OK(jalon_trajectory_epochs(some, &epochs));
  column(epochs, "xyz", values, 6);
  assert_true(values[0] == 2.5 && values[2] == 40 && values[3] == 22);
  column(epochs, "attitude", values, 6);
  assert_true(fabs(fabs(values[2]) - 3.14159265) < 1e-3); /* from 3.1 to -3.1 through 180 degrees */
  jalon_fields_release(epochs);
  const double beyond[2] = {10.5, 14.6};
  jalon_trajectory* none = NULL;
  INVALID(jalon_trajectory_interpolate(whole, beyond, 2, &none));
  assert_string_equal(
      jalon_last_error_message(),
      "time 14.6 of item 1 is outside of the trajectory, which lasts from 10 to 14.5");
  assert_null(none);
  jalon_trajectory_release(some);
  jalon_trajectory_release(whole);
}

static void trajectory__at_control_times__keeps_first_and_last(void** state) {
  (void)state;
  jalon_trajectory *whole = drive(), *some = NULL;
  OK(jalon_trajectory_control(whole, 2, &some));
  jalon_fields* epochs = NULL;
  double times[3];
  uint64_t count = 0;
  OK(jalon_trajectory_count(some, &count));
  assert_int_equal(count, 3);
  OK(jalon_trajectory_epochs(some, &epochs));
  column(epochs, "time", times, 3);
  assert_true(times[0] == 10 && times[1] == 12 && times[2] == 14.5);
  jalon_fields_release(epochs);
  jalon_trajectory_release(some);
  jalon_trajectory_release(whole);
}

/* Information times covariance is 1: row i of the covariance from sigmas and factors. */
static void prior__of_a_trajectory__is_the_inverse_of_the_chain_of_its_sigmas(void** state) {
  (void)state;
  jalon_trajectory* whole = drive();
  jalon_fields* prior = NULL;
  double sigma[2 * kEpochs], information[2 * kEpochs], beside[2 * kEpochs], factor[2 * kEpochs];
  OK(jalon_trajectory_prior(whole, &prior));
  column(prior, "sigma", sigma, 2 * kEpochs);
  column(prior, "information", information, 2 * kEpochs);
  column(prior, "beside", beside, 2 * kEpochs);
  column(prior, "factor", factor, 2 * kEpochs);
  assert_true(isnan(factor[2 * kEpochs - 1]));
  double covariance[kEpochs][kEpochs];
  for (int i = 0; i < kEpochs; ++i) {
    covariance[i][i] = sigma[2 * i] * sigma[2 * i];
    for (int j = i + 1; j < kEpochs; ++j)
      covariance[i][j] = covariance[j][i] = covariance[i][j - 1] * factor[2 * (j - 1)];
  }
  for (int i = 0; i < kEpochs; ++i)
    for (int j = 0; j < kEpochs; ++j) {
      double sum = information[2 * i] * covariance[i][j];
      if (i > 0) sum += beside[2 * (i - 1)] * covariance[i - 1][j];
      if (i + 1 < kEpochs) sum += beside[2 * i] * covariance[i + 1][j];
      assert_true(fabs(sum - (i == j)) < 1e-11);
    }
  jalon_fields_release(prior);
  jalon_trajectory_release(whole);
}

static void perturbed__with_a_seed__moves_in_plan_by_about_its_sigmas(void** state) {
  (void)state;
  jalon_trajectory *whole = drive(), *moved = NULL;
  OK(jalon_trajectory_perturb(whole, 7, &moved));
  jalon_fields* epochs = NULL;
  double xyz[3 * kEpochs];
  OK(jalon_trajectory_epochs(moved, &epochs));
  column(epochs, "xyz", xyz, 3 * kEpochs);
  for (int i = 0; i < kEpochs; ++i) {
    const double dx = xyz[3 * i] - kPositions[3 * i];
    assert_true(dx != 0 && fabs(dx) < 6 * kSigmas[3 * i]);
    assert_true(xyz[3 * i + 2] == kPositions[3 * i + 2]);
  }
  jalon_fields_release(epochs);
  jalon_trajectory_release(moved);
  jalon_trajectory_release(whole);
}

int main(void) {
  const struct CMUnitTest tests[] = {
      cmocka_unit_test(trajectory__made_of_arrays__gives_them_back),
      cmocka_unit_test(trajectory__that_is_wrong__is_refused_with_epoch_and_field),
      cmocka_unit_test(trajectory__between_epochs__is_straight_and_turns_the_short_way),
      cmocka_unit_test(trajectory__at_control_times__keeps_first_and_last),
      cmocka_unit_test(prior__of_a_trajectory__is_the_inverse_of_the_chain_of_its_sigmas),
      cmocka_unit_test(perturbed__with_a_seed__moves_in_plan_by_about_its_sigmas),
  };
  return cmocka_run_group_tests_name("trajectory", tests, NULL, NULL);
}

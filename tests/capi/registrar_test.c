/* SPDX-FileCopyrightText: 2026 The Jalon authors
 * SPDX-License-Identifier: Apache-2.0 */
#include "support.h"

#include <math.h>

/* Four targets, and the same seen from a scanner that stands elsewhere, turned by a quarter about the vertical. */
static void four_targets(jalon_target* reference, jalon_target* moving) {
  static const char* const names[4] = {"A", "B", "C", "D"};
  const double xyz[4][3] = {
      {652000, 6861000, 30}, {652010, 6861002, 31}, {652003, 6861012, 29}, {652006, 6861005, 35}};
  memset(reference, 0, 4 * sizeof *reference);
  memset(moving, 0, 4 * sizeof *moving);
  for (int i = 0; i < 4; ++i) {
    reference[i].name = moving[3 - i].name = names[i];
    reference[i].xyz = (jalon_vec3){xyz[i][0], xyz[i][1], xyz[i][2]};
    moving[3 - i].xyz = (jalon_vec3){xyz[i][1] - 6861000, 652000 - xyz[i][0], xyz[i][2] - 30};
  }
}

static jalon_registration* registered(void) {
  jalon_target reference[4], moving[4];
  four_targets(reference, moving);
  jalon_registrar* registrar = NULL;
  jalon_registration* registration = NULL;
  MUST(jalon_registrar_create("targets", &registrar));
  MUST(jalon_registrar_run_targets(registrar, reference, 4, moving, 4, NULL, &registration));
  jalon_registrar_release(registrar);
  return registration;
}

static void targets__of_the_same_names_give_the_pose_on_the_national_grid(void** state) {
  (void)state;
  jalon_registration* registration = registered();
  jalon_transform pose;
  MUST(jalon_registration_pose(registration, &pose));
  const double truth[12] = {0, -1, 0, 652000, 1, 0, 0, 6861000, 0, 0, 1, 30};
  for (int i = 0; i < 12; ++i)
    assert_true(fabs(pose.m[i] - truth[i]) < (i % 4 == 3 ? 1e-7 : 1e-13));
  jalon_fields* summary = NULL;
  MUST(jalon_registration_summary(registration, &summary));
  const char* name = NULL;
  MUST(jalon_registration_pair_name(registration, 3, &name));
  assert_string_equal(name, "A");
  REFUSED(JALON_ERROR_INVALID_ARGUMENT, jalon_registration_pair_name(registration, 4, &name));
  uint8_t converged = 0, stopped = 0;
  double rms = 1;
  MUST(jalon_fields_copy(summary, "converged", JALON_UINT8, &converged, 1));
  MUST(jalon_fields_copy(summary, "stopped", JALON_UINT8, &stopped, 1));
  MUST(jalon_fields_copy(summary, "rms", JALON_FLOAT64, &rms, 1));
  assert_int_equal(converged, 1);
  assert_int_equal(stopped, JALON_STOPPED_CONVERGED);
  assert_true(rms < 2e-9);
  jalon_fields_release(summary);
  jalon_registration_release(registration);
}

static void registration__moves_a_cloud_and_gives_the_level_of_detection_its_covariance(
    void** state) {
  (void)state;
  jalon_registration* registration = registered();
  const double xyz[3] = {2, -10, 1};
  jalon_cloud *cloud = NULL, *moved = NULL;
  MUST(jalon_cloud_create(xyz, JALON_FLOAT64, 1, 0, 0, &cloud));
  MUST(jalon_registration_apply(registration, cloud, NULL, &moved));
  jalon_array_view view;
  MUST(jalon_cloud_points(moved, &view));
  const double* at = view.data;
  assert_true(fabs(at[0] - 652010) < 1e-8 && fabs(at[1] - 6861002) < 1e-8 &&
              fabs(at[2] - 31) < 1e-8);
  jalon_comparer *m3c2 = NULL, *distance = NULL;
  MUST(jalon_comparer_create("m3c2", &m3c2));
  MUST(jalon_comparer_use_registration(m3c2, registration));
  jalon_params* params = NULL;
  MUST(jalon_comparer_params(m3c2, &params));
  const double* covariance = NULL;
  uint64_t count = 0;
  MUST(jalon_params_get_doubles(params, "registration_covariance", &covariance, &count));
  assert_int_equal(count, 36);
  /* 3 mm on each side; the centroid of four targets */
  assert_true(fabs(covariance[35] - 2 * 9e-6 / 4) < 1e-12);
  MUST(jalon_comparer_create("distance", &distance));
  REFUSED(JALON_ERROR_UNSUPPORTED, jalon_comparer_use_registration(distance, registration));
  jalon_params_release(params);
  jalon_comparer_release(m3c2);
  jalon_comparer_release(distance);
  jalon_cloud_release(cloud);
  jalon_cloud_release(moved);
  jalon_registration_release(registration);
}

static void registration__report_is_one_page_with_pose_residuals_and_histograms(void** state) {
  (void)state;
  jalon_registration* registration = registered();
  double xyz[300];
  for (uint64_t i = 0; i < 100; ++i) { /* a plane in the moving scan */
    xyz[3 * i] = 2 + (double)(i % 10) * 0.1;
    xyz[3 * i + 1] = -10 + (double)(i / 10) * 0.1;
    xyz[3 * i + 2] = 1;
  }
  jalon_cloud *moving = NULL, *reference = NULL;
  MUST(jalon_cloud_create(xyz, JALON_FLOAT64, 100, 0, 0, &moving));
  MUST(jalon_registration_apply(registration, moving, NULL, &reference));
  const char* page = "registration.html";
  MUST(jalon_report_write_registration(registration, reference, moving, "{\"title\": \"<Hall>\"}",
                                       page, NULL, NULL));
  static char text[400000];
  FILE* file = fopen(page, "rb");
  assert_non_null(file);
  text[fread(text, 1, sizeof text - 1, file)] = 0;
  fclose(file);
  remove(page);
  const char* const expected[] = {"&lt;Hall&gt;",  "Converged",           "on 4 pairs",
                                  "652000.000000", "What fixes the pose", "Before",
                                  "After",         "95 % below 0.00 mm",  "residual"};
  for (size_t i = 0; i < sizeof expected / sizeof *expected; ++i)
    if (strstr(text, expected[i]) == NULL) fail_msg("%s is not in the page", expected[i]);
  jalon_cloud_release(moving);
  jalon_cloud_release(reference);
  jalon_registration_release(registration);
}

static void targets__that_cannot_give_a_pose_are_refused(void** state) {
  (void)state;
  jalon_target reference[4], moving[4];
  four_targets(reference, moving);
  jalon_registrar* registrar = NULL;
  jalon_registration* registration = NULL;
  MUST(jalon_registrar_create("targets", &registrar));
  REFUSED(JALON_ERROR_INSUFFICIENT_DATA,
          jalon_registrar_run_targets(registrar, reference, 2, moving, 4, NULL, &registration));
  moving[1].xyz.y = NAN;
  REFUSED(JALON_ERROR_INVALID_ARGUMENT,
          jalon_registrar_run_targets(registrar, reference, 4, moving, 4, NULL, &registration));
  assert_null(registration);
  jalon_registrar_release(registrar);
}

/* A slope of a floor and two walls, 20 x 20 points each. */
static jalon_cloud* corner(double shift) {
  static double xyz[3 * 1200];
  jalon_cloud* cloud = NULL;
  for (int i = 0; i < 400; ++i) {
    const double u = 0.1 * (i % 20), v = 0.1 * (i / 20), rough = 1e-3 * sin(12.9898 * i);
    const double at[9] = {u, v, rough, u, rough, v + 0.05, rough, u, v + 0.05};
    for (int k = 0; k < 9; ++k) xyz[9 * i + k] = at[k] + (k % 3 == 0 ? shift : 0);
  }
  MUST(jalon_cloud_create(xyz, JALON_FLOAT64, 1200, 0, 0, &cloud));
  return cloud;
}

static void automatic__is_the_default(void** state) {
  (void)state;
  const char* const* names = NULL;
  uint64_t count = 0;
  jalon_registrar* registrar = NULL;
  jalon_params* params = NULL;
  double shift_m = -1;
  int64_t neighbours = 0;
  MUST(jalon_registrar_methods(&names, &count));
  assert_string_equal(names[0], "automatic");
  MUST(jalon_registrar_create(NULL, &registrar));
  MUST(jalon_registrar_params(registrar, &params));
  MUST(jalon_params_get_double(params, "max_shift_m", &shift_m)); /* of "coarse" */
  MUST(jalon_params_get_int64(params, "k", &neighbours));         /* of "icp" */
  jalon_params_release(params);
  jalon_registrar_release(registrar);
}

static void icp__lays_a_corner_onto_itself(void** state) {
  (void)state;
  jalon_registrar* registrar = NULL;
  jalon_registration* registration = NULL;
  jalon_cloud *reference = corner(0), *moving = corner(0.03), *few = NULL;
  jalon_transform pose, wild = {{1, 0, 0, NAN, 0, 1, 0, 0, 0, 0, 1, 0}};
  jalon_fields* log = NULL;
  MUST(jalon_registrar_create("icp", &registrar));
  MUST(jalon_registrar_run(registrar, reference, moving, NULL, NULL, &registration));
  MUST(jalon_registration_pose(registration, &pose));
  assert_true(fabs(pose.m[3] + 0.03) < 1e-5);
  MUST(jalon_registration_iterations(registration, &log));
  jalon_fields_release(log);
  jalon_registration_release(registration);
  registration = NULL;
  REFUSED(JALON_ERROR_INVALID_ARGUMENT,
          jalon_registrar_run(registrar, reference, moving, &wild, NULL, &registration));
  MUST(jalon_cloud_create((const double[9]){0, 0, 0, 1, 0, 0, 0, 1, 0}, JALON_FLOAT64, 3, 0, 0,
                          &few));
  REFUSED(JALON_ERROR_INSUFFICIENT_DATA,
          jalon_registrar_run(registrar, reference, few, NULL, NULL, &registration));
  assert_null(registration);
  jalon_cloud_release(few);
  jalon_cloud_release(moving);
  jalon_cloud_release(reference);
  jalon_registrar_release(registrar);
}

/* Two samples of a furnished corner: floor, two walls, a chest; points on a jittered lattice. */
static uint64_t furnished_corner(double* xyz, uint32_t seed) {
  static const double sheets[6][9] = {{0, 0, 0, 6, 0, 0, 0, 5, 0},   {0, 0, 0, 6, 0, 0, 0, 0, 3},
                                      {0, 0, 0, 0, 5, 0, 0, 0, 3},   {3, 1, 0, 1.5, 0, 0, 0, 0, 1},
                                      {3, 1, 1, 1.5, 0, 0, 0, 1, 0}, {3, 1, 0, 0, 1, 0, 0, 0, 1}};
  uint64_t n = 0;
  uint32_t state = seed;
  for (int k = 0; k < 6; ++k)
    for (int i = 0; i < 2500; ++i) {
      double share[2];
      for (int c = 0; c < 2; ++c) {
        state = state * 1664525u + 1013904223u;
        share[c] = (double)(state >> 8) / 16777216.0;
      }
      for (int c = 0; c < 3; ++c)
        xyz[3 * n + (uint64_t)c] =
            sheets[k][c] + share[0] * sheets[k][3 + c] + share[1] * sheets[k][6 + c];
      ++n;
    }
  return n;
}

static void automatic__finds_a_cloud_that_was_turned_and_shifted(void** state) {
  (void)state;
  static double a[45000], b[45000];
  const uint64_t n = furnished_corner(a, 1);
  assert_int_equal(furnished_corner(b, 2), n);
  for (uint64_t i = 0; i < n; ++i) { /* a quarter turn and a shift */
    const double x = b[3 * i], y = b[3 * i + 1];
    b[3 * i] = 12 - y;
    b[3 * i + 1] = x - 7;
    b[3 * i + 2] += 1;
  }
  jalon_cloud *reference = NULL, *moving = NULL;
  MUST(jalon_cloud_create(a, JALON_FLOAT64, n, 0, 0, &reference));
  MUST(jalon_cloud_create(b, JALON_FLOAT64, n, 0, 0, &moving));
  const char* const methods[] = {"coarse", "automatic"};
  const double within[] = {0.1, 0.005};
  for (int k = 0; k < 2; ++k) {
    jalon_registrar* registrar = NULL;
    jalon_registration* registration = NULL;
    jalon_fields* summary = NULL;
    MUST(jalon_registrar_create(methods[k], &registrar));
    MUST(jalon_registrar_run(registrar, reference, moving, NULL, NULL, &registration));
    jalon_transform pose;
    MUST(jalon_registration_pose(registration, &pose));
    /* The place (1, 2, 3) of the corner lies at (10, -6, 4) in the moving cloud. */
    const double place[4] = {10, -6, 4, 1}, truth[3] = {1, 2, 3};
    for (int r = 0; r < 3; ++r) {
      double at = 0;
      for (int c = 0; c < 4; ++c) at += pose.m[4 * r + c] * place[c];
      assert_true(fabs(at - truth[r]) < within[k]);
    }
    MUST(jalon_registration_summary(registration, &summary));
    jalon_array_view view;
    MUST(jalon_fields_view(summary, "stopped", &view));
    assert_int_equal(*(const uint8_t*)view.data, JALON_STOPPED_CONVERGED);
    MUST(jalon_fields_view(summary, "score", &view));
    assert_true(*(const double*)view.data > 0.8);
    jalon_fields_release(summary);
    jalon_registration_release(registration);
    jalon_registrar_release(registrar);
  }
  jalon_cloud_release(reference);
  jalon_cloud_release(moving);
}

struct last_owner {
  jalon_registrar* registrar;
  double at; /* fraction of the work that was done when it went */
};

static int32_t release_registrar(double fraction, const char* stage, void* user) {
  struct last_owner* last = user;
  (void)stage;
  if (last->registrar != NULL) last->at = fraction;
  jalon_registrar_release(last->registrar);
  last->registrar = NULL;
  return 0;
}

static void automatic__outlives_a_registrar_that_its_progress_callback_releases(void** state) {
  (void)state;
  static double xyz[45000];
  jalon_cloud *reference = NULL, *moving = NULL;
  struct last_owner last = {NULL, 0};
  MUST(jalon_cloud_create(xyz, JALON_FLOAT64, furnished_corner(xyz, 1), 0, 0, &reference));
  MUST(jalon_cloud_create(xyz, JALON_FLOAT64, furnished_corner(xyz, 2), 0, 0, &moving));
  jalon_registration* registration = NULL;
  jalon_task* task = NULL;
  MUST(jalon_registrar_create("automatic", &last.registrar));
  MUST(jalon_task_create(&task));
  MUST(jalon_task_set_progress(task, release_registrar, &last));
  MUST(jalon_registrar_run(last.registrar, reference, moving, NULL, task, &registration));
  assert_null(last.registrar);
  assert_true(last.at < 0.5); /* before "icp" read its parameters */
  const char* parameters = NULL;
  MUST(jalon_registration_parameters(registration, &parameters));
  assert_non_null(strstr(parameters, "coarse_cell_m"));
  assert_non_null(strstr(parameters, "max_iterations"));
  jalon_registration_release(registration);
  jalon_task_release(task);
  jalon_cloud_release(reference);
  jalon_cloud_release(moving);
}

int main(void) {
  const struct CMUnitTest tests[] = {
      cmocka_unit_test(targets__of_the_same_names_give_the_pose_on_the_national_grid),
      cmocka_unit_test(registration__moves_a_cloud_and_gives_the_level_of_detection_its_covariance),
      cmocka_unit_test(registration__report_is_one_page_with_pose_residuals_and_histograms),
      cmocka_unit_test(automatic__finds_a_cloud_that_was_turned_and_shifted),
      cmocka_unit_test(automatic__outlives_a_registrar_that_its_progress_callback_releases),
      cmocka_unit_test(targets__that_cannot_give_a_pose_are_refused),
      cmocka_unit_test(automatic__is_the_default),
      cmocka_unit_test(icp__lays_a_corner_onto_itself),
  };
  return cmocka_run_group_tests(tests, NULL, NULL);
}

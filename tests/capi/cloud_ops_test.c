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

enum { kSide = 60 };

/* A wall in y = 0: kSide x kSide points, 10 cm apart, and two copies of the first one at the end. */
static jalon_cloud* wall(void) {
  static double xyz[(kSide * kSide + 2) * 3];
  jalon_cloud* cloud = NULL;
  memset(xyz, 0, sizeof xyz);
  for (int i = 0; i < kSide * kSide; ++i) {
    xyz[3 * i] = 0.1 * (i % kSide);
    xyz[3 * i + 2] = 0.1 * (i / kSide);
  }
  OK(jalon_cloud_create(xyz, JALON_FLOAT64, kSide * kSide + 2, 0, 0, &cloud));
  return cloud;
}

static uint64_t count_of(const jalon_cloud* cloud) {
  uint64_t n = 0;
  OK(jalon_cloud_count(cloud, &n));
  return n;
}

static void first_of(const jalon_cloud* cloud, const char* name, float out[3]) {
  jalon_fields* fields = NULL;
  jalon_array_view view;
  OK(jalon_cloud_fields(cloud, &fields));
  OK(jalon_fields_view(fields, name, &view));
  assert_int_equal(view.type, JALON_FLOAT32);
  memcpy(out, view.data, view.components * sizeof(float));
  jalon_fields_release(fields);
}

static jalon_params* params(const char* operation) {
  jalon_params* p = NULL;
  OK(jalon_params_create(operation, &p));
  return p;
}

static void normals__oriented_to_a_point_and_inverted(void** state) {
  (void)state;
  jalon_cloud* cloud = wall();
  jalon_params* p = params("normals");
  const double viewpoint[3] = {3, -10, 3};
  float n[3];
  OK(jalon_params_set_string(p, "orientation", "point"));
  OK(jalon_params_set_doubles(p, "viewpoint", viewpoint, 3));
  OK(jalon_cloud_compute_normals(cloud, p, NULL));
  first_of(cloud, "normal", n);
  assert_true(n[1] < -0.999f);
  OK(jalon_cloud_invert_normals(cloud, NULL));
  first_of(cloud, "normal", n);
  assert_true(n[1] > 0.999f);
  OK(jalon_params_set_string(p, "orientation", "station"));
  INVALID(jalon_cloud_compute_normals(cloud, p, NULL));
  assert_non_null(strstr(jalon_last_error_message(), "point 0 has no station"));
  first_of(cloud, "normal", n);
  assert_true(n[1] > 0.999f); /* a failed call leaves the cloud as it was */
  jalon_params_release(p);
  p = params("features");
  INVALID(jalon_cloud_compute_normals(cloud, p, NULL));
  jalon_params_release(p);
  jalon_cloud_release(cloud);
}

static void features_and_components__add_their_fields(void** state) {
  (void)state;
  jalon_cloud* cloud = wall();
  jalon_params* p = params("features");
  uint64_t components = 0;
  float value[3];
  OK(jalon_params_set_string(p, "which", "planarity verticality"));
  OK(jalon_cloud_compute_features(cloud, p, NULL));
  first_of(cloud, "verticality", value);
  assert_true(value[0] > 0.999f);
  OK(jalon_params_set_string(p, "which", "beauty"));
  INVALID(jalon_cloud_compute_features(cloud, p, NULL));
  jalon_params_release(p);
  p = params("components");
  OK(jalon_params_set_double(p, "cell_m", 0.15)); /* more than the spacing */
  OK(jalon_cloud_compute_components(cloud, p, NULL, &components));
  assert_int_equal(components, 1);
  INVALID(jalon_cloud_compute_components(cloud, NULL, NULL, NULL));
  jalon_params_release(p);
  jalon_cloud_release(cloud);
}

static void statistics__covariance_and_moments(void** state) {
  (void)state;
  const double xyz[12] = {0, 0, 0, 2, 0, 0, 0, 4, 0, 2, 4, 6};
  jalon_cloud *cloud = NULL, *empty = NULL;
  jalon_vec3 centroid;
  double c[9], moment = 0;
  OK(jalon_cloud_create(xyz, JALON_FLOAT64, 4, 0, 0, &cloud));
  OK(jalon_cloud_create(NULL, JALON_FLOAT64, 0, 0, 0, &empty));
  OK(jalon_cloud_covariance(cloud, NULL, &centroid, c));
  assert_true(centroid.x == 1 && centroid.y == 2 && centroid.z == 1.5);
  assert_true(c[0] == 1 && c[4] == 4 && c[8] == 6.75 && c[2] == 1.5 && c[6] == 1.5 && c[5] == 3 &&
              c[7] == 3);
  OK(jalon_cloud_moment(cloud, 1, 1, 1, 0, NULL, &moment));
  assert_true(moment == 12);
  INVALID(jalon_cloud_moment(cloud, 9, 0, 0, 0, NULL, &moment));
  assert_int_equal(jalon_cloud_covariance(empty, NULL, NULL, NULL), JALON_ERROR_INSUFFICIENT_DATA);
  jalon_cloud_release(cloud);
  jalon_cloud_release(empty);
}

static void reductions__report_what_they_did(void** state) {
  (void)state;
  jalon_cloud *cloud = wall(), *out = NULL;
  jalon_params* p = params("subsample");
  jalon_reduction report;
  OK(jalon_cloud_remove_duplicates(cloud, 1e-4, NULL, &out, &report));
  assert_true(report.count_in == kSide * kSide + 2 && report.removed == 2 &&
              report.count_out == count_of(out));
  assert_true(fabs(report.removed_percent - 200.0 / (kSide * kSide + 2)) < 1e-12);
  jalon_cloud_release(out);
  out = NULL;
  INVALID(jalon_cloud_remove_duplicates(cloud, -1, NULL, &out, NULL));
  assert_null(out);
  OK(jalon_params_set_double(p, "cell_m", 0.5));
  OK(jalon_cloud_subsample(cloud, p, NULL, &out, &report));
  assert_int_equal(report.count_out, 12 * 12);
  jalon_cloud_release(out);
  OK(jalon_params_set_string(p, "method", "random"));
  OK(jalon_params_set_int64(p, "count", 100));
  OK(jalon_cloud_subsample(cloud, p, NULL, &out, NULL));
  assert_int_equal(count_of(out), 100);
  jalon_cloud_release(out);
  OK(jalon_cloud_remove_outliers(cloud, NULL, NULL, &out, &report));
  assert_true(report.count_out + report.removed == report.count_in);
  jalon_cloud_release(out);
  jalon_params_release(p);
  jalon_cloud_release(cloud);
}

static void split_interest__facade_and_the_rest(void** state) {
  (void)state;
  jalon_cloud *cloud = wall(), *interest = NULL, *unwanted = NULL;
  OK(jalon_cloud_split_interest(cloud, NULL, NULL, &interest, &unwanted));
  assert_int_equal(count_of(interest) + count_of(unwanted), count_of(cloud));
  assert_int_equal(count_of(unwanted), 0);
  jalon_cloud_release(interest);
  jalon_cloud_release(unwanted);
  jalon_cloud_release(cloud);
}

static void cancel__ends_every_long_call_and_leaves_the_cloud_usable(void** state) {
  (void)state;
  jalon_cloud *cloud = wall(), *out = NULL;
  jalon_task* task = NULL;
  uint64_t n = 0;
  OK(jalon_task_create(&task));
  OK(jalon_task_cancel(task));
  assert_int_equal(jalon_cloud_compute_normals(cloud, NULL, task), JALON_ERROR_CANCELLED);
  assert_int_equal(jalon_cloud_compute_features(cloud, NULL, task), JALON_ERROR_CANCELLED);
  assert_int_equal(jalon_cloud_compute_components(cloud, NULL, task, &n), JALON_ERROR_CANCELLED);
  assert_int_equal(jalon_cloud_remove_duplicates(cloud, 1e-4, task, &out, NULL),
                   JALON_ERROR_CANCELLED);
  assert_int_equal(jalon_cloud_remove_outliers(cloud, NULL, task, &out, NULL),
                   JALON_ERROR_CANCELLED);
  assert_int_equal(jalon_cloud_subsample(cloud, NULL, task, &out, NULL), JALON_ERROR_CANCELLED);
  assert_int_equal(jalon_cloud_split_interest(cloud, NULL, task, &out, NULL),
                   JALON_ERROR_CANCELLED);
  assert_int_equal(jalon_cloud_append(cloud, cloud, task, &out), JALON_ERROR_CANCELLED);
  assert_int_equal(jalon_cloud_prepare(cloud, task), JALON_ERROR_CANCELLED);
  assert_null(out);
  OK(jalon_task_reset(task));
  OK(jalon_cloud_compute_normals(cloud, NULL, task));
  jalon_task_release(task);
  jalon_cloud_release(cloud);
}

static void index__that_was_dropped_is_built_again(void** state) {
  (void)state;
  jalon_cloud *cloud = NULL, *copy = NULL;
  const double xyz[] = {0, 0, 0, 1, 0, 0, 0, 3, 0, 0, 0, 5}, place[] = {0.9, 0, 0};
  uint64_t before[2], after[2];
  OK(jalon_cloud_create(xyz, JALON_FLOAT64, 4, 0, 0, &cloud));
  OK(jalon_cloud_copy(cloud, &copy));
  OK(jalon_cloud_drop_index(cloud));  // which has none yet
  OK(jalon_cloud_knn(cloud, place, JALON_FLOAT64, 1, 0, 2, JALON_LEVEL_AUTOMATIC, NULL, before,
                     NULL));
  OK(jalon_cloud_drop_index(copy));
  OK(jalon_cloud_knn(cloud, place, JALON_FLOAT64, 1, 0, 2, JALON_LEVEL_AUTOMATIC, NULL, after,
                     NULL));
  assert_int_equal(before[0], 1);
  assert_memory_equal(before, after, sizeof before);
  assert_int_equal(jalon_cloud_drop_index(NULL), JALON_ERROR_INVALID_ARGUMENT);
  jalon_cloud_release(copy);
  jalon_cloud_release(cloud);
}

int main(void) {
  const struct CMUnitTest tests[] = {
      cmocka_unit_test(index__that_was_dropped_is_built_again),
      cmocka_unit_test(normals__oriented_to_a_point_and_inverted),
      cmocka_unit_test(features_and_components__add_their_fields),
      cmocka_unit_test(statistics__covariance_and_moments),
      cmocka_unit_test(reductions__report_what_they_did),
      cmocka_unit_test(split_interest__facade_and_the_rest),
      cmocka_unit_test(cancel__ends_every_long_call_and_leaves_the_cloud_usable),
  };
  return cmocka_run_group_tests(tests, NULL, NULL);
}

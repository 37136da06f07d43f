/* SPDX-FileCopyrightText: 2026 The Jalon authors
 * SPDX-License-Identifier: Apache-2.0 */
/* Statistics against sums made here, reductions and components of points whose clusters are known. */
#include "lifted_square.h"

enum { kSpread = 500, kLattice = 20 };

/* Whole multiples of 1/64 m, so that whole-metre shifts are exact. */
static void spread_points(double* xyz, double east_m, double north_m) {
  for (uint64_t i = 0; i < kSpread; ++i) {
    const double u = floor(640 * uniform(31, 3 * i)) / 64,
                 v = floor(64 * uniform(31, 3 * i + 1)) / 64;
    xyz[3 * i] = east_m + u;
    xyz[3 * i + 1] = north_m + v + u / 2;
    xyz[3 * i + 2] = floor(192 * uniform(31, 3 * i + 2)) / 64;
  }
}

static void statistics__agree_with_plain_sums_wherever_the_points_lie(void** state) {
  (void)state;
  static double xyz[3 * kSpread], here[9], there[9];
  double sums[3] = {0}, products[9] = {0};
  spread_points(xyz, 0, 0);
  for (int i = 0; i < kSpread; ++i)
    for (int k = 0; k < 3; ++k) sums[k] += xyz[3 * i + k] / kSpread;
  for (int i = 0; i < kSpread; ++i)
    for (int k = 0; k < 9; ++k)
      products[k] +=
          (xyz[3 * i + k / 3] - sums[k / 3]) * (xyz[3 * i + k % 3] - sums[k % 3]) / kSpread;
  jalon_cloud* cloud = cloud_of(xyz, kSpread);
  jalon_vec3 centre, far_centre;
  MUST(jalon_cloud_covariance(cloud, NULL, &centre, here));
  /* n roundings of numbers up to 100 */
  const double within = kSpread * 100 * 2.3e-16;
  for (int k = 0; k < 9; ++k) assert_true(fabs(here[k] - products[k]) < within);
  assert_true(fabs(centre.x - sums[0]) < within && fabs(centre.z - sums[2]) < within);
  for (uint32_t i = 0; i < 3; ++i)
    for (uint32_t k = 0; k < 3; ++k) {
      uint32_t power[3] = {0, 0, 0};
      double moment = 0;
      ++power[i], ++power[k];
      MUST(jalon_cloud_moment(cloud, power[0], power[1], power[2], 1, NULL, &moment));
      assert_true(fabs(moment - here[3 * i + k]) < within);
      assert_true(here[3 * i + k] == here[3 * k + i]);
      /* As they are: more by the product of the centroid's coordinates. */
      MUST(jalon_cloud_moment(cloud, power[0], power[1], power[2], 0, NULL, &moment));
      assert_true(fabs(moment - here[3 * i + k] - sums[i] * sums[k]) < within);
    }
  double one = 0;
  MUST(jalon_cloud_moment(cloud, 0, 0, 0, 1, NULL, &one));
  assert_true(one == 1);
  jalon_cloud_release(cloud);
  /* On a national grid: the same covariance, bit by bit. */
  spread_points(xyz, 652000, 6861000);
  cloud = cloud_of(xyz, kSpread);
  MUST(jalon_cloud_covariance(cloud, NULL, &far_centre, there));
  assert_memory_equal(here, there, sizeof here);
  assert_true(fabs(far_centre.y - 6861000 - centre.y) < 1e-9);
  MUST(jalon_cloud_covariance(cloud, NULL, NULL, NULL));
  jalon_cloud_release(cloud);
}

/* Three lattices of points 0.1 m apart: 20 x 20, 10 x 20 and 20, 5 m from each other. */
static jalon_cloud* three_clusters(void) {
  static double xyz[3 * 620];
  for (int i = 0; i < 620; ++i) {
    const int cluster = i < 20    ? 2
                        : i < 220 ? 1
                                  : 0,
              k = i - (cluster == 2   ? 0
                       : cluster == 1 ? 20
                                      : 220);
    xyz[3 * i] = 0.1 * (k % kLattice);
    xyz[3 * i + 1] = 0.1 * (k / kLattice);
    xyz[3 * i + 2] = 5.0 * cluster;
  }
  return cloud_of(xyz, 620);
}

static void components__are_numbered_by_size_and_a_failure_adds_nothing(void** state) {
  (void)state;
  jalon_cloud* cloud = three_clusters();
  jalon_params *options = options_of("components", "{\"cell_m\": 0.2, \"min_points\": 30}"),
               *wrong = options_of("normals", "{}");
  jalon_fields* fields = NULL;
  uint64_t count = 77, columns = 0;
  REFUSED(JALON_ERROR_INVALID_ARGUMENT, jalon_cloud_compute_components(cloud, wrong, NULL, &count));
  REFUSED(JALON_ERROR_INVALID_ARGUMENT, jalon_cloud_compute_components(cloud, options, NULL, NULL));
  assert_int_equal(count, 77);
  MUST(jalon_cloud_fields(cloud, &fields));
  MUST(jalon_fields_count(fields, &columns));
  assert_int_equal(columns, 0);
  jalon_fields_release(fields);
  MUST(jalon_cloud_compute_components(cloud, options, NULL, &count));
  assert_int_equal(count, 2);
  MUST(jalon_cloud_fields(cloud, &fields));
  for (uint64_t i = 0; i < 620; ++i) /* 0: too small; 1: the largest */
    assert_int_equal(cell_of(fields, "component", i, 0), i < 20 ? 0 : i < 220 ? 2 : 1);
  jalon_fields_release(fields);
  jalon_params_release(options), jalon_params_release(wrong);
  jalon_cloud_release(cloud);
}

static void reductions__account_for_every_point(void** state) {
  (void)state;
  static double xyz[3 * (kLattice * kLattice + 41)];
  const int n = kLattice * kLattice;
  for (int i = 0; i < n + 41; ++i) { /* a lattice, forty of its points again, and one far from it */
    xyz[3 * i] = 0.1 * (i % n % kLattice);
    xyz[3 * i + 1] = 0.1 * (i % n / kLattice);
    xyz[3 * i + 2] = i == n + 40 ? 30 : 0;
  }
  jalon_cloud *cloud = cloud_of(xyz, (uint64_t)n + 41), *once = NULL, *clean = NULL, *thin = NULL;
  jalon_reduction report;
  MUST(jalon_cloud_remove_duplicates(cloud, 1e-4, NULL, &once, &report));
  assert_int_equal(report.removed, 40);
  MUST(jalon_cloud_remove_outliers(once, NULL, NULL, &clean, &report));
  assert_int_equal(report.count_in, n + 1);
  assert_int_equal(report.count_in - report.removed, report.count_out);
  assert_int_equal(report.count_out, count_of(clean));
  jalon_box box;
  MUST(jalon_cloud_bounds(clean, &box));
  assert_true(box.max.z == 0); /* the far point is gone */
  jalon_params* options = options_of("subsample", "{\"method\": \"voxel\", \"cell_m\": 100}");
  MUST(jalon_cloud_subsample(cloud, options, NULL, &thin, &report));
  assert_true(count_of(thin) >= 1 && count_of(thin) <= 8); /* cells that meet in a corner */
  assert_true(fabs(report.removed_percent - 100.0 * (double)report.removed / (n + 41)) < 1e-12);
  jalon_cloud_release(thin);
  jalon_cloud* empty = cloud_of(NULL, 0);
  MUST(jalon_cloud_remove_duplicates(empty, 1e-4, NULL, &thin, &report));
  assert_true(report.count_in == 0 && report.removed == 0 && report.removed_percent == 0);
  jalon_cloud_release(thin), jalon_cloud_release(empty);
  jalon_params_release(options);
  jalon_cloud_release(cloud), jalon_cloud_release(once), jalon_cloud_release(clean);
}

int main(void) {
  const struct CMUnitTest tests[] = {
      cmocka_unit_test(statistics__agree_with_plain_sums_wherever_the_points_lie),
      cmocka_unit_test(components__are_numbered_by_size_and_a_failure_adds_nothing),
      cmocka_unit_test(reductions__account_for_every_point),
  };
  return cmocka_run_group_tests(tests, NULL, NULL);
}

/* SPDX-FileCopyrightText: 2026 The Jalon authors
 * SPDX-License-Identifier: Apache-2.0 */
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <setjmp.h>
#include <cmocka.h>

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include <jalon/jalon.h>

enum { kSide = 12, kCount = kSide * kSide * kSide };

/* A grid of 0.25 m at national-grid coordinates: full of ties. */
static jalon_cloud* grid_cloud(double dx, double* xyz) {
  jalon_cloud* cloud = NULL;
  for (int i = 0; i < kCount; ++i) {
    xyz[3 * i] = 652000 + dx + 0.25 * (i % kSide);
    xyz[3 * i + 1] = 6861000 + 0.25 * (i / kSide % kSide);
    xyz[3 * i + 2] = 0.25 * (i / kSide / kSide);
  }
  assert_int_equal(jalon_cloud_create(xyz, JALON_FLOAT64, kCount, 0, 0, &cloud), JALON_OK);
  return cloud;
}

static double squared(const double* a, const double* b) {
  const double dx = a[0] - b[0], dy = a[1] - b[1], dz = a[2] - b[2];
  return dx * dx + dy * dy + dz * dz;
}

/* The j-th nearest by repeated search for the next in (distance, index) order. */
static uint64_t next_nearest(const double* xyz, const double* q, double after,
                             uint64_t after_index) {
  uint64_t best = JALON_NO_POINT;
  double best_squared = INFINITY;
  for (uint64_t i = 0; i < kCount; ++i) {
    const double s = squared(xyz + 3 * i, q);
    if (s < after || (s == after && (after_index != JALON_NO_POINT && i <= after_index))) continue;
    if (s < best_squared) {
      best = i;
      best_squared = s;
    }
  }
  return best;
}

static void knn__equals_brute_force_at_every_level(void** state) {
  (void)state;
  static double xyz[3 * kCount];
  jalon_cloud* cloud = grid_cloud(0, xyz);
  const double queries[] = {652001.1, 6861001.2, 1.3, 652000, 6861000, 0, 651000, 6861000, 5};
  uint64_t expected[3 * 9], found[3 * 9];
  double distances[3 * 9];
  for (int q = 0; q < 3; ++q) {
    double after = -1;
    uint64_t after_index = JALON_NO_POINT;
    for (int j = 0; j < 9; ++j) {
      after_index = next_nearest(xyz, queries + 3 * q, after, after_index);
      after = squared(xyz + 3 * after_index, queries + 3 * q);
      expected[9 * q + j] = after_index;
    }
  }
  const int32_t levels[] = {JALON_LEVEL_AUTOMATIC, 1, 2, 4, 7, 10, 21};
  for (size_t l = 0; l < sizeof levels / sizeof *levels; ++l) {
    memset(found, 0, sizeof found);
    assert_int_equal(
        jalon_cloud_knn(cloud, queries, JALON_FLOAT64, 3, 0, 9, levels[l], NULL, found, distances),
        JALON_OK);
    assert_memory_equal(found, expected, sizeof expected);
    for (int i = 0; i < 27; ++i)
      assert_true(distances[i] == squared(xyz + 3 * found[i], queries + 3 * (i / 9)));
  }
  jalon_cloud_release(cloud);
}

static void knn_all__agrees_with_knn(void** state) {
  (void)state;
  static double xyz[3 * kCount];
  static uint32_t all[kCount * 7];
  static float squares[kCount * 7];
  static uint64_t each[kCount * 7];
  jalon_cloud* cloud = grid_cloud(0, xyz);
  assert_int_equal(jalon_cloud_knn_all(cloud, 7, NULL, all, squares), JALON_OK);
  assert_int_equal(jalon_cloud_knn(cloud, xyz, JALON_FLOAT64, kCount, 0, 7, JALON_LEVEL_AUTOMATIC,
                                   NULL, each, NULL),
                   JALON_OK);
  for (int i = 0; i < kCount * 7; ++i) assert_int_equal(all[i], each[i]);
  assert_true(squares[0] == 0 && squares[1] == 0.0625f);
  jalon_cloud_release(cloud);
}

static void radius_search__finds_the_closed_ball(void** state) {
  (void)state;
  static double xyz[3 * kCount];
  jalon_cloud* cloud = grid_cloud(0, xyz);
  jalon_fields *ranges = NULL, *neighbours = NULL;
  assert_int_equal(jalon_cloud_radius_search(cloud, xyz, JALON_FLOAT64, kCount, 0, 0.25, NULL,
                                             &ranges, &neighbours),
                   JALON_OK);
  jalon_array_view first, index, distance;
  assert_int_equal(jalon_fields_view(ranges, "first", &first), JALON_OK);
  assert_int_equal(jalon_fields_view(neighbours, "index", &index), JALON_OK);
  assert_int_equal(jalon_fields_view(neighbours, "distance", &distance), JALON_OK);
  assert_int_equal(first.count, kCount + 1);
  const uint64_t* firsts = first.data;
  const uint64_t* indices = index.data;
  const double* lengths = distance.data;
  assert_int_equal(firsts[0], 0);
  assert_int_equal(firsts[1], 4); /* a corner: itself and three */
  assert_int_equal(firsts[kCount], kCount + 3 * 2 * kSide * kSide * (kSide - 1));
  for (uint64_t n = 0; n < 4; ++n)
    assert_true(lengths[n] == sqrt(squared(xyz, xyz + 3 * indices[n])));
  jalon_fields_release(ranges);
  jalon_fields_release(neighbours);
  jalon_cloud_release(cloud);
}

static void cells__tile_the_points_in_order(void** state) {
  (void)state;
  static double xyz[3 * kCount];
  jalon_cloud* cloud = grid_cloud(0, xyz);
  jalon_vec3 origin;
  double edge = 0;
  assert_int_equal(jalon_cloud_octree_cube(cloud, NULL, &origin, &edge), JALON_OK);
  assert_true(edge == 4.0 && origin.x == 652000.0 && origin.y == 6861000.0 && origin.z == 0.0);
  jalon_fields *cells = NULL, *order = NULL, *around = NULL;
  assert_int_equal(jalon_cloud_cells(cloud, 2, NULL, &cells), JALON_OK);
  assert_int_equal(jalon_cloud_order(cloud, NULL, &order), JALON_OK);
  jalon_array_view code, first, count, centre, sorted;
  assert_int_equal(jalon_fields_view(cells, "code", &code), JALON_OK);
  assert_int_equal(jalon_fields_view(cells, "first", &first), JALON_OK);
  assert_int_equal(jalon_fields_view(cells, "count", &count), JALON_OK);
  assert_int_equal(jalon_fields_view(cells, "centre", &centre), JALON_OK);
  assert_int_equal(jalon_fields_view(order, "order", &sorted), JALON_OK);
  assert_int_equal(code.count, 27); /* 3 m of cells of 1 m */
  uint64_t next = 0;
  for (uint64_t c = 0; c < code.count; ++c) {
    assert_int_equal(((const uint64_t*)first.data)[c], next);
    assert_int_equal(((const uint64_t*)count.data)[c], 64);
    for (uint64_t i = next; i < next + 64; ++i)
      for (int axis = 0; axis < 3; ++axis)
        assert_true(fabs(xyz[3 * ((const uint64_t*)sorted.data)[i] + axis] -
                         ((const double*)centre.data)[3 * c + axis]) <= 0.5);
    next += 64;
  }
  assert_int_equal(next, kCount);
  assert_int_equal(
      jalon_cloud_cell_neighbours(cloud, 2, ((const uint64_t*)code.data)[0], 1, NULL, &around),
      JALON_OK);
  jalon_array_view codes;
  assert_int_equal(jalon_fields_view(around, "code", &codes), JALON_OK);
  assert_int_equal(codes.count, 7);
  jalon_fields_release(cells);
  jalon_fields_release(order);
  jalon_fields_release(around);
  jalon_cloud_release(cloud);
}

static void share_octree__gives_one_cube(void** state) {
  (void)state;
  static double xyz[3 * kCount];
  jalon_cloud* clouds[2] = {grid_cloud(0, xyz), grid_cloud(40, xyz)};
  jalon_vec3 a, b;
  double edge_a = 0, edge_b = 0;
  assert_int_equal(jalon_cloud_share_octree(clouds, 2, NULL), JALON_OK);
  assert_int_equal(jalon_cloud_octree_cube(clouds[0], NULL, &a, &edge_a), JALON_OK);
  assert_int_equal(jalon_cloud_octree_cube(clouds[1], NULL, &b, &edge_b), JALON_OK);
  assert_memory_equal(&a, &b, sizeof a);
  assert_true(edge_a == 64.0 && edge_b == 64.0);
  int32_t level = 0;
  assert_int_equal(jalon_cloud_best_level(clouds[0], clouds[1], 1, NULL, &level), JALON_OK);
  assert_true(level >= 1 && level <= JALON_OCTREE_MAX_LEVEL);
  jalon_cloud_release(clouds[0]);
  jalon_cloud_release(clouds[1]);
}

static void bad_arguments__are_refused_and_nothing_is_written(void** state) {
  (void)state;
  static double xyz[3 * kCount];
  jalon_cloud* cloud = grid_cloud(0, xyz);
  uint64_t found[8] = {77};
  const double bad[] = {0, NAN, 0};
  jalon_fields *fields = NULL, *more = NULL;
  assert_int_equal(jalon_cloud_knn(cloud, bad, JALON_FLOAT64, 1, 0, 1, -1, NULL, found, NULL),
                   JALON_ERROR_INVALID_ARGUMENT);
  assert_int_equal(jalon_cloud_knn(cloud, xyz, JALON_FLOAT64, 1, 0, 0, -1, NULL, found, NULL),
                   JALON_ERROR_INVALID_ARGUMENT);
  assert_int_equal(jalon_cloud_knn(cloud, xyz, JALON_FLOAT64, 1, 0, 1, 22, NULL, found, NULL),
                   JALON_ERROR_INVALID_ARGUMENT);
  assert_int_equal(jalon_cloud_knn(cloud, xyz, JALON_FLOAT64, 1, 0, 1, 0, NULL, found, NULL),
                   JALON_ERROR_INVALID_ARGUMENT);
  assert_int_equal(jalon_cloud_knn(cloud, xyz, 99, 1, 0, 1, -1, NULL, found, NULL),
                   JALON_ERROR_INVALID_ARGUMENT);
  assert_int_equal(
      jalon_cloud_knn(cloud, xyz, JALON_FLOAT64, UINT64_MAX, 0, 1, -1, NULL, found, NULL),
      JALON_ERROR_INVALID_ARGUMENT);
  assert_int_equal(found[0], 77);
  assert_int_equal(jalon_cloud_knn_all(cloud, 257, NULL, (uint32_t*)found, NULL),
                   JALON_ERROR_INVALID_ARGUMENT);
  assert_int_equal(
      jalon_cloud_radius_search(cloud, xyz, JALON_FLOAT64, 1, 0, -1, NULL, &fields, &more),
      JALON_ERROR_INVALID_ARGUMENT);
  assert_int_equal(
      jalon_cloud_radius_search(cloud, xyz, JALON_FLOAT64, 1, 0, NAN, NULL, &fields, &more),
      JALON_ERROR_INVALID_ARGUMENT);
  assert_int_equal(jalon_cloud_cells(cloud, 22, NULL, &fields), JALON_ERROR_INVALID_ARGUMENT);
  assert_int_equal(jalon_cloud_cell_neighbours(cloud, 2, 64, 1, NULL, &fields),
                   JALON_ERROR_INVALID_ARGUMENT);
  assert_null(fields);
  assert_int_equal(jalon_cloud_cells(NULL, 2, NULL, &fields), JALON_ERROR_INVALID_ARGUMENT);
  assert_int_equal(jalon_cloud_cells(cloud, 2, NULL, NULL), JALON_ERROR_INVALID_ARGUMENT);
  jalon_cloud_release(cloud);
}

static void empty_cloud__has_no_neighbours(void** state) {
  (void)state;
  jalon_cloud* cloud = NULL;
  assert_int_equal(jalon_cloud_create(NULL, JALON_FLOAT64, 0, 0, 0, &cloud), JALON_OK);
  const float query[3] = {1, 2, 3};
  uint64_t found[2] = {0, 0};
  double distances[2] = {0, 0};
  for (int32_t level = -1; level < 4; level += 4) {
    assert_int_equal(
        jalon_cloud_knn(cloud, query, JALON_FLOAT32, 1, 0, 2, level, NULL, found, distances),
        JALON_OK);
    assert_true(found[0] == JALON_NO_POINT && found[1] == JALON_NO_POINT && isinf(distances[1]));
  }
  assert_int_equal(jalon_cloud_knn_all(cloud, 4, NULL, NULL, NULL), JALON_OK);
  jalon_fields* cells = NULL;
  jalon_array_view view;
  assert_int_equal(jalon_cloud_cells(cloud, 3, NULL, &cells), JALON_OK);
  assert_int_equal(jalon_fields_view(cells, "code", &view), JALON_OK);
  assert_int_equal(view.count, 0);
  jalon_fields_release(cells);
  jalon_cloud_release(cloud);
}

int main(void) {
  const struct CMUnitTest tests[] = {
      cmocka_unit_test(knn__equals_brute_force_at_every_level),
      cmocka_unit_test(knn_all__agrees_with_knn),
      cmocka_unit_test(radius_search__finds_the_closed_ball),
      cmocka_unit_test(cells__tile_the_points_in_order),
      cmocka_unit_test(share_octree__gives_one_cube),
      cmocka_unit_test(bad_arguments__are_refused_and_nothing_is_written),
      cmocka_unit_test(empty_cloud__has_no_neighbours),
  };
  return cmocka_run_group_tests(tests, NULL, NULL);
}

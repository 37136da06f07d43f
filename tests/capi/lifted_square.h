/* SPDX-FileCopyrightText: 2026 The Jalon authors
 * SPDX-License-Identifier: Apache-2.0 */
/* A floor of points on a lattice, and the same with a square of it lifted: every distance between them is known. */
#ifndef JALON_TEST_LIFTED_SQUARE_H
#define JALON_TEST_LIFTED_SQUARE_H

#include "support.h"

#include <math.h>

enum { kFloorSide = 41, kFloorPoints = kFloorSide * kFloorSide, kLiftedSide = 17 };
static const double kFloorStep_m = 0.05, kLift_m = 0.25;

static inline int is_lifted(int i) {
  const int column = i % kFloorSide, row = i / kFloorSide;
  return column >= 12 && column < 12 + kLiftedSide && row >= 12 && row < 12 + kLiftedSide;
}

/* 2 x 2 m; lifted: the square from 0.6 to 1.4 m along both axes lies 0.25 m higher. */
static inline jalon_cloud* floor_cloud(int lifted) {
  static double xyz[3 * kFloorPoints];
  for (int i = 0; i < kFloorPoints; ++i) {
    xyz[3 * i] = kFloorStep_m * (i % kFloorSide);
    xyz[3 * i + 1] = kFloorStep_m * (i / kFloorSide);
    xyz[3 * i + 2] = lifted && is_lifted(i) ? kLift_m : 0;
  }
  return cloud_of(xyz, kFloorPoints);
}

static inline jalon_comparison* compared_by(const char* method, const jalon_cloud* reference,
                                            const jalon_cloud* compared) {
  jalon_comparer* comparer = NULL;
  jalon_comparison* comparison = NULL;
  MUST(jalon_comparer_create(method, &comparer));
  MUST(jalon_comparer_run(comparer, reference, compared, NULL, &comparison));
  jalon_comparer_release(comparer);
  return comparison;
}

/* The lifted floor compared with the level one. */
static inline jalon_comparison* lifted_comparison(void) {
  jalon_cloud *before = floor_cloud(0), *after = floor_cloud(1);
  jalon_comparison* comparison = compared_by("distance", before, after);
  jalon_cloud_release(before);
  jalon_cloud_release(after);
  return comparison;
}

static inline jalon_params* options_of(const char* operation, const char* json) {
  jalon_params* options = NULL;
  MUST(jalon_params_create(operation, &options));
  MUST(jalon_params_from_json(options, json));
  return options;
}

/* Element k of row i. */
static inline double cell_of(const jalon_fields* table, const char* name, uint64_t i, uint32_t k) {
  jalon_array_view view;
  MUST(jalon_fields_view(table, name, &view));
  const uint64_t elements = view.count * view.components;
  double* all = malloc((size_t)elements * 8 + 8);
  assert_non_null(all);
  MUST(jalon_fields_copy(table, name, JALON_FLOAT64, all, elements));
  assert_true(i < view.count && k < view.components);
  const double value = all[i * view.components + k];
  free(all);
  return value;
}

static inline uint64_t rows_of(const jalon_fields* table, const char* name) {
  jalon_array_view view;
  MUST(jalon_fields_view(table, name, &view));
  return view.count;
}

/* The message of the last failure holds this. */
static inline void expect_message(const char* part) {
  if (strstr(jalon_last_error_message(), part) == NULL)
    fail_msg("\"%s\" is not in \"%s\"", part, jalon_last_error_message());
}

#endif

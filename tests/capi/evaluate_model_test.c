/* SPDX-FileCopyrightText: 2026 The Jalon authors
 * SPDX-License-Identifier: Apache-2.0 */
#include "support.h"

#include <math.h>

static double value(jalon_fields* fields, const char* name, uint64_t row) {
  double out[64];
  jalon_array_view view;
  MUST(jalon_fields_view(fields, name, &view));
  assert_true(row < view.count && view.count * view.components <= 64);
  MUST(jalon_fields_copy(fields, name, JALON_FLOAT64, out, 64));
  return out[row * view.components];
}

/* An upright wall of 4 x 3 m, this far out and to the right. */
static jalon_model* wall(double out_m, double right_m) {
  const double xyz[12] = {right_m,     -out_m, 0, right_m + 4, -out_m, 0,
                          right_m + 4, -out_m, 3, right_m,     -out_m, 3};
  const uint32_t triangles[6] = {0, 1, 2, 0, 2, 3};
  jalon_model* model = NULL;
  MUST(jalon_model_create_mesh(xyz, JALON_FLOAT64, 4, 0, triangles, 2, NULL, &model));
  return model;
}

static jalon_model* scene(const char* name) {
  jalon_params* options = NULL;
  jalon_model* model = NULL;
  MUST(jalon_params_create("scene", &options));
  MUST(jalon_params_set_string(options, "name", name));
  MUST(jalon_scene_create(options, NULL, &model));
  jalon_params_release(options);
  return model;
}

static void model__against_itself_gives_1_1_0_0_0(void** state) {
  (void)state;
  jalon_model* model = scene("arches");
  jalon_model_evaluation* evaluation = NULL;
  jalon_fields* totals = NULL;
  MUST(jalon_model_evaluate(model, model, NULL, NULL, &evaluation));
  jalon_model_release(model);
  MUST(jalon_model_evaluation_totals(evaluation, &totals));
  assert_true(value(totals, "pairs", 0) > 0 && value(totals, "unmatched_reference", 0) == 0);
  assert_true(value(totals, "total_completeness", 0) == 1 &&
              value(totals, "total_quality", 0) == 1);
  assert_true(value(totals, "total_branching", 0) == 0 && value(totals, "total_miss", 0) == 0);
  assert_true(value(totals, "total_failure", 0) == 0 && value(totals, "max_distance", 0) == 0);
  jalon_fields_release(totals);
  jalon_model_evaluation_release(evaluation);
}

static void model__tables_tell_a_moved_wall(void** state) {
  (void)state;
  jalon_model *found = wall(0.02, 0.05), *truth = wall(0, 0);
  jalon_model_evaluation* evaluation = NULL;
  jalon_fields *pairs = NULL, *automatic = NULL, *vertices = NULL;
  MUST(jalon_model_evaluate(found, truth, NULL, NULL, &evaluation));
  MUST(jalon_model_evaluation_pairs(evaluation, &pairs));
  MUST(jalon_model_evaluation_automatic(evaluation, &automatic));
  MUST(jalon_model_evaluation_vertices(evaluation, &vertices));
  jalon_model_evaluation_release(evaluation);
  assert_true(fabs(value(pairs, "completeness", 0) - 3.95 / 4) < 1e-9);
  assert_true(fabs(value(pairs, "branching", 0) - 0.05 / 3.95) < 1e-9);
  assert_true(fabs(value(pairs, "distance", 0) - 0.02) < 1e-9);
  assert_true(fabs(value(pairs, "hausdorff", 0) - 0.05) < 1e-9);
  assert_true(value(automatic, "merged", 0) == 2 && value(automatic, "partner", 0) == 0);
  assert_true(fabs(value(vertices, "along", 3) - 0.05) < 1e-9 &&
              fabs(value(vertices, "out", 3) - 0.02) < 1e-9);
  jalon_fields_release(pairs), jalon_fields_release(automatic), jalon_fields_release(vertices);
  jalon_params* options = NULL;
  MUST(jalon_params_create("model_evaluation", &options));
  MUST(jalon_params_set_string(options, "mode", "relative"));
  MUST(jalon_model_evaluate(found, truth, options, NULL, &evaluation));
  MUST(jalon_model_evaluation_totals(evaluation, &pairs));
  assert_true(fabs(value(pairs, "shift", 0) + 0.05) < 1e-9);
  assert_true(value(pairs, "total_quality", 0) == 1);
  jalon_fields_release(pairs);
  jalon_model_evaluation_release(evaluation);
  REFUSED(JALON_ERROR_INVALID_ARGUMENT, jalon_params_set_string(options, "mode", "both"));
  jalon_params_release(options);
  jalon_model_release(found), jalon_model_release(truth);
}

static void indices__reproduce_a_printed_row(void** state) {
  (void)state;
  /* Boulaassal 2010, table 5.7, rows 5 and 7. */
  const double a[2] = {0.65, 4.80}, r[2] = {0.73, 4.49}, i[2] = {0.60, 4.34};
  jalon_fields *rows = NULL, *totals = NULL;
  MUST(jalon_area_indices(a, r, i, 2, NULL, &rows, &totals));
  assert_true(fabs(value(rows, "completeness", 0) - 0.822) < 5e-4);
  assert_true(fabs(value(rows, "branching", 0) - 0.083) < 5e-4);
  assert_true(fabs(value(rows, "miss", 0) - 0.217) < 5e-4);
  assert_true(fabs(value(totals, "mean_quality", 0) - (0.769 + 0.877) / 2) < 5e-4);
  jalon_fields_release(rows), jalon_fields_release(totals);
  jalon_params* options = NULL;
  MUST(jalon_params_create("indices", &options));
  MUST(jalon_params_set_string(options, "formulas", "thesis"));
  MUST(jalon_area_indices(a, r, i, 2, options, &rows, NULL));
  assert_true(fabs(value(rows, "branching", 0) - 0.217) < 5e-4); /* as printed: the two swapped */
  jalon_fields_release(rows);
  jalon_params_release(options);
  const double too_much[2] = {0.66, 1};
  REFUSED(JALON_ERROR_INVALID_ARGUMENT, jalon_area_indices(a, r, too_much, 2, NULL, &rows, NULL));
}

static void indices__of_polygons_take_holes_by_their_sense(void** state) {
  (void)state;
  /* A wall of 4 x 3 m with a window of 1 x 1 m, found 0.1 m too far to the right and without its window. */
  const double truth[16] = {0, 0, 4, 0, 4, 3, 0, 3, 1, 1, 1, 2, 2, 2, 2, 1};
  const double found[8] = {0.1, 0, 4.1, 0, 4.1, 3, 0.1, 3};
  const uint64_t truth_rings[2] = {4, 4}, found_rings[1] = {4};
  jalon_fields* rows = NULL;
  MUST(jalon_polygon_indices(found, found_rings, 1, truth, truth_rings, 2, NULL, &rows));
  assert_true(fabs(value(rows, "area_reference", 0) - 11) < 1e-9);
  assert_true(fabs(value(rows, "intersection", 0) - (3.9 * 3 - 1)) < 1e-9);
  assert_true(fabs(value(rows, "excess", 0) - 1.3) < 1e-9 &&
              fabs(value(rows, "deficit", 0) - 0.3) < 1e-9);
  jalon_fields_release(rows);
  MUST(jalon_polygon_indices(truth, truth_rings, 2, truth, truth_rings, 2, NULL, &rows));
  assert_true(value(rows, "quality", 0) == 1 && value(rows, "branching", 0) == 0);
  jalon_fields_release(rows);
  const double nowhere[2] = {NAN, 0};
  const uint64_t one[1] = {1};
  REFUSED(JALON_ERROR_INVALID_ARGUMENT,
          jalon_polygon_indices(nowhere, one, 1, NULL, NULL, 0, NULL, &rows));
}

static void deviations__tell_bias_and_spread_per_axis(void** state) {
  (void)state;
  const double found[6] = {1.03, 2, 3, 4.01, 5, 6.02}, truth[6] = {1, 2, 3, 4, 5, 6};
  jalon_fields *rows = NULL, *totals = NULL;
  MUST(jalon_vertex_deviations(found, truth, 2, &rows, &totals));
  assert_true(fabs(value(rows, "dx", 0) - 0.03) < 1e-12 &&
              fabs(value(rows, "dz", 1) - 0.02) < 1e-12);
  assert_true(isnan(value(rows, "along", 0)));
  assert_true(fabs(value(totals, "mean_dx", 0) - 0.02) < 1e-12);
  assert_true(fabs(value(totals, "std_dx", 0) - sqrt(2e-4)) < 1e-12);
  assert_true(fabs(value(totals, "rms_dx", 0) - sqrt(5e-4)) < 1e-12);
  assert_true(fabs(value(totals, "max_distance", 0) - 0.03) < 1e-12);
  jalon_fields_release(rows), jalon_fields_release(totals);
  MUST(jalon_vertex_deviations(NULL, NULL, 0, NULL, &totals));
  assert_true(isnan(value(totals, "mean_dx", 0)));
  jalon_fields_release(totals);
}

int main(void) {
  const struct CMUnitTest tests[] = {
      cmocka_unit_test(model__against_itself_gives_1_1_0_0_0),
      cmocka_unit_test(model__tables_tell_a_moved_wall),
      cmocka_unit_test(indices__reproduce_a_printed_row),
      cmocka_unit_test(indices__of_polygons_take_holes_by_their_sense),
      cmocka_unit_test(deviations__tell_bias_and_spread_per_axis),
  };
  return cmocka_run_group_tests(tests, NULL, NULL);
}

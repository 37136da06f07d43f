/* SPDX-FileCopyrightText: 2026 The Jalon authors
 * SPDX-License-Identifier: Apache-2.0 */
/* Regions, changes and outlines of a lifted square and of a slab that came, whose measures are known. */
#include "lifted_square.h"

static const char* const kHalfLift = "{\"criterion\": \"threshold\", \"threshold_m\": 0.1}";

static void regions__of_a_lifted_square_have_its_measures(void** state) {
  (void)state;
  jalon_comparison* comparison = lifted_comparison();
  jalon_params* options = options_of("regions", kHalfLift);
  jalon_fields *points = NULL, *regions = NULL;
  MUST(jalon_comparison_regions(comparison, options, NULL, &points, &regions));
  assert_int_equal(rows_of(points, "changed"), kFloorPoints);
  for (int i = 0; i < kFloorPoints; ++i) {
    assert_int_equal(cell_of(points, "changed", (uint64_t)i, 0), is_lifted(i));
    assert_int_equal(cell_of(points, "region", (uint64_t)i, 0), is_lifted(i));
  }
  assert_int_equal(rows_of(regions, "region"), 1);
  assert_int_equal(cell_of(regions, "points", 0, 0), kLiftedSide * kLiftedSide);
  const char* const lengths[] = {"mean", "rms", "extreme"};
  for (int k = 0; k < 3; ++k)
    assert_true(fabs(cell_of(regions, lengths[k], 0, 0) - kLift_m) < 1e-12);
  const double low[3] = {0.6, 0.6, 0.25}, high[3] = {1.4, 1.4, 0.25}, middle[3] = {1, 1, 0.25};
  for (uint32_t k = 0; k < 3; ++k) { /* rounding of seventeen steps */
    assert_true(fabs(cell_of(regions, "box_min", 0, k) - low[k]) < 1e-12);
    assert_true(fabs(cell_of(regions, "box_max", 0, k) - high[k]) < 1e-12);
    assert_true(fabs(cell_of(regions, "centroid", 0, k) - middle[k]) < 1e-12);
  }
  /* Between the square of the points and the one with half a step around it, and as much beside the discs. */
  const double area = cell_of(regions, "area", 0, 0);
  assert_true(area > 0.8 * 0.8 * 0.85 && area < 0.85 * 0.85 * 1.15);
  assert_true(fabs(cell_of(regions, "volume", 0, 0) - area * kLift_m) < 1e-6);
  jalon_fields_release(points), jalon_fields_release(regions);
  /* Nothing beyond the threshold is a result: a table without rows. */
  MUST(jalon_params_set_double(options, "threshold_m", 0.3));
  MUST(jalon_comparison_regions(comparison, options, NULL, NULL, &regions));
  assert_int_equal(rows_of(regions, "region"), 0);
  jalon_fields_release(regions);
  jalon_params_release(options);
  jalon_comparison_release(comparison);
}

static void regions__that_cannot_be_told_are_refused_and_nothing_is_written(void** state) {
  (void)state;
  jalon_comparison* comparison = lifted_comparison();
  jalon_params *options = options_of("regions", "{\"criterion\": \"significance\"}"),
               *wrong = options_of("diagnosis", "{}");
  jalon_fields *points = NULL, *regions = NULL;
  REFUSED(JALON_ERROR_INVALID_ARGUMENT,
          jalon_comparison_regions(comparison, options, NULL, &points, &regions));
  REFUSED(JALON_ERROR_INVALID_ARGUMENT,
          jalon_comparison_regions(comparison, wrong, NULL, &points, &regions));
  REFUSED(JALON_ERROR_INVALID_ARGUMENT,
          jalon_comparison_regions(NULL, NULL, NULL, &points, &regions));
  expect_message("comparison is NULL");
  REFUSED(JALON_ERROR_INVALID_ARGUMENT,
          jalon_comparison_diagnose(comparison, NULL, NULL, NULL, &points, NULL, &regions));
  expect_message("reverse is NULL");
  assert_true(points == NULL && regions == NULL);
  MUST(jalon_comparison_regions(comparison, NULL, NULL, NULL, NULL));
  jalon_params_release(options), jalon_params_release(wrong);
  jalon_comparison_release(comparison);
}

static void changes__a_slab_that_came_appeared_and_the_other_way_round_disappeared(void** state) {
  (void)state;
  jalon_cloud *before = floor_cloud(0), *lifted = floor_cloud(1), *high = NULL, *after = NULL;
  const jalon_box upper = {{-1, -1, 0.1}, {3, 3, 1}};
  const jalon_transform up = {{1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0.25}};
  jalon_cloud* slab = NULL;
  MUST(jalon_cloud_crop_box(lifted, &upper, NULL, NULL, &high, NULL));
  MUST(jalon_cloud_transform(high, &up, NULL, &slab));
  MUST(jalon_cloud_append(before, slab, NULL, &after));
  jalon_comparison *forward = compared_by("distance", before, after),
                   *reverse = compared_by("distance", after, before);
  jalon_params* options = options_of("diagnosis", kHalfLift);
  for (int way = 0; way < 2; ++way) {
    jalon_fields *changes = NULL, *points = NULL;
    MUST(jalon_comparison_diagnose(way == 0 ? forward : reverse, way == 0 ? reverse : forward,
                                   options, NULL, way == 0 ? &points : NULL,
                                   way == 0 ? NULL : &points, &changes));
    assert_int_equal(rows_of(changes, "class"), 1);
    assert_int_equal(cell_of(changes, "class", 0, 0),
                     way == 0 ? JALON_CHANGE_APPEARANCE : JALON_CHANGE_DISAPPEARANCE);
    assert_int_equal(cell_of(changes, way == 0 ? "points_after" : "points_before", 0, 0),
                     kLiftedSide * kLiftedSide);
    const char* const centre = way == 0 ? "centroid_after" : "centroid_before";
    assert_true(fabs(cell_of(changes, centre, 0, 2) - 0.5) < 1e-12);
    assert_true(isnan(cell_of(changes, "displacement", 0, 0)));
    const double confidence = cell_of(changes, "confidence", 0, 0);
    assert_true(confidence > 0 && confidence <= 1);
    /* The points of the later cloud: floor first, then the slab. */
    assert_int_equal(rows_of(points, "change"), kFloorPoints + kLiftedSide * kLiftedSide);
    assert_int_equal(cell_of(points, "change", 0, 0), 0);
    assert_int_equal(cell_of(points, "change", kFloorPoints, 0), 1);
    jalon_fields_release(points), jalon_fields_release(changes);
  }
  jalon_params_release(options);
  jalon_comparison_release(forward), jalon_comparison_release(reverse);
  jalon_cloud_release(before), jalon_cloud_release(after), jalon_cloud_release(lifted);
  jalon_cloud_release(high), jalon_cloud_release(slab);
}

static void outlines__of_the_square_are_one_face_through_its_outermost_points(void** state) {
  (void)state;
  jalon_comparison* comparison = lifted_comparison();
  jalon_params* options = options_of("regions", kHalfLift);
  jalon_fields *points = NULL, *regions = NULL, *faces = NULL;
  jalon_model* model = NULL;
  MUST(jalon_comparison_regions(comparison, options, NULL, &points, &regions));
  MUST(jalon_comparison_outlines(comparison, points, NULL, NULL, NULL, NULL, NULL, &model));
  MUST(jalon_model_faces(model, &faces));
  assert_int_equal(rows_of(faces, "area"), 1);
  assert_true(fabs(cell_of(faces, "area", 0, 0) - 0.8 * 0.8) < 1e-9);
  assert_true(fabs(fabs(cell_of(faces, "normal", 0, 2)) - 1) < 1e-9);
  assert_int_equal(cell_of(faces, "id", 0, 0), 1);
  const char *name = NULL, *part_class = NULL;
  MUST(jalon_model_part(model, (uint64_t)cell_of(faces, "part", 0, 0), &name, &part_class, NULL));
  assert_string_equal(name, "region 1");
  assert_string_equal(part_class, "region");
  jalon_model_release(model);
  model = NULL;
  /* A reverse comparison without its table, and a table of something else. */
  REFUSED(JALON_ERROR_INVALID_ARGUMENT, jalon_comparison_outlines(comparison, points, comparison,
                                                                  NULL, NULL, NULL, NULL, &model));
  expect_message("reverse_points is NULL");
  REFUSED(JALON_ERROR_INVALID_ARGUMENT,
          jalon_comparison_outlines(comparison, regions, NULL, NULL, NULL, NULL, NULL, &model));
  assert_null(model);
  jalon_fields_release(points), jalon_fields_release(regions), jalon_fields_release(faces);
  jalon_params_release(options);
  jalon_comparison_release(comparison);
}

int main(void) {
  const struct CMUnitTest tests[] = {
      cmocka_unit_test(regions__of_a_lifted_square_have_its_measures),
      cmocka_unit_test(regions__that_cannot_be_told_are_refused_and_nothing_is_written),
      cmocka_unit_test(changes__a_slab_that_came_appeared_and_the_other_way_round_disappeared),
      cmocka_unit_test(outlines__of_the_square_are_one_face_through_its_outermost_points),
  };
  return cmocka_run_group_tests(tests, NULL, NULL);
}

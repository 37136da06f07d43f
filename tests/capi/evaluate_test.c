/* SPDX-FileCopyrightText: 2026 The Jalon authors
 * SPDX-License-Identifier: Apache-2.0 */
#include "support.h"

#include <math.h>

enum { kSide = 40, kFace = kSide * kSide, kCount = 3 * kFace };

/* Three walls of 2 x 2 m, 1 m behind each other, 2 mm noise; labels in a field of this type. */
static jalon_cloud* walls(const void* labels, int32_t type) {
  static double xyz[3 * kCount];
  for (int i = 0; i < kCount; ++i) {
    xyz[3 * i] = 0.05 * (i % kSide);
    xyz[3 * i + 1] = i / kFace + 0.004 * (uniform(3, (uint64_t)i) - 0.5);
    xyz[3 * i + 2] = 0.05 * (double)(i / kSide % kSide);
  }
  jalon_cloud* cloud = cloud_of(xyz, kCount);
  if (labels != NULL)
    MUST(jalon_cloud_set_field(cloud, "wall", labels, type, 1, kCount, 0, NULL, NULL));
  return cloud;
}

static double value(jalon_fields* fields, const char* name, uint64_t row) {
  static double all[64];
  MUST(jalon_fields_copy(fields, name, JALON_FLOAT64, all, 64));
  return all[row];
}

static jalon_segmentation* segmentation_of(const jalon_cloud* cloud) {
  jalon_segmentation* made = NULL;
  MUST(jalon_segmentation_from_labels(cloud, "wall", NULL, NULL, &made));
  return made;
}

/* Labels 5, -7 and 1000000 for the walls; the second has 100 noise points, the third a few of the first's. */
static int32_t* some_labels(void) {
  static int32_t labels[kCount];
  const int32_t names[3] = {5, -7, 1000000};
  for (int i = 0; i < kCount; ++i) labels[i] = names[i / kFace];
  for (int i = 0; i < 100; ++i) labels[kFace + i] = 0;
  for (int i = 0; i < 10; ++i) labels[i] = 1000000;
  return labels;
}

static void labels__become_segments_with_planes(void** state) {
  (void)state;
  jalon_cloud* cloud = walls(some_labels(), JALON_INT32);
  jalon_segmentation* made = segmentation_of(cloud);
  jalon_fields *segments = NULL, *points = NULL;
  MUST(jalon_segmentation_segments(made, &segments));
  MUST(jalon_segmentation_points(made, &points));
  const double source[3] = {1000000, 5, -7}, inliers[3] = {kFace + 10, kFace - 10, kFace - 100};
  for (uint64_t s = 0; s < 3; ++s) {
    assert_true(value(segments, "label", s) == (double)(s + 1));
    assert_true(value(segments, "source_label", s) == source[s]);
    assert_true(value(segments, "inliers", s) == inliers[s]);
  }
  assert_true(fabs(value(segments, "area", 1) - 4) < 0.5);
  assert_true(fabs(value(segments, "sigma", 1) - 0.004 / sqrt(12)) < 1e-4);
  jalon_array_view label;
  MUST(jalon_fields_view(points, "label", &label));
  assert_true(((const uint32_t*)label.data)[kFace] == 0);
  assert_true(((const uint32_t*)label.data)[kFace - 1] == 2);
  jalon_fields_release(points);
  jalon_fields_release(segments);
  jalon_segmentation_release(made);
  jalon_cloud_release(cloud);
}

static void labels__without_a_plane_keep_their_row(void** state) {
  (void)state;
  static double labels[kCount]; /* whole numbers of a text file's column come as doubles */
  for (int i = 0; i < kCount; ++i) labels[i] = i < 2 ? 3 : i < kSide ? 4 : NAN;
  static double xyz[3 * kCount];
  for (int i = 0; i < kCount; ++i) xyz[3 * i] = 0.1 * i, xyz[3 * i + 1] = 0.2 * i;
  jalon_cloud* cloud = cloud_of(xyz, kCount);
  MUST(jalon_cloud_set_field(cloud, "wall", labels, JALON_FLOAT64, 1, kCount, 0, NULL, NULL));
  jalon_segmentation* made = segmentation_of(cloud);
  jalon_fields* segments = NULL;
  MUST(jalon_segmentation_segments(made, &segments));
  for (uint64_t s = 0; s < 2; ++s) {
    assert_true(isnan(value(segments, "offset", s)));
    assert_true(isnan(value(segments, "area", s)));
    assert_true(value(segments, "orientation", s) == JALON_ORIENTATION_NONE);
  }
  assert_true(value(segments, "inliers", 0) == kSide - 2 && value(segments, "inliers", 1) == 2);
  jalon_fields_release(segments);
  jalon_segmentation_release(made);
  labels[77] = 0.5;
  MUST(jalon_cloud_set_field(cloud, "wall", labels, JALON_FLOAT64, 1, kCount, 0, NULL, NULL));
  REFUSED(JALON_ERROR_INVALID_ARGUMENT,
          jalon_segmentation_from_labels(cloud, "wall", NULL, NULL, &made));
  assert_non_null(strstr(jalon_last_error_message(), "77"));
  REFUSED(JALON_ERROR_NOT_FOUND, jalon_segmentation_from_labels(cloud, "face", NULL, NULL, &made));
  jalon_cloud_release(cloud);
}

static void labels__survive_las_and_ply(void** state) {
  (void)state;
  jalon_cloud* cloud = walls(some_labels(), JALON_INT32);
  jalon_segmentation* made = segmentation_of(cloud);
  jalon_cloud* labelled = NULL;
  MUST(jalon_segmentation_cloud(made, &labelled));
  const char* names[2] = {"labels.las", "labels.ply"};
  for (int f = 0; f < 2; ++f) {
    char path[512];
    snprintf(path, sizeof path, "%s", temporary(names[f]));
    jalon_cloud* back = NULL;
    jalon_segmentation* again = NULL;
    jalon_evaluation* evaluation = NULL;
    jalon_fields* totals = NULL;
    MUST(jalon_cloud_write(labelled, path, NULL, NULL));
    MUST(jalon_cloud_read(path, NULL, NULL, &back));
    MUST(jalon_segmentation_from_labels(back, "label", NULL, NULL, &again));
    MUST(jalon_segmentation_evaluate(made, again, NULL, NULL, &evaluation));
    MUST(jalon_evaluation_totals(evaluation, &totals));
    assert_true(value(totals, "pairs", 0) == 3);
    assert_true(value(totals, "detection", 0) == 1 && value(totals, "accuracy", 0) == 1);
    assert_true(fabs(value(totals, "mean_offset_difference", 0)) < 1e-4);
    jalon_fields_release(totals);
    jalon_evaluation_release(evaluation);
    jalon_segmentation_release(again);
    jalon_cloud_release(back);
    remove(path);
  }
  jalon_cloud_release(labelled);
  jalon_segmentation_release(made);
  jalon_cloud_release(cloud);
}

static void evaluation__has_its_tables_and_outlives_its_inputs(void** state) {
  (void)state;
  jalon_cloud* cloud = walls(some_labels(), JALON_INT32);
  jalon_segmentation* automatic = segmentation_of(cloud);
  static uint8_t truth[kCount];
  for (int i = 0; i < kCount; ++i) truth[i] = (uint8_t)(1 + i / kFace);
  jalon_cloud* true_cloud = walls(truth, JALON_UINT8);
  jalon_segmentation* reference = segmentation_of(true_cloud);
  jalon_evaluation* evaluation = NULL;
  MUST(jalon_segmentation_evaluate(automatic, reference, NULL, NULL, &evaluation));
  jalon_cloud_release(cloud), jalon_cloud_release(true_cloud);
  jalon_segmentation_release(automatic), jalon_segmentation_release(reference);
  jalon_fields *pairs = NULL, *a = NULL, *r = NULL;
  MUST(jalon_evaluation_pairs(evaluation, &pairs));
  MUST(jalon_evaluation_automatic(evaluation, &a));
  MUST(jalon_evaluation_reference(evaluation, &r));
  jalon_evaluation_release(evaluation);
  /* Reference labels 1, 2, 3 are the walls; the automatic ones came as 1000000, 5, -7. */
  const double partner[3] = {2, 3, 1}, intersection[3] = {kFace - 10, kFace - 100, kFace};
  for (uint64_t i = 0; i < 3; ++i) {
    assert_true(value(pairs, "reference", i) == (double)(i + 1));
    assert_true(value(pairs, "automatic", i) == partner[i]);
    assert_true(value(pairs, "intersection", i) == intersection[i]);
    assert_true(value(pairs, "commission", i) == (i == 2 ? 10 : 0));
    assert_true(fabs(value(pairs, "tdr", i) - intersection[i] / kFace) < 1e-15);
    assert_true(value(pairs, "angle", i) < (i == 2 ? 0.1 : 0.001) &&
                value(pairs, "distance", i) < 0.03);
    assert_true(value(r, "partner", i) == partner[i]);
    assert_true(value(r, "kept", i) == 1);
  }
  assert_true(value(a, "source_label", 2) == -7);
  jalon_fields_release(pairs), jalon_fields_release(a), jalon_fields_release(r);
}

static void evaluation__refuses_other_points(void** state) {
  (void)state;
  jalon_cloud* cloud = walls(some_labels(), JALON_INT32);
  const jalon_transform moved = {{1, 0, 0, 0.1, 0, 1, 0, 0, 0, 0, 1, 0}};
  jalon_cloud* other = NULL;
  MUST(jalon_cloud_transform(cloud, &moved, NULL, &other));
  jalon_segmentation *a = segmentation_of(cloud), *b = segmentation_of(other);
  jalon_evaluation* evaluation = NULL;
  REFUSED(JALON_ERROR_INVALID_ARGUMENT, jalon_segmentation_evaluate(a, b, NULL, NULL, &evaluation));
  assert_null(evaluation);
  jalon_segmentation_release(a), jalon_segmentation_release(b);
  jalon_cloud_release(cloud), jalon_cloud_release(other);
}

static void confusion__counts_precision_recall_and_f1(void** state) {
  (void)state;
  /* By hand: truth 1 1 1 1 2 2 2 3 9, given 1 1 1 2 2 2 1 2 1; class 9 is left out. */
  const double xyz[27] = {0};
  const uint8_t truth[9] = {1, 1, 1, 1, 2, 2, 2, 3, 9};
  const float given[9] = {1, 1, 1, 2, 2, 2, 1, 2, 1};
  jalon_cloud* cloud = cloud_of(xyz, 9);
  MUST(jalon_cloud_set_field(cloud, "class", truth, JALON_UINT8, 1, 9, 0, NULL, NULL));
  MUST(jalon_cloud_set_field(cloud, "given", given, JALON_FLOAT32, 1, 9, 0, NULL, NULL));
  jalon_params* options = NULL;
  const double ignored = 9;
  MUST(jalon_params_create("confusion", &options));
  MUST(jalon_params_set_doubles(options, "ignored_classes", &ignored, 1));
  jalon_fields *classes = NULL, *totals = NULL;
  MUST(jalon_cloud_confusion(cloud, "given", "class", options, NULL, &classes, &totals));
  const double matrix[9] = {3, 1, 0, 1, 2, 0, 0, 1, 0}, precision[2] = {0.75, 0.5},
               recall[3] = {0.75, 2.0 / 3, 0};
  for (uint64_t i = 0; i < 9; ++i) assert_true(value(classes, "confusion", i) == matrix[i]);
  for (uint64_t i = 0; i < 2; ++i)
    assert_true(fabs(value(classes, "precision", i) - precision[i]) < 1e-15);
  for (uint64_t i = 0; i < 3; ++i)
    assert_true(fabs(value(classes, "recall", i) - recall[i]) < 1e-15);
  assert_true(isnan(value(classes, "precision", 2))); /* never given */
  assert_true(fabs(value(classes, "f1", 1) - 2 * 0.5 * (2.0 / 3) / (0.5 + 2.0 / 3)) < 1e-15);
  assert_true(value(totals, "points", 0) == 8 && value(totals, "accuracy", 0) == 5.0 / 8);
  const double chance = (4.0 * 4 + 3 * 4 + 1 * 0) / 64;
  assert_true(fabs(value(totals, "kappa", 0) - (5.0 / 8 - chance) / (1 - chance)) < 1e-15);
  jalon_fields_release(classes), jalon_fields_release(totals);
  REFUSED(JALON_ERROR_NOT_FOUND,
          jalon_cloud_confusion(cloud, "none", "class", NULL, NULL, &classes, NULL));
  jalon_params_release(options);
  jalon_cloud_release(cloud);
}

int main(void) {
  const struct CMUnitTest tests[] = {
      cmocka_unit_test(labels__become_segments_with_planes),
      cmocka_unit_test(labels__without_a_plane_keep_their_row),
      cmocka_unit_test(labels__survive_las_and_ply),
      cmocka_unit_test(evaluation__has_its_tables_and_outlives_its_inputs),
      cmocka_unit_test(evaluation__refuses_other_points),
      cmocka_unit_test(confusion__counts_precision_recall_and_f1),
  };
  return cmocka_run_group_tests(tests, NULL, NULL);
}

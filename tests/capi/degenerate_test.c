/* SPDX-FileCopyrightText: 2026 The Jalon authors
 * SPDX-License-Identifier: Apache-2.0 */
/* Clouds that hold no surface, or hardly one: every method, with every value of every choice, ends in the status that
 * its header tells. */
#include "support.h"

#include <math.h>

enum { kMany = 400, kSide = 20 };
static const char* const kMethods[] = {"ransac",   "region_growing",   "raster_growing",
                                       "profiles", "triangle_growing", "split_merge",
                                       "hough"};
static const double kEast = 652000.25, kNorth = 6861000.5;

struct case_ {
  const char* name;
  jalon_status status; /* of every method */
  uint64_t count;
  uint64_t planes; /* most that there can be */
  double xyz[3 * kMany];
};

static void put(struct case_* c, double x, double y, double z) {
  double* p = c->xyz + 3 * c->count++;
  p[0] = kEast + x, p[1] = kNorth + y, p[2] = z;
}

static void fill(struct case_* c, const char* name, jalon_status status, uint64_t planes) {
  c->name = name, c->status = status, c->planes = planes, c->count = 0;
}

/* The clouds; returns how many. */
static int make_cases(struct case_* all) {
  struct case_* c = all;
  fill(c, "no point", JALON_ERROR_INSUFFICIENT_DATA, 0), ++c;
  fill(c, "one point", JALON_ERROR_INSUFFICIENT_DATA, 0), put(c, 0, 0, 0), ++c;
  fill(c, "two points", JALON_ERROR_INSUFFICIENT_DATA, 0), put(c, 0, 0, 0), put(c, 1, 0, 0), ++c;
  fill(c, "three on a line", JALON_ERROR_DEGENERATE, 0);
  for (int i = 0; i < 3; ++i) put(c, i, 2 * i, 3 * i);
  ++c;
  fill(c, "three of a triangle", JALON_OK, 1);
  for (int i = 0; i < 3; ++i) put(c, i == 1, 0, i == 2);
  ++c;
  fill(c, "many on a line", JALON_ERROR_DEGENERATE, 0);
  for (int i = 0; i < kMany; ++i) put(c, 0.01 * i, 0.02 * i, 0.03 * i);
  ++c;
  fill(c, "many equal", JALON_ERROR_DEGENERATE, 0);
  for (int i = 0; i < kMany; ++i) put(c, 0, 0, 0);
  ++c;
  fill(c, "one plane without noise", JALON_OK, 1);
  for (int i = 0; i < kMany; ++i) put(c, 0.1 * (i % kSide), 0, 0.1 * (i / kSide));
  ++c;
  fill(c, "one plane, every point four times", JALON_OK, 1);
  for (int i = 0; i < kMany; ++i) put(c, 0.2 * (i % 10), 0, 0.2 * (i / 10 % 10));
  ++c;
  fill(c, "four places, each a hundred times", JALON_OK, 1);
  for (int i = 0; i < kMany; ++i) put(c, i % 2, 0, i / 2 % 2);
  ++c;
  fill(c, "a plane of 0.1 mm", JALON_OK, 1);
  for (int i = 0; i < kMany; ++i) put(c, 5e-6 * (i % kSide), 0, 5e-6 * (i / kSide));
  ++c;
  fill(c, "a plane of 1000 km", JALON_OK, 1);
  for (int i = 0; i < kMany; ++i) put(c, 5e4 * (i % kSide), 0, 5e4 * (i / kSide));
  return (int)(++c - all);
}

static int kCaseCount;
static struct case_ kCases[16];

static int prepare(void** state) {
  (void)state;
  kCaseCount = make_cases(kCases);
  return kCaseCount > (int)(sizeof kCases / sizeof *kCases);
}

static uint64_t segments_of(const jalon_segmentation* segmentation) {
  jalon_fields* segments;
  jalon_array_view label;
  MUST(jalon_segmentation_segments(segmentation, &segments));
  MUST(jalon_fields_view(segments, "label", &label));
  const uint64_t count = label.count;
  jalon_fields_release(segments);
  return count;
}

/* One run on one cloud; what names the parameters in a message. */
static void run(const jalon_segmenter* segmenter, const struct case_* c, const char* what) {
  jalon_cloud* cloud = cloud_of(c->count > 0 ? c->xyz : NULL, c->count);
  jalon_segmentation* segmentation = NULL;
  const jalon_status status = jalon_segmenter_run(segmenter, cloud, NULL, &segmentation);
  if (status != c->status)
    fail_msg("%s, %s: \"%s\", not \"%s\" (%s)", c->name, what, jalon_status_name(status),
             jalon_status_name(c->status), jalon_last_error_message());
  if (status != JALON_OK) {
    expect_one_line();
    assert_true(segmentation == NULL);
  } else {
    const uint64_t found = segments_of(segmentation);
    if (found > c->planes)
      fail_msg("%s, %s: %llu planes", c->name, what, (unsigned long long)found);
    jalon_segmentation_release(segmentation);
  }
  jalon_cloud_release(cloud);
}

static void run_all(const jalon_segmenter* segmenter, const char* what) {
  for (int i = 0; i < kCaseCount; ++i) run(segmenter, &kCases[i], what);
}

/* Every value of a choice or a switch, the other parameters at their defaults. The clouds have no field of normals. */
static void run_values(jalon_segmenter* segmenter, jalon_params* params,
                       const jalon_param_info* info) {
  char text[400], what[300];
  MUST(jalon_params_reset(params));
  if (info->type == JALON_PARAM_BOOL) {
    for (int value = 0; value < 2; ++value) {
      snprintf(what, sizeof what, "%s = %d", info->name, value);
      MUST(jalon_params_set_bool(params, info->name, value));
      run_all(segmenter, what);
    }
  } else if (info->type == JALON_PARAM_CHOICE) {
    char* rest = text;
    snprintf(text, sizeof text, "%s", info->choices);
    for (char* value = strtok_r(text, "|", &rest); value != NULL;
         value = strtok_r(NULL, "|", &rest)) {
      if (strcmp(value, "field") == 0) continue;
      snprintf(what, sizeof what, "%s = %s", info->name, value);
      MUST(jalon_params_set_string(params, info->name, value));
      run_all(segmenter, what);
    }
  }
}

static void every_method_and_choice__gives_the_documented_status(void** state) {
  (void)state;
  for (size_t m = 0; m < sizeof kMethods / sizeof *kMethods; ++m) {
    jalon_segmenter* segmenter;
    jalon_params* params;
    uint64_t rows;
    MUST(jalon_segmenter_create(kMethods[m], &segmenter));
    MUST(jalon_segmenter_params(segmenter, &params));
    MUST(jalon_params_count(params, &rows));
    run_all(segmenter, kMethods[m]);
    for (uint64_t i = 0; i < rows; ++i) {
      jalon_param_info info = {.struct_size = sizeof info};
      MUST(jalon_params_info(params, i, &info));
      run_values(segmenter, params, &info);
    }
    jalon_params_release(params);
    jalon_segmenter_release(segmenter);
  }
}

static void ransac_with_few_points_asked_for__gives_the_documented_status(void** state) {
  (void)state;
  const char* const kRows[] = {
      "{\"min_points\": 3, \"min_area_m2\": 0}",
      "{\"min_points\": 3, \"min_area_m2\": 0, \"normals\": \"none\", \"sampling\": \"global\"}",
      ("{\"min_points\": 3, \"min_area_m2\": 0, \"normals\": \"none\", \"refit\": false, "
       "\"reassign\": false}"),
      "{\"orientation_order\": \"vertical horizontal inclined parallel\"}",
      "{\"orientation_order\": \"inclined\", \"min_points\": 3}",
      "{\"draws\": 1}",
      "{\"draws\": 500, \"criterion\": \"standard_deviation\"}",
      "{\"max_planes\": 1, \"strip_width_m\": 0.5}",
      "{\"tolerance_from\": \"estimate\", \"tolerance_dof\": 2}",
      "{\"distance_tolerance_m\": 0.00001}",
      "{\"distance_tolerance_m\": 10}",
      "{\"pixel_m\": 100, \"gap_m\": 100, \"merge_gap_m\": 10000}",
      "{\"least_radius_m\": 0}"};
  jalon_segmenter* segmenter;
  jalon_params* params;
  MUST(jalon_segmenter_create("ransac", &segmenter));
  MUST(jalon_segmenter_params(segmenter, &params));
  for (size_t r = 0; r < sizeof kRows / sizeof *kRows; ++r) {
    MUST(jalon_params_reset(params));
    MUST(jalon_params_from_json(params, kRows[r]));
    run_all(segmenter, kRows[r]);
  }
  jalon_params_release(params);
  jalon_segmenter_release(segmenter);
}

static void one_plane__is_found_whole(void** state) {
  (void)state;
  for (size_t m = 0; m < sizeof kMethods / sizeof *kMethods; ++m)
    for (int i = 0; i < kCaseCount; ++i) {
      if (strncmp(kCases[i].name, "one plane", 9) != 0) continue;
      jalon_segmenter* segmenter;
      jalon_segmentation* segmentation;
      jalon_fields* segments;
      jalon_array_view inliers;
      jalon_cloud* cloud = cloud_of(kCases[i].xyz, kCases[i].count);
      MUST(jalon_segmenter_create(kMethods[m], &segmenter));
      MUST(jalon_segmenter_run(segmenter, cloud, NULL, &segmentation));
      MUST(jalon_segmentation_segments(segmentation, &segments));
      MUST(jalon_fields_view(segments, "inliers", &inliers));
      if (inliers.count != 1 || *(const uint64_t*)inliers.data != kMany)
        fail_msg("%s: %s gives %llu planes", kCases[i].name, kMethods[m],
                 (unsigned long long)inliers.count);
      jalon_fields_release(segments);
      jalon_segmentation_release(segmentation);
      jalon_segmenter_release(segmenter);
      jalon_cloud_release(cloud);
    }
}

/* Picks on the points of each cloud: a seed, a polygon, two picks with the normals around, enough for a ball or
 * column. */
static const struct pick_kind {
  int32_t primitive;
  uint64_t picks;
} kKinds[] = {{JALON_PRIMITIVE_PLANE, 1},    {JALON_PRIMITIVE_PLANE, 4},
              {JALON_PRIMITIVE_SPHERE, 2},   {JALON_PRIMITIVE_SPHERE, 4},
              {JALON_PRIMITIVE_CYLINDER, 2}, {JALON_PRIMITIVE_CYLINDER, 3}};

static jalon_status expected_of_pick(const struct case_* c, const struct pick_kind* kind) {
  const int asks_the_points =
      kind->primitive == JALON_PRIMITIVE_PLANE ? kind->picks == 1 : kind->picks == 2;
  /* Four picks in one plane are no ball, three in an upright one no column, whatever the points. */
  if (kind->primitive != JALON_PRIMITIVE_PLANE && !asks_the_points) return JALON_ERROR_DEGENERATE;
  if (asks_the_points && c->count < 3) return JALON_ERROR_INSUFFICIENT_DATA;
  if (asks_the_points && (c->status != JALON_OK || kind->primitive != JALON_PRIMITIVE_PLANE))
    return JALON_ERROR_DEGENERATE;
  if (strncmp(c->name, "one plane", 9) == 0) return JALON_OK;
  if (strcmp(c->name, "four places, each a hundred times") == 0 && asks_the_points)
    return JALON_ERROR_DEGENERATE;
  if (strcmp(c->name, "a plane of 1000 km") == 0 && asks_the_points) return JALON_OK;
  return JALON_ERROR_INSUFFICIENT_DATA;
}

static void picks__gather_too_little_or_fix_no_surface(void** state) {
  (void)state;
  const double kPicks[12] = {kEast,     kNorth, 0, kEast + 1, kNorth, 0,
                             kEast + 1, kNorth, 1, kEast,     kNorth, 1};
  for (int i = 0; i < kCaseCount; ++i) {
    const struct case_* c = &kCases[i];
    jalon_cloud* cloud = cloud_of(c->count > 0 ? c->xyz : NULL, c->count);
    jalon_segmentation* start;
    MUST(jalon_segmentation_start(cloud, NULL, &start));
    assert_int_equal(segments_of(start), 0);
    for (size_t k = 0; k < sizeof kKinds / sizeof *kKinds; ++k) {
      const struct pick_kind* kind = &kKinds[k];
      jalon_segmentation* picked = NULL;
      const jalon_status expected = expected_of_pick(c, kind);
      const jalon_status status =
          jalon_segmentation_pick(start, kind->primitive, kPicks, kind->picks, NULL, NULL, &picked);
      if (status != expected)
        fail_msg("%s, primitive %d, %d picks: \"%s\", not \"%s\" (%s)", c->name,
                 (int)kind->primitive, (int)kind->picks, jalon_status_name(status),
                 jalon_status_name(expected), jalon_last_error_message());
      if (status != JALON_OK) expect_one_line();
      assert_true((picked != NULL) == (status == JALON_OK));
      jalon_segmentation_release(picked);
    }
    jalon_segmentation_release(start);
    jalon_cloud_release(cloud);
  }
}

static void evaluation__of_clouds_without_planes_has_rates_and_no_geometry(void** state) {
  (void)state;
  for (int i = 0; i < kCaseCount; ++i) {
    const struct case_* c = &kCases[i];
    jalon_cloud* cloud = cloud_of(c->count > 0 ? c->xyz : NULL, c->count);
    uint32_t labels[kMany];
    for (int k = 0; k < kMany; ++k) labels[k] = 7;
    jalon_segmentation* reference;
    jalon_evaluation* evaluation;
    jalon_fields *totals, *pairs;
    jalon_array_view rate, angle;
    MUST(jalon_cloud_set_field(cloud, "label", labels, JALON_UINT32, 1, c->count, 0, NULL, NULL));
    MUST(jalon_segmentation_from_labels(cloud, "label", NULL, NULL, &reference));
    assert_int_equal(segments_of(reference), c->count > 0);
    MUST(jalon_segmentation_evaluate(reference, reference, NULL, NULL, &evaluation));
    MUST(jalon_evaluation_totals(evaluation, &totals));
    MUST(jalon_evaluation_pairs(evaluation, &pairs));
    MUST(jalon_fields_view(totals, "global_tdr", &rate));
    MUST(jalon_fields_view(pairs, "angle", &angle));
    assert_int_equal(angle.count, c->count > 0);
    if (c->count == 0) {
      assert_true(isnan(*(const double*)rate.data));
    } else {
      assert_true(*(const double*)rate.data == 1);
      const double radians = *(const double*)angle.data;
      if (c->status != JALON_OK ? !isnan(radians) : !(fabs(radians) < 1e-6))
        fail_msg("%s: angle %g", c->name, radians);
    }
    jalon_fields_release(totals);
    jalon_fields_release(pairs);
    jalon_evaluation_release(evaluation);
    jalon_segmentation_release(reference);
    jalon_cloud_release(cloud);
  }
}

static void nan__never_becomes_a_cloud(void** state) {
  (void)state;
  double xyz[9] = {0, 0, 0, 1, 0, 0, 0, 1, 0};
  jalon_cloud* cloud = NULL;
  for (int k = 0; k < 9; ++k) {
    const double before = xyz[k];
    for (int sign = -1; sign <= 1; ++sign) {
      xyz[k] = sign == 0 ? NAN : sign * INFINITY;
      REFUSED(JALON_ERROR_INVALID_ARGUMENT,
              jalon_cloud_create(xyz, JALON_FLOAT64, 3, 0, 0, &cloud));
      assert_true(cloud == NULL);
    }
    xyz[k] = before;
  }
}

int main(void) {
  const struct CMUnitTest tests[] = {
      cmocka_unit_test(every_method_and_choice__gives_the_documented_status),
      cmocka_unit_test(ransac_with_few_points_asked_for__gives_the_documented_status),
      cmocka_unit_test(one_plane__is_found_whole),
      cmocka_unit_test(picks__gather_too_little_or_fix_no_surface),
      cmocka_unit_test(evaluation__of_clouds_without_planes_has_rates_and_no_geometry),
      cmocka_unit_test(nan__never_becomes_a_cloud),
  };
  return cmocka_run_group_tests(tests, prepare, NULL);
}

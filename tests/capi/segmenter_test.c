/* SPDX-FileCopyrightText: 2026 The Jalon authors
 * SPDX-License-Identifier: Apache-2.0 */
#include "support.h"

#include <math.h>

enum { kSide = 60, kCount = 2 * kSide * kSide };

/* A wall y = 0 and a floor z = 0, 3 x 3 m each, 2 mm noise. */
static jalon_cloud* corner_cloud(void) {
  static double xyz[3 * kCount];
  for (int i = 0; i < kSide * kSide; ++i) {
    const double a = 3.0 * (i % kSide) / kSide, b = 3.0 * (double)(i / kSide) / kSide + 0.05;
    const double wall[3] = {a, 0.004 * (uniform(1, (uint64_t)i) - 0.5), b};
    const double floor_[3] = {a, -b, 0.004 * (uniform(2, (uint64_t)i) - 0.5)};
    memcpy(xyz + 6 * i, wall, sizeof wall);
    memcpy(xyz + 6 * i + 3, floor_, sizeof floor_);
  }
  jalon_cloud* cloud = NULL;
  MUST(jalon_cloud_create(xyz, JALON_FLOAT64, kCount, 0, 0, &cloud));
  return cloud;
}

static jalon_segmentation* segment_by(const char* method, const jalon_cloud* cloud) {
  jalon_segmenter* segmenter = NULL;
  jalon_segmentation* segmentation = NULL;
  MUST(jalon_segmenter_create(method, &segmenter));
  MUST(jalon_segmenter_run(segmenter, cloud, NULL, &segmentation));
  jalon_segmenter_release(segmenter);
  return segmentation;
}

static jalon_segmentation* segment(const jalon_cloud* cloud) { return segment_by(NULL, cloud); }

static void segmenter__finds_two_planes_with_their_tables(void** state) {
  (void)state;
  jalon_cloud* cloud = corner_cloud();
  jalon_segmentation* segmentation = segment(cloud);
  jalon_cloud_release(cloud); /* the result keeps it */
  jalon_fields *points = NULL, *segments = NULL;
  MUST(jalon_segmentation_points(segmentation, &points));
  MUST(jalon_segmentation_segments(segmentation, &segments));
  jalon_array_view label, residual, orientation, normal, offset, inliers, covariance;
  MUST(jalon_fields_view(points, "label", &label));
  MUST(jalon_fields_view(points, "residual", &residual));
  MUST(jalon_fields_view(points, "orientation", &orientation));
  assert_int_equal(label.count, kCount);
  assert_int_equal(label.type, JALON_UINT32);
  assert_int_equal(residual.type, JALON_FLOAT32);
  assert_int_equal(orientation.type, JALON_UINT8);
  MUST(jalon_fields_view(segments, "normal", &normal));
  MUST(jalon_fields_view(segments, "offset", &offset));
  MUST(jalon_fields_view(segments, "inliers", &inliers));
  MUST(jalon_fields_view(segments, "covariance", &covariance));
  assert_int_equal(normal.count, 2);
  assert_int_equal(normal.components, 3);
  assert_int_equal(covariance.components, 16);
  const uint64_t* n = inliers.data;
  assert_true(n[0] >= n[1]);
  assert_true(n[0] + n[1] == kCount);
  const double *m = normal.data, *d = offset.data;
  for (int s = 0; s < 2; ++s) {
    assert_true(fabs(d[s]) < 1e-3);
    assert_true(fabs(m[3 * s + 1]) > 0.9999 || m[3 * s + 2] > 0.9999); /* the floor looks up */
  }
  const char* names[] = {"label",
                         "type",
                         "orientation",
                         "centroid",
                         "radius",
                         "axis_u",
                         "axis_v",
                         "sigma",
                         "area",
                         "length_u",
                         "length_v",
                         "front_source",
                         "front_confidence",
                         "cylinder_covariance"};
  for (size_t i = 0; i < sizeof names / sizeof *names; ++i) {
    jalon_array_view view;
    MUST(jalon_fields_view(segments, names[i], &view));
    assert_int_equal(view.count, 2);
  }
  jalon_array_view type, radius;
  MUST(jalon_fields_view(segments, "type", &type));
  MUST(jalon_fields_view(segments, "radius", &radius));
  assert_int_equal(((const uint8_t*)type.data)[1], JALON_PRIMITIVE_PLANE);
  assert_true(isnan(((const double*)radius.data)[1]));
  jalon_cloud* labelled = NULL;
  MUST(jalon_segmentation_cloud(segmentation, &labelled));
  jalon_fields* fields = NULL;
  MUST(jalon_cloud_fields(labelled, &fields));
  jalon_array_view again;
  MUST(jalon_fields_view(fields, "label", &again));
  assert_true(memcmp(again.data, label.data, kCount * sizeof(uint32_t)) == 0);
  jalon_transform frame;
  MUST(jalon_segmentation_facade_frame(segmentation, &frame));
  assert_true(fabs(fabs(frame.m[5]) - 1) < 1e-3); /* the wall lies along X already */
  jalon_fields_release(fields);
  jalon_cloud_release(labelled);
  jalon_fields_release(points);
  jalon_fields_release(segments);
  jalon_segmentation_release(segmentation);
}

/* The corner's wall without a station and with one on either side. */
static void segmenter__tells_what_the_side_of_a_normal_was_taken_from(void** state) {
  (void)state;
  jalon_cloud* cloud = corner_cloud();
  double side[3] = {0, -5, 5};
  for (int k = 0; k < 3; ++k) {
    jalon_transform pose = {{1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0}};
    pose.m[3] = 1;
    pose.m[7] = side[k];
    pose.m[11] = 1;
    if (k > 0) MUST(jalon_cloud_set_station(cloud, "station", &pose));
    jalon_segmentation* segmentation = segment(cloud);
    jalon_fields* segments = NULL;
    MUST(jalon_segmentation_segments(segmentation, &segments));
    jalon_array_view normal, source, confidence;
    MUST(jalon_fields_view(segments, "normal", &normal));
    MUST(jalon_fields_view(segments, "front_source", &source));
    MUST(jalon_fields_view(segments, "front_confidence", &confidence));
    assert_int_equal(source.type, JALON_UINT8);
    assert_int_equal(confidence.type, JALON_FLOAT64);
    for (uint64_t s = 0; s < source.count; ++s) {
      const double* n = (const double*)normal.data + 3 * s;
      const int told = ((const uint8_t*)source.data)[s];
      const double p = ((const double*)confidence.data)[s];
      if (k > 0) {
        assert_int_equal(told, JALON_FRONT_STATION);
        assert_true(p == 1);
        if (fabs(n[1]) > 0.9) assert_true(n[1] * side[k] > 0);
      } else if (told == JALON_FRONT_EVIDENCE) {
        assert_true(fabs(n[1]) > 0.9 && p >= 0.5 && p <= 1);
      } else {
        assert_int_equal(told, JALON_FRONT_NONE);
        assert_true(isnan(p));
      }
    }
    jalon_fields_release(segments);
    jalon_segmentation_release(segmentation);
  }
  jalon_cloud_release(cloud);
}

static void segmenter__tells_parameters_and_distribution(void** state) {
  (void)state;
  jalon_cloud* cloud = corner_cloud();
  jalon_segmenter* segmenter = NULL;
  jalon_params* params = NULL;
  jalon_segmentation* segmentation = NULL;
  MUST(jalon_segmenter_create("ransac", &segmenter));
  MUST(jalon_segmenter_params(segmenter, &params));
  MUST(jalon_params_set_string(params, "tolerance_from", "sigma"));
  MUST(jalon_params_set_double(params, "sigma_m", 0.005));
  MUST(jalon_params_set_int64(params, "tolerance_dof", 2));
  MUST(jalon_segmenter_run(segmenter, cloud, NULL, &segmentation));
  const char* json = NULL;
  MUST(jalon_segmentation_parameters(segmentation, &json));
  assert_non_null(strstr(json, "\"distance_tolerance_m\":0.01517")); /* sqrt(9.21) x 5 mm */
  jalon_fields *bins = NULL, *normal = NULL;
  MUST(jalon_segmentation_residuals(segmentation, 0, 20, NULL, &bins, &normal));
  jalon_array_view count, expected, sigma, total, kurtosis;
  MUST(jalon_fields_view(bins, "count", &count));
  MUST(jalon_fields_view(bins, "expected", &expected));
  MUST(jalon_fields_view(normal, "sigma", &sigma));
  MUST(jalon_fields_view(normal, "count", &total));
  MUST(jalon_fields_view(normal, "excess_kurtosis", &kurtosis));
  assert_int_equal(count.count, 20);
  assert_int_equal(expected.type, JALON_FLOAT64);
  assert_int_equal(total.count, 1);
  uint64_t sum = 0;
  for (int i = 0; i < 20; ++i) sum += ((const uint64_t*)count.data)[i];
  assert_true(sum == *(const uint64_t*)total.data);
  /* The noise is even over 4 mm: sigma 4 / sqrt(12), flat. */
  assert_true(fabs(*(const double*)sigma.data - 0.004 / sqrt(12)) < 2e-5);
  assert_true(*(const double*)kurtosis.data < -1);
  jalon_fields *kept = bins, *kept_normal = normal;
  assert_int_equal(jalon_segmentation_residuals(segmentation, 3, 20, NULL, &bins, &normal),
                   JALON_ERROR_NOT_FOUND);
  assert_int_equal(jalon_segmentation_residuals(segmentation, 1, 0, NULL, &bins, &normal),
                   JALON_ERROR_INVALID_ARGUMENT);
  assert_ptr_equal(bins, kept);
  assert_ptr_equal(normal, kept_normal);
  jalon_fields_release(bins);
  jalon_fields_release(normal);
  jalon_segmentation_release(segmentation);
  jalon_params_release(params);
  jalon_segmenter_release(segmenter);
  jalon_cloud_release(cloud);
}

static void segmenter__shares_its_parameters(void** state) {
  (void)state;
  jalon_segmenter* segmenter = NULL;
  jalon_params *one = NULL, *two = NULL;
  MUST(jalon_segmenter_create("ransac", &segmenter));
  MUST(jalon_segmenter_params(segmenter, &one));
  MUST(jalon_segmenter_params(segmenter, &two));
  MUST(jalon_params_set_double(one, "min_area_m2", 100));
  double value = 0;
  MUST(jalon_params_get_double(two, "min_area_m2", &value));
  assert_true(value == 100);
  REFUSED(JALON_ERROR_INVALID_ARGUMENT, jalon_params_set_double(one, "distance_tolerance_m", 0));
  REFUSED(JALON_ERROR_NOT_FOUND, jalon_params_set_double(one, "tolerance", 1));
  jalon_cloud* cloud = corner_cloud();
  jalon_segmentation* segmentation = NULL;
  /* nothing is 100 m2 large: a success without segments */
  MUST(jalon_segmenter_run(segmenter, cloud, NULL, &segmentation));
  jalon_fields* segments = NULL;
  MUST(jalon_segmentation_segments(segmentation, &segments));
  jalon_array_view view;
  MUST(jalon_fields_view(segments, "label", &view));
  assert_int_equal(view.count, 0);
  jalon_fields_release(segments);
  jalon_segmentation_release(segmentation);
  jalon_cloud_release(cloud);
  jalon_params_release(one);
  jalon_params_release(two);
  jalon_segmenter_release(segmenter);
}

static const char* const kMethods[] = {
    "ransac",      "region_growing", "raster_growing", "profiles",     "triangle_growing",
    "split_merge", "hough",          "scan_lines",     "survey_codes", "target_codes"};
enum { kMethodCount = sizeof kMethods / sizeof *kMethods };

static void segmenter__grows_the_same_two_planes(void** state) {
  (void)state;
  jalon_cloud* cloud = corner_cloud();
  jalon_segmentation* segmentation = segment_by("region_growing", cloud);
  jalon_fields* segments = NULL;
  jalon_array_view normal, inliers;
  MUST(jalon_segmentation_segments(segmentation, &segments));
  MUST(jalon_fields_view(segments, "normal", &normal));
  MUST(jalon_fields_view(segments, "inliers", &inliers));
  assert_int_equal(normal.count, 2);
  const double* m = normal.data;
  for (int s = 0; s < 2; ++s) assert_true(fabs(m[3 * s + 1]) > 0.9999 || m[3 * s + 2] > 0.9999);
  const uint64_t* n = inliers.data;
  assert_true(n[0] + n[1] == kCount);
  jalon_fields_release(segments);
  jalon_segmentation_release(segmentation);
  jalon_cloud_release(cloud);
}

static void segmenter__each_method_has_its_own_parameters(void** state) {
  (void)state;
  jalon_segmenter* segmenter = NULL;
  jalon_params* params = NULL;
  double tolerance = 0;
  int64_t k = 0;
  MUST(jalon_segmenter_create("region_growing", &segmenter));
  MUST(jalon_segmenter_params(segmenter, &params));
  MUST(jalon_params_get_double(params, "distance_tolerance_m", &tolerance));
  MUST(jalon_params_get_int64(params, "k", &k));
  assert_true(tolerance == 0.025 && k == 16);
  REFUSED(JALON_ERROR_NOT_FOUND, jalon_params_set_double(params, "probability", 0.9));
  REFUSED(JALON_ERROR_INVALID_ARGUMENT, jalon_params_set_int64(params, "k", 3));
  /* the field "normal" is asked for and not there */
  jalon_cloud* cloud = corner_cloud();
  jalon_segmentation* segmentation = NULL;
  MUST(jalon_params_set_string(params, "normals", "field"));
  REFUSED(JALON_ERROR_NOT_FOUND, jalon_segmenter_run(segmenter, cloud, NULL, &segmentation));
  jalon_cloud_release(cloud);
  jalon_params_release(params);
  jalon_segmenter_release(segmenter);
}

static void segmenter__codes_give_classes_objects_and_notes(void** state) {
  (void)state;
  jalon_segmenter* segmenter = NULL;
  jalon_params* params = NULL;
  jalon_segmentation* segmentation = NULL;
  jalon_cloud *cloud = corner_cloud(), *coded = NULL;
  const char* notes = NULL;
  MUST(jalon_segmenter_create("survey_codes", &segmenter));
  MUST(jalon_segmenter_params(segmenter, &params));
  MUST(
      jalon_params_set_string(params, "codes", "4;1;0.001;1;360\n5;2;-0.001;2;360\n6;0;0;0;777\n"));
  MUST(jalon_segmenter_run(segmenter, cloud, NULL, &segmentation));
  MUST(jalon_segmentation_notes(segmentation, &notes));
  assert_non_null(strstr(notes, "\"name\":\"window 4\""));
  assert_non_null(strstr(notes, "unknown code \\\"777\\\""));
  REFUSED(JALON_ERROR_INVALID_ARGUMENT, jalon_segmentation_notes(NULL, &notes));
  REFUSED(JALON_ERROR_INVALID_ARGUMENT, jalon_segmentation_notes(segmentation, NULL));
  MUST(jalon_segmentation_cloud(segmentation, &coded));
  jalon_fields* fields = NULL;
  jalon_array_view classes;
  MUST(jalon_cloud_fields(coded, &fields));
  MUST(jalon_fields_view(fields, "classification", &classes));
  uint64_t windows = 0;
  for (uint64_t i = 0; i < classes.count; ++i) windows += ((const uint8_t*)classes.data)[i] == 3;
  assert_true(windows > 300 && windows < 500);
  jalon_segmentation* planes = segment(cloud);
  MUST(jalon_segmentation_notes(planes, &notes));
  assert_string_equal(notes, "");
  MUST(jalon_params_set_string(params, "codes", "1;0;0;0;360\n2;0;x;0;360\n"));
  jalon_segmentation* none = NULL;
  REFUSED(JALON_ERROR_FORMAT, jalon_segmenter_run(segmenter, cloud, NULL, &none));
  assert_true(none == NULL);
  jalon_segmentation_release(planes);
  jalon_fields_release(fields);
  jalon_cloud_release(coded);
  jalon_segmentation_release(segmentation);
  jalon_cloud_release(cloud);
  jalon_params_release(params);
  jalon_segmenter_release(segmenter);
}

static void refuses_bad_input(const char* method) {
  jalon_segmenter* segmenter = NULL;
  REFUSED(JALON_ERROR_NOT_FOUND, jalon_segmenter_create("magic", &segmenter));
  MUST(jalon_segmenter_create(method, &segmenter));
  const double line[9] = {0, 0, 0, 1, 1, 1, 2, 2, 2};
  jalon_cloud *none = NULL, *two = NULL, *three = NULL;
  MUST(jalon_cloud_create(NULL, JALON_FLOAT64, 0, 0, 0, &none));
  MUST(jalon_cloud_create(line, JALON_FLOAT64, 2, 0, 0, &two));
  MUST(jalon_cloud_create(line, JALON_FLOAT64, 3, 0, 0, &three));
  jalon_segmentation* segmentation = NULL;
  REFUSED(JALON_ERROR_INSUFFICIENT_DATA, jalon_segmenter_run(segmenter, none, NULL, &segmentation));
  REFUSED(JALON_ERROR_INSUFFICIENT_DATA, jalon_segmenter_run(segmenter, two, NULL, &segmentation));
  REFUSED(JALON_ERROR_DEGENERATE, jalon_segmenter_run(segmenter, three, NULL, &segmentation));
  REFUSED(JALON_ERROR_INVALID_ARGUMENT, jalon_segmenter_run(segmenter, NULL, NULL, &segmentation));
  assert_true(segmentation == NULL);
  jalon_cloud_release(none);
  jalon_cloud_release(two);
  jalon_cloud_release(three);
  jalon_segmenter_release(segmenter);
}

static void segmenter__refuses_bad_input(void** state) {
  (void)state;
  for (int i = 0; i < kMethodCount; ++i) refuses_bad_input(kMethods[i]);
}

static void stops_when_cancelled_and_runs_again(const char* method) {
  jalon_task* task = NULL;
  jalon_segmenter* segmenter = NULL;
  jalon_segmentation* segmentation = NULL;
  jalon_cloud* cloud = corner_cloud();
  const jalon_transform pose = {
      {1, 0, 0, 2, 0, 1, 0, -5, 0, 0, 1, 1.5}}; /* scan_lines asks for one */
  MUST(jalon_cloud_set_station(cloud, "tripod", &pose));
  MUST(jalon_task_create(&task));
  MUST(jalon_segmenter_create(method, &segmenter));
  MUST(jalon_task_cancel(task));
  REFUSED(JALON_ERROR_CANCELLED, jalon_segmenter_run(segmenter, cloud, task, &segmentation));
  assert_true(segmentation == NULL);
  MUST(jalon_task_reset(task));
  MUST(jalon_segmenter_run(segmenter, cloud, task, &segmentation));
  jalon_segmentation_release(segmentation);
  jalon_segmenter_release(segmenter);
  jalon_cloud_release(cloud);
  jalon_task_release(task);
}

static void segmenter__stops_when_cancelled_and_runs_again(void** state) {
  (void)state;
  for (int i = 0; i < kMethodCount; ++i) stops_when_cancelled_and_runs_again(kMethods[i]);
}

int main(void) {
  const struct CMUnitTest tests[] = {
      cmocka_unit_test(segmenter__finds_two_planes_with_their_tables),
      cmocka_unit_test(segmenter__tells_what_the_side_of_a_normal_was_taken_from),
      cmocka_unit_test(segmenter__grows_the_same_two_planes),
      cmocka_unit_test(segmenter__tells_parameters_and_distribution),
      cmocka_unit_test(segmenter__shares_its_parameters),
      cmocka_unit_test(segmenter__each_method_has_its_own_parameters),
      cmocka_unit_test(segmenter__codes_give_classes_objects_and_notes),
      cmocka_unit_test(segmenter__refuses_bad_input),
      cmocka_unit_test(segmenter__stops_when_cancelled_and_runs_again),
  };
  return cmocka_run_group_tests(tests, NULL, NULL);
}

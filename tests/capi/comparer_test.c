/* SPDX-FileCopyrightText: 2026 The Jalon authors
 * SPDX-License-Identifier: Apache-2.0 */
#include "support.h"

#include <math.h>

static jalon_cloud* line_of(double shift, uint64_t n) {
  double xyz[300] = {0};
  for (uint64_t i = 0; i < n; ++i) {
    xyz[3 * i] = (double)i;
    xyz[3 * i + 1] = shift;
    xyz[3 * i + 2] = 0;
  }
  jalon_cloud* cloud = NULL;
  MUST(jalon_cloud_create(xyz, JALON_FLOAT64, n, 0, 0, &cloud));
  return cloud;
}

static void comparison__gives_distance_nearest_point_and_status_of_each_point(void** state) {
  (void)state;
  jalon_cloud* reference = line_of(0, 10);
  jalon_cloud* compared = line_of(0.25, 20);
  jalon_comparer* comparer = NULL;
  MUST(jalon_comparer_create(NULL, &comparer));
  jalon_params* params = NULL;
  MUST(jalon_comparer_params(comparer, &params));
  MUST(jalon_params_set_double(params, "max_distance_m", 2));
  jalon_comparison* comparison = NULL;
  MUST(jalon_comparer_run(comparer, reference, compared, NULL, &comparison));
  jalon_params_release(params);
  jalon_comparer_release(comparer);
  jalon_cloud_release(reference);
  jalon_fields* points = NULL;
  MUST(jalon_comparison_points(comparison, &points));
  double distance[20];
  uint8_t status[20];
  uint32_t nearest[20];
  MUST(jalon_fields_copy(points, "distance", JALON_FLOAT64, distance, 20));
  MUST(jalon_fields_copy(points, "status", JALON_UINT8, status, 20));
  MUST(jalon_fields_copy(points, "nearest", JALON_UINT32, nearest, 20));
  for (int i = 0; i < 20; ++i) {
    if (i < 11) {
      assert_int_equal(status[i], JALON_COMPARED);
      assert_int_equal(nearest[i], i < 10 ? i : 9);
      assert_true(fabs(distance[i] - (i < 10 ? 0.25 : sqrt(1.0625))) < 1e-15);
    } else {
      assert_int_equal(status[i], JALON_NOTHING_NEAR);
      assert_true(isnan(distance[i]));
      assert_int_equal(nearest[i], UINT32_MAX);
    }
  }
  jalon_fields_release(points);
  jalon_cloud* coloured = NULL;
  MUST(jalon_comparison_cloud(comparison, &coloured));
  jalon_fields* fields = NULL;
  MUST(jalon_cloud_fields(coloured, &fields));
  jalon_array_view view;
  MUST(jalon_fields_view(fields, "distance", &view));
  assert_int_equal(view.count, 20);
  jalon_fields_release(fields);
  jalon_cloud_release(coloured);
  jalon_comparison_release(comparison);
  jalon_cloud_release(compared);
}

static void comparer__refuses_empty_clouds_and_two_different_crs(void** state) {
  (void)state;
  jalon_cloud* one = line_of(0, 1);
  jalon_cloud* other = line_of(1, 1);
  jalon_cloud* empty = line_of(0, 0);
  jalon_comparer* comparer = NULL;
  MUST(jalon_comparer_create("distance", &comparer));
  jalon_comparison* comparison = NULL;
  assert_int_equal(jalon_comparer_run(comparer, empty, one, NULL, &comparison),
                   JALON_ERROR_INSUFFICIENT_DATA);
  assert_int_equal(jalon_comparer_run(comparer, one, empty, NULL, &comparison),
                   JALON_ERROR_INSUFFICIENT_DATA);
  MUST(jalon_cloud_set_crs(one, "EPSG:2154"));
  MUST(jalon_comparer_run(comparer, one, other, NULL, &comparison));
  jalon_comparison_release(comparison);
  comparison = NULL;
  MUST(jalon_cloud_set_crs(other, "EPSG:2056"));
  assert_int_equal(jalon_comparer_run(comparer, one, other, NULL, &comparison),
                   JALON_ERROR_INVALID_ARGUMENT);
  assert_null(comparison);
  assert_int_equal(jalon_comparer_create("nonsense", &comparer), JALON_ERROR_NOT_FOUND);
  jalon_comparer_release(comparer);
  jalon_cloud_release(one);
  jalon_cloud_release(other);
  jalon_cloud_release(empty);
}

// A level grid of points at 50 mm with a little of everything in z, at the height given.
static jalon_cloud* floor_at(double z) {
  enum { kSide = 40 };
  static double xyz[3 * kSide * kSide];
  for (int i = 0; i < kSide * kSide; ++i) {
    xyz[3 * i] = 0.05 * (i % kSide);
    xyz[3 * i + 1] = 0.05 * (i / kSide);
    xyz[3 * i + 2] = z + 0.002 * sin(12.9898 * i);
  }
  jalon_cloud* cloud = NULL;
  MUST(jalon_cloud_create(xyz, JALON_FLOAT64, kSide * kSide, 0, 0, &cloud));
  return cloud;
}

static void cloud_overlap__tells_clouds_that_lie_apart(void** state) {
  (void)state;
  jalon_cloud *here = floor_at(0), *same = floor_at(0.01), *above = floor_at(40);
  jalon_fields* overlap = NULL;
  jalon_array_view apart, gap, cause;
  MUST(jalon_cloud_overlap(here, same, NULL, &overlap));
  MUST(jalon_fields_view(overlap, "apart", &apart));
  assert_int_equal(*(const uint8_t*)apart.data, 0);
  jalon_fields_release(overlap);
  MUST(jalon_cloud_overlap(here, above, NULL, &overlap));
  MUST(jalon_fields_view(overlap, "apart", &apart));
  MUST(jalon_fields_view(overlap, "gap", &gap));
  MUST(jalon_fields_view(overlap, "cause", &cause));
  assert_int_equal(*(const uint8_t*)apart.data, 1);
  assert_true(fabs(*(const double*)gap.data - 40) < 0.01);
  assert_int_equal(*(const uint8_t*)cause.data, JALON_APART_ORIGIN);
  jalon_fields_release(overlap);
  jalon_cloud_release(here), jalon_cloud_release(same), jalon_cloud_release(above);
}

static void comparer_preview__and_closest_points_of_a_line(void** state) {
  (void)state;
  jalon_cloud *reference = line_of(0, 10), *compared = line_of(0.25, 4), *closest = NULL;
  jalon_comparer* comparer = NULL;
  jalon_comparison* comparison = NULL;
  MUST(jalon_comparer_create("preview", &comparer));
  MUST(jalon_comparer_run(comparer, reference, compared, NULL, &comparison));
  jalon_comparer_release(comparer);
  assert_int_equal(jalon_comparison_closest_points(comparison, reference, NULL, &closest),
                   JALON_ERROR_NOT_FOUND);
  jalon_comparison_release(comparison);
  MUST(jalon_comparer_create("distance", &comparer));
  MUST(jalon_comparer_run(comparer, reference, compared, NULL, &comparison));
  jalon_comparer_release(comparer);
  MUST(jalon_comparison_closest_points(comparison, reference, NULL, &closest));
  uint64_t count = 0;
  MUST(jalon_cloud_count(closest, &count));
  assert_int_equal(count, 4);
  jalon_cloud_release(closest);
  jalon_comparison_release(comparison);
  jalon_cloud_release(reference);
  jalon_cloud_release(compared);
}

static void comparer_m3c2__measures_at_given_core_points_along_the_normal(void** state) {
  (void)state;
  jalon_cloud* reference = floor_at(0);
  jalon_cloud* compared = floor_at(0.03);
  const double at[6] = {1, 1, 0, 50, 50, 0};
  jalon_cloud* core = NULL;
  MUST(jalon_cloud_create(at, JALON_FLOAT64, 2, 0, 0, &core));
  jalon_comparer* comparer = NULL;
  MUST(jalon_comparer_create("m3c2", &comparer));
  jalon_comparison* comparison = NULL;
  MUST(jalon_comparer_run_core(comparer, reference, compared, core, NULL, &comparison));
  jalon_fields* points = NULL;
  MUST(jalon_comparison_points(comparison, &points));
  double distance[2], lod[2], normal[6];
  uint8_t significant[2], status[2];
  MUST(jalon_fields_copy(points, "distance", JALON_FLOAT64, distance, 2));
  MUST(jalon_fields_copy(points, "lod", JALON_FLOAT64, lod, 2));
  MUST(jalon_fields_copy(points, "normal", JALON_FLOAT64, normal, 6));
  MUST(jalon_fields_copy(points, "significant", JALON_UINT8, significant, 2));
  MUST(jalon_fields_copy(points, "status", JALON_UINT8, status, 2));
  assert_true(fabs(distance[0] - 0.03) < 0.0005);
  assert_true(lod[0] > 0 && lod[0] < 0.005);
  assert_true(normal[2] > 0.999);
  assert_int_equal(significant[0], 1);
  assert_int_equal(status[0], JALON_COMPARED);
  assert_true(isnan(distance[1]) && isnan(lod[1]) && isnan(normal[3]));
  assert_int_equal(significant[1], 0);
  assert_int_equal(status[1], JALON_TOO_FEW_POINTS);
  jalon_fields_release(points);
  jalon_comparison_release(comparison);
  comparison = NULL;
  // Core points of another CRS, and a method that has none.
  MUST(jalon_cloud_set_crs(reference, "EPSG:2154"));
  MUST(jalon_cloud_set_crs(core, "EPSG:2056"));
  assert_int_equal(jalon_comparer_run_core(comparer, reference, compared, core, NULL, &comparison),
                   JALON_ERROR_INVALID_ARGUMENT);
  jalon_comparer_release(comparer);
  MUST(jalon_comparer_create("distance", &comparer));
  assert_int_equal(
      jalon_comparer_run_core(comparer, compared, compared, compared, NULL, &comparison),
      JALON_ERROR_UNSUPPORTED);
  assert_null(comparison);
  jalon_comparer_release(comparer);
  jalon_cloud_release(core);
  jalon_cloud_release(compared);
  jalon_cloud_release(reference);
}

static void count_warning(int32_t level, const char* text, void* user) {
  if (level == JALON_LOG_WARNING && strstr(text, "NewIdea") != NULL) ++*(int*)user;
}

static void comparer_m3c2__reads_parameter_files_of_cloudcompare(void** state) {
  (void)state;
  const char* path = temporary("m3c2_params.txt");
  FILE* file = fopen(path, "wb");
  assert_non_null(file);
  fputs("[General]\nM3C2VER=1\nNormalScale=0.5\nSearchScale=0.3\nSearchDepth=0.8\nNewIdea=7\n",
        file);
  fclose(file);
  jalon_comparer* comparer = NULL;
  jalon_params* params = NULL;
  jalon_task* task = NULL;
  int warnings = 0;
  double value = 0;
  MUST(jalon_task_create(&task));
  MUST(jalon_task_set_log(task, count_warning, &warnings));
  MUST(jalon_comparer_create("m3c2", &comparer));
  MUST(jalon_comparer_read_m3c2_file(comparer, path, task));
  assert_int_equal(warnings, 1);
  MUST(jalon_comparer_params(comparer, &params));
  MUST(jalon_params_get_double(params, "normal_radius_m", &value));
  assert_true(value == 0.25);
  MUST(jalon_params_get_double(params, "cylinder_radius_m", &value));
  assert_true(value == 0.15);
  MUST(jalon_params_get_double(params, "max_depth_m", &value));
  assert_true(value == 0.8);
  assert_int_equal(remove(path), 0);
  REFUSED(JALON_ERROR_NOT_FOUND, jalon_comparer_read_m3c2_file(comparer, path, task));
  jalon_params_release(params);
  jalon_comparer_release(comparer);
  MUST(jalon_comparer_create("distance", &comparer));
  REFUSED(JALON_ERROR_UNSUPPORTED, jalon_comparer_read_m3c2_file(comparer, path, task));
  jalon_comparer_release(comparer);
  jalon_task_release(task);
}

/* A plate of 2 x 2 m with points every 2 cm, lifted by 10 cm where up is set, within 0.6 ... 1.4 m. */
static jalon_cloud* plate(int up) {
  static double xyz[3 * 101 * 101];
  double* p = xyz;
  for (int i = 0; i <= 100; ++i)
    for (int k = 0; k <= 100; ++k, p += 3) {
      p[0] = 0.02 * i + (up ? 0.003 : 0);
      p[1] = 0.02 * k;
      p[2] = up && i >= 30 && i <= 70 && k >= 30 && k <= 70 ? 0.1 : 0.001 * ((i * 7 + k * 3) % 5);
    }
  jalon_cloud* cloud = NULL;
  MUST(jalon_cloud_create(xyz, JALON_FLOAT64, 101 * 101, 0, 0, &cloud));
  return cloud;
}

static void changes__of_a_lifted_square_are_found_told_and_reported(void** state) {
  (void)state;
  jalon_cloud *before = plate(0), *after = plate(1);
  jalon_comparer* comparer = NULL;
  MUST(jalon_comparer_create("distance", &comparer));
  jalon_comparison *forward = NULL, *reverse = NULL;
  MUST(jalon_comparer_run(comparer, before, after, NULL, &forward));
  MUST(jalon_comparer_run(comparer, after, before, NULL, &reverse));
  jalon_fields *points = NULL, *regions = NULL, *changes = NULL;
  MUST(jalon_comparison_regions(forward, NULL, NULL, &points, &regions));
  double area[1], mean[1];
  MUST(jalon_fields_copy(regions, "area", JALON_FLOAT64, area, 1));
  MUST(jalon_fields_copy(regions, "mean", JALON_FLOAT64, mean, 1));
  assert_true(fabs(area[0] - 0.82 * 0.82) < 0.05);
  assert_true(fabs(mean[0] - 0.1) < 0.005);
  MUST(jalon_comparison_diagnose(forward, reverse, NULL, NULL, NULL, NULL, &changes));
  jalon_array_view classes;
  MUST(jalon_fields_view(changes, "class", &classes));
  assert_true(classes.count >= 1);
  const char* page = temporary("comparison.html");
  MUST(jalon_report_write_comparison(forward, reverse, changes, "{\"title\": \"<Plate>\"}", page,
                                     NULL, NULL));
  char* text = content_of(page, NULL);
  assert_non_null(strstr(text, "&lt;Plate&gt;"));
  assert_non_null(strstr(
      text, " beyond ")); /* the lifted square: the histogram shows the body of the distances */
  assert_null(strstr(text, "Weibull")); /* which do not scatter here */
  free(text);
  remove(page);
  const char* picture = temporary("distances.png");
  MUST(jalon_report_write_deviations(forward, picture, NULL, NULL));
  text = content_of(picture, NULL);
  assert_true(memcmp(text, "\x89PNG", 4) == 0);
  free(text);
  remove(picture);
  jalon_fields_release(points);
  jalon_fields_release(regions);
  jalon_fields_release(changes);
  jalon_comparison_release(forward);
  jalon_comparison_release(reverse);
  jalon_comparer_release(comparer);
  jalon_cloud_release(before);
  jalon_cloud_release(after);
}

int main(void) {
  const struct CMUnitTest tests[] = {
      cmocka_unit_test(comparison__gives_distance_nearest_point_and_status_of_each_point),
      cmocka_unit_test(comparer__refuses_empty_clouds_and_two_different_crs),
      cmocka_unit_test(changes__of_a_lifted_square_are_found_told_and_reported),
      cmocka_unit_test(cloud_overlap__tells_clouds_that_lie_apart),
      cmocka_unit_test(comparer_preview__and_closest_points_of_a_line),
      cmocka_unit_test(comparer_m3c2__measures_at_given_core_points_along_the_normal),
      cmocka_unit_test(comparer_m3c2__reads_parameter_files_of_cloudcompare),
  };
  return cmocka_run_group_tests(tests, NULL, NULL);
}

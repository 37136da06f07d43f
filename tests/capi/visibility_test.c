/* SPDX-FileCopyrightText: 2026 The Jalon authors
 * SPDX-License-Identifier: Apache-2.0 */
/* Depth maps and labels through the public surface. */
#include "support.h"

#include <math.h>

/* A scan of the box on its ground from one tripod, its label field against itself or another. */
static jalon_cloud* box_scan(const char* scene_name) {
  jalon_params *options, *params;
  jalon_model* model;
  jalon_scanner* scanner;
  jalon_cloud* cloud;
  MUST(jalon_params_create("scene", &options));
  MUST(jalon_params_set_string(options, "name", scene_name));
  MUST(jalon_scene_create(options, NULL, &model));
  MUST(jalon_scanner_create("static", &scanner));
  MUST(jalon_scanner_params(scanner, &params));
  MUST(jalon_params_set_double(params, "horizontal_step_rad", 0.01));
  MUST(jalon_params_set_double(params, "vertical_step_rad", 0.01));
  const jalon_transform pose = {{1, 0, 0, 0, 0, 1, 0, -6, 0, 0, 1, 1.7}};
  MUST(jalon_scanner_add_station(scanner, "tripod", &pose));
  MUST(jalon_scanner_run(scanner, model, NULL, &cloud));
  jalon_params_release(options);
  jalon_params_release(params);
  jalon_model_release(model);
  jalon_scanner_release(scanner);
  return cloud;
}

static void labels__tell_what_the_reference_saw(void** state) {
  (void)state;
  jalon_cloud* reference = box_scan("box");
  /* before the box, on it, behind it, under the ground, above all that was seen */
  const double xyz[15] = {0, -3, 0.5, 0, -0.9, 0.7, 0, 3, 0.5, 4, -4, -1, 0, -3, 9};
  const uint8_t expected[5] = {JALON_VISIBLE, JALON_VISIBLE, JALON_HIDDEN, JALON_HIDDEN,
                               JALON_OUT_OF_FIELD};
  jalon_cloud* cloud = cloud_of(xyz, 5);
  MUST(jalon_cloud_compute_visibility(cloud, reference, NULL, NULL));
  jalon_fields* fields;
  uint8_t labels[5];
  MUST(jalon_cloud_fields(cloud, &fields));
  MUST(jalon_fields_copy(fields, "visibility", JALON_UINT8, labels, 5));
  for (int i = 0; i < 5; ++i) assert_int_equal(labels[i], expected[i]);
  jalon_fields_release(fields);
  /* A cloud without stations could have been seen from anywhere. */
  REFUSED(JALON_ERROR_INVALID_ARGUMENT,
          jalon_cloud_compute_visibility(reference, cloud, NULL, NULL));
  jalon_cloud_release(cloud);
  jalon_cloud_release(reference);
}

static void depth_map__is_a_table_of_cells(void** state) {
  (void)state;
  jalon_cloud* reference = box_scan("box");
  jalon_fields* map;
  uint64_t rows, columns, points = 0, n;
  MUST(jalon_cloud_depth_map(reference, 0, NULL, NULL, &map, &rows, &columns));
  jalon_array_view range, count, fill;
  MUST(jalon_fields_view(map, "range", &range));
  MUST(jalon_fields_view(map, "points", &count));
  MUST(jalon_fields_view(map, "fill", &fill));
  assert_true(rows > 20 && columns > 100 && range.count == rows * columns);
  for (uint64_t c = 0; c < range.count; ++c) {
    points += ((const uint32_t*)count.data)[c];
    assert_true(isnan(((const float*)range.data)[c]) == (((const uint8_t*)fill.data)[c] == 0));
  }
  MUST(jalon_cloud_count(reference, &n));
  assert_int_equal(points, n);
  jalon_fields_release(map);
  REFUSED(JALON_ERROR_INVALID_ARGUMENT,
          jalon_cloud_depth_map(reference, 1, NULL, NULL, &map, NULL, NULL));
  jalon_cloud_release(reference);
}

static void depth_map__is_a_picture(void** state) {
  (void)state;
  jalon_cloud* reference = box_scan("box");
  char path[] = "/tmp/jalon_depth_XXXXXX";
  const int file = mkstemp(path);
  assert_true(file >= 0);
  close(file);
  MUST(jalon_cloud_write_depth_map(reference, 0, path, NULL, NULL));
  unsigned char head[8] = {0};
  FILE* in = fopen(path, "rb");
  assert_non_null(in);
  assert_int_equal(fread(head, 1, 8, in), 8);
  fclose(in);
  assert_true(memcmp(head, "\x89PNG\r\n\x1a\n", 8) == 0);
  remove(path);
  char tiff[sizeof path + 4];
  snprintf(tiff, sizeof tiff, "%s.tif", path);
  MUST(jalon_cloud_write_depth_map(reference, 0, tiff, NULL, NULL));
  in = fopen(tiff, "rb");
  assert_non_null(in);
  assert_int_equal(fread(head, 1, 8, in), 8);
  fclose(in);
  assert_true(memcmp(head, "II*", 4) == 0);
  remove(tiff);
  jalon_cloud_release(reference);
}

int main(void) {
  const struct CMUnitTest tests[] = {
      cmocka_unit_test(labels__tell_what_the_reference_saw),
      cmocka_unit_test(depth_map__is_a_table_of_cells),
      cmocka_unit_test(depth_map__is_a_picture),
  };
  return cmocka_run_group_tests(tests, NULL, NULL);
}

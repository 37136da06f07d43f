/* SPDX-FileCopyrightText: 2026 The Jalon authors
 * SPDX-License-Identifier: Apache-2.0 */
#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include <cmocka.h>

#include "jalon/jalon.h"

/* The ready-made room of 6 x 5 x 2.8 m, scanned from one station; the noise across its walls. */
enum { kRoomSections = 3 };
static const double kSigma_m = 0.003;

static jalon_cloud* scanned_room(double shift) {
  jalon_params *scene = NULL, *params = NULL;
  jalon_transform pose = {{1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0}};
  jalon_model* model = NULL;
  jalon_scanner* scanner = NULL;
  jalon_cloud* cloud = NULL;
  const double shift_m[3] = {shift, 10 * shift, 0};
  assert_int_equal(jalon_params_create("scene", &scene), JALON_OK);
  assert_int_equal(jalon_params_set_string(scene, "name", "room"), JALON_OK);
  assert_int_equal(jalon_params_set_doubles(scene, "shift_m", shift_m, 3), JALON_OK);
  assert_int_equal(jalon_scene_create(scene, NULL, &model), JALON_OK);
  assert_int_equal(jalon_scanner_create("static", &scanner), JALON_OK);
  assert_int_equal(jalon_scanner_params(scanner, &params), JALON_OK);
  assert_int_equal(jalon_params_set_double(params, "horizontal_step_rad", 0.005), JALON_OK);
  assert_int_equal(jalon_params_set_double(params, "vertical_step_rad", 0.005), JALON_OK);
  pose.m[3] = shift + 2, pose.m[7] = 10 * shift + 2.5, pose.m[11] = 1.7;
  assert_int_equal(jalon_scanner_add_station(scanner, NULL, &pose), JALON_OK);
  assert_int_equal(jalon_scanner_run(scanner, model, NULL, &cloud), JALON_OK);
  jalon_params_release(params);
  jalon_params_release(scene);
  jalon_model_release(model);
  jalon_scanner_release(scanner);
  return cloud;
}

static jalon_sections* cut(const jalon_cloud* cloud, uint32_t threads) {
  const double heights[kRoomSections] = {0.6, 1.2, 2.1};
  jalon_params* options = NULL;
  jalon_task* task = NULL;
  jalon_sections* sections = NULL;
  assert_int_equal(jalon_params_create("sections", &options), JALON_OK);
  assert_int_equal(jalon_params_set_doubles(options, "at_m", heights, kRoomSections), JALON_OK);
  assert_int_equal(jalon_task_create(&task), JALON_OK);
  assert_int_equal(jalon_task_set_threads(task, threads), JALON_OK);
  assert_int_equal(jalon_cloud_sections(cloud, NULL, 0, options, task, &sections), JALON_OK);
  jalon_task_release(task);
  jalon_params_release(options);
  return sections;
}

static jalon_array_view column(jalon_fields* table, const char* name) {
  jalon_array_view view;
  assert_int_equal(jalon_fields_view(table, name, &view), JALON_OK);
  return view;
}

static void sections__of_a_scanned_room_are_its_walls(void** state) {
  (void)state;
  const double shift = 652000;
  jalon_cloud* cloud = scanned_room(shift);
  jalon_sections* sections = cut(cloud, 0);
  jalon_fields *summary = NULL, *lines = NULL, *vertices = NULL;
  assert_int_equal(jalon_sections_summary(sections, &summary), JALON_OK);
  assert_int_equal(jalon_sections_lines(sections, &lines), JALON_OK);
  assert_int_equal(jalon_sections_vertices(sections, &vertices), JALON_OK);
  assert_int_equal(column(lines, "section").count, kRoomSections);
  assert_int_equal(column(vertices, "xyz").count, 4 * kRoomSections);
  const double* xyz = column(vertices, "xyz").data;
  for (int i = 0; i < 4 * kRoomSections; ++i) { /* corners, to three sigma of single points */
    const double x = xyz[3 * i] - shift, y = xyz[3 * i + 1] - 10 * shift;
    assert_true(fmin(fabs(x), fabs(x - 6)) < 3 * kSigma_m);
    assert_true(fmin(fabs(y), fabs(y - 5)) < 3 * kSigma_m);
  }
  for (int s = 0; s < kRoomSections; ++s) {
    assert_true(fabs(((const double*)column(summary, "length").data)[s] - 22) < 0.01);
    assert_true(((const double*)column(summary, "rms").data)[s] < 2 * kSigma_m);
    assert_int_equal(((const uint8_t*)column(lines, "closed").data)[s], 1);
  }
  const char *name = NULL, *parameters = NULL;
  assert_int_equal(jalon_sections_name(sections, 1, &name), JALON_OK);
  assert_string_equal(name, "Z 1.200");
  assert_int_equal(jalon_sections_name(sections, kRoomSections, &name),
                   JALON_ERROR_INVALID_ARGUMENT);
  assert_int_equal(jalon_sections_parameters(sections, &parameters), JALON_OK);
  assert_non_null(strstr(parameters, "\"tolerance_m\""));
  jalon_sections_release(sections);
  jalon_fields_release(summary);
  jalon_fields_release(lines);
  jalon_fields_release(vertices); /* tables outlive their sections */
  jalon_cloud_release(cloud);
}

static void sections__have_the_same_bits_for_any_number_of_threads(void** state) {
  (void)state;
  jalon_cloud* cloud = scanned_room(0);
  jalon_fields *one = NULL, *other = NULL;
  jalon_sections* first = cut(cloud, 1);
  assert_int_equal(jalon_sections_vertices(first, &one), JALON_OK);
  for (uint32_t threads = 2; threads <= 7; threads += 5) {
    jalon_sections* second = cut(cloud, threads);
    assert_int_equal(jalon_sections_vertices(second, &other), JALON_OK);
    const jalon_array_view a = column(one, "xyz"), b = column(other, "xyz");
    assert_int_equal(a.count, b.count);
    assert_memory_equal(a.data, b.data, 24 * a.count);
    jalon_fields_release(other);
    jalon_sections_release(second);
  }
  jalon_fields_release(one);
  jalon_sections_release(first);
  jalon_cloud_release(cloud);
}

static void sections__are_refused_with_a_line_and_nothing_written(void** state) {
  (void)state;
  const double xyz[9] = {0, 0, 0, 1, 0, 0, 1, 1, 1}, axis[6] = {2, 2, 0, 2, 2, 9};
  jalon_cloud *cloud = NULL, *empty = NULL;
  jalon_sections* out = NULL;
  jalon_task* task = NULL;
  assert_int_equal(jalon_cloud_create(xyz, JALON_FLOAT64, 3, 0, 0, &cloud), JALON_OK);
  assert_int_equal(jalon_cloud_create(NULL, JALON_FLOAT64, 0, 0, 0, &empty), JALON_OK);
  assert_int_equal(jalon_cloud_sections(empty, NULL, 0, NULL, NULL, &out),
                   JALON_ERROR_INSUFFICIENT_DATA);
  assert_int_equal(jalon_cloud_sections(cloud, axis, 2, NULL, NULL, &out),
                   JALON_ERROR_INVALID_ARGUMENT);
  assert_int_equal(jalon_task_create(&task), JALON_OK);
  assert_int_equal(jalon_task_cancel(task), JALON_OK);
  assert_int_equal(jalon_cloud_sections(cloud, NULL, 0, NULL, task, &out), JALON_ERROR_CANCELLED);
  jalon_task_release(task);
  assert_null(out);
  assert_int_equal(jalon_cloud_sections(cloud, NULL, 0, NULL, NULL, &out), JALON_OK);
  assert_int_equal(jalon_sections_write(out, "sections.pdf", NULL, NULL), JALON_ERROR_UNSUPPORTED);
  assert_non_null(strstr(jalon_last_error_message(), ".dxf or .svg"));
  jalon_sections_release(out);
  jalon_cloud_release(cloud);
  jalon_cloud_release(empty);
}

int main(void) {
  const struct CMUnitTest tests[] = {
      cmocka_unit_test(sections__of_a_scanned_room_are_its_walls),
      cmocka_unit_test(sections__have_the_same_bits_for_any_number_of_threads),
      cmocka_unit_test(sections__are_refused_with_a_line_and_nothing_written),
  };
  return cmocka_run_group_tests(tests, NULL, NULL);
}

/* SPDX-FileCopyrightText: 2026 The Jalon authors
 * SPDX-License-Identifier: Apache-2.0 */
#include "wall_scene.h"

#include <math.h>

static void modeller__draws_the_wall_with_its_window(void** state) {
  (void)state;
  wall_scene scene = make_wall_scene();
  jalon_model* model = model_of_scene(&scene);
  jalon_fields* faces = NULL;
  MUST(jalon_model_faces(model, &faces));
  jalon_array_view rows;
  MUST(jalon_fields_view(faces, "area", &rows));
  assert_int_equal(rows.count, 1);
  double area = 0, normal[3];
  uint64_t rings = 0;
  uint32_t id = 0;
  MUST(jalon_fields_copy(faces, "area", JALON_FLOAT64, &area, 1));
  MUST(jalon_fields_copy(faces, "normal", JALON_FLOAT64, normal, 3));
  MUST(jalon_fields_copy(faces, "ring_count", JALON_UINT64, &rings, 1));
  MUST(jalon_fields_copy(faces, "id", JALON_UINT32, &id, 1));
  assert_true(fabs(area / (6 * 3.99 - 1.2 * 1.5) - 1) < 0.02);
  assert_true(fabs(normal[1]) > 0.9999);
  assert_int_equal(rings, 2);
  assert_int_equal(id, 1);
  jalon_fields_release(faces);
  jalon_model_release(model);
  release_scene(&scene);
}

static void modeller__parameters_change_the_model(void** state) {
  (void)state;
  wall_scene scene = make_wall_scene();
  jalon_modeller* modeller = NULL;
  jalon_params* params = NULL;
  MUST(jalon_modeller_create("outlines", &modeller));
  MUST(jalon_modeller_params(modeller, &params));
  MUST(jalon_params_set_double(params, "min_opening_area_m2", 5));
  REFUSED(JALON_ERROR_INVALID_ARGUMENT, jalon_params_set_double(params, "alpha_factor", -1));
  REFUSED(JALON_ERROR_NOT_FOUND, jalon_params_set_double(params, "no_such_thing", 1));
  jalon_params_release(params);
  jalon_model* model = NULL;
  MUST(jalon_modeller_run(modeller, scene.cloud, scene.segmentation, NULL, &model));
  jalon_fields* rings = NULL;
  jalon_array_view view;
  MUST(jalon_model_rings(model, &rings));
  MUST(jalon_fields_view(rings, "count", &view));
  assert_int_equal(view.count, 1);
  jalon_fields_release(rings);
  jalon_model_release(model);
  jalon_modeller_release(modeller);
  release_scene(&scene);
}

static void modeller__refuses_another_cloud_and_unknown_methods(void** state) {
  (void)state;
  wall_scene scene = make_wall_scene();
  jalon_modeller* modeller = NULL;
  jalon_cloud* other = NULL;
  jalon_model* model = NULL;
  const double point[3] = {0, 0, 0};
  REFUSED(JALON_ERROR_NOT_FOUND, jalon_modeller_create("sculpture", &modeller));
  assert_null(modeller);
  MUST(jalon_modeller_create(NULL, &modeller));
  MUST(jalon_cloud_create(point, JALON_FLOAT64, 1, 0, 0, &other));
  REFUSED(JALON_ERROR_INVALID_ARGUMENT,
          jalon_modeller_run(modeller, other, scene.segmentation, NULL, &model));
  REFUSED(JALON_ERROR_INVALID_ARGUMENT,
          jalon_modeller_run(modeller, scene.cloud, NULL, NULL, &model));
  REFUSED(JALON_ERROR_INVALID_ARGUMENT,
          jalon_modeller_run(NULL, scene.cloud, scene.segmentation, NULL, &model));
  REFUSED(JALON_ERROR_INVALID_ARGUMENT,
          jalon_modeller_run(modeller, scene.cloud, scene.segmentation, NULL, NULL));
  assert_null(model);
  jalon_cloud_release(other);
  jalon_modeller_release(modeller);
  jalon_modeller_release(NULL);
  release_scene(&scene);
}

static void modeller__cancelled_leaves_everything_usable(void** state) {
  (void)state;
  wall_scene scene = make_wall_scene();
  jalon_modeller* modeller = NULL;
  jalon_task* task = NULL;
  jalon_model* model = NULL;
  MUST(jalon_modeller_create(NULL, &modeller));
  MUST(jalon_task_create(&task));
  MUST(jalon_task_cancel(task));
  REFUSED(JALON_ERROR_CANCELLED,
          jalon_modeller_run(modeller, scene.cloud, scene.segmentation, task, &model));
  assert_null(model);
  MUST(jalon_task_reset(task));
  MUST(jalon_modeller_run(modeller, scene.cloud, scene.segmentation, task, &model));
  jalon_model_release(model);
  jalon_task_release(task);
  jalon_modeller_release(modeller);
  release_scene(&scene);
}

static void modeller__facade_makes_a_tree_with_a_window(void** state) {
  (void)state;
  wall_scene scene = make_wall_scene();
  jalon_modeller* modeller = NULL;
  jalon_params* params = NULL;
  jalon_model* model = NULL;
  MUST(jalon_modeller_create("facade", &modeller));
  MUST(jalon_modeller_params(modeller, &params));
  REFUSED(JALON_ERROR_INVALID_ARGUMENT, jalon_params_set_double(params, "max_depth_m", -1));
  MUST(jalon_params_set_double(params, "max_depth_m", 0.8));
  jalon_params_release(params);
  MUST(jalon_modeller_run(modeller, scene.cloud, scene.segmentation, NULL, &model));
  uint64_t count = 0, parent = 0;
  MUST(jalon_model_part_count(model, &count));
  assert_int_equal(count, 3);
  const char *name = NULL, *part_class = NULL;
  MUST(jalon_model_part(model, 2, &name, &part_class, &parent));
  assert_string_equal(name, "window 1.1");
  assert_string_equal(part_class, "window");
  assert_int_equal(parent, 1);
  jalon_fields* parts = NULL;
  MUST(jalon_model_parts(model, &parts));
  double width[3];
  uint8_t evidence[3];
  MUST(jalon_fields_copy(parts, "width", JALON_FLOAT64, width, 3));
  MUST(jalon_fields_copy(parts, "evidence", JALON_UINT8, evidence, 3));
  assert_true(fabs(width[2] - 1.2) < 0.03);
  assert_int_equal(evidence[2], JALON_EVIDENCE_SHAPE);
  jalon_fields_release(parts);
  jalon_model_release(model);
  jalon_modeller_release(modeller);
  release_scene(&scene);
}

static void modeller__extrusion_needs_a_depth_and_gives_a_closed_solid(void** state) {
  (void)state;
  wall_scene scene = make_wall_scene();
  jalon_modeller* modeller = NULL;
  jalon_params* params = NULL;
  jalon_model* model = NULL;
  MUST(jalon_modeller_create("extrusion", &modeller));
  REFUSED(JALON_ERROR_INSUFFICIENT_DATA,
          jalon_modeller_run(modeller, scene.cloud, scene.segmentation, NULL, &model));
  assert_null(model);
  MUST(jalon_modeller_params(modeller, &params));
  MUST(jalon_params_set_double(params, "thickness_m", 0.25));
  jalon_params_release(params);
  MUST(jalon_modeller_run(modeller, scene.cloud, scene.segmentation, NULL, &model));
  jalon_fields *solids = NULL, *edges = NULL;
  uint64_t faces = 0;
  MUST(jalon_model_solids(model, &solids));
  MUST(jalon_fields_copy(solids, "face_count", JALON_UINT64, &faces, 1));
  assert_int_equal(faces, 2 + 4 + 4);
  jalon_array_view uses;
  MUST(jalon_model_edges(model, &edges));
  MUST(jalon_fields_view(edges, "uses", &uses));
  assert_int_equal(uses.count, 24);
  for (uint64_t i = 0; i < uses.count; ++i) assert_int_equal(((const uint32_t*)uses.data)[i], 2);
  jalon_fields_release(edges);
  jalon_fields_release(solids);
  jalon_model_release(model);
  jalon_modeller_release(modeller);
  release_scene(&scene);
}

static void model__parts_are_renamed_in_a_new_model(void** state) {
  (void)state;
  wall_scene scene = make_wall_scene();
  jalon_model *model = model_of_scene(&scene), *renamed = NULL, *less = NULL;
  const char *name = NULL, *part_class = NULL;
  MUST(jalon_model_rename_part(model, 1, "street front", NULL, &renamed));
  MUST(jalon_model_part(renamed, 1, &name, &part_class, NULL));
  assert_string_equal(name, "street front");
  MUST(jalon_model_part(model, 1, &name, NULL, NULL));
  assert_string_not_equal(name, "street front");
  REFUSED(JALON_ERROR_INVALID_ARGUMENT, jalon_model_rename_part(model, 99, "x", NULL, &less));
  REFUSED(JALON_ERROR_INVALID_ARGUMENT, jalon_model_rename_part(model, 0, "\xff", NULL, &less));
  REFUSED(JALON_ERROR_INVALID_ARGUMENT, jalon_model_remove_copy(model, 1, &less));
  REFUSED(JALON_ERROR_INVALID_ARGUMENT, jalon_model_remove_copy(model, 99, &less));
  assert_null(less);
  jalon_model_release(renamed);
  jalon_model_release(model);
  release_scene(&scene);
}

static void segmentation__long_edges_tell_the_curve_and_its_contour_points(void** state) {
  (void)state;
  wall_scene scene = make_wall_scene();
  jalon_params* options = NULL;
  jalon_fields *lengths = NULL, *points = NULL, *summary = NULL;
  MUST(jalon_params_create("long_edges", &options));
  MUST(jalon_params_set_double(options, "threshold_m", 0.3));
  MUST(jalon_segmentation_long_edges(scene.segmentation, 1, options, NULL, &lengths, &points,
                                     &summary));
  jalon_array_view length, point, xyz, longer, threshold;
  MUST(jalon_fields_view(lengths, "length", &length));
  MUST(jalon_fields_view(points, "point", &point));
  MUST(jalon_fields_view(summary, "longer", &longer));
  MUST(jalon_fields_view(summary, "threshold", &threshold));
  MUST(jalon_cloud_points(scene.cloud, &xyz));
  const double* l = length.data;
  uint64_t beyond = 0;
  for (uint64_t i = 0; i < length.count; ++i) {
    if (i > 0) assert_true(l[i] >= l[i - 1]);
    beyond += l[i] > 0.3;
  }
  assert_true(beyond > 0 && beyond == *(const uint64_t*)longer.data);
  assert_true(*(const double*)threshold.data == 0.3);
  /* 0.3 m is ten steps of the lattice: only the borders of the window and of the wall have such edges */
  assert_true(point.count > 10);
  for (uint64_t i = 0; i < point.count; ++i) {
    const double* p = (const double*)xyz.data + 3 * ((const uint64_t*)point.data)[i];
    const int at_window = p[0] > 1.9 && p[0] < 3.3 && p[2] > 0.9 && p[2] < 2.6;
    const int at_border = p[0] < 0.1 || p[0] > 5.9 || p[2] < 0.1 || p[2] > 3.9;
    assert_true(at_window || at_border);
  }
  REFUSED(JALON_ERROR_NOT_FOUND, jalon_segmentation_long_edges(scene.segmentation, 99, NULL, NULL,
                                                               &lengths, &points, &summary));
  jalon_fields_release(lengths), jalon_fields_release(points), jalon_fields_release(summary);
  jalon_params_release(options);
  release_scene(&scene);
}

static void modeller__lines_by_ransac_find_the_same_wall(void** state) {
  (void)state;
  wall_scene scene = make_wall_scene();
  jalon_modeller* modeller = NULL;
  jalon_params* params = NULL;
  jalon_model* model = NULL;
  jalon_fields *faces = NULL, *corners = NULL;
  MUST(jalon_modeller_create("outlines", &modeller));
  MUST(jalon_modeller_params(modeller, &params));
  MUST(jalon_params_set_string(params, "lines", "ransac"));
  MUST(jalon_params_set_double(params, "line_gap_m", 0.2));
  MUST(jalon_modeller_run(modeller, scene.cloud, scene.segmentation, NULL, &model));
  MUST(jalon_model_faces(model, &faces));
  MUST(jalon_model_corners(model, &corners));
  jalon_array_view area, vertex;
  MUST(jalon_fields_view(faces, "area", &area));
  MUST(jalon_fields_view(corners, "vertex", &vertex));
  assert_int_equal(area.count, 1);
  assert_int_equal(vertex.count, 8); /* four corners of the wall, four of its window */
  assert_true(fabs(*(const double*)area.data - (24 - 1.8)) < (20 + 5.4) * 0.03);
  REFUSED(JALON_ERROR_INVALID_ARGUMENT, jalon_params_set_string(params, "lines", "hough"));
  jalon_fields_release(faces), jalon_fields_release(corners);
  jalon_model_release(model);
  jalon_params_release(params);
  jalon_modeller_release(modeller);
  release_scene(&scene);
}

int main(void) {
  const struct CMUnitTest tests[] = {
      cmocka_unit_test(modeller__draws_the_wall_with_its_window),
      cmocka_unit_test(modeller__parameters_change_the_model),
      cmocka_unit_test(modeller__refuses_another_cloud_and_unknown_methods),
      cmocka_unit_test(modeller__cancelled_leaves_everything_usable),
      cmocka_unit_test(modeller__facade_makes_a_tree_with_a_window),
      cmocka_unit_test(modeller__extrusion_needs_a_depth_and_gives_a_closed_solid),
      cmocka_unit_test(model__parts_are_renamed_in_a_new_model),
      cmocka_unit_test(segmentation__long_edges_tell_the_curve_and_its_contour_points),
      cmocka_unit_test(modeller__lines_by_ransac_find_the_same_wall),
  };
  return cmocka_run_group_tests(tests, NULL, NULL);
}
